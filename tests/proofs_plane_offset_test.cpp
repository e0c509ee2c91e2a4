// SPDX-License-Identifier: GPL-3.0-or-later
// Claim S19: the offset of a plane may be taken from either box's edge. Equal in real numbers; here is what
// floats make of it. The shaft of B and A is that of A and B with every offset taken from the other edge.
//
// GNOMON_SEARCH_TRIALS sets the cases of each distribution.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "exact/shaft_box.h"
#include "fast/shaft_box.h"
#include "fuzz/generator.h"
#include "tests/bound_cases.h"
#include "tests/search_trials.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using fast::Shaft;
using fast::ShaftPlane;
using scene::Category;

template <class F>
class ProofsPlaneOffset : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ProofsPlaneOffset, Scalars);

/// The plane of the same two edges in the shaft whose boxes are exchanged.
template <class F>
const ShaftPlane<F>* counterpart(const Shaft<F>& exchanged, const ShaftPlane<F>& plane) {
  for (const ShaftPlane<F>& other : exchanged.planes()) {
    if (other.far0 == plane.far1 && other.far1 == plane.far0) return &other;
  }
  return nullptr;
}

TYPED_TEST(ProofsPlaneOffset, OnlyTheOffsetDiffers) {
  using F = TypeParam;
  const auto generator = fuzz::make_generator<scene::ShaftBoxCase>(
      fuzz::parse_distribution("uniform"),
      std::is_same_v<F, float> ? scene::Scalar::f32 : scene::Scalar::f64);
  int planes = 0, other_offsets = 0;
  for (std::uint64_t trial = 0; trial < 1000; ++trial) {
    fuzz::CaseRandom random(3, 0, trial);
    const auto c = scene::converted<F>(generator->make(random));
    const Shaft<F> shaft = fast::form_shaft(c.a, c.b, fast::Normals::as_formed);
    const Shaft<F> exchanged = fast::form_shaft(c.b, c.a, fast::Normals::as_formed);
    ASSERT_EQ(shaft.plane_count, exchanged.plane_count);
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      const ShaftPlane<F>* const other = counterpart(exchanged, plane);
      ASSERT_NE(other, nullptr);
      EXPECT_EQ(other->n0, plane.n1);
      EXPECT_EQ(other->n1, plane.n0);
      EXPECT_EQ(other->d, -(other->n0 * c.b.c[other->far0] + other->n1 * c.b.c[other->far1]));
      ++planes;
      other_offsets += other->d != plane.d;
    }
  }
  EXPECT_GT(planes, 1000);
  EXPECT_GT(other_offsets, 100);
}

struct Differences {
  std::uint64_t verdicts = 0, a_wrong = 0, b_wrong = 0, certified = 0, unsound = 0;
};

template <class F>
Differences compare(const fuzz::Distribution& distribution, std::uint64_t trials) {
  const auto generator = fuzz::make_generator<scene::ShaftBoxCase>(
      {&distribution, ""}, std::is_same_v<F, float> ? scene::Scalar::f32 : scene::Scalar::f64);
  Differences result;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    fuzz::CaseRandom random(4, fuzz::stream_of(distribution.name), trial);
    const scene::ShaftBoxCase c = generator->make(random);
    const auto t = scene::converted<F>(c);
    const auto answer = [&t](const Shaft<F>& shaft) { return fast::classify(shaft, t.t).answer; };
    const Category a = answer(fast::form_shaft(t.a, t.b, fast::Normals::as_formed));
    const Category b = answer(fast::form_shaft(t.b, t.a, fast::Normals::as_formed));
    const Category safe_a = answer(fast::form_certified_box_shaft(t.a, t.b));
    const Category safe_b = answer(fast::form_certified_box_shaft(t.b, t.a));
    result.certified += safe_a != safe_b;
    result.verdicts += a != b;
    const Category truth = exact::classify(c);
    result.a_wrong += a != truth;
    result.b_wrong += b != truth;
    for (const Category safe : {safe_a, safe_b}) result.unsound += safe != truth && safe != Category::overlap;
  }
  return result;
}

TYPED_TEST(ProofsPlaneOffset, VerdictsDifferWhereRoundingDecides) {
  using F = TypeParam;
  const std::uint64_t trials = search_trials(10000);
  std::printf("%s, %llu cases each %10s %10s %10s %10s\n", std::is_same_v<F, float> ? "f32" : "f64",
              static_cast<unsigned long long>(trials), "differ", "A wrong", "B wrong", "certified");
  std::uint64_t differences = 0;
  for (const fuzz::Distribution& distribution : fuzz::distributions()) {
    if (distribution.needs_argument) continue;
    const Differences d = compare<F>(distribution, trials);
    std::printf("%-20s %10llu %10llu %10llu %10llu\n", std::string(distribution.name).c_str(),
                static_cast<unsigned long long>(d.verdicts), static_cast<unsigned long long>(d.a_wrong),
                static_cast<unsigned long long>(d.b_wrong), static_cast<unsigned long long>(d.certified));
    EXPECT_EQ(d.unsound, 0U) << distribution.name;
    differences += d.verdicts;
  }
  EXPECT_GT(differences, 0U);
}

/// The error of a plane from b's edge, over the threshold of its own (as `box_threshold`) and over that of
/// the plane from a's edge (as `plane_value`, which is what climb() is told).
template <class F>
class OffsetCase {
 public:
  explicit OffsetCase(fuzz::CaseRandom& random) : edges_(random) {
    if (random.chance(0.5)) edges_.shrink_a(random);
  }
  void change(fuzz::CaseRandom& random) { edges_.change(random); }
  void measure(BoundShares& shares) const {
    const Shaft<F> shaft = fast::form_certified_box_shaft(edges_.a(), edges_.b());
    const Shaft<F> exchanged = fast::form_certified_box_shaft(edges_.b(), edges_.a());
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      const ShaftPlane<F>& other = *counterpart(exchanged, plane);
      const F x = edges_.point(other.far0), y = edges_.point(other.far1);
      if (!in_extent(exchanged, other, x, y)) continue;
      const Quad error = magnitude(Quad(other.value(x, y)) - QuadPlane<F>(exchanged, other).value(x, y));
      shares.add(Bound::plane_value, error / Quad(plane.outside_threshold));
      shares.add(Bound::box_threshold, error / Quad(other.outside_threshold));
    }
  }

 private:
  EdgesCase<F> edges_;
};

TYPED_TEST(ProofsPlaneOffset, EachEdgeHoldsItsOwnThreshold) {
  using F = TypeParam;
  BoundShares shares;
  for (std::uint64_t start = 0; start < std::max<std::uint64_t>(search_trials(10000) / 5000, 2); ++start) {
    shares.add(climb<OffsetCase<F>>(Bound::plane_value, 5, start, 20000));
    shares.add(climb<OffsetCase<F>>(Bound::box_threshold, 5, start, 20000));
  }
  std::printf("offset from b's edge: %.3f of its own threshold, %.3f of that for a's edge\n",
              shares.of(Bound::box_threshold), shares.of(Bound::plane_value));
  EXPECT_LE(shares.of(Bound::box_threshold), 1);
  EXPECT_GT(shares.of(Bound::box_threshold), 0.5);
}

}  // namespace
}  // namespace gnomon::tests
