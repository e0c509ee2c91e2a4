// SPDX-License-Identifier: MIT
// A tree whose branches fork in two, with a leaf of glass at the end of each twig.
#include <cmath>

#include "scene/builtin_list.h"
#include "scene/modeller.h"

namespace gnomon::scene {
namespace {

/// All coordinates stay below 8: 22 bits, so that a hexagon's corners and their halves are exact.
constexpr double kStep = 0x1p-19;

Point3 plus(const Point3& p, const Point3& q, double factor = 1) {
  return {p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2]};
}

Point3 cross(const Point3& p, const Point3& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

Point3 scaled_to(const Point3& p, double length) {
  return plus({0, 0, 0}, p, length / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
}

/// To multiples of four steps, of which quarters are still on the lattice.
Point3 coarse(const Point3& p) {
  Point3 q;
  for (std::size_t k = 0; k < 3; ++k) q[k] = std::floor(p[k] / (4 * kStep) + 0.5) * (4 * kStep);
  return q;
}

class Tree {
 public:
  explicit Tree(Modeller& modeller) : modeller_(modeller) {}

  /// A branch from `base` along `axis`, and what grows on it. `side` is any direction across.
  void add(const Point3& base, const Point3& axis, const Point3& side, double radius, std::uint32_t depth) {
    // An affinely regular hexagon u, v, v - u, -u, -v, u - v: its sides are parallel to those of the
    // hexagon at the thinner end, so that the six sides of the branch are flat exactly.
    const Point3 across = scaled_to(cross(axis, side), 1), along = scaled_to(cross(across, axis), 1);
    const Point3 u = coarse(plus({0, 0, 0}, along, radius));
    const Point3 v = coarse(plus(plus({0, 0, 0}, along, radius / 2), across, radius * std::sqrt(0.75)));
    const Point3 bottom = coarse(base), top = coarse(plus(base, axis));
    std::vector<Point3> rings[2];
    for (const auto& [i, j] : {std::pair(1, 0), {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}) {
      const Point3 offset = plus(plus({0, 0, 0}, u, i), v, j);
      rings[0].push_back(plus(bottom, offset));
      rings[1].push_back(plus(top, offset, 0.75));
    }
    modeller_.object(depth == 0 ? "twig" : "branch", Shape::convex);
    modeller_.loft(rings);
    if (depth == 0) {
      const Point3 tip = plus(top, axis, 0.25);
      modeller_.object("leaf", Shape::convex, 0.5);
      modeller_.ball(tip, 0.25 * std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]));
      return;
    }
    // Lean 30 degrees to either side, in planes that turn by a right angle from fork to fork.
    const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const Point3 forward = scaled_to(axis, 0.8 * std::sqrt(0.75) * length);
    for (const double way : {-0.4, 0.4}) {
      add(top, plus(forward, along, way * length), across, 0.75 * radius, depth - 1);
    }
  }

 private:
  Modeller& modeller_;
};

Scene make(std::uint32_t depth) {
  Modeller modeller(kStep);
  modeller.object("ground", Shape::convex);
  modeller.box({-4, -4, -0.125}, {4, 4, 0});
  Tree(modeller).add({0, 0, 0}, {0, 0, 1.25}, {1, 0, 0}, 0.125, depth);
  modeller.point_light({3, -3, 6});
  modeller.point_light({-4, -1, 5});
  modeller.point_light({1, 4, 7});
  modeller.view({5, -9.5, 3.5}, {0, 0, 2.25}, 40);
  return modeller.finish();
}

}  // namespace

BuiltinScene tree_scene() {
  return {"tree",
          "a tree with leaves of glass, each branch and leaf an object",
          "how often branches fork",
          "light buffer, \"Glass-Leaved Tree\" (256 transparent balls, 3 lights)",
          8,
          16,
          [](std::uint32_t size) {
            const std::size_t leaves = std::size_t{1} << size;
            return 12 + 20 * (2 * leaves - 1) + leaves;
          },
          make};
}

}  // namespace gnomon::scene
