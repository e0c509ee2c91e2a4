// SPDX-License-Identifier: MIT
//
// Where the thresholds come from. u is the unit roundoff, eta half of the smallest denormal; fl() rounds to
// nearest. Capital letters are exact: N0 = b_g - a_g and N1 = a_f - b_f up to sign, the plane of the edges of
// a and b.
//
// BOXES. The kernel computes T = fl(fl(fl(n0 x) + fl(n1 y)) + d), n = fl(N), d = -fl(fl(n0 a0) + fl(n1 a1)).
// Each of the four products carries four factors (1 + e), |e| <= u, and the underflow of four products:
//     |T - exact| <= 4.000002 u S + 5 eta,   S = |N0| (|x| + |a0|) + |N1| (|y| + |a1|) (1)
// for all real x and y. Soundness for one threshold a shaft: a box that meets the shaft has a real point p of
// the shaft, hence of the extent box, in common with it. The near corner comes before p in the direction of
// the normal, rounding is monotone, so T(near) <= T(p) <= 0 + (1) at p, and there |x| <= X and |y| <= Y, the
// largest magnitudes in the extent box. So T(near) > threshold >= (1) at (X, Y) proves the box outside.
// Completeness: if the exact near value is positive and the box meets the extent box, the near corner lies in
// the extent box (from N0 (x - a0) > -N1 (y - a1) and y <= hi), so (1) holds there too; what is kept wrongly
// has an exact value of at most twice the threshold. Far corners are compared only when t lies within the
// extent box.
//
// BALLS. With q = c - p, |q| <= r, p the ball's point in the shaft, and normals m of length at most 1 - 5 u:
//     T(c) <= m.q (1 + 3.001 u) + [m.p + d] + u (3.001 P + D) + 2.5 eta,   P = |m0| X + |m1| Y, D = |m0 a0| +
//     |m1 a1|
// where d, computed from the rounded m, costs another 2.001 u D; m.(b - a) is not 0 but at most 2.001 u B
// with B = |m0 (b0 - a0)| + |m1 (b1 - a1)|, as the two components carry different roundings (claim S19 in
// floats); and underflow of m costs 4 eta (X + Y). |m| (1 + 3.001 u) <= 1 - u by the shortening, which leaves
// u r for rounding r + threshold. Inside: for c within the extent box the same errors, plus 4.01 u P for the
// turned normal, have to be paid below -r; the shortening helps, as it makes the value's magnitude smaller.
#include "fast/certified_shaft.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace gnomon::fast {

namespace {

using Constants = CertifiedConstants;

/// Sums of products above this may overflow on the way: three terms below it can't.
template <class F>
constexpr F kLargestSafe = std::numeric_limits<F>::max() / 256;

/// The largest magnitude that a coordinate on the axis has in the extent box. Exact.
template <class F>
F magnitude(const scene::Box<F>& extent, int axis) {
  return std::max(std::fabs(extent.lo(axis)), std::fabs(extent.hi(axis)));
}

/// Makes the plane decide nothing: no value is above infinity, and none is at most NaN.
template <class F>
void disarm(ShaftPlane<F>& plane) {
  plane.outside_threshold = std::numeric_limits<F>::infinity();
  plane.inside_threshold = std::numeric_limits<F>::quiet_NaN();
}

template <class F>
void set_box_threshold(ShaftPlane<F>& plane, const Shaft<F>& shaft) {
  const F x = magnitude(shaft.extent, axis_of(plane.far0));
  const F y = magnitude(shaft.extent, axis_of(plane.far1));
  const F sum = std::fabs(plane.n0) * (x + std::fabs(shaft.a.c[plane.far0])) +
                std::fabs(plane.n1) * (y + std::fabs(shaft.a.c[plane.far1]));
  if (!(sum <= kLargestSafe<F>)) return disarm(plane);
  // 5 u sum is at least 4.000002 u S but for underflow, which 1024 eta pays for with the 5 eta of (1).
  const F threshold = F(Constants::box_plane) * Rounding<F>::u * sum + F(512) * Rounding<F>::two_eta;
  plane.outside_threshold = threshold;
  plane.inside_threshold = -threshold;
}

/// The growth of a box by `growth` on all sides raises the exact near value by growth (|N0| + |N1|).
template <class F>
F box_gap(const ShaftPlane<F>& plane) {
  if (std::isinf(plane.outside_threshold)) return plane.outside_threshold;
  const F length = std::fabs(plane.n0) + std::fabs(plane.n1);
  const F gap = 2 * plane.outside_threshold / length;
  return gap * (1 + 16 * Rounding<F>::u) + Rounding<F>::two_eta;
}

/// Scales the normal to a length of at most 1 - 5 u (4 u are what the scaling itself may be wrong by); scaled
/// by a power of two first, so that the squares neither overflow nor vanish.
template <class F>
void shorten(ShaftPlane<F>& plane) {
  constexpr F kSafe = std::is_same_v<F, float> ? F(0x1p40) : F(0x1p300);
  const F larger = std::max(std::fabs(plane.n0), std::fabs(plane.n1));
  if (!(larger >= 1 / kSafe && larger <= kSafe)) {
    const int exponent = std::ilogb(larger);
    plane.n0 = std::scalbn(plane.n0, -exponent);
    plane.n1 = std::scalbn(plane.n1, -exponent);
  }
  const F length = std::sqrt(plane.n0 * plane.n0 + plane.n1 * plane.n1);
  const F scale = (1 - (Constants::ball_shortening + 4) * Rounding<F>::u) / length;
  plane.n0 *= scale;
  plane.n1 *= scale;
}

template <class F>
void set_ball_threshold(ShaftPlane<F>& plane, Shaft<F>& shaft) {
  constexpr F u = Rounding<F>::u;
  const int axis0 = axis_of(plane.far0), axis1 = axis_of(plane.far1);
  const F x = magnitude(shaft.extent, axis0), y = magnitude(shaft.extent, axis1);
  const F a0 = shaft.a.c[plane.far0], a1 = shaft.a.c[plane.far1];
  const F b0 = shaft.b.c[plane.far0], b1 = shaft.b.c[plane.far1];
  if (!(x + y <= kLargestSafe<F>) || !std::isfinite(plane.n0) || !std::isfinite(plane.n1)) {
    plane.n0 = plane.n1 = plane.d = 0;
    disarm(plane);
    shaft.stated_gap.base = std::numeric_limits<F>::infinity();
    return;
  }
  shorten(plane);
  plane.d = -(plane.n0 * a0 + plane.n1 * a1);

  const F m0 = std::fabs(plane.n0), m1 = std::fabs(plane.n1);
  const F p = m0 * x + m1 * y;
  const F d = m0 * std::fabs(a0) + m1 * std::fabs(a1);
  const F b = m0 * std::fabs(b0 - a0) + m1 * std::fabs(b1 - a1);
  // What underflow costs is 4 eta (X + Y) + 5 eta. The smallest normal number in eta's place matters to no
  // shaft larger than 1e-30 (floats), and spares every other one the processor's slow path for denormals.
  const F underflow = std::numeric_limits<F>::min() * (1 + x + y);
  constexpr F inflate = F(1.001);  // 3.002 / 3, and the rounding of these sums
  const F outside = inflate * u *
                        (F(Constants::ball_outside_p) * p + F(Constants::ball_outside_d) * d +
                         F(Constants::ball_outside_b) * b) +
                    underflow;
  const F inside =
      inflate * u * (F(Constants::ball_inside_p) * p + F(Constants::ball_inside_d) * d) + underflow;
  plane.outside_threshold = outside;
  plane.inside_threshold = -inside;

  // What is kept wrongly: the threshold, plus the shortening of values up to 2 P + r, plus the error of T.
  const F base = inflate * (std::max(outside, inside) + u * (60 * p)) + 4 * underflow;
  shaft.stated_gap.base = std::max(shaft.stated_gap.base, base);
}

}  // namespace

