// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mesh_generator.h"

#include <stdexcept>

#include "fuzz/shapes.h"
#include "scene/bounding_hierarchy.h"
#include "scene/read_mesh.h"

namespace gnomon::fuzz {

namespace {

using scene::BoundingHierarchy;
using scene::HierarchyNode;

template <class F>
class NodePicker {
 public:
  explicit NodePicker(const scene::Mesh& mesh) : tree_(mesh) {}

  [[nodiscard]] const BoundingHierarchy<F>& tree() const { return tree_; }

  /// A node reached by `depth` random turns from the root, or the leaf before.
  [[nodiscard]] std::size_t at_depth(CaseRandom& random, int depth) const {
    std::size_t node = 0;
    for (int i = 0; i < depth && !tree_.node(node).is_leaf(); ++i)
      node = child(node, (random.bits() & 1u) != 0);
    return node;
  }

  /// The path from the root to the leaf whose boxes lie nearest to a point, cut at a random depth.
  [[nodiscard]] std::size_t towards(CaseRandom& random, const std::array<F, 3>& point, int depth) const {
    std::size_t node = 0;
    for (int i = 0; i < depth && !tree_.node(node).is_leaf(); ++i) {
      const std::size_t left = child(node, false), right = child(node, true);
      const bool stray = random.chance(0.1);
      node = (distance(left, point) <= distance(right, point)) != stray ? left : right;
    }
    return node;
  }

  [[nodiscard]] std::size_t child(std::size_t node, bool second) const {
    return tree_.node(node).children[second ? 1 : 0];
  }

 private:
  [[nodiscard]] F distance(std::size_t node, const std::array<F, 3>& point) const {
    const scene::Box<F>& box = tree_.node(node).box;
    F sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      sum += std::fabs(box.lo(axis) / 2 + box.hi(axis) / 2 - point[static_cast<std::size_t>(axis)]);
    }
    return sum;
  }

  BoundingHierarchy<F> tree_;
};

template <class Case, class F>
class MeshGenerator final : public Generator<Case> {
 public:
  explicit MeshGenerator(const scene::Mesh& mesh) : picker_(mesh) {
    for (std::size_t nodes = picker_.tree().size(); nodes > 1; nodes /= 2) ++levels_;
  }

  [[nodiscard]] Case make(CaseRandom& random) const override {
    const BoundingHierarchy<F>& tree = picker_.tree();
    const int depth = random.integer(1, levels_);
    const std::size_t a = picker_.at_depth(random, depth);
    const std::size_t b = picker_.at_depth(random, random.integer(std::max(1, depth - 2), depth));
    random.part(Part::t);
    std::size_t t = 0;
    const int deep = random.integer(0, levels_), kind = random.below(10);
    if (kind < 3) {
      t = picker_.at_depth(random, deep);
    } else if (kind < 8) {
      const F s = random.unit<F>();
      std::array<F, 3> point{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const F from = random.between<F>(tree.node(a).box.c[axis], tree.node(a).box.c[axis + 3]);
        const F to = random.between<F>(tree.node(b).box.c[axis], tree.node(b).box.c[axis + 3]);
        point[axis] = from + s * (to - from);
      }
      t = picker_.towards(random, point, deep);
    } else {
      t = relative(random, kind == 8 ? a : b);
    }
    return build(tree.node(a), tree.node(b), tree.node(t));
  }

 private:
  /// A descendant of the node.
  [[nodiscard]] std::size_t relative(CaseRandom& random, std::size_t node) const {
    for (int i = random.below(4); i > 0 && !picker_.tree().node(node).is_leaf(); --i) {
      node = picker_.child(node, (random.bits() & 1u) != 0);
    }
    return node;
  }

  [[nodiscard]] static Case build(const HierarchyNode<F>& a, const HierarchyNode<F>& b,
                                  const HierarchyNode<F>& t) {
    if constexpr (std::is_same_v<Case, scene::ShaftBoxCase>) {
      return scene::converted<double>(Triple<F>{a.box, b.box, t.box});
    } else {
      return scene::converted<double>(scene::ShaftBallCaseOf<F>{a.box, b.box, t.ball});
    }
  }

  NodePicker<F> picker_;
  int levels_ = 1;
};

}  // namespace

template <class Case, class F>
std::unique_ptr<Generator<Case>> make_mesh_generator(const std::string& file) {
  const scene::Mesh mesh = scene::read_mesh(file);
  try {
    return std::make_unique<MeshGenerator<Case, F>>(mesh);
  } catch (const std::runtime_error& error) {
    throw UsageError(file + ": " + error.what());
  }
}

template std::unique_ptr<Generator<scene::ShaftBoxCase>> make_mesh_generator<scene::ShaftBoxCase, float>(
    const std::string&);
template std::unique_ptr<Generator<scene::ShaftBoxCase>> make_mesh_generator<scene::ShaftBoxCase, double>(
    const std::string&);
template std::unique_ptr<Generator<scene::ShaftBallCase>> make_mesh_generator<scene::ShaftBallCase, float>(
    const std::string&);
template std::unique_ptr<Generator<scene::ShaftBallCase>> make_mesh_generator<scene::ShaftBallCase, double>(
    const std::string&);

}  // namespace gnomon::fuzz
