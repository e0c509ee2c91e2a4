// SPDX-License-Identifier: MIT
// What a PairCaster holds of its scene. Internal to fast/pair_*.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/hierarchy_build.h"

namespace gnomon::fast {

/// The corners of a TriangleBlock that it does not have itself, and all corners' numbers in the scene.
struct alignas(32) CornerBlock {
  std::array<Eight, 3> v1, v2;
  std::array<std::array<std::uint32_t, kWidth>, 3> number;
};

struct PairArrays {
  HierarchyArrays tree;
  scene::LargeVector<CornerBlock> corners;  ///< one for each of tree.triangles
  std::uint64_t number;                     ///< no two casters of a process have the same, nor 0

  /// Throws as build_hierarchy() does.
  explicit PairArrays(const scene::Scene& scene);
};

}  // namespace gnomon::fast
