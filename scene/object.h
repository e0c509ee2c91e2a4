// SPDX-License-Identifier: MIT
// Objects: what groups faces.
#pragma once

#include <cstddef>
#include <string>

namespace gnomon::scene {

/// A run of a scene's triangles and a run of its balls. Runs of different objects don't overlap.
struct Object {
  std::string name;
  std::size_t first_triangle = 0, triangle_count = 0;
  std::size_t first_ball = 0, ball_count = 0;
  double transmittance = 0;      ///< the share of light let through, from 0 (opaque) to 1
  bool declared_convex = false;  ///< what the source says, not what is so
  /// Its triangles have a front only, the side from which their corners run counterclockwise: a point of one
  /// that faces away from a light is in shadow without a blocker (`facing`). Balls are left to their own
  /// rule.
  bool one_sided = false;

  [[nodiscard]] std::size_t face_count() const { return triangle_count + ball_count; }

  friend bool operator==(const Object&, const Object&) = default;
};

}  // namespace gnomon::scene
