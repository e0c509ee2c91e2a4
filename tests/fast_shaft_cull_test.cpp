// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point cull tests of boxes and balls: by hand, on small integers where floats are exact, and
// the errata of print.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "fast/box_relation.h"
#include "fast/certified_shaft.h"
#include "fast/shaft_ball.h"
#include "fast/shaft_box.h"
#include "fast/slab_ball.h"
#include "fast/slab_box.h"
#include "tests/shaft_generator.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using fast::Normals;
using fast::Shaft;
using scene::Ball;
using scene::Box;
using scene::Category;

/// Two unit cubes, diagonal in x and y: planes x - y <= 1 and y - x <= 1 over the extent box [0,5] x [0,5] x
/// [0,1].
const Box<float> kA{{0, 0, 0, 1, 1, 1}}, kB{{4, 4, 0, 5, 5, 1}};

struct BoxByHand {
  Box<float> t;
  Category answer, printed;
};

TEST(FastShaftCull, BoxesByHand) {
  const BoxByHand table[] = {
      {{{6, 0, 0, 7, 1, 1}}, Category::outside, Category::outside},  // beyond the extent box
      {{{0, 0, 2, 5, 5, 3}}, Category::outside, Category::outside},  // above it
      {{{3, 0, 0, 4, 1, 1}}, Category::outside, Category::outside},  // within it, beyond a plane
      {{{0, 3, 0, 1, 4, 1}}, Category::outside, Category::outside},  // beyond the other plane
      {{{3, 1, 0, 4, 2, 1}}, Category::overlap, Category::overlap},  // touches a plane at (3, 2)
      {{{3, 2, 0, 4, 3, 1}}, Category::overlap, Category::overlap},  // crosses the plane
      {{{2, 2, 0, 3, 3, 2}}, Category::overlap, Category::overlap},  // sticks out of the extent box
      {{{2, 2, 0, 3, 3, 1}}, Category::inside, Category::inside},    // flush with four sides
      {{{2.25f, 2.25f, 0.25f, 2.5f, 2.5f, 0.5f}}, Category::inside, Category::inside},
      {{{5, 5, 1, 6, 6, 2}}, Category::overlap, Category::overlap},     // touches at a corner
      {{{-1, -1, -1, 9, 9, 9}}, Category::overlap, Category::overlap},  // holds everything
      {{{0.25f, 0.25f, 0.25f, 0.5f, 0.5f, 0.5f}}, Category::inside, Category::overlap},  // within A: S2b
      {{{0.5f, 0.5f, 0.5f, 1.25f, 1.25f, 1}}, Category::inside, Category::overlap},      // meets A: S2b
  };
  const Shaft<float> shaft = fast::form_shaft(kA, kB, Normals::as_formed);
  for (const BoxByHand& row : table) {
    const std::string text = text_of(row.t);
    EXPECT_EQ(fast::classify(shaft, row.t).answer, row.answer) << text;
    EXPECT_TRUE(fast::classify(shaft, row.t).certain) << text;  // naive: no band, nothing undecided
    EXPECT_EQ(fast::classify_as_printed(shaft, row.t), row.printed) << text;
    EXPECT_EQ(fast::classify_by_slabs(kA, kB, row.t), row.answer) << text;
    const scene::ShaftBoxCase c{as_double(kA), as_double(kB), as_double(row.t)};
    EXPECT_EQ(exact::refer_in_rationals(c).truth, row.answer) << text;
    EXPECT_EQ(exact::refer_in_rationals(c).printed, row.printed) << text;
  }
}

struct BallByHand {
  Ball<float> t;
  Category truth, naive, printed;
};

TEST(FastShaftCull, BallsByHand) {
  const BallByHand table[] = {
      {{{7, 7, 0.5f}, 1}, Category::outside, Category::outside, Category::outside},
      {{{7, 5, 0.5f}, 2}, Category::overlap, Category::overlap, Category::overlap},  // touches B's side
      {{{4, 1, 0.5f}, 1}, Category::outside, Category::outside, Category::outside},  // beyond the plane
      {{{4, 1, 0.5f}, 1.5f}, Category::overlap, Category::overlap, Category::overlap},
      {{{2.5f, 2.5f, 0.5f}, 0.5f}, Category::inside, Category::inside, Category::overlap},  // S7: too deep
      {{{2.5f, 2.5f, 0.5f}, 0.25f}, Category::inside, Category::inside, Category::overlap},
      {{{2.5f, 2.5f, 0.5f}, 0.75f}, Category::overlap, Category::overlap, Category::overlap},  // sides
      {{{0.5f, 0.5f, 0.5f}, 0.25f}, Category::inside, Category::inside, Category::overlap},    // within A
      {{{2.5f, 2.5f, 0.5f}, 0}, Category::inside, Category::inside, Category::overlap},
      {{{2.5f, 3.75f, 0.5f}, 0.5f}, Category::overlap, Category::overlap, Category::overlap},
  };
  const Shaft<float> shaft = fast::form_shaft(kA, kB, Normals::unit);
  const Shaft<float> as_formed = fast::form_shaft(kA, kB, Normals::as_formed);
  for (const BallByHand& row : table) {
    const std::string text = text_of(scene::ShaftBallCaseOf<float>{kA, kB, row.t});
    EXPECT_EQ(fast::classify(shaft, row.t).answer, row.naive) << text;
    EXPECT_EQ(fast::classify(shaft, row.t).certain, row.naive != Category::overlap) << text;
    EXPECT_EQ(fast::classify_as_printed(shaft, row.t), row.printed) << text;
    EXPECT_EQ(fast::classify_by_slabs(as_formed, row.t), row.truth) << text;
    const scene::ShaftBallCase c = as_double(scene::ShaftBallCaseOf<float>{kA, kB, row.t});
    EXPECT_EQ(exact::refer_in_rationals(c).truth, row.truth) << text;
    EXPECT_EQ(exact::refer_in_rationals(c).printed, row.printed) << text;
  }
}

