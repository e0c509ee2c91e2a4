// SPDX-License-Identifier: GPL-3.0-or-later
// Every case there is on a small grid: the box test against the definition of a shaft, and the number of
// planes for every order of the two boxes' faces. Nothing is sampled.
//
// GNOMON_EXHAUSTIVE=1 runs the code itself on all 10^9 triples of boxes with coordinates 0..3, too (minutes).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <thread>
#include <vector>

#include "fast/shaft_box.h"

namespace gnomon::tests {
namespace {

using fast::Shaft;
using scene::Box;
using scene::Category;

struct Interval {
  int lo, hi;
};

std::vector<Interval> intervals(int largest) {
  std::vector<Interval> all;
  for (int lo = 0; lo <= largest; ++lo)
    for (int hi = lo; hi <= largest; ++hi) all.push_back({lo, hi});
  return all;
}

/// The s in [0, 1], in sixths, for which the interval (1-s)a + sb meets t. With coordinates 0..3 every end is
/// a whole number of sixths: it is p/q with |q| <= 3.
struct Sixths {
  int from, to;
};
Sixths meeting(Interval a, Interval b, Interval t) {
  Sixths s{0, 6};
  const auto need = [&s](int p, int q) {  // p + q s >= 0
    if (q > 0) s.from = std::max(s.from, -6 * p / q);
    if (q < 0) s.to = std::min(s.to, 6 * p / -q);
    if (q == 0 && p < 0) s.to = -1;
  };
  need(a.hi - t.lo, b.hi - a.hi);
  need(t.hi - a.lo, a.lo - b.lo);
  return s;
}

/// One axis of a case: what the test by the definition and the test by planes need of it.
struct Axis {
  Interval a, b, t;
  Sixths meets, lo_meets, hi_meets;  // of t, and of its two ends alone
  std::uint64_t weight = 1;          // how many cases of an axis look like this one
};
Axis axis_of(Interval a, Interval b, Interval t) {
  return {a, b, t, meeting(a, b, t), meeting(a, b, {t.lo, t.lo}), meeting(a, b, {t.hi, t.hi})};
}

/// By the definition: a common s; and one for each corner.
Category truth(const Axis& x, const Axis& y, const Axis& z) {
  const int from = std::max({x.meets.from, y.meets.from, z.meets.from});
  const int to = std::min({x.meets.to, y.meets.to, z.meets.to});
  if (from > to) return Category::outside;
  for (int corner = 0; corner < 8; ++corner) {
    const Sixths& u = corner & 1 ? x.hi_meets : x.lo_meets;
    const Sixths& v = corner & 2 ? y.hi_meets : y.lo_meets;
    const Sixths& w = corner & 4 ? z.hi_meets : z.lo_meets;
    if (std::max({u.from, v.from, w.from}) > std::min({u.to, v.to, w.to})) return Category::overlap;
  }
  return Category::inside;
}

/// The two sides of an axis, outwards: how far a, b and the near and far corner of t reach.
struct Outward {
  int a, b, near, far;
};
std::array<Outward, 2> outwards(const Axis& x) {
  return {Outward{-x.a.lo, -x.b.lo, -x.t.hi, -x.t.lo}, Outward{x.a.hi, x.b.hi, x.t.lo, x.t.hi}};
}

/// The paper's test in integers: extent box, then the plane of every two faces on which different boxes are
/// extreme.
Category by_planes(const Axis& x, const Axis& y, const Axis& z) {
  const std::array<std::array<Outward, 2>, 3> sides{outwards(x), outwards(y), outwards(z)};
  bool inside = true;
  for (const auto& pair : sides) {
    for (const Outward& side : pair) {
      if (side.near > std::max(side.a, side.b)) return Category::outside;
      inside &= side.far <= std::max(side.a, side.b);
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i == j) continue;
      for (const Outward& f : sides[static_cast<std::size_t>(i)]) {
        for (const Outward& g : sides[static_cast<std::size_t>(j)]) {
          if (!(f.a > f.b && g.b > g.a)) continue;
          if ((g.b - g.a) * (f.near - f.a) + (f.a - f.b) * (g.near - g.a) > 0) return Category::outside;
          inside &= (g.b - g.a) * (f.far - f.a) + (f.a - f.b) * (g.far - g.a) <= 0;
        }
      }
    }
  }
  return inside ? Category::inside : Category::overlap;
}

/// Runs job(0), ..., job(count - 1) on all cores.
template <class Job>
void in_parallel(std::size_t count, const Job& job) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < count; k = next++) job(k);
    });
  }
}

