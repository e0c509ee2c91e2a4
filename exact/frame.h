// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates of a scene as floats near 1, rounded outwards. Internal to exact/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gnomon::exact {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The nearest float, but finite.
[[nodiscard]] inline float nearest_float(double x) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(x > kLargest ? kLargest : x < -kLargest ? -kLargest : x);
}

/// At least one float up (down), and at most three: two but next to the denormals. Where |x| 2^-23
/// underflows, adding the least denormal is exact.
[[nodiscard]] inline float stepped_up(float x) {
  return x + (std::fabs(x) * 0x1p-23f + std::numeric_limits<float>::denorm_min());
}
[[nodiscard]] inline float stepped_down(float x) {
  return x - (std::fabs(x) * 0x1p-23f + std::numeric_limits<float>::denorm_min());
}

/// A float below (above) every number that rounds to x in double precision: the neighbour of the nearest
/// float is off by at least as much again as the nearest one, and a double's rounding is far less. Infinite
/// only next to the largest floats.
[[nodiscard]] inline float float_below(double x) {
  return stepped_down(nearest_float(x));
}
[[nodiscard]] inline float float_above(double x) {
  return stepped_up(nearest_float(x));
}

/// x -> (x - centre) * scale, scale a power of two: so that a scene far from 0 or of any size has use of all
/// the digits of a float.
struct Frame {
  std::array<double, 3> centre{};
  double scale = 1;

  Frame() = default;
  /// The frame of the box from lo to hi.
  Frame(const std::array<double, 3>& lo, const std::array<double, 3>& hi) {
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      centre[i] = lo[i] / 2 + hi[i] / 2;
      reach = std::fmax(reach, std::fmax(hi[i] - centre[i], centre[i] - lo[i]));
    }
    if (reach > 0) scale = std::ldexp(1.0, -std::max(-1000, std::min(1000, std::ilogb(reach))));
  }

  /// Correctly rounded but for a power of two, which may underflow by less than any float's spacing.
  [[nodiscard]] double map(double x, std::size_t axis) const { return (x - centre[axis]) * scale; }
};

}  // namespace gnomon::exact
