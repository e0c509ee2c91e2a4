// SPDX-License-Identifier: MIT
// A binary tree of boxes and balls over a mesh's faces: the objects that hierarchical culling asks about.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/hierarchy_node.h"
#include "scene/mesh.h"

namespace gnomon::scene {

/// The mesh's points rounded to F, and the tree over its faces: nodes in preorder, root first, one face a
/// leaf, so 2 n - 1 nodes for n faces and a depth of ceil(log2 n). Each node splits at the median of its
/// faces' box centres along the axis where these spread widest (ties: the lower axis; equal centres: by face
/// number), so equal input gives an equal tree everywhere. F is float or double.
template <class F>
class BoundingHierarchy {
 public:
  /// Builds in O(n log² n) time. Throws std::runtime_error, with one line, when the mesh is not is_valid(),
  /// has over 2^31 faces, has a coordinate beyond F's finite range (used by a face or not), or is so large
  /// that a ball's radius would be beyond it.
  explicit BoundingHierarchy(const Mesh& mesh);

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  /// Node i < size(); the root is node 0, and children come after their parents.
  [[nodiscard]] const HierarchyNode<F>& node(std::size_t i) const { return nodes_[i]; }
  /// The mesh's face numbers below a node, each once; a leaf has one.
  [[nodiscard]] std::span<const std::uint32_t> faces(const HierarchyNode<F>& node) const {
    return {faces_.data() + node.first_face, node.face_count};
  }
  /// The mesh's points rounded to nearest in F, under the mesh's indices.
  [[nodiscard]] const std::vector<std::array<F, 3>>& points() const { return points_; }

 private:
  std::vector<std::array<F, 3>> points_;
  std::vector<std::uint32_t> faces_;
  std::vector<HierarchyNode<F>> nodes_;
};

extern template class BoundingHierarchy<float>;
extern template class BoundingHierarchy<double>;

}  // namespace gnomon::scene
