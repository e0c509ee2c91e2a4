// SPDX-License-Identifier: MIT
// Volumes with a centre and three axes against a shaft: the kernel that oriented boxes and ellipsoids share.
// They differ in how far the axes reach along a normal.
//
// Error bounds. u is the unit roundoff, eta half of the smallest denormal; N, D are the exact plane (times
// its power of two), n, d the rounded one, a the point it goes through. With S = sum |N_j| (|c_j| + |a_j|),
// at most two terms:
//  - v = n.c + d: component of n, product, at most one sum within n.c, and the sum with d make four factors
//    (1 + e) on either term: |v - V| <= 4.0001 u S + 4 eta (1).
// With P = sum over axes i and components j of |N_j u_ij|:
//  - n.u_i: component, product, one sum: within 3.0001 u of its share of P, and 2 eta each (2).
//  - Boxes, h = sum |n.u_i|: two more sums: |h - H| <= 5.0001 u P + 6 eta (3).
//  - Ellipsoids, h = sqrt(sum (n.u_i)^2): by (2) the vector of the three is off by at most 3.0001 u P + 6
//    eta; its length by that much and 2.5001 u of itself, at most P, for squares, sums and root; squares that
//    vanish cost sqrt(3 eta): |h - H| <= 5.5001 u P + 6 eta + sqrt(3 eta) (4).
// near = v - h and far = v + h add one rounding to both: within 6.5002 u (S + P) + 10 eta (+ sqrt(3 eta)).
// S + P = sum |N_j| (|c_j| + sum |u_ij| + |a_j|) is computed as `sum` with at most eleven factors 1 - u on
// each term, so that 7 u sum pays for it; what underflow takes from `sum` and from the product with 7 u is
// paid by `tiny`. Where `sum` is at most kLargestSafeSum no term of v and h overflows, and the squares of (4)
// can only make h infinite, which neither tells outside (near = -inf) nor inside (far = inf). Otherwise the
// plane decides nothing.
#pragma once

#include <array>
#include <cmath>

#include "fast/banded.h"
#include "fast/support_shaft.h"

namespace gnomon::fast {

/// What 7 u pays for: see above.
inline constexpr int kSpannedRelative = 7;

/// sum |n.u_i|: boxes.
struct BoxReach {
  template <class F>
  static F of(F x, F y, F z) {
    return (std::fabs(x) + std::fabs(y)) + std::fabs(z);
  }
  template <class F>
  static constexpr F kTiny = F(64) * Rounding<F>::two_eta;
};

/// |M^T n|: ellipsoids. sqrt(3 eta) is less than 2^-74 for floats and 2^-536 for doubles.
struct EllipsoidReach {
  template <class F>
  static F of(F x, F y, F z) {
    return std::sqrt((x * x + y * y) + z * z);
  }
  template <class F>
  static constexpr F kTiny = sizeof(F) == sizeof(float) ? F(0x1p-73) : F(0x1p-535);
};

/// n.p, in the order that the bounds are derived for.
template <class F>
[[nodiscard]] F dot(const std::array<F, 3>& n, const std::array<F, 3>& p) {
  return (n[0] * p[0] + n[1] * p[1]) + n[2] * p[2];
}

/// How far t's points lie from the origin on each axis, at most: |c_j| + sum |u_ij|, rounded.
template <class Volume>
[[nodiscard]] auto magnitudes_of(const Volume& t) {
  auto sum = t.centre;
  for (std::size_t j = 0; j < 3; ++j) {
    sum[j] = std::fabs(t.centre[j]);
    for (std::size_t i = 0; i < 3; ++i) sum[j] += std::fabs(t.axes[i][j]);
  }
  return sum;
}

/// What near and far values of a plane may be wrong by; infinite where they may overflow.
template <class Reach, class F>
[[nodiscard]] F error_of(const SupportPlane<F>& plane, const std::array<F, 3>& magnitudes) {
  F sum = plane.base;
  for (std::size_t j = 0; j < 3; ++j) sum += std::fabs(plane.n[j]) * magnitudes[j];
  if (!(sum <= kLargestSafeSum<F>)) return std::numeric_limits<F>::infinity();
  return F(kSpannedRelative) * Rounding<F>::u * sum + Reach::template kTiny<F>;
}

/// The planes' test. Naive: the answer alone means something. Certified: `outside` and `inside` are never
/// wrong, and `certain` says that the answer is the exact one: an overlap is when the centre surely lies in
/// the shaft, and a point of t surely does not.
template <class Reach, Rigour kRigour, class F, class Volume>
[[nodiscard]] Banded classify_spanned(const SupportShaft<F>& shaft, const Volume& t) {
  constexpr bool kCertified = kRigour == Rigour::certified;
  std::array<F, 3> magnitudes{};
  if constexpr (kCertified) magnitudes = magnitudes_of(t);
  bool inside = true, centre_inside = true, not_inside = false;
  for (const SupportPlane<F>& plane : shaft.planes()) {
    const F value = dot(plane.n, t.centre) + plane.d;
    const F reach = Reach::of(dot(plane.n, t.axes[0]), dot(plane.n, t.axes[1]), dot(plane.n, t.axes[2]));
    F error = 0;
    if constexpr (kCertified) error = error_of<Reach>(plane, magnitudes);
    if (value - reach > error) return {scene::Category::outside, true};
    const F far = value + reach;
    if constexpr (kCertified)
      inside &= std::isfinite(error);  // no value is above infinity, but -inf is at most -inf
    inside &= far <= -error;
    not_inside |= far > error && std::isfinite(far);  // squares that overflow tell nothing
    centre_inside &= value <= -error;
  }
  if (inside) return {scene::Category::inside, true};
  return {scene::Category::overlap, centre_inside && not_inside};
}

/// The stated threshold: where the certified test says overlap and the exact test by planes knows better, the
/// value that would have told is at most twice the error; growing t by this much on all sides takes it away.
template <class Reach, class F, class Volume>
[[nodiscard]] F stated_gap_of(const SupportShaft<F>& shaft, const Volume& t) {
  const std::array<F, 3> magnitudes = magnitudes_of(t);
  F most = 0;
  for (const SupportPlane<F>& plane : shaft.planes()) {
    most = std::max(most, 2 * error_of<Reach>(plane, magnitudes) / plane.length);
  }
  return most * (1 + 16 * Rounding<F>::u) + Rounding<F>::two_eta;
}

}  // namespace gnomon::fast
