// SPDX-License-Identifier: GPL-3.0-or-later
// What the exact shadow reference costs next to CGAL's AABB_tree.
#pragma once

#include <cstddef>

namespace gnomon::bench {

struct ShadowTruthOptions {
  int rounds = 9;
  /// Pixels of the picture whose shadow queries are asked.
  std::size_t queries = 20000;
  /// Scenes of more triangles are left out.
  std::size_t most = 1'000'000;
};

/// Times exact::Hierarchy and CGAL's AABB_tree over Epick (the row cgal-epick) on the same segments, as an
/// image asks them and shuffled, and prints medians, ratios, and how many answers differ.
void print_shadow_truth(const ShadowTruthOptions& options);

}  // namespace gnomon::bench
