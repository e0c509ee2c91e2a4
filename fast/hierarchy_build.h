// SPDX-License-Identifier: MIT
// Builds the nodes and leaves of a Hierarchy. Internal to fast/hierarchy*.
#pragma once

#include <vector>

#include "fast/hierarchy_layout.h"
#include "scene/large_pages.h"
#include "scene/scene.h"

namespace gnomon::fast {

/// What a Hierarchy holds: the root is node 0, children come after their parents. No nodes without faces.
struct HierarchyArrays {
  scene::LargeVector<WideNode> nodes;
  scene::LargeVector<TriangleBlock> triangles;
  scene::LargeVector<BallBlock> balls;
  std::vector<FacePlace> places;  ///< of every face of the scene
};

/// Coordinates of the scene must be floats. O(n log n) time, the same result for the same scene everywhere.
/// Throws std::runtime_error when there are more blocks than a ChildLink can name.
[[nodiscard]] HierarchyArrays build_hierarchy(const scene::Scene& scene);

}  // namespace gnomon::fast
