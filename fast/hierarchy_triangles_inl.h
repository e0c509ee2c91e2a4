// SPDX-License-Identifier: MIT
//
// Eight triangles against one line, compiled once for each instruction set. Internal to fast/hierarchy*.
//
// THE ARITHMETIC (Moeller and Trumbore, JGT 2(1), 1997). With the line p + t d, corners v0, v1, v2, edges
// e1 = v1 - v0, e2 = v2 - v0, the normal n = e1 x e2, c = v0 - p and R = c x d:
//     D = n . d,  T = n . c,  U = R . e2,  V = R . (-e1),  W = D - U - V,  T' = T - D = n . (v0 - (p + d)).
// The line meets the plane at t = T / D, and there the triangle's weights of v1, v2, v0 are U / D, V / D and
// W / D. The ends p and p + d lie on the sides of the plane that T and T' tell.
//
// WHAT SIGNS PROVE. Two of U, V, W of opposite signs: the line misses the closed triangle (if it lies in the
// triangle's plane, or if the triangle is degenerate and the line meets its line, all three are 0). T and T'
// of one sign: the segment misses its plane. All of U, V, W of one sign, T and T' of opposite signs: the open
// segment crosses the triangle's interior.
//
// ERRORS. u is the roundoff, g(k) = k u / (1 - k u), |.|_1 the sum and |.|_m the largest of magnitudes.
// Computed: c, d (exact for rays), e1 and e2, with one rounding each; n as fast/hierarchy_leaves.cpp says.
//  - R_x has products of two rounded differences, and a difference: off by g(4) (|c_y||d_z| + |c_z||d_y|).
//    With a rounded edge, a product and two sums: U off by g(8) sum |e_x| (|c_y||d_z| + |c_z||d_y|)
//    <= g(8) |e|_1 |c|_m s, where s >= |d_j| + |d_k|. So: E |c|_m s with E = 8 u max(|e1|_1, |e2|_1),
//    and V too.
//  - T: a rounded difference, a product and two sums, and n's own error: (4 u |n|_1 + |n - exact n|_1) |c|_m.
//    D: the same with |d|_m. With N = 5 u |n|_1 + |n - exact n|_1 there is room for one more rounding of
//    each: T' off by N (|c|_m + |d|_m).
//  - W: both errors, D's, and two roundings: u (|U| + |V|) <= 2 u a for a = |e|_1 |c|_m s, then
//    u (|D| + 2 u a), where N has room for u |D|: (2 * 8 + 2 + 2) u a = 2.5 E |c|_m s, and N |d|_m.
//    We take 2.6, which is room for terms of second order; E and N are rounded up by 16 u, which is room for
//    the roundings of the thresholds themselves.
//  - Underflow (eta = 2^-150 each, no sums): R has 2 eta, which e1 and e2 below 2^41 make 6 * 2^41 eta in U
//    and V, besides their 3 eta; W has both, and D's 3 eta (n's is in N): less than 2^-105. 2^-104 is room
//    for the thresholds' underflow.
//  - Overflow: numbers up to 2^40 give differences up to 2^41, R and n up to 2^83, U, V, T, D up to
//    3 * 2^124, W up to 9 * 2^124 < 2^128.
#if defined(GNOMON_FAST_HIERARCHY_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_HIERARCHY_TRIANGLES_INL_H_
#undef GNOMON_FAST_HIERARCHY_TRIANGLES_INL_H_
#else
#define GNOMON_FAST_HIERARCHY_TRIANGLES_INL_H_
#endif

#include "fast/hierarchy_vectors_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// The values above, for as many triangles as a vector holds.
struct TriangleValues {
  V u, v, w, t, d, c_most;
};

HWY_INLINE TriangleValues evaluate(const BeamVectors& beam, const TriangleBlock& block, std::size_t at) {
  const Floats d;
  const auto load = [&](const Eight& eight) { return hn::Load(d, eight.data() + at); };
  const V cx = hn::Sub(load(block.v0[0]), beam.origin[0]), cy = hn::Sub(load(block.v0[1]), beam.origin[1]),
          cz = hn::Sub(load(block.v0[2]), beam.origin[2]);
  const V dx = beam.direction[0], dy = beam.direction[1], dz = beam.direction[2];
  const V rx = hn::Sub(hn::Mul(cy, dz), hn::Mul(cz, dy)), ry = hn::Sub(hn::Mul(cz, dx), hn::Mul(cx, dz)),
          rz = hn::Sub(hn::Mul(cx, dy), hn::Mul(cy, dx));
  const auto dot = [&](const std::array<Eight, 3>& a, V x, V y, V z) {
    return hn::Add(hn::Add(hn::Mul(load(a[0]), x), hn::Mul(load(a[1]), y)), hn::Mul(load(a[2]), z));
  };
  TriangleValues values;
  values.u = dot(block.to_v2, rx, ry, rz);
  values.v = dot(block.to_v1, rx, ry, rz);
  values.d = dot(block.normal, dx, dy, dz);
  values.t = dot(block.normal, cx, cy, cz);
  values.w = hn::Sub(values.d, hn::Add(values.u, values.v));
  values.c_most = hn::Max(hn::Max(hn::Abs(cx), hn::Abs(cy)), hn::Abs(cz));
  return values;
}

/// What these may be off by: u, v and w by w, t by t, t - d by t + d.
struct TriangleErrors {
  V w, t, d;
};

