// SPDX-License-Identifier: GPL-3.0-or-later
// fast/front_plane.h: the threshold of half-spaces, from both sides; and what planes of shafts cut off.
#include "fast/front_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/side_of_face.h"
#include "fast/shaft_cull.h"
#include "fuzz/shapes.h"
#include "tests/bound_shares.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {
namespace {

using fast::Arithmetic;
using fast::FrontPlane;

using FloatBox = scene::Box<float>;

/// What so many trials find at least; sanitized builds run fewer of them.
std::size_t least(int count) {
  return static_cast<std::size_t>(affordable(count));
}

/// What the value of the plane errs by, over its threshold, at a point; in 113 bits.
double share_of_threshold(const fast::FrontCorners& corners, const FrontPlane& plane,
                          const std::array<float, 3>& p) {
  std::array<Quad, 3> e1{}, e2{}, q{}, normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    e1[k] = Quad(corners[1][k]) - Quad(corners[0][k]);
    e2[k] = Quad(corners[2][k]) - Quad(corners[0][k]);
    q[k] = Quad(p[k]) - Quad(corners[0][k]);
  }
  std::size_t largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    normal[k] = e1[(k + 1) % 3] * e2[(k + 2) % 3] - e1[(k + 2) % 3] * e2[(k + 1) % 3];
    if (magnitude(normal[k]) > magnitude(normal[largest])) largest = k;
  }
  const int exponent = std::ilogb(static_cast<double>(magnitude(normal[largest])));
  const Quad exact =
      (normal[0] * q[0] + normal[1] * q[1] + normal[2] * q[2]) * Quad(std::ldexp(1.0, -exponent));
  return static_cast<double>(magnitude(Quad(plane.value(p[0], p[1], p[2])) - exact) / Quad(plane.threshold));
}

/// Corners and points near their plane: floats about 1 of all precisions, slivers among them.
std::array<float, 3> plane_point(Random& random, const fast::FrontCorners& corners) {
  const double u = random.unit() * 3 - 1, v = random.unit() * 3 - 1;
  std::array<float, 3> p{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = static_cast<double>(corners[0][k]);
    p[k] = static_cast<float>(a + u * (static_cast<double>(corners[1][k]) - a) +
                              v * (static_cast<double>(corners[2][k]) - a));
    if (random.chance(20)) p[k] = fuzz::step_ulps(p[k], random.between(-2, 2));
  }
  return p;
}

FloatBox box_at(const std::array<float, 3>& p) {
  return {{p[0], p[1], p[2], p[0], p[1], p[2]}};
}

TEST(FrontPlane, CertifiedPlanesNeverCallWhatIsInFrontBehindAndAreNotMuchTooCareful) {
  Random random(7);
  double most = 0;
  std::size_t wrong = 0, culled = 0, near = 0;
  for (int trial = 0; trial < affordable(60000); ++trial) {
    fast::FrontCorners corners;
    const double size = std::ldexp(1.0, -random.below(24)),
                 offset = random.chance(50) ? random.unit() * 8 : 0;
    for (auto& corner : corners) {
      for (float& x : corner) x = static_cast<float>(offset + size * (random.unit() * 2 - 1));
    }
    if (random.chance(10)) corners[0][1] = corners[1][1] = corners[2][1];
    const std::array<float, 3> p = plane_point(random, corners);
    const FloatBox box = box_at(p);
    FloatBox region = box;
    for (std::size_t k = 0; k < 3; ++k) {
      if (random.chance(50)) region.c[k] = std::min(-p[k], p[k]);
    }
    const FrontPlane plane = fast::form_front_plane(corners, region, Arithmetic::certified);
    const FrontPlane naive = fast::form_front_plane(corners, region, Arithmetic::naive);
    std::array<std::array<double, 3>, 3> exact_corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k) exact_corners[c][k] = static_cast<double>(corners[c][k]);
    }
    const int side = exact::side_of_face(
        exact_corners, {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    if (side > 0) {
      EXPECT_FALSE(plane.none_in_front(box));
    }
    if (side < 0) {
      EXPECT_FALSE(plane.none_behind(box));
    }
    wrong += side > 0 && naive.none_in_front(box);
    culled += plane.none_in_front(box);
    near += plane.none_in_front(box) && naive.none_in_front(box);
    if (plane.threshold > 0) most = std::max(most, share_of_threshold(corners, plane, p));
  }
  EXPECT_GT(wrong, least(100));   // naive planes do err on these
  EXPECT_GT(culled, least(100));  // and certified ones still cull
  EXPECT_EQ(culled, near);
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.15);  // what the bound gives away
}

