// SPDX-License-Identifier: MIT
#include "fast/goldsmith_salmon.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace gnomon::fast {

std::uint32_t GoldsmithSalmon::add_leaf(const scene::Box<float>& box, std::uint32_t primitive) {
  TreeSketch::Node leaf;
  leaf.box = box;
  leaf.primitive = primitive;
  tree_.nodes.push_back(leaf);
  surfaces_.push_back(half_surface(box));
  return static_cast<std::uint32_t>(tree_.nodes.size() - 1);
}

void GoldsmithSalmon::push(double inherited, std::uint32_t node) {
  open_.emplace_back(inherited, node);
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
}

GoldsmithSalmon::Place GoldsmithSalmon::cheapest_place(const scene::Box<float>& box) {
  const auto grown = [&](std::uint32_t node) { return half_surface(box_around(tree_.nodes[node].box, box)); };
  // What a pair of the box with the leaf costs: a node of two children.
  if (tree_.nodes[0].is_leaf()) return {2 * grown(0), 0};

  const double own = half_surface(box);
  Place best{std::numeric_limits<double>::infinity(), 0};
  open_.clear();
  push(tree_.nodes[0].children * (grown(0) - surfaces_[0]), 0);
  for (std::size_t expanded = 0; !open_.empty() && expanded < kMostExpanded; ++expanded) {
    const auto [inherited, node] = open_.front();
    // Every place at the node or below costs at least what a node of the box's own size would.
    if (inherited + own >= best.cost) break;
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    open_.pop_back();
    const TreeSketch::Node& parent = tree_.nodes[node];
    if (parent.children < kWidest) {
      const double cost = inherited + grown(node);
      if (cost < best.cost) best = {cost, node};
    }
    for (std::uint32_t c = parent.first_child; c != TreeSketch::kNone; c = tree_.nodes[c].next_sibling) {
      const TreeSketch::Node& child = tree_.nodes[c];
      const double surface = grown(c);
      if (child.is_leaf()) {
        const double cost = inherited + 2 * surface;
        if (cost < best.cost) best = {cost, c};
      } else {
        const double with_growth = inherited + child.children * (surface - surfaces_[c]);
        if (with_growth + own < best.cost) push(with_growth, c);
      }
    }
  }
  return best;
}

void GoldsmithSalmon::grow_from(std::uint32_t node, const scene::Box<float>& box) {
  for (; node != TreeSketch::kNone; node = tree_.nodes[node].parent) {
    tree_.nodes[node].box = box_around(tree_.nodes[node].box, box);
    surfaces_[node] = half_surface(tree_.nodes[node].box);
  }
}

void GoldsmithSalmon::insert(const scene::Box<float>& box, std::uint32_t primitive) {
  if (tree_.nodes.empty()) {
    add_leaf(box, primitive);
    return;
  }
  const std::uint32_t place = cheapest_place(box).node;
  if (tree_.nodes[place].is_leaf()) {
    // The leaf's node becomes the pair, so that nothing above has to be linked anew.
    const TreeSketch::Node leaf = tree_.nodes[place];
    tree_.nodes[place].primitive = TreeSketch::kNone;
    tree_.add_child(place, add_leaf(leaf.box, leaf.primitive));
  }
  tree_.add_child(place, add_leaf(box, primitive));
  grow_from(place, box);
}

}  // namespace gnomon::fast