template <class F>
Shaft<F> form_certified_box_shaft(const scene::Box<F>& a, const scene::Box<F>& b) {
  Shaft<F> shaft = form_shaft(a, b, Normals::as_formed);
  for (ShaftPlane<F>& plane : shaft.planes()) {
    set_box_threshold(plane, shaft);
    shaft.stated_gap.base = std::max(shaft.stated_gap.base, box_gap(plane));
  }
  return shaft;
}

template <class F>
Shaft<F> form_certified_ball_shaft(const scene::Box<F>& a, const scene::Box<F>& b) {
  constexpr F u = Rounding<F>::u;
  Shaft<F> shaft = form_shaft(a, b, Normals::as_formed);
  // Squares: the computed sum is at most D (1+u)^5 + 3.1 eta; r^2 is at least r^2 (1-u) - eta, times the
  // factor with two more roundings. (1 + 10 u)(1 - u)^3 >= (1+u)^5 for u <= 2^-24, and 8 eta covers the 5.1
  // eta of underflow.
  shaft.slack.square_factor = 1 + Constants::square_factor * u;
  shaft.slack.square_offset = 4 * Rounding<F>::two_eta;
  // Sides: fl(c - lo) >= fl(r (1 + 4 u)) implies c - lo >= r; denormal differences are exact.
  shaft.slack.inside_factor = 1 + Constants::side_factor * u;
  // Up to here r + threshold and every value near the ball stay finite (planes above kLargestSafe are
  // disarmed).
  shaft.slack.largest_radius = kLargestSafe<F>;
  for (ShaftPlane<F>& plane : shaft.planes()) set_ball_threshold(plane, shaft);

  // The squared-distance test keeps wrongly what is within r (1 + 11 u) and the root of 20 eta; the sides'
  // test says "overlap" wrongly within 7 u r; planes within 30 u r on top of their base.
  shaft.stated_gap.per_radius = 32 * u;
  constexpr F kRootOf32Eta = std::is_same_v<F, float> ? F(0x1p-72) : F(0x1p-534);  // rounded up
  shaft.stated_gap.base += kRootOf32Eta;
  return shaft;
}

template Shaft<float> form_certified_box_shaft(const scene::Box<float>&, const scene::Box<float>&);
template Shaft<double> form_certified_box_shaft(const scene::Box<double>&, const scene::Box<double>&);
template Shaft<float> form_certified_ball_shaft(const scene::Box<float>&, const scene::Box<float>&);
template Shaft<double> form_certified_ball_shaft(const scene::Box<double>&, const scene::Box<double>&);

}  // namespace gnomon::fast
