// SPDX-License-Identifier: GPL-3.0-or-later
// What the exact shadow reference costs next to CGAL's AABB_tree.
#pragma once

#include <cstddef>
#include <memory>

#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::bench {

struct ShadowTruthOptions {
  int rounds = 9;
  /// Pixels of the picture whose shadow queries are asked.
  std::size_t queries = 20000;
  /// Scenes of more triangles are left out.
  std::size_t most = 1'000'000;
};

/// Times exact::Hierarchy and CGAL's AABB_tree<Epick>::do_intersect on the same segments, as an image asks
/// them and shuffled, and prints medians, ratios, and how many answers differ.
void print_shadow_truth(const ShadowTruthOptions& options);

/// CGAL's tree over the triangles of a scene, in a translation unit of its own.
class CgalTree {
 public:
  explicit CgalTree(const scene::Scene& scene);
  ~CgalTree();
  CgalTree(const CgalTree&) = delete;
  CgalTree& operator=(const CgalTree&) = delete;

  /// True when the closed segment meets a triangle; own faces are met like any other.
  [[nodiscard]] bool meets(const scene::ShadowQuery& query) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace gnomon::bench
