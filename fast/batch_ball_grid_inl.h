// SPDX-License-Identifier: MIT
// The exact ball test on a grid: between its first and its second stage, in the precision F. Compiled once
// for each instruction set. Internal to batch_ball_exact.cpp.
//
// All numbers are multiples of g, a power of two, and m = (digits of F - 2) / 2. The shaft's are at most
// 2^(2m-1) g, its extent box is at most 2^(m-2) g wide; the centre is within 2^m g of every side (checked).
// Hence differences of coordinates are multiples of g up to 2^m g, their products of g^2 up to 2^2m g^2, and
// three of those still fit into the digits of F: every difference, product of two differences, and sum of up
// to three such products is exact, and products of them have exact errors (sign_of_products). So is r^2 up to
// 3 2^2m g^2; a larger one is not computed as less than that, and then 3. is right to say "meets". Only s is
// rounded, and the t_k in 4. that say so.
//
// The centre lies beyond side k at s by t_k = p_k + q_k s, and beyond side k of the extent box by x_k = p_k +
// min(q_k, 0). D(s) = sum of max(t_k, 0)^2, over all real s convex with a continuous slope; at most one side
// of an axis has t_k > 0 while 0 <= s <= 1. With r^2 the ball is outside exactly when D > r^2 on [0, 1].
// 1. E = sum of max(x_k, 0)^2 > r^2: outside.
// 2. v <= 0 for every plane, and x_k <= 0 for every side with q_k != 0: by Helly some s in [0, 1] has all
//    those sides behind the centre, so D(s) consists of the sides that don't move, D(s) = E: decided by 1.
// 3. D(0) <= r^2 or D(1) <= r^2: meets. Else D'(0) >= 0 or D'(1) <= 0: outside, as D is convex.
// 4. Else D'(0) < 0 < D'(1), and the least D is at some s in (0, 1).
//    - Meets: D(s) < r^2 for some s, in floating point: the error of t_k is at most u |t_k| + u |q_k|, so the
//      root of D is at most (1 + 4 u) that of its computed value, and sqrt(3) u 2^(m-2) g. As r is 0 or at
//      least g, a value below (1 - 2^-12) r^2 proves D(s) < r^2: 2^-13 > 4 u + sqrt(3) u 2^(m-2).
//    - Let K be sides, one an axis at most, and P, Q, R the sums over K of p^2, p q and q^2. If R > 0, and
//      t_k >= 0 on K and t_k <= 0 off K at s = -Q / R, then D'(s) = 0 and D(s) = P - Q^2 / R: it is the
//      least, and compares with r^2 as (P - r^2) R does with Q^2. The sign of t_k is that of p_k R - q_k Q.
//    K is taken where Newton's method leads (and bisection where that would leave the bracket), and the lane
//    is left open when it has not found the right one.
// - Inside: -x_k >= r, v <= 0, v^2 >= r^2 |n|^2 (the definition, without a root).
#if defined(GNOMON_FAST_BATCH_BALL_GRID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_BATCH_BALL_GRID_INL_H_
#undef GNOMON_FAST_BATCH_BALL_GRID_INL_H_
#else
#define GNOMON_FAST_BATCH_BALL_GRID_INL_H_
#endif

#include <hwy/highway.h>

#include "fast/batch_ball.h"
#include "fast/batch_error_free_inl.h"
#include "fast/batch_vector_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// As many balls as a vector holds, against one shaft whose `grid` is usable.
template <class F>
class BallGridStage {
 public:
  HWY_INLINE BallGridStage(const ExactBallShaft<F>& shaft, const F* const* c) : shaft_(shaft) {
    for (std::size_t axis = 0; axis < 3; ++axis) centre_[axis] = hn::LoadU(d_, c[axis]);
    radius_ = hn::LoadU(d_, c[3]);
    square_ = hn::Mul(radius_, radius_);
  }

  template <bool kThreeWay, Effort kEffort>
  HWY_INLINE BatchWord resolve() const {
    BatchWord answers;
    const std::uint64_t all = (std::uint64_t{1} << hn::Lanes(d_)) - 1;
    const M usable = on_grid();
    answers.open = all;
    if (hn::AllFalse(d_, usable)) return answers;

    V p[6];
    for (std::size_t face = 0; face < 6; ++face) p[face] = beyond(face, shaft_.a.c[face]);
    const Within within = judge_within(p);
    const M near = hn::Le(within.square, square_), behind = hn::Le(within.moving, hn::Zero(d_));
    M meets = hn::And(near, behind), open = hn::AndNot(behind, near);
    if (!hn::AllFalse(d_, hn::And(usable, open))) {
      const Decided decided = this->template judge_distance<kEffort>(p, hn::And(usable, open));
      meets = hn::Or(meets, hn::And(open, decided.meets));
      open = hn::AndNot(hn::Or(decided.meets, decided.outside), open);
    }
    const std::uint64_t known = bits_of(d_, usable);
    answers.open = (all & ~known) | (known & bits_of(d_, open));
    answers.kept = bits_of(d_, meets);
    if (!kThreeWay) return answers;
    const M deep = hn::And(hn::And(usable, behind), hn::Le(within.nearest, hn::Neg(radius_)));
    if (!hn::AllFalse(d_, deep)) answers.inside = bits_of(d_, hn::And(deep, deep_in_planes(p)));
    return answers;
  }

