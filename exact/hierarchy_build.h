// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the nodes of exact/hierarchy.h. Internal to exact/.
#pragma once

#include "exact/frame.h"
#include "exact/wide_node.h"
#include "scene/large_pages.h"
#include "scene/scene.h"

namespace gnomon::exact {

/// No path from the root has more nodes.
inline constexpr std::size_t kMostLevels = 80;

struct BuiltHierarchy {
  Frame frame;
  scene::LargeVector<WideNode> nodes;  ///< the root first; none for a scene without faces
  /// One of them holds the faces, the other one nothing.
  scene::LargeVector<Leaf<float>> float_leaves;
  scene::LargeVector<Leaf<double>> double_leaves;

  template <class F>
  [[nodiscard]] const Leaf<F>* leaves() const {
    if constexpr (sizeof(F) == sizeof(float)) {
      return float_leaves.data();
    } else {
      return double_leaves.data();
    }
  }
};

/// A hierarchy over all faces of a valid scene, split where the binned surface area heuristic says (Wald:
/// "On fast construction of SAH-based bounding volume hierarchies", 2007).
[[nodiscard]] BuiltHierarchy build_hierarchy(const scene::Scene& scene);

}  // namespace gnomon::exact
