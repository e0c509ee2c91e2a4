// SPDX-License-Identifier: MIT
// The second stage of the exact ball test; its bounds are derived in batch_ball_exact.cpp. Compiled once for
// each instruction set. Internal to that file.
#if defined(GNOMON_FAST_BATCH_BALL_STAGE2_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_BATCH_BALL_STAGE2_INL_H_
#undef GNOMON_FAST_BATCH_BALL_STAGE2_INL_H_
#else
#define GNOMON_FAST_BATCH_BALL_STAGE2_INL_H_
#endif

#include <hwy/highway.h>

#include "fast/batch_ball.h"
#include "fast/batch_error_free_inl.h"
#include "fast/batch_vector_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// As many balls as a vector of doubles holds, against one shaft.
template <class F>
class BallStage2 {
 public:
  HWY_INLINE BallStage2(const ExactBallShaft<F>& shaft, const F* const* c) : shaft_(shaft) {
    for (std::size_t axis = 0; axis < 3; ++axis) centre_[axis] = load_double(d_, c[axis]);
    radius_ = load_double(d_, c[3]);
    for (std::size_t face = 0; face < 6; ++face) {
      const VDouble side = number(shaft.a.c[face]);
      from_a_[face] =
          face < 3 ? two_difference(side, centre_[face]) : two_difference(centre_[face - 3], side);
    }
  }

  template <bool kThreeWay>
  HWY_INLINE BatchWord resolve() const {
    const std::uint64_t all = (std::uint64_t{1} << hn::Lanes(d_)) - 1;
    const Signs signs = plane_signs();
    const MDouble centre_in = hn::And(signs.known, hn::AndNot(signs.positive, within_extent()));
    Distance distance{centre_in, no_lanes(d_), hn::Zero(d_)};
    if (!hn::AllTrue(d_, centre_in)) distance = judge_distance();
    MDouble meets = hn::Or(distance.meets, centre_in);
    MDouble open = hn::Not(hn::Or(meets, distance.outside));
    if (!hn::AllFalse(d_, open)) {
      meets = hn::Or(meets, meets_exactly(distance.s));
      if (!hn::AllFalse(d_, hn::AndNot(meets, open))) meets = hn::Or(meets, meets_at_rational(distance.s));
      open = hn::AndNot(meets, open);
    }
    BatchWord answers;
    answers.kept = all & ~bits_of(d_, distance.outside);
    answers.open = all & bits_of(d_, open);
    if (!kThreeWay || answers.kept == 0) return answers;
    // What is inside meets. Once the ball is surely not inside, only the distance can be open.
    const Inside inside = judge_inside(signs);
    answers.inside = answers.kept & bits_of(d_, inside.surely);
    answers.open = (answers.open & ~answers.inside) | (answers.kept & bits_of(d_, inside.open));
    return answers;
  }

 private:
  const Doubles d_{};
  const ExactBallShaft<F>& shaft_;
  VDouble centre_[3], radius_;
  TwoDoubles
      from_a_[6];  ///< p: how far the centre is from the sides of a, positive beyond lower and upper ones

  HWY_INLINE VDouble number(F x) const { return hn::Set(d_, static_cast<double>(x)); }
  HWY_INLINE VDouble constant(double x) const { return hn::Set(d_, x); }

  /// max(0, p + q s)
  HWY_INLINE VDouble beyond(std::size_t face, VDouble s) const {
    const VDouble moved = hn::Mul(constant(shaft_.runs[face].q), s);
    return hn::Max(hn::Add(from_a_[face].high, moved), hn::Zero(d_));
  }