TEST(FrontPlane, AcrossAnAxisTheTestIsExactAndDegeneratePlanesSayNothing) {
  const FloatBox region{{-9, -9, -9, 9, 9, 9}};
  const float z = 0.1F;
  const fast::FrontCorners up{{{0, 0, z}, {1, 0, z}, {0, 1, z}}}, down{{{0, 0, z}, {0, 1, z}, {1, 0, z}}};
  const float above = std::nextafter(z, 1.0F), below = std::nextafter(z, 0.0F);
  for (const Arithmetic arithmetic : {Arithmetic::naive, Arithmetic::certified}) {
    const FrontPlane plane = fast::form_front_plane(up, region, arithmetic);
    EXPECT_TRUE(plane.none_in_front({{-9, -9, -9, 9, 9, z}}));
    EXPECT_FALSE(plane.none_in_front({{-9, -9, -9, 9, 9, above}}));
    EXPECT_TRUE(plane.none_behind({{-9, -9, z, 9, 9, 9}}));
    EXPECT_FALSE(plane.none_behind({{-9, -9, below, 9, 9, 9}}));
    const FrontPlane turned = fast::form_front_plane(down, region, arithmetic);
    EXPECT_TRUE(turned.none_in_front({{-9, -9, z, 9, 9, 9}}));
    EXPECT_FALSE(turned.none_in_front({{-9, -9, below, 9, 9, 9}}));
    const FrontPlane line = fast::form_front_plane({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, region, arithmetic);
    EXPECT_FALSE(line.none_in_front(region));
    EXPECT_FALSE(line.none_behind(region));
    EXPECT_FALSE(line.none_in_front(box_at({5, 5, 5})));
  }
  // Where values may overflow, certified planes say nothing.
  constexpr float kMost = std::numeric_limits<float>::max();
  const FrontPlane far = fast::form_front_plane({{{0, 0, 0}, {1, 0, 1}, {0, 1, 0}}},
                                                {{-kMost, 0, 0, kMost, 0, 0}}, Arithmetic::certified);
  EXPECT_FALSE(far.none_in_front(box_at({1, 0, 0})));
}

// Against the share of a fine lattice of points in the extent box that lie outside of the plane.
TEST(ShaftCull, ShareCutOffIsThatOfTheExtentBox) {
  Random random(8);
  int planes = 0;
  for (int trial = 0; trial < 60; ++trial) {
    FloatBox a, b;
    for (FloatBox* box : {&a, &b}) {
      for (int axis = 0; axis < 3; ++axis) {
        box->lo(axis) = static_cast<float>(random.below(8));
        box->hi(axis) = box->lo(axis) + static_cast<float>(random.below(5));
      }
    }
    const fast::Shaft<float> shaft = fast::form_shaft(a, b, fast::Normals::as_formed);
    for (const fast::ShaftPlane<float>& plane : shaft.planes()) {
      ++planes;
      const int axis0 = fast::axis_of(plane.far0), axis1 = fast::axis_of(plane.far1);
      constexpr int kCells = 200;
      int outside = 0;
      for (int i = 0; i < kCells * kCells; ++i) {
        const auto at = [&](int axis, int cell) {
          const float share = (static_cast<float>(cell) + 0.5F) / kCells;
          return shaft.extent.lo(axis) + share * (shaft.extent.hi(axis) - shaft.extent.lo(axis));
        };
        outside += plane.value(at(axis0, i / kCells), at(axis1, i % kCells)) > 0;
      }
      EXPECT_NEAR(fast::share_cut_off(shaft, plane), static_cast<float>(outside) / (kCells * kCells), 0.01F);
    }
  }
  EXPECT_GT(planes, 200);
  EXPECT_EQ(fast::shrunk({{0, 2, 4, 1, 2, 8}}, 0.25F), (FloatBox{{0.25F, 2, 5, 0.75F, 2, 7}}));
}

}  // namespace
}  // namespace gnomon::tests
