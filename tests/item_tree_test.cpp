// SPDX-License-Identifier: GPL-3.0-or-later
// fast/item_tree.h: both builders against their definitions, and volumes against what they hold.
#include "fast/item_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "exact/polygons.h"
#include "fast/goldsmith_salmon.h"
#include "fast/sah_sketch.h"
#include "scene/builtin.h"
#include "tests/scene_cases.h"

namespace gnomon::tests {
namespace {

using fast::Item;
using fast::ItemTree;
using fast::kNoItem;
using fast::TreeBuild;
using fast::TreeSketch;
using fast::Volumes;
using scene::FaceRun;
using scene::Scene;

using FloatBox = scene::Box<float>;

FloatBox random_float_box(Random& random, int most, int size) {
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo(axis) = static_cast<float>(random.below(most));
    box.hi(axis) = box.lo(axis) + static_cast<float>(random.below(size));
  }
  return box;
}

/// Whether the ball holds the point; a centre, a radius and a point of 24 bits each give exact products
/// in 64.
bool holds(const scene::Ball<float>& ball, const std::array<float, 3>& p, float reach) {
  if (std::isinf(ball.radius)) return true;
  using Wide = long double;
  Wide squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide apart = static_cast<Wide>(p[k]) - static_cast<Wide>(ball.centre[k]);
    squared += apart * apart;
  }
  const Wide left = static_cast<Wide>(ball.radius) - static_cast<Wide>(reach);
  return left >= 0 && left * left >= squared;
}

void check_tree(const Scene& scene, const ItemTree& tree, std::size_t primitives) {
  std::vector<int> seen(scene.face_count(), 0);
  std::size_t leaves = 0;
  for (std::uint32_t i = 0; i < tree.size(); ++i) {
    const Item& item = tree.item(i);
    leaves += item.is_primitive();
    for (std::uint32_t k = 0; k < item.count(); ++k) {
      if (item.is_primitive()) {
        const std::uint32_t face = item.first + k;
        ++seen[face];
        ASSERT_EQ(tree.primitive_of(face), i);
        // Every volume above holds the face.
        for (std::uint32_t above = i; above != kNoItem; above = tree.parent(above)) {
          const FloatBox& box = tree.item(above).box;
          const float reach = tree.is_ball(face) ? tree.scene_ball(face).radius : 0;
          std::vector<std::array<float, 3>> points;
          if (tree.is_ball(face)) {
            points.push_back(tree.scene_ball(face).centre);
          } else {
            points.assign(tree.triangle(face).begin(), tree.triangle(face).end());
          }
          for (const auto& p : points) {
            for (int axis = 0; axis < 3; ++axis) {
              const auto x = static_cast<double>(p[static_cast<std::size_t>(axis)]);
              ASSERT_LE(static_cast<double>(box.lo(axis)), x - static_cast<double>(reach));
              ASSERT_GE(static_cast<double>(box.hi(axis)), x + static_cast<double>(reach));
            }
            if (tree.volumes() == Volumes::spheres) {
              ASSERT_TRUE(holds(tree.ball(above), p, reach)) << above;
            }
          }
        }
      } else {
        ASSERT_GT(item.first + k, i);
        ASSERT_EQ(tree.parent(item.first + k), i);
      }
    }
    if (!item.is_primitive()) {
      ASSERT_GE(item.count(), 2u);
    }
  }
  EXPECT_EQ(leaves, primitives);
  for (const int times : seen) ASSERT_EQ(times, 1);

  // The stack of a walk that opens everything stays within what the tree says.
  std::vector<std::uint32_t> open{0};
  std::size_t most = 1;
  while (!open.empty()) {
    const Item& item = tree.item(open.back());
    open.pop_back();
    for (std::uint32_t k = 0; !item.is_primitive() && k < item.count(); ++k) open.push_back(item.first + k);
    most = std::max(most, open.size());
  }
  EXPECT_LE(most, tree.stack_size());
}

bool same(const ItemTree& a, const ItemTree& b) {
  if (a.size() != b.size()) return false;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    if (a.item(i).box != b.item(i).box || a.item(i).first != b.item(i).first ||
        a.item(i).bits != b.item(i).bits)
      return false;
  }
  return true;
}