  /// About the s in [0, 1] with the least distance: the slope, which rises with s, is evaluated at every
  /// kink; the piece between the last kink where it falls and the first where it rises holds the minimum.
  /// Nothing depends on how good it is but how often the certificates work.
  HWY_INLINE VDouble minimiser() const {
    const VDouble zero = hn::Zero(d_), one = constant(1);
    VDouble left = zero, right = one;
    for (std::size_t kink = 0; kink < 6; ++kink) {
      const auto& run = shaft_.runs[kink];
      if (run.inverse == 0) continue;
      VDouble s = hn::Mul(from_a_[kink].high, constant(-run.inverse));
      s = hn::Min(hn::Max(s, zero), one);
      VDouble slope = zero;
      for (std::size_t face = 0; face < 6; ++face) {
        if (shaft_.runs[face].q == 0) continue;
        slope = hn::Add(slope, hn::Mul(beyond(face, s), constant(shaft_.runs[face].q)));
      }
      const MDouble falls = hn::Le(slope, zero);
      left = hn::IfThenElse(falls, hn::Max(left, s), left);
      right = hn::IfThenElse(falls, right, hn::Min(right, s));
    }
    right = hn::Max(left, right);
    const VDouble middle = hn::Mul(hn::Add(left, right), constant(0.5));
    VDouble pq = zero, qq = zero;
    for (std::size_t face = 0; face < 6; ++face) {
      const VDouble q = constant(shaft_.runs[face].q);
      const MDouble active = hn::Gt(hn::Add(from_a_[face].high, hn::Mul(q, middle)), zero);
      pq = hn::Add(pq, hn::IfThenElseZero(active, hn::Mul(from_a_[face].high, q)));
      qq = hn::Add(qq, hn::IfThenElseZero(active, hn::Mul(q, q)));
    }
    const VDouble s = hn::Div(hn::Sub(zero, pq), qq);
    return hn::IfThenElse(hn::Gt(qq, zero), hn::Min(hn::Max(s, left), right), left);
  }

  struct Distance {
    MDouble meets, outside;
    VDouble s;
  };

  HWY_INLINE Distance judge_distance() const {
    constexpr double u = Rounding<double>::u;
    const VDouble zero = hn::Zero(d_), s = minimiser();
    VDouble squares = zero, products = zero, sizes = zero, beyond_a = zero, beyond_b = zero;
    for (std::size_t face = 0; face < 6; ++face) {
      const VDouble t = beyond(face, s), p = from_a_[face].high;
      const VDouble size = hn::Add(hn::Abs(p), hn::Abs(constant(shaft_.runs[face].q)));
      const VDouble side_b = number(shaft_.b.c[face]);
      const VDouble from_b = face < 3 ? hn::Sub(side_b, centre_[face]) : hn::Sub(centre_[face - 3], side_b);
      squares = hn::Add(squares, hn::Mul(t, t));
      products = hn::Add(products, hn::Mul(t, size));
      sizes = hn::Add(sizes, hn::Mul(size, size));
      beyond_a = hn::Add(beyond_a, hn::Mul(t, p));
      beyond_b = hn::Add(beyond_b, hn::Mul(t, from_b));
    }
    // The factors are a little more than derived, for the rounding of these sums themselves.
    const VDouble slack =
        hn::Add(hn::Add(hn::Mul(products, constant(13 * u)), hn::Mul(sizes, constant(30 * u * u))),
                constant(0x1p-1000));
    const VDouble square = hn::Mul(hn::Mul(radius_, radius_), constant(1 - 4 * u));
    const MDouble meets = hn::Lt(hn::Add(squares, slack), square);  // two infinities prove nothing

    const VDouble support = hn::Sub(hn::Min(beyond_a, beyond_b), hn::Mul(products, constant(9 * u)));
    const VDouble reach = hn::Mul(hn::Mul(radius_, hn::Sqrt(squares)), constant(1 + 16 * u));
    const MDouble outside = hn::And(hn::Gt(support, reach), hn::Ge(squares, constant(0x1p-900)));
    return {meets, outside, s};
  }