/// Claim S7, the unsound half of the erratum: printed, a ball that sticks out of every plane a little is
/// inside.
TEST(FastShaftCull, PrintedSphereTestSaysInsideOfABallThatSticksOut) {
  const Box<float> a{{0, 0, 0, 1, 9, 9}}, b{{8, 3, 0, 9, 6, 9}};  // planes past y = 0 and y = 9
  const Ball<float> t{{4.5f, 7, 4.5f}, 1.5f};
  const Box<float> wide_a{{0, 0, 0, 1, 1, 4}}, wide_b{{9, 9, 0, 10, 10, 4}};
  const Ball<float> sticks_out{{5, 5, 2}, 1.5f};
  EXPECT_EQ(fast::classify(fast::form_shaft(a, b, Normals::unit), t).answer, Category::overlap);
  const Shaft<float> shaft = fast::form_shaft(wide_a, wide_b, Normals::unit);
  EXPECT_EQ(fast::classify(shaft, sticks_out).answer, Category::overlap);
  EXPECT_EQ(fast::classify_as_printed(shaft, sticks_out), Category::inside);
  const scene::ShaftBallCase c = as_double(scene::ShaftBallCaseOf<float>{wide_a, wide_b, sticks_out});
  EXPECT_EQ(exact::classify(c), Category::overlap);
  EXPECT_EQ(exact::refer_in_rationals(c).printed, Category::inside);
}

/// Claim S6: a ball off the rounded edge between the extent box and a plane is kept; the slab test culls it.
TEST(FastShaftCull, FalsePositiveOfTheSphereTest) {
  const Ball<float> t{{6, 3.5f, 0.5f}, 1.09375f};  // nearest point of the shaft: the edge x = 5, y = 4
  const Shaft<float> unit = fast::form_shaft(kA, kB, Normals::unit);
  const Shaft<float> formed = fast::form_shaft(kA, kB, Normals::as_formed);
  EXPECT_EQ(fast::classify(unit, t).answer, Category::overlap);
  EXPECT_EQ(fast::classify_by_slabs(formed, t), Category::outside);
  EXPECT_FLOAT_EQ(fast::squared_distance_to_shaft(kA, kB, t.centre), 1.25f);
  const scene::ShaftBallCase c = as_double(scene::ShaftBallCaseOf<float>{kA, kB, t});
  EXPECT_EQ(exact::refer_in_rationals(c).truth, Category::outside);
  EXPECT_EQ(exact::refer_in_rationals(c).planes, Category::overlap);
}

/// From without, at the foot (20, 15) on the plane of normal (3, 4), well within the extent box: v > 0
/// decides.
TEST(FastShaftCull, BallTouchingAPlaneFromOutsideIsNotInside) {
  const Box<float> a{{-10, -10, 0, 40, 0, 20}}, b{{-10, -10, 0, 0, 30, 20}};
  const Ball<float> t{{23, 19, 10}, 5};
  EXPECT_EQ(fast::classify_by_slabs(fast::form_shaft(a, b, Normals::as_formed), t), Category::overlap);
  const exact::ShaftBallReference r =
      exact::refer_in_rationals(as_double(scene::ShaftBallCaseOf<float>{a, b, t}));
  EXPECT_EQ(r.truth, Category::overlap);
  EXPECT_TRUE(r.touches_outside);
  EXPECT_FALSE(r.touches_inside);
  EXPECT_EQ(exact::classify_grown(as_double(scene::ShaftBallCaseOf<float>{a, b, t}), 0), Category::overlap);
}

