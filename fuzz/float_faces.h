// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's faces in single precision, for methods that keep their own copy.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/ball.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::fuzz {

using Vector = std::array<float, 3>;

[[nodiscard]] inline Vector to_floats(const std::array<double, 3>& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
[[nodiscard]] inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
[[nodiscard]] inline float dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[nodiscard]] inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The faces of a scene of floats, under its numbers, and the rules about own faces in floats.
struct FloatFaces {
  explicit FloatFaces(const scene::Scene& scene);

  std::vector<Vector> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<scene::Ball<float>> balls;
  std::vector<std::uint8_t> one_sided;  ///< of each triangle

  /// True when the own face is a one-sided triangle whose normal, as floats give it, turns away from the
  /// light.
  [[nodiscard]] bool faces_away(const scene::ShadowQuery& query) const {
    if (query.own >= triangles.size() || one_sided[query.own] == 0) return false;
    const auto& [i, j, k] = triangles[query.own];
    const Vector normal = cross(points[j] - points[i], points[k] - points[i]);
    return dot(normal, to_floats(query.light) - to_floats(query.point)) < 0;
  }

  /// True when the own face is a ball and `direction` leads into it.
  [[nodiscard]] bool own_ball_blocks(std::uint32_t own, const Vector& point, const Vector& direction) const {
    if (own < triangles.size() || own - triangles.size() >= balls.size()) return false;
    return dot(point - balls[own - triangles.size()].centre, direction) < 0;
  }

  [[nodiscard]] std::size_t bytes() const {
    return points.size() * sizeof(points[0]) + triangles.size() * sizeof(triangles[0]) +
           balls.size() * sizeof(balls[0]) + one_sided.size();
  }
};

}  // namespace gnomon::fuzz