  /// The distance at s is at most r, everything computed without error: ties with faces, edges and corners
  /// that don't move, or at s = 0 and 1.
  HWY_INLINE MDouble meets_exactly(VDouble s) const {
    const VDouble zero = hn::Zero(d_);
    const MDouble at_a = hn::Eq(s, zero), at_b = hn::Eq(s, constant(1));
    MDouble exact = hn::Eq(zero, zero);
    VDouble sum = zero;
    for (std::size_t face = 0; face < 6; ++face) {
      const auto& run = shaft_.runs[face];
      const VDouble side_b = number(shaft_.b.c[face]);
      const TwoDoubles from_b =
          face < 3 ? two_difference(side_b, centre_[face]) : two_difference(centre_[face - 3], side_b);
      const VDouble p = from_a_[face].high, moved = hn::Add(p, hn::Mul(constant(run.q), s));
      VDouble t = hn::IfThenElse(at_a, p, hn::IfThenElse(at_b, from_b.high, moved));
      const VDouble low = hn::IfThenElse(at_b, from_b.low, from_a_[face].low);
      MDouble known = hn::Eq(low, zero);
      if (run.q != 0 || !run.is_exact) known = hn::And(known, hn::Or(at_a, at_b));
      const VDouble size = hn::Add(hn::Abs(p), hn::Abs(constant(run.q)));
      const MDouble surely_behind = hn::Lt(moved, hn::Mul(size, constant(-4 * Rounding<double>::u)));
      t = hn::IfThenElseZero(hn::AndNot(surely_behind, hn::Gt(t, zero)), t);
      const TwoDoubles square = two_product(t, t);
      const TwoDoubles next = two_sum(sum, square.high);
      const MDouble no_error = hn::And(hn::Eq(square.low, zero), hn::Eq(next.low, zero));
      exact = hn::And(exact, hn::And(no_error, hn::Or(known, surely_behind)));
      exact = hn::And(exact, in_range_or_zero(t));
      sum = next.high;
    }
    const TwoDoubles square = two_product(radius_, radius_);
    exact = hn::And(exact, hn::And(hn::Eq(square.low, zero), in_range_or_zero(radius_)));
    return hn::And(exact, hn::Le(sum, square.high));
  }

  /// The distance at a rational s is at most r, everything computed without error: ties with edges and
  /// planes. Let K be the sides that are not surely behind the centre near s. The sum over K of (p_k + q_k
  /// s)^2 bounds d^2 from above at every s where the others are behind; its least value is pp - pq^2 / qq, at
  /// -pq / qq, so (pp - r^2) qq <= pq^2 proves d <= r if that s is in [0, 1] and has the others behind (its
  /// rounding: another u |q_k|).
  HWY_INLINE MDouble meets_at_rational(VDouble s) const {
    const VDouble zero = hn::Zero(d_);
    TwoDoubles pp{zero, zero}, pq = pp, qq = pp;
    MDouble exact = hn::Eq(zero, zero), in_k[6];
    const auto add = [&](TwoDoubles& sum, MDouble where, VDouble a, VDouble b) {
      const TwoDoubles product = two_product(hn::IfThenElseZero(where, a), b);
      sum = two_sum(sum.high, product.high);
      exact = hn::And(exact, hn::And(hn::Eq(product.low, zero), hn::Eq(sum.low, zero)));
    };
    const auto surely_behind = [&](std::size_t face, VDouble at) {
      const VDouble p = from_a_[face].high, q = constant(shaft_.runs[face].q);
      const VDouble size = hn::Add(hn::Abs(p), hn::Abs(q));
      return hn::Lt(hn::Add(p, hn::Mul(q, at)), hn::Mul(size, constant(-8 * Rounding<double>::u)));
    };
    const auto fourth_power_fits = [&](VDouble x) {
      const VDouble size = hn::Abs(x);
      const MDouble fits = hn::And(hn::Ge(size, constant(0x1p-200)), hn::Le(size, constant(0x1p200)));
      return hn::Or(fits, hn::Eq(size, zero));
    };
    for (std::size_t face = 0; face < 6; ++face) {
      const VDouble p = from_a_[face].high, q = constant(shaft_.runs[face].q);
      in_k[face] = hn::Not(surely_behind(face, s));
      add(pp, in_k[face], p, p);
      add(pq, in_k[face], p, q);
      add(qq, in_k[face], q, q);
      MDouble known =
          hn::And(hn::Eq(from_a_[face].low, zero), hn::And(fourth_power_fits(p), fourth_power_fits(q)));
      if (!shaft_.runs[face].is_exact) known = no_lanes(d_);
      exact = hn::And(exact, hn::Or(known, hn::Not(in_k[face])));
    }
    const VDouble minus_pq = hn::Neg(pq.high);
    const VDouble least = hn::Div(minus_pq, qq.high);
    for (std::size_t face = 0; face < 6; ++face) {
      exact = hn::And(exact, hn::Or(in_k[face], surely_behind(face, least)));
    }
    exact = hn::And(exact, hn::And(hn::Ge(minus_pq, zero), hn::Le(minus_pq, qq.high)));
    exact = hn::And(exact, hn::And(hn::Gt(qq.high, zero), fourth_power_fits(radius_)));
    const TwoDoubles square = two_product(radius_, radius_);
    const TwoDoubles rest = two_difference(pp.high, square.high);
    exact = hn::And(exact, hn::And(hn::Eq(square.low, zero), hn::Eq(rest.low, zero)));
    const TwoDoubles left = two_product(rest.high, qq.high), right = two_product(pq.high, pq.high);
    const MDouble tie = hn::And(hn::Eq(left.high, right.high), hn::Le(left.low, right.low));
    return hn::And(exact, hn::Or(hn::Lt(left.high, right.high), tie));
  }

