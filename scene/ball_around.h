// SPDX-License-Identifier: MIT
// A ball of given centre around points, rounded outwards.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gnomon::scene {

/// Collects points and tells a radius within which all of them lie around a fixed centre: never less than the
/// exact greatest distance, and more by a factor of at most 1 + 2^-49 in double (then rounded up to F). F is
/// float or double; all coordinates must be finite, and `extent` must be the greatest |coordinate - centre|,
/// as subtracted in double, of the points that add() will be given.
///
/// Derivation, u = 2^-53. All work is in doubles, scaled by a power of two to the size of `extent`, so that
/// squares can't overflow. Each difference errs by a factor in [1 - u, 1 + u] (no difference of doubles
/// underflows), so does each square, and each of the two sums: the computed sum of squares s is at least (1 -
/// u)^5 of the exact one, and sqrt(s) at least (1 - u)^3.5 of the exact distance. The product with 1 + 8 u,
/// which errs by another 1 - u, is thus no smaller than the exact distance, as (1 + 8 u) (1 - u)^4.5 > 1 + 3
/// u. Only squares below 2^-1021 underflow, beside a greatest one that is at least 1, or 2^-148 where the
/// scale is clamped (extents of denormals, whose squares are all 0 or at least 2^-148): the 3 u that are left
/// cover that.
template <class F>
class BallAround {
 public:
  BallAround(const std::array<F, 3>& centre, double extent)
      : centre_{static_cast<double>(centre[0]), static_cast<double>(centre[1]),
                static_cast<double>(centre[2])},
        exponent_(extent > 0 ? std::max(std::ilogb(extent), -1000) : 0),
        scale_(std::ldexp(1.0, -exponent_)) {}

  void add(const std::array<F, 3>& point) {
    const double x = (static_cast<double>(point[0]) - centre_[0]) * scale_;
    const double y = (static_cast<double>(point[1]) - centre_[1]) * scale_;
    const double z = (static_cast<double>(point[2]) - centre_[2]) * scale_;
    greatest_ = std::max(greatest_, x * x + y * y + z * z);
  }

  /// Infinity when no finite F is large enough.
  [[nodiscard]] F radius() const {
    constexpr double kOutwards = 1 + 8 * 0x1p-53;
    const double scaled = std::sqrt(greatest_) * kOutwards;
    double radius = std::ldexp(scaled, exponent_);
    if (std::ldexp(radius, -exponent_) < scaled) {  // a denormal that was rounded down
      radius = std::nextafter(radius, std::numeric_limits<double>::infinity());
    }
    if (radius > static_cast<double>(std::numeric_limits<F>::max()))
      return std::numeric_limits<F>::infinity();
    const F rounded = static_cast<F>(radius);
    if (static_cast<double>(rounded) >= radius) return rounded;
    return std::nextafter(rounded, std::numeric_limits<F>::infinity());
  }

 private:
  std::array<double, 3> centre_;
  int exponent_;
  double scale_;
  double greatest_ = 0;
};

}  // namespace gnomon::scene
