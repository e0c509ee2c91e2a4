// SPDX-License-Identifier: MIT
//
// Eight balls against one beam, compiled once for each instruction set. Internal to fast/hierarchy*.
//
// THE ARITHMETIC. With m = c - p, the point p + t d is closest to the centre at t0 = m . d / d . d; s is t0
// moved into the beam's range [0, end], q = m - s d, and the ball is met when G = r^2 - q . q is positive.
//
// WHAT SIGNS PROVE. Whatever s in the closed range was computed, G > 0 for it exactly means a point strictly
// within the ball, and so points of the open range as well. G < 0 for the s that is closest means that the
// closed range misses the ball.
//
// ERRORS, in the notation of fast/hierarchy_triangles_inl.h, |.| the length. q stands for its exact value at
// the s that was computed.
//  - q_i: m_i with a rounding, s d_i with two, and a difference: off by at most u (|m_i| + 2.01 |s d_i| +
//    |q_i|) + eta <= u (3.1 |m_i| + 3.1 |q_i|) + eta, as s d_i = m_i - q_i. So 2 sum |q_i| (..) <=
//    6.2 u |m|_m |q|_1 + 6.2 u q . q, what eta gives is below 4 eta |q| < 2^-105, and the squares' sum is
//    below 60 u^2 |m|_m^2 and little of q . q. The square's own roundings: g(3) q . q. (From the computed q
//    to the exact one the same holds with |q|_1 and q . q as computed, which the kernel has.)
//  - t0: m . d is off by g(5) |m| |d| + 3 eta, d . d by g(5) of itself as long as it is at least 2^-100, and
//    there is a division: |d| times t0's error is at most e = 11.2 u |m| + 3 eta / |d| + eta |d|, the last
//    two terms together below 2^-98. Moving into the range does not enlarge it. q . q exceeds its least value
//    in the range by at most e^2
//    <= 2 (11.2 u |m|)^2 + 2^-195 <= 753 u^2 |m|_m^2 + 2^-195 (it is a parabola in s; where t0 lies beyond an
//    end and s does not, s is within the error of t0).
//  - r^2 has a rounding, G another: u r^2 + u (r^2 + q . q).
// Altogether G is off by less than 6.2 u |m|_m |q|_1 + 820 u^2 |m|_m^2 + 10.3 u q . q + 2.1 u r^2 + 2^-104.
// The kernel takes a little more of everything, for its own roundings. Below d . d = 2^-100 nothing is
// decided.
#if defined(GNOMON_FAST_HIERARCHY_BALLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_HIERARCHY_BALLS_INL_H_
#undef GNOMON_FAST_HIERARCHY_BALLS_INL_H_
#else
#define GNOMON_FAST_HIERARCHY_BALLS_INL_H_
#endif

#include "fast/hierarchy_vectors_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// The values above, for as many balls as a vector holds; `error` bounds that of `depth` (G).
struct BallValues {
  V closest;  ///< t0
  V depth, error;
  V offset;  ///< |m|_m
  V dd;
};

HWY_INLINE BallValues evaluate(const BeamVectors& beam, const BallBlock& block, std::size_t at, V end) {
  const Floats d;
  V m[3], q[3];
  for (std::size_t k = 0; k < 3; ++k) {
    m[k] = hn::Sub(hn::Load(d, block.centre[k].data() + at), beam.origin[k]);
  }
  const auto dot = [](const V* a, const V* b) {
    return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
  };
  const auto sum = [](const V* a) { return hn::Add(hn::Add(hn::Abs(a[0]), hn::Abs(a[1])), hn::Abs(a[2])); };
  BallValues values;
  values.dd = dot(beam.direction, beam.direction);
  values.closest = hn::Div(dot(m, beam.direction), values.dd);
  // A NaN becomes 0, which is in the range.
  const V s = less_or_second(more_or_second(values.closest, hn::Zero(d)), end);
  for (std::size_t k = 0; k < 3; ++k) q[k] = hn::Sub(m[k], hn::Mul(s, beam.direction[k]));
  const V r = hn::Load(d, block.radius.data() + at);
  const V rr = hn::Mul(r, r), qq = dot(q, q);
  values.depth = hn::Sub(rr, qq);
  values.offset = hn::Max(hn::Max(hn::Abs(m[0]), hn::Abs(m[1])), hn::Abs(m[2]));
  constexpr float u = Rounding<float>::u;
  const V um = hn::Mul(hn::Set(d, u), values.offset);
  const V linear = hn::Add(hn::Mul(hn::Set(d, 6.3f), sum(q)), hn::Mul(hn::Set(d, 850.0f), um));
  const V squares = hn::Add(hn::Mul(hn::Set(d, 10.5f * u), qq), hn::Mul(hn::Set(d, 2.2f * u), rr));
  values.error = hn::Add(hn::Add(hn::Mul(um, linear), squares), hn::Set(d, kBallUnderflow));
  return values;
}

