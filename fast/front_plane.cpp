// SPDX-License-Identifier: MIT
//
// Where the threshold comes from. N is the exact normal times the power of two that brings the largest of its
// computed components into [1, 2), u = 2^-24, w = 2^-53 (doubles), eta = 2^-150; fl() rounds to floats.
//
// Each component of N is e1 e2' - e1' e2 of differences of floats, in doubles, where nothing underflows: a
// relative error of (1 + w)^4 on each product, so the computed one is within 4.001 w M_i, M_i = |e1 e2'| +
// |e1' e2|. Rounded to a float n_i: |n_i - N_i| <= 1.001 u |n_i| + 4.002 w M_i + eta.
// d is the sum of -n_i v_i in doubles, whose products are exact: |d + n.v| <= 2.001 w D + u |d| + eta <=
// 1.001 u D + eta, D = sum of |n_i v_i|. The value takes four roundings of the first terms and one of d:
//     |T - (n.x + d)| <= 4.001 u P + 1.001 u D + 4 eta, P = sum of |n_i x_i|
//     |T - N.(x - v)| <= 4.001 u P + 2.002 u D + 1.001 u (P + D) + sum of (4.002 w M_i + eta)(|x_i| + |v_i|)
//     + 5 eta
// which is below 6 u (P + D) + 5 w sum of M_i (|x_i| + |v_i|) + 2 eta sum of (|x_i| + |v_i|) + 6 eta. The
// threshold is that at the largest |x_i| of the region, computed in doubles and rounded up. So a point in
// front, N.(x - v) > 0, has T > -threshold, and the corner of its box that is farthest in front has no
// smaller T, as rounding is monotone: none_in_front() is never wrong; none_behind() likewise.
//
// Where all three corners share a coordinate, N has one component alone, n is exactly 1 or -1, and T is the
// rounded difference of two floats, whose sign is exact: the threshold is 0.
#include "fast/front_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::fast {

namespace {

constexpr double kFloatRoundoff = 0x1p-24, kDoubleRoundoff = 0x1p-53, kTwoEta = 0x1p-149;
/// Sums of four terms below it don't overflow.
constexpr double kLargestSafe = 0x1p120;
constexpr float kSaysNothing = std::numeric_limits<float>::quiet_NaN();

}  // namespace

FrontPlane form_front_plane(const FrontCorners& corners, const scene::Box<float>& region,
                            Arithmetic arithmetic) {
  FrontPlane plane;
  plane.threshold = kSaysNothing;
  std::array<double, 3> v{}, e1{}, e2{}, normal{}, products{};
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = static_cast<double>(corners[0][k]);
    e1[k] = static_cast<double>(corners[1][k]) - v[k];
    e2[k] = static_cast<double>(corners[2][k]) - v[k];
  }
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double plus = e1[i] * e2[j], minus = e1[j] * e2[i];
    normal[k] = plus - minus;
    products[k] = std::abs(plus) + std::abs(minus);
    largest = std::max(largest, std::abs(normal[k]));
  }
  if (!(largest > 0)) return plane;

  const int exponent = std::ilogb(largest);
  double size = 0, size_of_products = 0, distances = 0, d = 0;
  int components = 0;
  std::size_t axis = 0;  ///< the last with a component that is or may be other than 0
  for (std::size_t k = 0; k < 3; ++k) {
    plane.n[k] = static_cast<float>(std::scalbn(normal[k], -exponent));
    plane.far[k] = static_cast<std::uint8_t>(plane.n[k] > 0 ? k + 3 : k);
    if (products[k] > 0) {
      ++components;
      axis = k;
    }
    const double n = static_cast<double>(plane.n[k]);
    const double reach =
        std::max(std::abs(static_cast<double>(region.c[k])), std::abs(static_cast<double>(region.c[k + 3]))) +
        std::abs(v[k]);
    size += std::abs(n) * reach;
    size_of_products += std::scalbn(products[k], -exponent) * reach;
    distances += reach;
    d -= n * v[k];
  }
  plane.d = static_cast<float>(d);
  if (arithmetic == Arithmetic::naive) {
    plane.threshold = 0;
    return plane;
  }
  if (!(size <= kLargestSafe && size_of_products <= kLargestSafe)) return plane;
  if (components == 1 && std::abs(normal[axis]) > 8 * kDoubleRoundoff * products[axis]) {
    plane.n[axis] = normal[axis] > 0 ? 1.0F : -1.0F;
    plane.d = normal[axis] > 0 ? -corners[0][axis] : corners[0][axis];
    plane.threshold = 0;
    return plane;
  }
  const double bound =
      6 * kFloatRoundoff * size + 5 * kDoubleRoundoff * size_of_products + kTwoEta * (distances + 3);
  plane.threshold = static_cast<float>(bound * (1 + 4 * kFloatRoundoff)) + static_cast<float>(kTwoEta);
  return plane;
}

}  // namespace gnomon::fast