TEST(ItemTree, VolumesHoldWhatIsBelowAndEveryPrimitiveIsThereOnce) {
  Random random(1);
  int different = 0;
  for (int trial = 0; trial < 60 && !HasFatalFailure(); ++trial) {
    const bool grid = trial % 2 == 0;
    const Scene scene =
        random_scene(random, {random.between(0, 60), random.between(1, 30), grid}, Placement());
    const std::vector<FaceRun> polygons = exact::polygons_of(scene);
    for (const TreeBuild build : {TreeBuild::goldsmith_salmon, TreeBuild::sah}) {
      for (const Volumes volumes : {Volumes::boxes, Volumes::spheres}) {
        const ItemTree tree(scene, polygons, build, volumes, 7);
        check_tree(scene, tree, polygons.size());
        EXPECT_TRUE(same(tree, ItemTree(scene, polygons, build, volumes, 7)));
        different += !same(tree, ItemTree(scene, polygons, build, volumes, 8));
      }
    }
  }
  EXPECT_GT(different, 60);   // the seed shuffles
  EXPECT_LE(different, 120);  // and matters to insertion alone
  const Scene office = scene::find_builtin("office:1")->make();
  const std::vector<FaceRun> polygons = exact::polygons_of(office);
  check_tree(office, ItemTree(office, polygons), polygons.size());
}

/// The cost of the tree from its definition.
double cost_of(const TreeSketch& tree) {
  double sum = 0;
  for (const TreeSketch::Node& node : tree.nodes) {
    if (!node.is_leaf()) sum += fast::half_surface(node.box) * node.children;
  }
  return sum;
}

/// What the tree costs once `box` is a child of the inner node, or paired with the leaf: by trying.
double cost_with(TreeSketch tree, std::uint32_t node, const FloatBox& box) {
  if (tree.nodes[node].is_leaf()) {
    tree.nodes.emplace_back();
    tree.nodes.back().box = tree.nodes[node].box;
    tree.add_child(node, static_cast<std::uint32_t>(tree.nodes.size() - 1));
  }
  tree.nodes.emplace_back();
  tree.nodes.back().box = box;
  tree.add_child(node, static_cast<std::uint32_t>(tree.nodes.size() - 1));
  for (std::uint32_t i = node; i != TreeSketch::kNone; i = tree.nodes[i].parent)
    tree.nodes[i].box = fast::box_around(tree.nodes[i].box, box);
  return cost_of(tree);
}

// Small integers: all costs are exact, so that the least one can be compared with ==.
TEST(ItemTree, GoldsmithAndSalmonInsertWhereTheCostRisesLeast) {
  Random random(2);
  int children = 0, pairs = 0, deep = 0;
  for (int trial = 0; trial < 400 && !HasFailure(); ++trial) {
    fast::GoldsmithSalmon inserter;
    for (std::uint32_t i = 0; i < 14; ++i) {
      const FloatBox box = random_float_box(random, 30, 1 + trial % 30);
      double least = std::numeric_limits<double>::infinity();
      const TreeSketch before = inserter.tree();
      for (std::uint32_t node = 0; node < before.nodes.size(); ++node)
        least = std::min(least, cost_with(before, node, box));
      inserter.insert(box, i);
      if (i == 0) continue;
      ASSERT_EQ(cost_of(inserter.tree()), least);
      (inserter.tree().nodes.size() - before.nodes.size() == 1 ? children : pairs) += 1;
      deep += inserter.tree().nodes.back().parent != 0;
    }
  }
  // All three cases occur.
  EXPECT_GT(children, 300);
  EXPECT_GT(pairs, 1000);
  EXPECT_GT(deep, 1000);
}

// Without a limit the root would take all of them, and each would be compared with all before it.
TEST(ItemTree, CrowdsOfEqualBoxesAreSpreadOverNodesOfLimitedWidth) {
  fast::GoldsmithSalmon inserter;
  std::uint32_t widest = 0;
  for (std::uint32_t i = 0; i < 5000; ++i) inserter.insert({{0, 0, 0, 1, 1, 1}}, i);
  for (const TreeSketch::Node& node : inserter.tree().nodes) widest = std::max(widest, node.children);
  EXPECT_EQ(widest, fast::GoldsmithSalmon::kWidest);
}

