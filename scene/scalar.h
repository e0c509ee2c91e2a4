// SPDX-License-Identifier: MIT
// The two floating-point formats that cases and methods use.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

namespace gnomon::scene {

enum class Scalar : std::uint8_t { f32, f64 };

[[nodiscard]] constexpr std::string_view name_of(Scalar scalar) {
  return scalar == Scalar::f32 ? "f32" : "f64";
}

/// True when `value` is a float: converting it there and back changes nothing (infinities: true; NaN: false).
[[nodiscard]] inline bool is_float(double value) {
  // A double beyond the largest float must not be converted: that would be undefined where it rounds to no
  // float.
  if (!(std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max()))) return std::isinf(value);
  return static_cast<double>(static_cast<float>(value)) == value;
}

/// The distance from |value| to the next larger number of the format (the ulp of design rules: one for each
/// binade; that of denormals below the smallest normal number); of the largest one to the next smaller.
[[nodiscard]] inline double ulp_of(double value, Scalar scalar) {
  const auto ulp = [](auto magnitude) {
    using F = decltype(magnitude);
    const F above = std::nextafter(magnitude, std::numeric_limits<F>::infinity());
    const F low = std::isinf(above) ? std::nextafter(magnitude, F(0)) : magnitude;
    return static_cast<double>((std::isinf(above) ? magnitude : above) - low);
  };
  const double magnitude = std::fabs(value);
  return scalar == Scalar::f32 ? ulp(static_cast<float>(magnitude)) : ulp(magnitude);
}

}  // namespace gnomon::scene
