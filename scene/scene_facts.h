// SPDX-License-Identifier: MIT
// What can be counted of a scene.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/box.h"
#include "scene/scene.h"

namespace gnomon::scene {

struct SceneFacts {
  std::size_t degenerate = 0;  ///< triangles whose corners lie on one line (exactly), and balls of radius 0
  /// Faces less distinct faces: triangles with the same corners in any order, balls with the same numbers.
  std::size_t duplicate = 0;
  /// For each object: true when each edge of its triangles belongs to exactly two of them. A triangle with
  /// two equal corners has no edges; balls are closed.
  std::vector<bool> closed;
  Box<double> extent;  ///< the least box of doubles that holds all faces

  [[nodiscard]] std::size_t closed_objects() const;
};

/// The least box of doubles that holds all faces of a scene that is_valid(). Linear.
[[nodiscard]] Box<double> extent_of(const Scene& scene);

/// The facts of a scene that is_valid(). O(n log n) in its faces.
[[nodiscard]] SceneFacts facts_of(const Scene& scene);

}  // namespace gnomon::scene