 private:
  using D = hn::ScalableTag<F>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  const D d_{};
  const ExactBallShaft<F>& shaft_;
  V centre_[3], radius_, square_;

  HWY_INLINE V number(F x) const { return hn::Set(d_, x); }

  /// How far the centre lies beyond a side.
  HWY_INLINE V beyond(std::size_t face, F side) const {
    return face < 3 ? hn::Sub(number(side), centre_[face]) : hn::Sub(centre_[face - 3], number(side));
  }

  HWY_INLINE M on_grid() const {
    const auto& grid = shaft_.grid;
    // The sum's last digit is worth g: it is exact for multiples of g, and rounded for others.
    const V rounder = number(grid.rounder);
    const auto is_multiple = [&](V x) { return hn::Eq(hn::Sub(hn::Add(x, rounder), rounder), x); };
    M result = hn::And(is_multiple(radius_), hn::Ge(radius_, hn::Zero(d_)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result = hn::And(result, is_multiple(centre_[axis]));
      result = and_le(result, number(grid.range.c[axis]), centre_[axis]);
      result = and_le(result, centre_[axis], number(grid.range.c[axis + 3]));
    }
    return result;
  }

  struct Within {
    V square;   ///< E, the squared distance to the extent box
    V nearest;  ///< the largest x_k
    V moving;   ///< the largest of 0, the planes' values and x_k of sides that move
  };

  HWY_INLINE V plane_value(const typename ExactBallShaft<F>::GridPlane& plane, const V (&p)[6]) const {
    return hn::Add(hn::Mul(number(plane.n0), p[plane.far0]), hn::Mul(number(plane.n1), p[plane.far1]));
  }

  HWY_INLINE Within judge_within(const V (&p)[6]) const {
    const V zero = hn::Zero(d_);
    V square = zero, nearest = zero, moving = zero;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const V lo = beyond(axis, shaft_.extent.c[axis]), hi = beyond(axis + 3, shaft_.extent.c[axis + 3]);
      if (shaft_.grid.q[axis] != 0) moving = hn::Max(moving, lo);
      if (shaft_.grid.q[axis + 3] != 0) moving = hn::Max(moving, hi);
      const V x = hn::Max(lo, hi), apart = hn::Max(x, zero);
      nearest = axis == 0 ? x : hn::Max(nearest, x);
      square = hn::Add(square, hn::Mul(apart, apart));
    }
    for (std::size_t i = 0; i < shaft_.plane_count; ++i) {
      moving = hn::Max(moving, plane_value(shaft_.grid.planes[i], p));
    }
    return {square, nearest, moving};
  }

  struct End {
    V square, slope;  ///< D, and half of D'
  };