  /// The centre within the extent box; exact.
  HWY_INLINE MDouble within_extent() const {
    MDouble within = hn::Eq(radius_, radius_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const MDouble lo = hn::Ge(centre_[axis], number(shaft_.extent.c[axis]));
      const MDouble hi = hn::Le(centre_[axis], number(shaft_.extent.c[axis + 3]));
      within = hn::And(within, hn::And(lo, hi));
    }
    return within;
  }

  /// c - a on the plane's axis, from the distance to a's side.
  HWY_INLINE TwoDoubles difference(Face face) const {
    const TwoDoubles& p = from_a_[face];
    if (is_max(face)) return p;
    return {hn::Neg(p.high), hn::Neg(p.low)};
  }

  struct Signs {
    MDouble positive;  ///< some plane has the centre beyond it, for certain
    MDouble known;     ///< the signs of all planes are
  };

  HWY_INLINE Signs plane_signs() const {
    MDouble positive = no_lanes(d_), known = hn::Not(positive);
    for (std::size_t i = 0; i < shaft_.plane_count; ++i) {
      const auto& plane = shaft_.planes[i];
      const TwoDoubles x = difference(plane.far0), y = difference(plane.far1);
      const VectorSign sign = sign_of_plane(plane, x, y);
      MDouble certain = sign.certain;
      if (sizeof(F) == 8) {
        certain = hn::And(certain, hn::And(in_range_or_zero(x.high), in_range_or_zero(y.high)));
      }
      positive = hn::Or(positive, hn::And(certain, hn::Gt(sign.value, hn::Zero(d_))));
      known = hn::And(known, certain);
    }
    return {positive, known};
  }

  struct Inside {
    MDouble surely, open;
  };

  HWY_INLINE Inside judge_inside(const Signs& signs) const {
    constexpr double u = Rounding<double>::u;
    const VDouble zero = hn::Zero(d_);
    MDouble surely_not = signs.positive;
    for (std::size_t face = 0; face < 6; ++face) {
      const VDouble side = number(shaft_.extent.c[face]);
      const TwoDoubles gap =
          face < 3 ? two_difference(centre_[face], side) : two_difference(side, centre_[face - 3]);
      const MDouble tie = hn::And(hn::Eq(gap.high, radius_), hn::Lt(gap.low, zero));
      surely_not = hn::Or(surely_not, hn::Or(hn::Lt(gap.high, radius_), tie));
    }
    if (hn::AllTrue(d_, surely_not)) return {no_lanes(d_), no_lanes(d_)};
    const MDouble is_point = hn::Eq(radius_, zero);
    MDouble surely = hn::Or(signs.known, hn::Not(is_point));
    for (std::size_t i = 0; i < shaft_.plane_count; ++i) {
      const auto& plane = shaft_.planes[i];
      const VDouble n0x = hn::Mul(constant(plane.n0_high), difference(plane.far0).high);
      const VDouble n1y = hn::Mul(constant(plane.n1_high), difference(plane.far1).high);
      const VDouble depth = hn::Neg(hn::Add(n0x, n1y));
      const VDouble error =
          hn::Add(hn::Mul(hn::Add(hn::Abs(n0x), hn::Abs(n1y)), constant(7 * u)), constant(0x1p-1000));
      const VDouble reach = hn::Mul(radius_, constant(plane.length));
      const MDouble deep = hn::Ge(hn::Sub(depth, error), hn::Mul(reach, constant(1 + 10 * u)));
      const MDouble shallow = hn::Lt(hn::Add(depth, error), hn::Mul(reach, constant(1 - 10 * u)));
      surely = hn::And(surely, hn::Or(deep, is_point));
      surely_not = hn::Or(surely_not, hn::AndNot(is_point, shallow));
    }
    surely = hn::AndNot(surely_not, surely);
    return {surely, hn::Not(hn::Or(surely, surely_not))};
  }
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
