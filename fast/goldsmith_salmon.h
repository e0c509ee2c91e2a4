// SPDX-License-Identifier: MIT
// Goldsmith and Salmon's insertion into a hierarchy of boxes (IEEE Computer Graphics and Applications 7,5,
// 1987, 14-20). Internal to fast/item_tree*.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "fast/tree_sketch.h"

namespace gnomon::fast {

/// Grows a tree one box at a time, each at the place where the cost of the tree rises least. The cost is the
/// sum over the inner nodes of half the surface times the number of children: what a ray that hits the root
/// is expected to test, up to a factor that is the same for every place. The places are the authors' three:
/// a new child of an inner node; a pair with a leaf, in a new node that takes the leaf's place; and either of
/// them further down, where the growth of all the nodes above (the inherited cost) is added.
///
/// The search is best first by inherited cost, so ties among branches are all followed, and ends when no
/// branch left can be cheaper: the place is a cheapest one of all. Two limits keep crowds of equal boxes
/// from costing quadratic time, and change nothing below them: a node with kWidest children gets no more,
/// and after kMostExpanded nodes the best place so far is taken.
class GoldsmithSalmon {
 public:
  static constexpr std::uint32_t kWidest = 32;
  static constexpr std::size_t kMostExpanded = 256;

  void insert(const scene::Box<float>& box, std::uint32_t primitive);
  [[nodiscard]] const TreeSketch& tree() const { return tree_; }

 private:
  struct Place {
    double cost;
    std::uint32_t node;
  };

  [[nodiscard]] Place cheapest_place(const scene::Box<float>& box);
  void push(double inherited, std::uint32_t node);
  void grow_from(std::uint32_t node, const scene::Box<float>& box);
  std::uint32_t add_leaf(const scene::Box<float>& box, std::uint32_t primitive);

  TreeSketch tree_;
  std::vector<double> surfaces_;                        ///< of the nodes
  std::vector<std::pair<double, std::uint32_t>> open_;  ///< a heap: inherited cost with own growth, node
};

}  // namespace gnomon::fast