struct Counts {
  std::array<std::atomic<std::uint64_t>, 3> of{};
  std::atomic<std::uint64_t> wrong = 0;

  void add(const std::array<std::uint64_t, 3>& some, std::uint64_t mistakes) {
    for (std::size_t i = 0; i < 3; ++i) of[i] += some[i];
    wrong += mistakes;
  }
  [[nodiscard]] std::uint64_t total() const { return of[0] + of[1] + of[2]; }
  void print(const char* what) const {
    std::cout << what << ": " << total() << " cases: " << of[0] << " outside, " << of[1] << " overlap, "
              << of[2] << " inside; " << wrong << " wrong\n";
  }
};

/// Mirror images of an axis (x -> 3 - x) are one case, and so are permutations of the axes: neither formula
/// can tell them apart. (By symmetry of the formulas above, which treat all sides and axes alike. The code
/// gets no such benefit below.)
TEST(ProofsExhaustive, PlanesAnswerEveryBoxOfTheGridRight) {
  constexpr int kLargest = 3;
  std::vector<Axis> axes;
  for (const Interval a : intervals(kLargest)) {
    for (const Interval b : intervals(kLargest)) {
      for (const Interval t : intervals(kLargest)) {
        const std::array<int, 6> as_is{a.lo, a.hi, b.lo, b.hi, t.lo, t.hi};
        const std::array<int, 6> mirrored{kLargest - a.hi, kLargest - a.lo, kLargest - b.hi,
                                          kLargest - b.lo, kLargest - t.hi, kLargest - t.lo};
        if (mirrored < as_is) continue;
        axes.push_back(axis_of(a, b, t));
        axes.back().weight = mirrored == as_is ? 1 : 2;
      }
    }
  }

  Counts counts;
  in_parallel(axes.size(), [&](std::size_t i) {
    std::array<std::uint64_t, 3> seen{};
    std::uint64_t wrong = 0;
    for (std::size_t j = i; j < axes.size(); ++j) {
      for (std::size_t k = j; k < axes.size(); ++k) {
        const std::uint64_t orders = i == j && j == k ? 1 : i == j || j == k ? 3 : 6;
        const std::uint64_t weight = orders * axes[i].weight * axes[j].weight * axes[k].weight;
        const Category right = truth(axes[i], axes[j], axes[k]);
        seen[static_cast<std::size_t>(right)] += weight;
        if (by_planes(axes[i], axes[j], axes[k]) != right) wrong += weight;
      }
    }
    counts.add(seen, wrong);
  });
  counts.print("planes in integers, coordinates 0..3");
  EXPECT_EQ(counts.total(), 1'000'000'000U);
  EXPECT_EQ(counts.wrong, 0U);
}

/// The code on every triple of boxes, without any symmetry. Floats compute exactly with numbers this small.
void run_the_code(int largest) {
  const std::vector<Interval> all = intervals(largest);
  const std::size_t n = all.size();
  std::vector<Axis> axes;  // index (a n + b) n + t
  for (const Interval a : all)
    for (const Interval b : all)
      for (const Interval t : all) axes.push_back(axis_of(a, b, t));
  const auto box = [&](std::size_t x, std::size_t y, std::size_t z) {
    Box<float> result;
    const std::array<Interval, 3> sides{all[x], all[y], all[z]};
    for (int axis = 0; axis < 3; ++axis) {
      result.lo(axis) = static_cast<float>(sides[static_cast<std::size_t>(axis)].lo);
      result.hi(axis) = static_cast<float>(sides[static_cast<std::size_t>(axis)].hi);
    }
    return result;
  };

  Counts counts;
  const std::size_t boxes = n * n * n;
  in_parallel(boxes, [&](std::size_t ia) {
    std::array<std::uint64_t, 3> seen{};
    std::uint64_t wrong = 0;
    const std::size_t ax = ia / (n * n), ay = ia / n % n, az = ia % n;
    const Box<float> a = box(ax, ay, az);
    for (std::size_t ib = 0; ib < boxes; ++ib) {
      const std::size_t bx = ib / (n * n), by = ib / n % n, bz = ib % n;
      const Shaft<float> shaft = form_shaft(a, box(bx, by, bz), fast::Normals::as_formed);
      for (std::size_t it = 0; it < boxes; ++it) {
        const std::size_t tx = it / (n * n), ty = it / n % n, tz = it % n;
        const Category right =
            truth(axes[(ax * n + bx) * n + tx], axes[(ay * n + by) * n + ty], axes[(az * n + bz) * n + tz]);
        ++seen[static_cast<std::size_t>(right)];
        wrong += classify(shaft, box(tx, ty, tz)).answer != right;
      }
    }
    counts.add(seen, wrong);
  });
  counts.print("the code in float32");
  EXPECT_EQ(counts.total(), static_cast<std::uint64_t>(boxes) * boxes * boxes);
  EXPECT_EQ(counts.wrong, 0U);
}

TEST(ProofsExhaustive, CodeAnswersEveryBoxOfTheSmallGridRight) {
  run_the_code(2);
}

TEST(ProofsExhaustive, CodeAnswersEveryBoxOfTheLargeGridRight) {
  if (std::getenv("GNOMON_EXHAUSTIVE") == nullptr) GTEST_SKIP() << "set GNOMON_EXHAUSTIVE=1";
  run_the_code(3);
}

/// On each of the six faces a, b or neither reaches farther, and nothing else decides how many planes there
/// are: 3^6 shafts stand for all (claims S3 and S4; the same enumeration is done in proofs/PlaneCount.v by
/// Coq's kernel).
TEST(ProofsExhaustive, EveryOrderOfFacesHasTheProvedNumberOfPlanes) {
  std::map<int, int> without_ties, with_ties;
  for (int pattern = 0; pattern < 729; ++pattern) {
    Box<float> a, b;
    bool tie = false, a_within_b = true, b_within_a = true;
    std::array<bool, 3> equal{true, true, true};
    int rest = pattern;
    for (std::size_t face = 0; face < 6; ++face, rest /= 3) {
      const int farther = rest % 3;  // 0: a, 1: b, 2: neither
      const float sign = face >= 3 ? 1.0F : -1.0F;
      a.c[face] = sign * (farther == 0 ? 2.0F : 1.0F);
      b.c[face] = sign * (farther == 1 ? 2.0F : 1.0F);
      tie |= farther == 2;
      a_within_b &= farther != 0;
      b_within_a &= farther != 1;
      equal[face % 3] = equal[face % 3] && farther == 2;
    }
    const int planes = form_shaft(a, b, fast::Normals::as_formed).plane_count;
    ++(tie ? with_ties : without_ties)[planes];
    const bool equal_on_two_axes = equal[0] + equal[1] + equal[2] >= 2;
    EXPECT_EQ(planes == 0, a_within_b || b_within_a || equal_on_two_axes) << "pattern " << pattern;
  }
  EXPECT_EQ(without_ties, (std::map<int, int>{{0, 2}, {4, 12}, {6, 32}, {8, 18}}));
  EXPECT_EQ(with_ties,
            (std::map<int, int>{{0, 131}, {1, 72}, {2, 156}, {3, 144}, {4, 90}, {5, 48}, {6, 24}}));
}

}  // namespace
}  // namespace gnomon::tests
