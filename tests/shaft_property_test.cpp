// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of shaft answers without asking a reference: symmetries, monotony, convexity.
#include <gtest/gtest.h>

#include <array>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "fast/certified_shaft.h"
#include "fast/shaft_ball.h"
#include "fast/shaft_box.h"
#include "fast/slab_ball.h"
#include "fast/slab_box.h"
#include "tests/shaft_property.h"

namespace gnomon::tests {
namespace {

using fast::Normals;
using scene::Box;
using scene::Category;
using scene::ShaftBallCase;
using scene::ShaftBoxCase;

using FloatBoxCase = scene::ShaftBoxCaseOf<float>;
using FloatBallCase = scene::ShaftBallCaseOf<float>;

/// Sends a coordinate x on an axis to sign * x * scale + shift on another axis.
struct AxisMap {
  std::array<int, 3> to{0, 1, 2};
  std::array<bool, 3> mirrored{};
  double scale = 1;
  std::array<double, 3> shift{};

  template <class F>
  [[nodiscard]] F map(F x, std::size_t axis) const {
    return static_cast<F>((mirrored[axis] ? -1 : 1) * static_cast<double>(x) * scale + shift[axis]);
  }
  template <class F>
  [[nodiscard]] Box<F> operator()(const Box<F>& box) const {
    Box<F> mapped;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const F lo = map(box.c[axis], axis), hi = map(box.c[axis + 3], axis);
      mapped.lo(to[axis]) = std::min(lo, hi);
      mapped.hi(to[axis]) = std::max(lo, hi);
    }
    return mapped;
  }
  template <class F>
  [[nodiscard]] scene::Ball<F> operator()(const scene::Ball<F>& ball) const {
    scene::Ball<F> mapped;
    for (std::size_t axis = 0; axis < 3; ++axis)
      mapped.centre[static_cast<std::size_t>(to[axis])] = map(ball.centre[axis], axis);
    mapped.radius = static_cast<F>(static_cast<double>(ball.radius) * scale);
    return mapped;
  }
  template <class Case>
  [[nodiscard]] Case of(const Case& c) const {
    return {(*this)(c.a), (*this)(c.b), (*this)(c.t)};
  }
};

rc::Gen<AxisMap> turns() {
  return rc::gen::exec([] {
    AxisMap turn;
    const std::array<std::array<int, 3>, 6> orders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    turn.to = orders[static_cast<std::size_t>(*in_range(0, 6))];
    for (bool& mirrored : turn.mirrored) mirrored = *in_range(0, 2) == 1;
    return turn;
  });
}

template <class Case>
void same_exact_answers(const Case& c, const Case& d) {
  const auto r = exact::refer_in_rationals(c), q = exact::refer_in_rationals(d);
  RC_ASSERT(r.truth == q.truth);
  RC_ASSERT(r.planes == q.planes);
  RC_ASSERT(r.printed == q.printed);
  RC_ASSERT(r.touches_outside == q.touches_outside);
  RC_ASSERT(r.touches_inside == q.touches_inside);
  RC_ASSERT(exact::classify(c) == exact::classify(d));
}

/// Guards against properties that hold of nothing: the generators meet every class.
TEST(ShaftProperty, GeneratorsReachEveryClass) {
  std::array<int, 5> boxes{}, balls{};
  const auto count = [](std::array<int, 5>& counts, const auto& r) {
    ++counts[static_cast<std::size_t>(r.truth)];
    counts[3] += r.touches_outside;
    counts[4] += r.touches_inside;
  };
  hold(5000, [&] {
    count(boxes, exact::refer_in_rationals(*box_cases<double>()));
    count(balls, exact::refer_in_rationals(*ball_cases<double>()));
  });
  for (std::size_t i = 0; i < 5; ++i) {
    RecordProperty("boxes_" + std::to_string(i), boxes[i]);
    RecordProperty("balls_" + std::to_string(i), balls[i]);
    EXPECT_GE(boxes[i], affordable(60)) << i;
    EXPECT_GE(balls[i], affordable(60)) << i;
  }
}

TEST(ShaftProperty, BoxesSwappedAnswersKept) {
  hold(3000, [] {
    const ShaftBoxCase c = *box_cases<double>();
    same_exact_answers(c, ShaftBoxCase{c.b, c.a, c.t});
    const ShaftBallCase d = *ball_cases<double>();
    same_exact_answers(d, ShaftBallCase{d.b, d.a, d.t});
  });
}

TEST(ShaftProperty, CertifiedAnswersNeverContradictThoseOfSwappedBoxes) {
  hold(4000, [] {
    const FloatBoxCase c = *box_cases<float>();
    const fast::Banded p = fast::classify(fast::form_certified_box_shaft(c.a, c.b), c.t);
    const fast::Banded q = fast::classify(fast::form_certified_box_shaft(c.b, c.a), c.t);
    RC_ASSERT(!p.certain || !q.certain || p.answer == q.answer);
    const FloatBallCase d = *ball_cases<float>();
    const fast::Banded s = fast::classify(fast::form_certified_ball_shaft(d.a, d.b), d.t);
    const fast::Banded t = fast::classify(fast::form_certified_ball_shaft(d.b, d.a), d.t);
    RC_ASSERT(!s.certain || !t.certain || s.answer == t.answer);
  });
}

TEST(ShaftProperty, AxesTurnedAndMirroredAnswersKept) {
  hold(3000, [] {
    const AxisMap turn = *turns();
    const ShaftBoxCase c = *box_cases<double>();
    same_exact_answers(c, turn.of(c));
    const ShaftBallCase d = *ball_cases<double>();
    same_exact_answers(d, turn.of(d));
  });
}

TEST(ShaftProperty, ScaledByAPowerOfTwoAnswersKept) {
  hold(5000, [] {
    AxisMap scaling;
    scaling.scale = std::ldexp(1.0, *in_range(-9, 10));
    const FloatBoxCase c = *box_cases<float>(), scaled = scaling.of(c);
    same_exact_answers(as_double(c), as_double(scaled));
    // Nothing under- or overflows here, so single precision answers bit for bit the same.
    for (const Normals normals : {Normals::as_formed, Normals::unit}) {
      const fast::Shaft<float> p = fast::form_shaft(c.a, c.b, normals);
      const fast::Shaft<float> q = fast::form_shaft(scaled.a, scaled.b, normals);
      RC_ASSERT(fast::classify(p, c.t).answer == fast::classify(q, scaled.t).answer);
      RC_ASSERT(fast::classify_as_printed(p, c.t) == fast::classify_as_printed(q, scaled.t));
    }
    RC_ASSERT(fast::classify_by_slabs(c.a, c.b, c.t) ==
              fast::classify_by_slabs(scaled.a, scaled.b, scaled.t));
  });
}

TEST(ShaftProperty, ScaledBallsByAPowerOfTwoAnswersKept) {
  hold(5000, [] {
    AxisMap scaling;
    scaling.scale = std::ldexp(1.0, *in_range(-9, 10));
    const FloatBallCase c = *ball_cases<float>(3), scaled = scaling.of(c);
    same_exact_answers(as_double(c), as_double(scaled));
    const fast::Shaft<float> p = fast::form_shaft(c.a, c.b, Normals::unit);
    const fast::Shaft<float> q = fast::form_shaft(scaled.a, scaled.b, Normals::unit);
    RC_ASSERT(fast::classify(p, c.t).answer == fast::classify(q, scaled.t).answer);
    RC_ASSERT(fast::classify_as_printed(p, c.t) == fast::classify_as_printed(q, scaled.t));
  });
}

TEST(ShaftProperty, MovedExactlyAnswersKept) {
  hold(3000, [] {
    AxisMap move;
    for (double& x : move.shift) x = *in_range(-1000000, 1000001) / 64.0;
    const ShaftBoxCase c = *box_cases<double>(2);  // dyadic numbers: the sums are exact
    same_exact_answers(c, move.of(c));
    const ShaftBallCase d = *ball_cases<double>(2);
    same_exact_answers(d, move.of(d));
  });
}

/// A larger box is outside or a subset only where a smaller one is.
TEST(ShaftProperty, MonotoneInTheBox) {
  hold(5000, [] {
    const ShaftBoxCase c = *box_cases<double>();
    ShaftBoxCase larger = c;
    for (int axis = 0; axis < 3; ++axis) {
      larger.t.lo(axis) -= *in_range(0, 4) / 8.0;
      larger.t.hi(axis) += *in_range(0, 4) / 8.0;
    }
    const Category small = exact::classify(c), large = exact::classify(larger);
    RC_ASSERT(large != Category::outside || small == Category::outside);
    RC_ASSERT(large != Category::inside || small == Category::inside);
    if (exact::gap(c, exact::Boundary::inside) <= 0) {
      RC_ASSERT(exact::gap(c, exact::Boundary::outside) <= 0);
    }
  });
}

TEST(ShaftProperty, MonotoneInTheRadius) {
  hold(5000, [] {
    const ShaftBallCase c = *ball_cases<double>();
    ShaftBallCase larger = c;
    larger.t.radius += *in_range(0, 64) / 32.0;
    const exact::ShaftBallReference small = exact::refer_in_rationals(c),
                                    large = exact::refer_in_rationals(larger);
    for (const auto& [s, l] : {std::pair{small.truth, large.truth}, std::pair{small.planes, large.planes}}) {
      RC_ASSERT(l != Category::outside || s == Category::outside);
      RC_ASSERT(l != Category::inside || s == Category::inside);
    }
  });
}

TEST(ShaftProperty, SlabsArePlanesInExactArithmetic) {
  hold(5000, [] {
    const exact::ShaftBoxReference r = exact::refer_in_rationals(*box_cases<double>());
    RC_ASSERT(r.truth == r.planes);
  });
}

TEST(ShaftProperty, BallOfRadiusZeroIsAPoint) {
  hold(3000, [] {
    const ShaftBallCase c = *ball_cases<double>();
    const auto& p = c.t.centre;
    const exact::ShaftBallReference ball = exact::refer_in_rationals(ShaftBallCase{c.a, c.b, {p, 0}});
    const exact::ShaftBoxReference box =
        exact::refer_in_rationals(ShaftBoxCase{c.a, c.b, {{p[0], p[1], p[2], p[0], p[1], p[2]}}});
    RC_ASSERT(ball.truth == box.truth);
    RC_ASSERT(ball.planes == box.planes);
    RC_ASSERT(ball.touches_outside == box.touches_outside);
    RC_ASSERT(ball.touches_inside == box.touches_inside);
  });
}

std::array<double, 3> point_of(const Box<double>& box) {
  std::array<double, 3> p{};
  for (int axis = 0; axis < 3; ++axis) {
    const double s = *in_range(0, 5) / 4.0;
    p[static_cast<std::size_t>(axis)] = (1 - s) * box.lo(axis) + s * box.hi(axis);
  }
  return p;
}

/// Claim S1, and that nothing less will do: the points of segments between the boxes are the shaft.
TEST(ShaftProperty, SegmentsBetweenTheBoxesLieInTheShaft) {
  hold(5000, [] {
    const ShaftBoxCase c = *box_cases<double>(2);  // quarters and eighths of dyadic numbers are exact
    const std::array<double, 3> p = point_of(c.a), q = point_of(c.b);
    const double s = *in_range(0, 9) / 8.0;
    ShaftBoxCase point = c;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t i = static_cast<std::size_t>(axis);
      point.t.lo(axis) = point.t.hi(axis) = (1 - s) * p[i] + s * q[i];
    }
    RC_ASSERT(exact::classify(point) == Category::inside);
    const std::array<double, 3> on{point.t.lo(0), point.t.lo(1), point.t.lo(2)};
    RC_ASSERT(exact::classify(ShaftBallCase{c.a, c.b, {on, 0}}) == Category::inside);
    RC_ASSERT(exact::classify(ShaftBallCase{c.a, c.b, {on, 1}}) != Category::outside);
    // What holds the point meets the shaft, and certified tests never cull it.
    const Box<float> a{{float(c.a.c[0]), float(c.a.c[1]), float(c.a.c[2]), float(c.a.c[3]), float(c.a.c[4]),
                        float(c.a.c[5])}};
    const Box<float> b{{float(c.b.c[0]), float(c.b.c[1]), float(c.b.c[2]), float(c.b.c[3]), float(c.b.c[4]),
                        float(c.b.c[5])}};
    const std::array<float, 3> at{float(on[0]), float(on[1]), float(on[2])};  // dyadic: exact in floats too
    const Box<float> t{{at[0], at[1], at[2], at[0] + 1, at[1] + 1, at[2] + 1}};
    RC_ASSERT(fast::classify(fast::form_certified_box_shaft(a, b), t).answer != Category::outside);
    RC_ASSERT(fast::classify(fast::form_certified_ball_shaft(a, b), {at, 0}).answer != Category::outside);
  });
}

