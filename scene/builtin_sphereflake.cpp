// SPDX-License-Identifier: MIT
// A ball with nine balls of a third of its size on it, six around its equator and three above, again and
// again.
#include <cmath>

#include "scene/builtin_list.h"
#include "scene/modeller.h"
#include "scene/turn.h"

namespace gnomon::scene {
namespace {

/// Three perpendicular unit vectors; the last points away from the ball that this one sits on.
using Frame = std::array<Point3, 3>;

Point3 combined(const Frame& frame, double x, double y, double z) {
  Point3 p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = x * frame[0][k] + y * frame[1][k] + z * frame[2][k];
  return p;
}

class Flake {
 public:
  explicit Flake(Modeller& modeller) : modeller_(modeller) {}

  void add(const Point3& centre, double radius, const Frame& frame, std::uint32_t depth) {
    modeller_.object("ball", Shape::convex);
    modeller_.ball(centre, radius);
    if (depth == 0) return;
    const double root = std::sqrt(0.75);
    for (std::uint64_t k = 0; k < 9; ++k) {
      // Six at height 0, and three at 60 degrees between them.
      const bool above = k >= 6;
      const Direction d = above ? turn(2 * (k - 6) + 1, 6) : turn(k, 6);
      const double across = above ? 0.5 : 1, up = above ? root : 0;
      const Point3 axis = combined(frame, across * d.cos, across * d.sin, up);
      const Frame child{combined(frame, up * d.cos, up * d.sin, -across), combined(frame, -d.sin, d.cos, 0),
                        axis};
      const double distance = radius * 4 / 3;
      add({centre[0] + distance * axis[0], centre[1] + distance * axis[1], centre[2] + distance * axis[2]},
          radius / 3, child, depth - 1);
    }
  }

 private:
  Modeller& modeller_;
};

Scene make(std::uint32_t depth) {
  Modeller modeller(0x1p-21);
  modeller.object("ground", Shape::convex);
  modeller.box({-3, -3, -1.75}, {3, 3, -1.625});
  Flake(modeller).add({0, 0, 0}, 0.75, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, depth);
  modeller.point_light({3, -2, 4});
  modeller.point_light({-3, -3, 3});
  modeller.point_light({0, 3.5, 3.5});
  modeller.view({2, -2.75, 2}, {0, 0, 0}, 45);
  return modeller.finish();
}

std::size_t faces(std::uint32_t depth) {
  std::size_t power = 9;
  for (std::uint32_t i = 0; i < depth; ++i) power *= 9;
  return 12 + (power - 1) / 8;
}

}  // namespace

BuiltinScene sphereflake_scene() {
  return {"sphereflake",
          "balls on balls, each an object, over a slab",
          "how often each ball gets nine smaller ones",
          "voxel occlusion, \"Flakes\"",
          4,
          7,
          faces,
          make};
}

}  // namespace gnomon::scene
