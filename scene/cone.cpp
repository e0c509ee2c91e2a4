// SPDX-License-Identifier: MIT
#include "scene/cone.h"

#include <algorithm>
#include <cmath>

namespace gnomon::scene {
namespace {

using Vector = std::array<double, 3>;
using Circle = std::array<std::array<double, 2>, kConeSides>;

/// Points at equal distances on the unit circle, from (1, 0) on, counterclockwise: one quarter by bisecting
/// it, the others by turning it.
Circle unit_circle() {
  constexpr std::size_t kQuarter = kConeSides / 4;
  static_assert((kQuarter & (kQuarter - 1)) == 0, "the quarter is bisected");
  Circle circle{};
  circle[0] = {1, 0};
  circle[kQuarter] = {0, 1};
  for (std::size_t step = kQuarter / 2; step > 0; step /= 2) {
    for (std::size_t i = step; i < kQuarter; i += 2 * step) {
      const double x = circle[i - step][0] + circle[i + step][0];
      const double y = circle[i - step][1] + circle[i + step][1];
      const double length = std::sqrt(x * x + y * y);
      circle[i] = {x / length, y / length};
    }
  }
  for (std::size_t i = kQuarter; i < kConeSides; ++i)
    circle[i] = {-circle[i - kQuarter][1], circle[i - kQuarter][0]};
  return circle;
}

/// The vector over its length, in two steps, so that no square over- or underflows.
Vector normalised(const Vector& v) {
  const double greatest = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
  const Vector w{v[0] / greatest, v[1] / greatest, v[2] / greatest};
  const double length = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  return {w[0] / length, w[1] / length, w[2] / length};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// From base to apex, halved when the difference itself would overflow.
Vector axis_of(const Cone& cone) {
  Vector axis{};
  for (std::size_t i = 0; i < 3; ++i) axis[i] = cone.apex[i] - cone.base[i];
  if (std::ranges::all_of(axis, [](double c) { return std::isfinite(c); })) return axis;
  for (std::size_t i = 0; i < 3; ++i) axis[i] = cone.apex[i] / 2 - cone.base[i] / 2;
  return axis;
}

/// The coordinate axis that is the farthest from the direction's own.
Vector farthest_axis(const Vector& direction) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::fabs(direction[i]) < std::fabs(direction[least])) least = i;
  }
  Vector axis{};
  axis[least] = 1;
  return axis;
}

}  // namespace

std::optional<ConeRings> rings_of(const Cone& cone) {
  if (cone.base == cone.apex) return std::nullopt;
  static const Circle circle = unit_circle();
  const Vector axis = normalised(axis_of(cone));
  const Vector u = normalised(cross(farthest_axis(axis), axis)), v = cross(axis, u);
  ConeRings rings{};
  for (std::size_t k = 0; k < kConeSides; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double outward = circle[k][0] * u[i] + circle[k][1] * v[i];
      rings.base[k][i] = cone.base[i] + cone.base_radius * outward;
      rings.apex[k][i] = cone.apex[i] + cone.apex_radius * outward;
      if (!std::isfinite(rings.base[k][i]) || !std::isfinite(rings.apex[k][i])) return std::nullopt;
    }
  }
  return rings;
}

}  // namespace gnomon::scene
