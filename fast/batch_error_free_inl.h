// SPDX-License-Identifier: MIT
// Error-free transforms in vector registers, and the sign of a plane by them. Compiled once for each
// instruction set. Internal to fast/batch_*_exact.cpp.
//
// Sums: Knuth's TwoSum, exact barring overflow. Products: by a fused multiply-add where the processor has
// one, else by Dekker's splitting; both give the exact error as long as nothing under- or overflows, hence
// the same bits (Muller et al., Handbook of Floating-Point Arithmetic, 2nd ed., 4.3-4.4).
#if defined(GNOMON_FAST_BATCH_ERROR_FREE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_BATCH_ERROR_FREE_INL_H_
#undef GNOMON_FAST_BATCH_ERROR_FREE_INL_H_
#else
#define GNOMON_FAST_BATCH_ERROR_FREE_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using VDouble = hn::Vec<Doubles>;
using MDouble = hn::Mask<Doubles>;

template <class D>
HWY_INLINE hn::Mask<D> no_lanes(D d) {
  return hn::FirstN(d, 0);
}

/// The unevaluated sum high + low, |low| <= u |high|.
template <class V>
struct TwoNumbers {
  V high, low;
};
using TwoDoubles = TwoNumbers<VDouble>;

template <class V>
HWY_INLINE TwoNumbers<V> two_sum(V a, V b) {
  const V sum = hn::Add(a, b);
  const V of_b = hn::Sub(sum, a);
  return {sum, hn::Add(hn::Sub(a, hn::Sub(sum, of_b)), hn::Sub(b, of_b))};
}

template <class V>
HWY_INLINE TwoNumbers<V> two_difference(V a, V b) {
  const V difference = hn::Sub(a, b);
  const V of_b = hn::Sub(a, difference);
  return {difference, hn::Sub(hn::Sub(a, hn::Add(difference, of_b)), hn::Sub(b, of_b))};
}

#if HWY_NATIVE_FMA
template <class V>
HWY_INLINE TwoNumbers<V> two_product(V a, V b) {
  const V product = hn::Mul(a, b);
  return {product, hn::MulSub(a, b, product)};
}
#else
/// Two halves of 12 bits each, or of 26 (one of them signed).
template <class V>
HWY_INLINE TwoNumbers<V> split(V a) {
  using F = hn::TFromV<V>;
  const V scaled = hn::Mul(a, hn::Set(hn::DFromV<V>(), sizeof(F) == 4 ? F(0x1p12 + 1) : F(0x1p27 + 1)));
  const V high = hn::Sub(scaled, hn::Sub(scaled, a));
  return {high, hn::Sub(a, high)};
}

template <class V>
HWY_INLINE TwoNumbers<V> two_product(V a, V b) {
  const V product = hn::Mul(a, b);
  const TwoNumbers<V> x = split(a), y = split(b);
  V error = hn::Sub(hn::Mul(x.high, y.high), product);
  error = hn::Add(error, hn::Mul(x.high, y.low));
  error = hn::Add(error, hn::Mul(x.low, y.high));
  return {product, hn::Add(error, hn::Mul(x.low, y.low))};
}
#endif

/// A number with the sign of a b - c d, zero included, where the errors of both products are exact: rounding
/// is monotone, so rounded products that differ are in the order of the exact ones, and the errors order
/// equal ones.
template <class V>
HWY_INLINE V sign_of_products(V a, V b, V c, V d) {
  const TwoNumbers<V> left = two_product(a, b), right = two_product(c, d);
  return hn::IfThenElse(hn::Eq(left.high, right.high), hn::Sub(left.low, right.low),
                        hn::Sub(left.high, right.high));
}

/// What is known of a sign: where `certain`, the exact value has the sign of `value`, zero included.
struct VectorSign {
  VDouble value;
  MDouble certain;
};

/// Products of numbers in [kLeastFactor, kLargestFactor] have exact errors, and sums of them don't overflow.
inline constexpr double kLeastFactor = 0x1p-450, kLargestFactor = 0x1p450;

HWY_INLINE MDouble in_range_or_zero(VDouble x) {
  const Doubles d;
  const VDouble size = hn::Abs(x);
  const MDouble normal =
      hn::And(hn::Ge(size, hn::Set(d, kLeastFactor)), hn::Le(size, hn::Set(d, kLargestFactor)));
  return hn::Or(normal, hn::Eq(size, hn::Zero(d)));
}

/// The sign of n0 x + n1 y, all four given as exact sums high + low. The normal's high parts are not 0 and in
/// [kLeastFactor, kLargestFactor]; so must be those of x and y, or 0.
///
/// Let u = 2^-53, p_i the two products of the high parts, e_i their errors, P = |p0| + |p1|. Exactly,
///     value = p0 + p1 + e0 + e1 + tails + (low x low),   p0 + p1 = s + t,   e0 + e1 = w + v.
/// Case 0: all low parts and both e_i are 0. Then value = p0 + p1, and its rounding has its sign.
/// Case 1: all low parts, t and v are 0. Then value = s + w, and its rounding has its sign.
/// Case 2: rest = t + (w + (v + tails)) is computed with an error of at most 17 u^2 P: u^2 P (1 + 2 u) for
/// the products of low parts; 6 u^2 P for tails (at most 2 u P, three roundings each); 3 u^2 P for v + tails,
/// 3.1 u^2 P for the sum with w (at most 2 u P), 4.1 u^2 P for that with t (at most u P). The last sum s +
/// rest keeps its sign when rounded, so |fl(s + rest)| > 32 u^2 P proves the sign. Tails may underflow: 4 eta
/// are far below u^2 kLeastFactor^2.
template <class Plane>
HWY_INLINE VectorSign sign_of_plane(const Plane& plane, const TwoDoubles& x, const TwoDoubles& y) {
  const Doubles d;
  const VDouble zero = hn::Zero(d);
  const VDouble n0 = hn::Set(d, plane.n0_high), n1 = hn::Set(d, plane.n1_high);
  const bool short_normal = plane.n0_low == 0 && plane.n1_low == 0;
  const TwoDoubles p0 = two_product(n0, x.high), p1 = two_product(n1, y.high);
  const auto all_zero = [&](VDouble a, VDouble b) { return hn::Eq(hn::Or(hn::Abs(a), hn::Abs(b)), zero); };
  const MDouble short_factors = all_zero(x.low, y.low);
  const MDouble case_0 = hn::And(short_factors, all_zero(p0.low, p1.low));
  if (HWY_LIKELY(short_normal && hn::AllTrue(d, case_0))) return {hn::Add(p0.high, p1.high), case_0};

  const TwoDoubles products = two_sum(p0.high, p1.high), errors = two_sum(p0.low, p1.low);
  const VDouble normal_tails =
      hn::Add(hn::Mul(hn::Set(d, plane.n0_low), x.high), hn::Mul(hn::Set(d, plane.n1_low), y.high));
  const VDouble tails = hn::Add(hn::Add(hn::Mul(n0, x.low), hn::Mul(n1, y.low)), normal_tails);
  const VDouble rest = hn::Add(products.low, hn::Add(errors.high, hn::Add(errors.low, tails)));
  const VDouble value = hn::Add(products.high, rest);

  const VDouble sum = hn::Add(hn::Abs(p0.high), hn::Abs(p1.high));
  const MDouble case_2 = hn::Gt(hn::Abs(value), hn::Mul(sum, hn::Set(d, 0x1p-101)));
  if (!short_normal) return {value, case_2};
  const MDouble case_1 = hn::And(short_factors, all_zero(products.low, errors.low));
  return {value, hn::Or(case_2, case_1)};
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