/// Touching at a plane, where floats can be exact: a plane made by hand, x/2 + y/2 <= 1, as if of unit
/// length.
TEST(FastShaftCull, BallsTouchingAPlaneMeetAndAreWithin) {
  Shaft<float> shaft = fast::form_shaft(kA, kB, Normals::unit);
  shaft.extent = {{-99, -99, -99, 99, 99, 99}};
  shaft.plane_count = 1;
  shaft.plane_set[0] = {0.5f, 0.5f, -1, 0, 0, 3, 4};
  const auto answer = [&](float x, float r) {
    return fast::classify(shaft, Ball<float>{{x, x, 50}, r}).answer;
  };
  const auto printed = [&](float x, float r) {
    return fast::classify_as_printed(shaft, Ball<float>{{x, x, 50}, r});
  };
  EXPECT_EQ(answer(4, 3), Category::overlap);
  EXPECT_EQ(answer(4, 2.75f), Category::outside);
  EXPECT_EQ(answer(-4, 5), Category::inside);
  EXPECT_EQ(answer(-4, 5.25f), Category::overlap);
  EXPECT_NE(printed(4, 3), Category::outside);
  EXPECT_EQ(printed(4, 2.75f), Category::outside);
  EXPECT_EQ(printed(-4, 5), Category::overlap);     // T > -radius fails at T = -radius
  EXPECT_EQ(printed(-4, 5.25f), Category::inside);  // and holds when it sticks out: the erratum
  shaft.plane_set[0].outside_threshold = 0.25f;
  shaft.plane_set[0].inside_threshold = -0.25f;
  EXPECT_EQ(answer(4, 2.75f), Category::overlap);
  EXPECT_EQ(answer(4, 2.5f), Category::outside);
  EXPECT_EQ(answer(-4, 5), Category::overlap);
  EXPECT_EQ(answer(-4, 4.75f), Category::inside);
}

TEST(FastShaftCull, ANanInAPlaneKeeps) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Box<float> beyond{{3, 0, 0, 4, 1, 1}}, within{{2, 2, 0, 3, 3, 1}};
  Shaft<float> shaft = fast::form_shaft(kA, kB, Normals::as_formed);
  EXPECT_EQ(fast::classify(shaft, beyond).answer, Category::outside);
  EXPECT_EQ(fast::classify(shaft, within).answer, Category::inside);
  for (fast::ShaftPlane<float>& plane : shaft.planes()) plane.d = nan;
  for (const Box<float>& t : {beyond, within}) {
    EXPECT_EQ(fast::classify(shaft, t).answer, Category::overlap);
    EXPECT_FALSE(fast::classify(shaft, t).certain);
    EXPECT_NE(fast::classify_as_printed(shaft, t), Category::outside);
  }
  const Ball<float> outer{{4, 1, 0.5f}, 0.5f}, inner{{2.5f, 2.5f, 0.5f}, 0.25f};
  for (const Ball<float>& t : {outer, inner}) {
    EXPECT_EQ(fast::classify(shaft, t).answer, Category::overlap);
    EXPECT_EQ(fast::classify_by_slabs(shaft, t) == Category::inside, false);
  }
}

/// Numbers that make bad input: which comparison they fail.
TEST(FastShaftCull, NanCoordinatesMeetAndHoldNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Box<float> t{{2, 2, 0, 3, 3, 1}};
  EXPECT_TRUE(fast::meets(t, t));
  EXPECT_TRUE(fast::contains(t, t));
  for (std::size_t i = 0; i < 6; ++i) {
    Box<float> bad = t;
    bad.c[i] = nan;
    EXPECT_FALSE(fast::meets(bad, t));
    EXPECT_FALSE(fast::contains(t, bad));
    EXPECT_FALSE(scene::is_valid(bad));
  }
}

TEST(FastShaftCull, BoxRelations) {
  const Box<double> box{{0, 0, 0, 2, 2, 2}};
  for (int axis = 0; axis < 3; ++axis) {
    Box<double> t = box;
    t.lo(axis) = 2;
    t.hi(axis) = 3;
    EXPECT_TRUE(fast::meets(t, box));  // touching counts
    EXPECT_TRUE(fast::meets(box, t));
    EXPECT_FALSE(fast::contains(box, t));
    t.lo(axis) = 2.5;
    EXPECT_FALSE(fast::meets(t, box));
    EXPECT_FALSE(fast::meets(box, t));
    t.lo(axis) = t.hi(axis) = 2;
    EXPECT_TRUE(fast::contains(box, t));
    t.lo(axis) = -1;
    EXPECT_FALSE(fast::contains(box, t));
  }
  EXPECT_EQ(fast::squared_distance<double>({1, 1, 2}, box), 0);
  EXPECT_EQ(fast::squared_distance<double>({5, -4, 1}, box), 25);
  EXPECT_EQ(fast::squared_distance<double>({-1, 4, 4}, box), 9);
}

}  // namespace
}  // namespace gnomon::tests