/// The segment's balls that are hit for certain, and those that may be. Naive: both the same.
template <bool kCertified>
HWY_INLINE LeafBits segment_balls(const BeamVectors& beam, const BallBlock& block) {
  const Floats d;
  LeafBits bits;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const BallValues x = evaluate(beam, block, at, hn::Set(d, 1.0f));
    if constexpr (kCertified) {
      const M reliable = hn::Ge(x.dd, hn::Set(d, kLeastSquare));
      bits.certain |= bits_of(d, hn::And(reliable, hn::Gt(x.depth, x.error))) << at;
      bits.possible |= bits_of(d, hn::Not(hn::And(reliable, hn::Lt(x.depth, hn::Neg(x.error))))) << at;
    } else {
      bits.possible |= bits_of(d, hn::Gt(x.depth, hn::Zero(d))) << at;
    }
  }
  if (!kCertified) bits.certain = bits.possible;
  return bits;
}

/// The ray's balls at parameters up to `limit`, and where it enters them: at t0 - sqrt(h), h = G / d . d, or
/// 0 from within; `leaving`: where it leaves them, at t0 + sqrt(h).
///
/// t0 is off by at most 20 u |m|_m / |d|_m + 4 eta / d . d. The root of h is the quotient of two roots: h
/// itself may be as large as 2^180 and as small as 2^-231 within the domain. It is off by 2.5 u of itself for
/// d . d, 0.5 u for the sum, u for each root, the quotient and the factor 1 -+ 8 u, besides what G's error
/// does.
template <bool kCertified>
HWY_INLINE LeafHits ray_balls(const BeamVectors& beam, const BallBlock& block, float limit, bool leaving) {
  const Floats d;
  const V zero = hn::Zero(d), infinity = hn::Set(d, std::numeric_limits<float>::infinity());
  constexpr float u = Rounding<float>::u;
  LeafHits hits;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const BallValues x = evaluate(beam, block, at, infinity);
    if constexpr (kCertified) {
      const M reliable = hn::Ge(x.dd, hn::Set(d, kLeastSquare));
      const M certain = hn::And(reliable, hn::Gt(x.depth, x.error));
      const V tiny = hn::Set(d, kParameterUnderflow);
      const V shift = hn::Add(hn::Mul(hn::Set(d, 20 * u), hn::Div(x.offset, beam.largest)),
                              hn::Add(hn::Div(tiny, x.dd), tiny));
      const auto root = [&](V square, float factor) {
        return hn::Mul(hn::Div(hn::Sqrt(hn::Max(square, zero)), hn::Sqrt(x.dd)), hn::Set(d, factor));
      };
      const V most = root(hn::Add(x.depth, x.error), 1 + 8 * u);
      const V least = root(hn::Sub(x.depth, x.error), 1 - 8 * u);
      // One more rounding of each end, of numbers no larger than these.
      const V slack = hn::Mul(hn::Set(d, 4 * u), hn::Add(hn::Abs(x.closest), hn::Add(most, shift)));
      const V before = hn::Sub(hn::Sub(x.closest, shift), slack),
              after = hn::Add(hn::Add(x.closest, shift), slack);
      const V from = leaving ? hn::Add(before, least) : hn::Sub(before, most);
      const V to = leaving ? hn::Add(after, most) : hn::Sub(after, least);
      const V lo = hn::IfThenElseZero(reliable, hn::Max(from, zero));
      const V hi = hn::IfThenElse(reliable, hn::Max(to, zero), infinity);
      hn::Store(lo, d, hits.lo + at);
      hn::Store(hi, d, hits.hi + at);
      const M missed = hn::And(reliable, hn::Lt(x.depth, hn::Neg(x.error)));
      hits.bits.certain |= bits_of(d, certain) << at;
      hits.bits.possible |= bits_of(d, hn::Not(hn::Or(missed, hn::Gt(lo, hn::Set(d, limit))))) << at;
    } else {
      const V root = hn::Sqrt(hn::Div(hn::Max(x.depth, zero), x.dd));
      const V t = leaving ? hn::Add(x.closest, root) : hn::Max(hn::Sub(x.closest, root), zero);
      hn::Store(t, d, hits.lo + at);
      hits.bits.possible |= bits_of(d, hn::And(hn::Gt(x.depth, zero), hn::Lt(t, hn::Set(d, limit)))) << at;
    }
  }
  return hits;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