  HWY_INLINE End judge_end(const V (&t)[6]) const {
    const V zero = hn::Zero(d_);
    V square = zero, slope = zero;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const V lo = hn::Max(t[axis], zero), hi = hn::Max(t[axis + 3], zero);
      const V either = hn::Add(lo, hi);  // one of them is 0
      square = hn::Add(square, hn::Mul(either, either));
      slope = hn::Add(slope, hn::Mul(number(shaft_.grid.q[axis]), lo));
      slope = hn::Add(slope, hn::Mul(number(shaft_.grid.q[axis + 3]), hi));
    }
    return {square, slope};
  }

  struct Decided {
    M meets, outside;
  };

  /// Tries of Newton's method: measured, next to nothing on a grid of 8 takes more.
  static constexpr int kRounds = 6;
  static constexpr F kClearly = F(1 - 0x1p-12);

  /// Steps 3 and 4 for the lanes `wanted`; a glance tries one s, and only in floating point.
  template <Effort kEffort>
  HWY_INLINE Decided judge_distance(const V (&p)[6], M wanted) const {
    const V zero = hn::Zero(d_);
    V from_b[6];
    for (std::size_t face = 0; face < 6; ++face) from_b[face] = hn::Add(p[face], number(shaft_.grid.q[face]));
    const End at_a = judge_end(p), at_b = judge_end(from_b);
    M meets = hn::Le(hn::Min(at_a.square, at_b.square), square_);
    M outside = hn::AndNot(meets, hn::Or(hn::Ge(at_a.slope, zero), hn::Le(at_b.slope, zero)));
    const V clearly = hn::Mul(square_, number(kClearly));
    // D' is negative at left, and not at right; were it straight, it were 0 at s.
    V left = zero, right = number(1), s = hn::Div(at_a.slope, hn::Sub(at_a.slope, at_b.slope));
    for (int round = 0;; ++round) {
      const Active k = active_at(p, s);
      meets = hn::Or(meets, hn::AndNot(outside, hn::Lt(k.square, clearly)));
      if (kEffort == Effort::glance || round == kRounds) return {meets, outside};
      const Decided decided = judge_least(p, k);
      meets = hn::Or(meets, hn::AndNot(outside, decided.meets));
      outside = hn::Or(outside, hn::AndNot(meets, decided.outside));
      if (hn::AllFalse(d_, hn::AndNot(hn::Or(meets, outside), wanted))) return {meets, outside};
      const M falls = hn::Lt(hn::Add(k.pq, hn::Mul(k.qq, s)), zero);
      left = hn::IfThenElse(falls, s, left);
      right = hn::IfThenElse(falls, right, s);
      const V newton = hn::Div(hn::Neg(k.pq), k.qq);
      const M between = hn::And(hn::Lt(left, newton), hn::Lt(newton, right));
      s = hn::IfThenElse(between, newton, hn::Mul(hn::Add(left, right), number(F(0.5))));
    }
  }

  /// The sides beyond which the centre lies at a computed s, the sums over them, and about D(s).
  struct Active {
    V pp, pq, qq, square;
    M in_k[6];
  };

  HWY_INLINE Active active_at(const V (&p)[6], V s) const {
    const V zero = hn::Zero(d_);
    Active k{zero, zero, zero, zero, {}};
    for (std::size_t lo = 0, hi = 3; lo < 3; ++lo, ++hi) {
      const V q_lo = number(shaft_.grid.q[lo]), q_hi = number(shaft_.grid.q[hi]);
      const V t_lo = hn::Add(p[lo], hn::Mul(q_lo, s)), t_hi = hn::Add(p[hi], hn::Mul(q_hi, s));
      k.in_k[lo] = hn::Gt(t_lo, zero);
      k.in_k[hi] = hn::AndNot(k.in_k[lo], hn::Gt(t_hi, zero));
      const V p_k = hn::IfThenElse(k.in_k[lo], p[lo], hn::IfThenElseZero(k.in_k[hi], p[hi]));
      const V q_k = hn::IfThenElse(k.in_k[lo], q_lo, hn::IfThenElseZero(k.in_k[hi], q_hi));
      const V t = hn::Max(hn::Max(t_lo, t_hi), zero);
      k.pp = hn::Add(k.pp, hn::Mul(p_k, p_k));
      k.pq = hn::Add(k.pq, hn::Mul(p_k, q_k));
      k.qq = hn::Add(k.qq, hn::Mul(q_k, q_k));
      k.square = hn::Add(k.square, hn::Mul(t, t));
    }
    return k;
  }

  HWY_INLINE Decided judge_least(const V (&p)[6], const Active& k) const {
    const V zero = hn::Zero(d_);
    V fault = zero;  // the largest t_k off K and -t_k on it, or what has the same sign
    for (std::size_t face = 0; face < 6; ++face) {
      const V t = sign_of_products(p[face], k.qq, number(shaft_.grid.q[face]), k.pq);
      fault = hn::Max(fault, hn::IfThenElse(k.in_k[face], hn::Neg(t), t));
    }
    const M least = hn::And(hn::Le(fault, zero), hn::Gt(k.qq, zero));
    const V excess = sign_of_products(hn::Sub(k.pp, square_), k.qq, k.pq, k.pq);
    return {hn::And(least, hn::Le(excess, zero)), hn::And(least, hn::Gt(excess, zero))};
  }

  /// The definition's v² >= r² |n|² for planes, where v <= 0 is known.
  HWY_INLINE M deep_in_planes(const V (&p)[6]) const {
    V shallow = hn::Zero(d_);
    for (std::size_t i = 0; i < shaft_.plane_count; ++i) {
      const auto& plane = shaft_.grid.planes[i];
      const V v = plane_value(plane, p);
      shallow = hn::Max(shallow, sign_of_products(square_, number(plane.squared_length), v, v));
    }
    return hn::Le(shallow, hn::Zero(d_));
  }
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
