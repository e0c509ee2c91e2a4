// SPDX-License-Identifier: MIT
// A tree of boxes while it is built. Internal to fast/item_tree*.
#pragma once

#include <cstdint>
#include <vector>

#include "fast/box_around.h"
#include "fast/strict_float.h"
#include "scene/box.h"

namespace gnomon::fast {

/// Half of the surface. Monotone: a box around another has no smaller one, roundings included; finite for
/// all boxes of floats.
[[nodiscard]] inline double half_surface(const scene::Box<float>& box) {
  const double x = static_cast<double>(box.hi(0)) - static_cast<double>(box.lo(0));
  const double y = static_cast<double>(box.hi(1)) - static_cast<double>(box.lo(1));
  const double z = static_cast<double>(box.hi(2)) - static_cast<double>(box.lo(2));
  return x * y + (y * z + z * x);
}

/// Nodes with their children as lists. The root is node 0; without nodes there is no tree.
struct TreeSketch {
  static constexpr std::uint32_t kNone = 0xffff'ffff;

  struct Node {
    scene::Box<float> box;
    std::uint32_t primitive = kNone;  ///< a leaf's
    std::uint32_t parent = kNone, first_child = kNone, next_sibling = kNone;
    std::uint32_t children = 0;

    [[nodiscard]] bool is_leaf() const { return children == 0; }
  };
  std::vector<Node> nodes;

  void add_child(std::uint32_t parent, std::uint32_t child) {
    nodes[child].parent = parent;
    nodes[child].next_sibling = nodes[parent].first_child;
    nodes[parent].first_child = child;
    ++nodes[parent].children;
  }
};

}  // namespace gnomon::fast
