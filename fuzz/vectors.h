// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of doubles, for making queries: nothing is decided here.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon::fuzz {

using Vector3 = std::array<double, 3>;

[[nodiscard]] inline Vector3 plus(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
[[nodiscard]] inline Vector3 minus(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
[[nodiscard]] inline Vector3 times(const Vector3& a, double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
/// a + s b.
[[nodiscard]] inline Vector3 along(const Vector3& a, const Vector3& b, double s) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
[[nodiscard]] inline double dot_product(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[nodiscard]] inline Vector3 cross_product(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
[[nodiscard]] inline double length_of(const Vector3& a) {
  return std::sqrt(dot_product(a, a));
}
/// Of length 1; the zero vector where `a` has no length.
[[nodiscard]] inline Vector3 unit_of(const Vector3& a) {
  const double length = length_of(a);
  return length > 0 ? times(a, 1 / length) : Vector3{};
}
/// Each coordinate as the nearest float; beyond their range the largest one. NaN must not come.
[[nodiscard]] inline Vector3 as_floats(const Vector3& a) {
  const auto rounded = [](double x) {
    constexpr double kLargest = 0x1.fffffep127;
    return static_cast<double>(static_cast<float>(std::clamp(x, -kLargest, kLargest)));
  };
  return {rounded(a[0]), rounded(a[1]), rounded(a[2])};
}

}  // namespace gnomon::fuzz