HWY_INLINE TriangleErrors errors_of(const BeamVectors& beam, const TriangleBlock& block, std::size_t at,
                                    const TriangleValues& x) {
  const Floats d;
  const V edge_error = hn::Load(d, block.edge_error.data() + at),
          normal_error = hn::Load(d, block.normal_error.data() + at), tiny = hn::Set(d, kTriangleUnderflow);
  TriangleErrors errors;
  errors.d = hn::Add(hn::Mul(normal_error, beam.largest), tiny);
  errors.w = hn::Add(hn::Mul(hn::Mul(edge_error, x.c_most), beam.third_spread), errors.d);
  errors.t = hn::Add(hn::Mul(normal_error, x.c_most), tiny);
  return errors;
}

/// The segment's triangles that are hit for certain, and those that may be. Naive: both the same, edges
/// included, ends not.
template <bool kCertified>
HWY_INLINE LeafBits segment_triangles(const BeamVectors& beam, const TriangleBlock& block) {
  const Floats d;
  const V zero = hn::Zero(d);
  LeafBits bits;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const TriangleValues x = evaluate(beam, block, at);
    const V least = hn::Min(hn::Min(x.u, x.v), x.w), most = hn::Max(hn::Max(x.u, x.v), x.w);
    const V t1 = hn::Sub(x.t, x.d);
    if constexpr (kCertified) {
      const TriangleErrors error = errors_of(beam, block, at, x);
      const M positive = hn::Gt(least, error.w), negative = hn::Lt(most, hn::Neg(error.w));
      const M crosses = hn::And(hn::Gt(most, error.w), hn::Lt(least, hn::Neg(error.w)));
      const M ends = hn::And(hn::Gt(hn::Abs(x.t), error.t), hn::Gt(hn::Abs(t1), hn::Add(error.t, error.d)));
      const M opposite = hn::Xor(hn::Gt(x.t, zero), hn::Gt(t1, zero));  // where neither is 0
      bits.certain |= bits_of(d, hn::And(hn::Or(positive, negative), hn::And(ends, opposite))) << at;
      bits.possible |= bits_of(d, hn::Not(hn::Or(crosses, hn::AndNot(opposite, ends)))) << at;
    } else {
      const M crosses = hn::And(hn::Gt(most, zero), hn::Lt(least, zero));
      const M ends =
          hn::Or(hn::And(hn::Gt(x.t, zero), hn::Lt(t1, zero)), hn::And(hn::Lt(x.t, zero), hn::Gt(t1, zero)));
      bits.possible |= bits_of(d, hn::AndNot(crosses, ends)) << at;
    }
  }
  if (!kCertified) bits.certain = bits.possible;
  return bits;
}

/// The ray's triangles at parameters up to `limit`, and where.
///
/// With |T - exact| <= a and |D - exact| <= b < |D|, t is from (|T| - a) / (|D| + b) to (|T| + a) / (|D| -
/// b); three roundings and one more for the factor 1 -+ 6 u. Quotients may underflow: hence the last term of
/// hi, next to which what lo may be too large by, 2^-149, is nothing. Where a quotient overflows, t is beyond
/// 2^127: no face in the domain is met there, as p + t d is at most 2^40 and some |d_k| at least 2^-81.
template <bool kCertified>
HWY_INLINE LeafHits ray_triangles(const BeamVectors& beam, const TriangleBlock& block, float limit) {
  const Floats d;
  const V zero = hn::Zero(d);
  LeafHits hits;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const TriangleValues x = evaluate(beam, block, at);
    const V least = hn::Min(hn::Min(x.u, x.v), x.w), most = hn::Max(hn::Max(x.u, x.v), x.w);
    if constexpr (kCertified) {
      constexpr float u = Rounding<float>::u;
      const TriangleErrors error = errors_of(beam, block, at, x);
      const M positive = hn::Gt(least, error.w), negative = hn::Lt(most, hn::Neg(error.w));
      const M crosses = hn::And(hn::Gt(most, error.w), hn::Lt(least, hn::Neg(error.w)));
      const V t_size = hn::Abs(x.t), d_size = hn::Abs(x.d);
      const M has_d = hn::Gt(d_size, error.d), signs = hn::And(hn::Gt(t_size, error.t), has_d);
      const M opposite = hn::Xor(hn::Gt(x.t, zero), hn::Gt(x.d, zero));  // where neither is 0
      const V from = hn::Div(hn::Max(hn::Sub(t_size, error.t), zero), hn::Add(d_size, error.d)),
              to = hn::Div(hn::Add(t_size, error.t), hn::Sub(d_size, error.d));
      const V lo = hn::IfThenElseZero(has_d, hn::Mul(from, hn::Set(d, 1 - 6 * u)));
      const V hi =
          hn::IfThenElse(has_d, hn::Add(hn::Mul(to, hn::Set(d, 1 + 6 * u)), hn::Set(d, kParameterUnderflow)),
                         hn::Set(d, std::numeric_limits<float>::infinity()));
      hn::Store(lo, d, hits.lo + at);
      hn::Store(hi, d, hits.hi + at);
      const M inside = hn::Or(positive, negative), ahead = hn::AndNot(opposite, signs);
      const M excluded = hn::Or(hn::Or(crosses, hn::And(opposite, signs)), hn::Gt(lo, hn::Set(d, limit)));
      hits.bits.certain |= bits_of(d, hn::And(inside, ahead)) << at;
      hits.bits.possible |= bits_of(d, hn::Not(excluded)) << at;
    } else {
      const M crosses = hn::And(hn::Gt(most, zero), hn::Lt(least, zero));
      const V t = hn::Div(x.t, x.d);
      hn::Store(t, d, hits.lo + at);
      const M near = hn::And(hn::Gt(t, zero), hn::Lt(t, hn::Set(d, limit)));
      hits.bits.possible |= bits_of(d, hn::AndNot(crosses, near)) << at;
    }
  }
  return hits;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
