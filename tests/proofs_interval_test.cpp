// SPDX-License-Identifier: GPL-3.0-or-later
// Claim S15: "using interval analysis a faster classification test can be devised, but this type of testing
// is conservative and inexact". Two readings. Intervals put into a plane's expression give the values of the
// near and far corner, so for a shaft that test is as exact as the paper's own. Intervals of s, with the
// shaft as a union of boxes, are conservative and inexact: how much is counted here.
//
// GNOMON_SEARCH_TRIALS sets the cases of each distribution.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "exact/shaft_box.h"
#include "fast/shaft.h"
#include "fuzz/generator.h"
#include "tests/interval_over_s.h"
#include "tests/search_trials.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using scene::Category;
using scene::ShaftBoxCase;

struct Interval {
  mpq_class lo, hi;
};
Interval interval(double lo, double hi) {
  return {mpq_class(lo), mpq_class(hi)};
}
Interval operator+(const Interval& x, const Interval& y) {
  return {x.lo + y.lo, x.hi + y.hi};
}
Interval operator-(const Interval& x, const Interval& y) {
  return {x.lo - y.hi, x.hi - y.lo};
}
Interval operator*(const Interval& x, const Interval& y) {
  const std::array<mpq_class, 4> ends{x.lo * y.lo, x.lo * y.hi, x.hi * y.lo, x.hi * y.hi};
  return {*std::min_element(ends.begin(), ends.end()), *std::max_element(ends.begin(), ends.end())};
}

/// Extent sides, then N0 (x - a0) + N1 (y - a1) <= 0 for x and y in t, in exact interval arithmetic.
Category by_intervals(const ShaftBoxCase& c) {
  const scene::Box<double> extent = fast::extent_of(c.a, c.b);
  bool inside = true;
  for (int axis = 0; axis < 3; ++axis) {
    if (c.t.lo(axis) > extent.hi(axis) || c.t.hi(axis) < extent.lo(axis)) return Category::outside;
    inside &= c.t.lo(axis) >= extent.lo(axis) && c.t.hi(axis) <= extent.hi(axis);
  }
  const fast::ExtremeLists lists = fast::extreme_lists(c.a, c.b);
  for (std::size_t i = 0; i < lists.count_a; ++i) {
    for (std::size_t j = 0; j < lists.count_b; ++j) {
      const fast::Face f = lists.of_a[i], g = lists.of_b[j];
      if (fast::axis_of(f) == fast::axis_of(g)) continue;
      const auto at = [](double x) { return interval(x, x); };
      Interval n0 = at(c.b.c[g]) - at(c.a.c[g]), n1 = at(c.a.c[f]) - at(c.b.c[f]);
      if (fast::is_max(f) != fast::is_max(g)) n0 = at(0) - n0, n1 = at(0) - n1;
      const Interval x = interval(c.t.lo(fast::axis_of(f)), c.t.hi(fast::axis_of(f)));
      const Interval y = interval(c.t.lo(fast::axis_of(g)), c.t.hi(fast::axis_of(g)));
      const Interval value = n0 * (x - at(c.a.c[f])) + n1 * (y - at(c.a.c[g]));
      if (value.lo > 0) return Category::outside;
      inside &= value.hi <= 0;
    }
  }
  return inside ? Category::inside : Category::overlap;
}

/// The first reading: exact, on every distribution.
TEST(ProofsInterval, IntervalsInThePlanesAreExact) {
  const std::uint64_t trials = search_trials(500);
  std::array<std::uint64_t, 3> seen{};
  for (const fuzz::Distribution& distribution : fuzz::distributions()) {
    if (distribution.needs_argument) continue;
    const auto generator = fuzz::make_generator<ShaftBoxCase>({&distribution, ""}, scene::Scalar::f64);
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      fuzz::CaseRandom random(5, fuzz::stream_of(distribution.name), trial);
      const ShaftBoxCase c = generator->make(random);
      const Category truth = exact::classify(c);
      ++seen[static_cast<std::size_t>(truth)];
      EXPECT_EQ(by_intervals(c), truth) << text_of(c);
    }
  }
  for (const std::uint64_t count : seen) EXPECT_GT(count, trials / 2);
}

/// The second reading: never wrong about outside, and the more often too careful the coarser the ranges.
TEST(ProofsInterval, IntervalsOfSAreConservativeAndInexact) {
  constexpr int kDeepest = 8;
  const std::uint64_t trials = search_trials(5000);
  std::printf("of the boxes outside, kept at depth\n%-16s %10s", "", "outside");
  for (int depth = 0; depth <= kDeepest; ++depth) std::printf("%9d", depth);
  std::printf("\n");
  std::uint64_t kept_at_all = 0, kept_coarsely = 0;
  for (const fuzz::Distribution& distribution : fuzz::distributions()) {
    if (distribution.needs_argument) continue;
    const auto generator = fuzz::make_generator<ShaftBoxCase>({&distribution, ""}, scene::Scalar::f64);
    std::uint64_t outside = 0;
    std::array<std::uint64_t, kDeepest + 1> kept{};
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      fuzz::CaseRandom random(6, fuzz::stream_of(distribution.name), trial);
      const ShaftBoxCase c = generator->make(random);
      const int told = IntervalOverS(c).depth_of_outside(kDeepest);
      if (exact::classify(c) != Category::outside) {
        EXPECT_GT(told, kDeepest) << text_of(c);
        continue;
      }
      ++outside;
      for (int depth = 0; depth < told && depth <= kDeepest; ++depth) ++kept[static_cast<std::size_t>(depth)];
    }
    std::printf("%-16s %10llu", std::string(distribution.name).c_str(),
                static_cast<unsigned long long>(outside));
    for (const std::uint64_t count : kept) {
      std::printf("%8.3f%%",
                  outside == 0 ? 0 : 100.0 * static_cast<double>(count) / static_cast<double>(outside));
    }
    std::printf("\n");
    kept_coarsely += kept.front();
    kept_at_all += kept.back();
  }
  EXPECT_GT(kept_coarsely, trials);
  EXPECT_GT(kept_at_all, trials / 100);
  EXPECT_LT(kept_at_all, kept_coarsely / 2);
}

}  // namespace
}  // namespace gnomon::tests