/// Claim S10: what overlaps a reference box overlaps the shaft.
TEST(ShaftProperty, WhatMeetsAReferenceBoxIsNotOutside) {
  hold(5000, [] {
    ShaftBoxCase c = *box_cases<double>();
    const Box<double>& one = *in_range(0, 2) == 0 ? c.a : c.b;
    for (int axis = 0; axis < 3; ++axis) {  // stretch t until it touches one of them
      c.t.lo(axis) = std::min(c.t.lo(axis), one.hi(axis));
      c.t.hi(axis) = std::max(c.t.hi(axis), one.lo(axis));
    }
    const exact::ShaftBoxReference r = exact::refer_in_rationals(c);
    RC_ASSERT(r.truth != Category::outside);
    RC_ASSERT(r.planes != Category::outside);
    RC_ASSERT(r.printed == Category::overlap);
  });
}

/// The box around a ball bounds what the ball can be.
TEST(ShaftProperty, ABallIsAtMostItsBox) {
  hold(5000, [] {
    const ShaftBallCase c = *ball_cases<double>(2);
    ShaftBoxCase box{c.a, c.b, {}};
    for (int axis = 0; axis < 3; ++axis) {
      box.t.lo(axis) = c.t.centre[static_cast<std::size_t>(axis)] - c.t.radius;
      box.t.hi(axis) = c.t.centre[static_cast<std::size_t>(axis)] + c.t.radius;
    }
    const Category of_box = exact::classify(box), of_ball = exact::classify(c);
    RC_ASSERT(of_box == Category::overlap || of_ball == of_box);
  });
}

}  // namespace
}  // namespace gnomon::tests
