// SPDX-License-Identifier: MIT
// What a bounding hierarchy is made of.
#pragma once

#include <array>
#include <cstdint>

#include "scene/ball.h"
#include "scene/box.h"

namespace gnomon::scene {

/// One node: some faces, and a box and a ball around all of their corners.
template <class F>
struct HierarchyNode {
  /// Stands for "no node": the root's parent, a leaf's children.
  static constexpr std::uint32_t kNone = 0xffff'ffff;

  Box<F> box;    ///< exact: the least and greatest coordinates of the corners, as rounded to F
  Ball<F> ball;  ///< holds every such corner, provably; centred in the box as well as F allows, not the least
                 ///< ball
  std::array<std::uint32_t, 2> children{kNone, kNone};
  std::uint32_t parent = kNone;
  std::uint32_t depth = 0;  ///< the root's is 0
  std::uint32_t first_face = 0;
  std::uint32_t face_count = 0;

  [[nodiscard]] bool is_leaf() const { return children[0] == kNone; }
};

}  // namespace gnomon::scene