// Centres on different integers, so that bins part all boxes: then the best of all splits in order is taken.
TEST(ItemTree, SahSplitsWhereTheHeuristicIsLeast) {
  Random random(3);
  for (int trial = 0; trial < 200 && !HasFailure(); ++trial) {
    std::vector<FloatBox> boxes;
    for (int i = 0; i < 20; ++i) {
      FloatBox box;
      for (int axis = 0; axis < 3; ++axis) {
        const int half = random.below(9), centre = (i * (axis == 0 ? 1 : axis == 1 ? 3 : 7)) % 20;
        box.lo(axis) = static_cast<float>(centre - half);
        box.hi(axis) = static_cast<float>(centre + half);
      }
      boxes.push_back(box);
    }
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      std::sort(boxes.begin(), boxes.end(), [&](const FloatBox& a, const FloatBox& b) {
        return a.lo(axis) + a.hi(axis) < b.lo(axis) + b.hi(axis);
      });
      for (std::size_t first = 1; first < boxes.size(); ++first) {
        FloatBox low = boxes[0], high = boxes.back();
        for (std::size_t i = 0; i < boxes.size(); ++i)
          (i < first ? low : high) = fast::box_around(i < first ? low : high, boxes[i]);
        least = std::min(least, fast::half_surface(low) * static_cast<double>(first) +
                                    fast::half_surface(high) * static_cast<double>(boxes.size() - first));
      }
    }
    const TreeSketch tree = fast::sketch_by_sah(boxes);
    double found = 0;
    std::uint32_t below = 0;
    for (std::uint32_t c = tree.nodes[0].first_child; c != TreeSketch::kNone;
         c = tree.nodes[c].next_sibling) {
      std::vector<std::uint32_t> open{c};
      std::uint32_t leaves = 0;
      while (!open.empty()) {
        const TreeSketch::Node& node = tree.nodes[open.back()];
        open.pop_back();
        leaves += node.is_leaf();
        for (std::uint32_t k = node.first_child; k != TreeSketch::kNone; k = tree.nodes[k].next_sibling)
          open.push_back(k);
      }
      found += fast::half_surface(tree.nodes[c].box) * leaves;
      below += leaves;
    }
    EXPECT_EQ(below, boxes.size());
    EXPECT_EQ(found, least);
  }
}

TEST(ItemTree, RefusesWhatIsNoFloatAndRunsThatAreNotEveryFaceOnce) {
  scene::SceneBuilder builder;
  builder.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  builder.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 1});
  builder.add_ball({{0, 0, 0}, 1});
  builder.add_ball({{0, 0, 0}, 2});
  Scene scene = builder.finish();
  const std::vector<FaceRun> good{{0, 2}, {2, 1}, {3, 1}};
  EXPECT_EQ(ItemTree(scene, good).face_count(), 4u);
  for (const std::vector<FaceRun>& runs :
       {std::vector<FaceRun>{{0, 2}, {2, 2}}, std::vector<FaceRun>{{0, 3}, {3, 1}},
        std::vector<FaceRun>{{0, 2}, {2, 1}}, std::vector<FaceRun>{{0, 2}, {2, 1}, {3, 1}, {3, 1}},
        std::vector<FaceRun>{{0, 2}, {2, 1}, {3, 1}, {4, 1}}, std::vector<FaceRun>{{0, 2}, {2, 1}, {3, 0}}}) {
    EXPECT_THROW(ItemTree(scene, runs), std::runtime_error);
  }
  scene.balls[0].radius = 0.1;
  EXPECT_THROW(ItemTree(scene, good), std::runtime_error);
  scene.balls[0] = {{3e38, 0, 0}, 1};
  scene.balls[0].centre[0] = static_cast<double>(std::numeric_limits<float>::max());
  EXPECT_THROW(ItemTree(scene, good), std::runtime_error);
  EXPECT_TRUE(ItemTree(Scene(), {}).empty());
  EXPECT_EQ(ItemTree(Scene(), {}).cost(), 0);
}

}  // namespace
}  // namespace gnomon::tests
