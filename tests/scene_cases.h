// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes and paths through them, full of ties: what the tests of `shadow` and `first-hit` draw from.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/ray_query.h"
#include "scene/scene_builder.h"
#include "scene/shadow_case.h"
#include "scene/shadow_query.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {

using Point3 = std::array<double, 3>;

/// What numbers are made of: x is multiplied by 2^exponent and moved by `offset`, exactly for small integers.
struct Placement {
  int exponent = 0;
  double offset = 0;

  [[nodiscard]] double place(double x) const { return std::ldexp(x, exponent) + offset; }
  [[nodiscard]] Point3 operator()(const Point3& p) const { return {place(p[0]), place(p[1]), place(p[2])}; }
  [[nodiscard]] double length(double x) const { return std::ldexp(x, exponent); }
};

inline constexpr std::array<Placement, 6> kPlacements{
    {{0, 0}, {0, 1e5}, {-3, -1e5}, {-1074, 0}, {-1000, 0}, {1019, 0}}};

inline Point3 grid_point(Random& random, int most = 3) {
  return {static_cast<double>(random.below(most + 1)), static_cast<double>(random.below(most + 1)),
          static_cast<double>(random.below(most + 1))};
}

inline Point3 float_point(Random& random) {
  return {static_cast<float>(random.unit()), static_cast<float>(random.unit()),
          static_cast<float>(random.unit())};
}

struct SceneShape {
  int triangles = 0, balls = 0;
  bool grid = true;
};

/// A few objects of triangles and balls; some triangles are there twice, degenerate, or share corners.
inline scene::Scene random_scene(Random& random, const SceneShape& shape, const Placement& place) {
  scene::SceneBuilder builder;
  const auto point = [&] { return place(shape.grid ? grid_point(random) : float_point(random)); };
  std::array<Point3, 3> last{point(), point(), point()};
  for (int i = 0; i < shape.triangles; ++i) {
    if (i == 0 || random.chance(30)) builder.begin_object("o" + std::to_string(i), 0, random.chance(40));
    for (std::size_t k = 0; k < 3; ++k) {
      if (!random.chance(i == 0 ? 0 : 50)) last[k] = point();
    }
    if (random.chance(3)) last[2] = last[0];
    builder.add_triangle(last[0], last[1], last[2]);
  }
  for (int i = 0; i < shape.balls; ++i) {
    if (i == 0 || random.chance(30)) builder.begin_object("b" + std::to_string(i), 0, random.chance(40));
    const double radius =
        shape.grid ? random.below(3) : static_cast<double>(static_cast<float>(random.unit() / 3));
    builder.add_ball({point(), place.length(radius)});
  }
  return builder.finish();
}

/// The surface of the box 0..size, `cells` x `cells` squares a side, each cut along one of its diagonals:
/// closed, all corners on a grid.
inline scene::Scene box_mesh(Random& random, int cells, const Placement& place) {
  scene::SceneBuilder builder;
  builder.begin_object("box", 0, false);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double side : {0.0, static_cast<double>(cells)}) {
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          const auto corner = [&](int u, int v) {
            Point3 p;
            p[axis] = side;
            p[(axis + 1) % 3] = i + u;
            p[(axis + 2) % 3] = j + v;
            return place(p);
          };
          const int turn = random.below(2);
          builder.add_triangle(corner(turn, 0), corner(1, turn), corner(1 - turn, 1));
          builder.add_triangle(corner(turn, 0), corner(1 - turn, 1), corner(0, 1 - turn));
        }
      }
    }
  }
  return builder.finish();
}

/// A path between grid points, sometimes of length 0; its own face is one of the scene's or none.
inline scene::ShadowQuery random_query(Random& random, const scene::Scene& scene, bool grid,
                                       const Placement& place) {
  const auto point = [&] {
    // Corners, and the middles of edges where they are exact, bring borders and ends.
    if (!scene.points.empty() && random.chance(30)) {
      return scene.points[static_cast<std::size_t>(random.below(static_cast<int>(scene.points.size())))];
    }
    return place(grid ? grid_point(random) : float_point(random));
  };
  scene::ShadowQuery q{point(), point(), scene::kNoFace};
  if (random.chance(2)) q.light = q.point;
  const int count = static_cast<int>(scene.face_count());
  if (count > 0 && random.chance(40)) q.own = static_cast<std::uint32_t>(random.below(count));
  return q;
}

/// A scene all of whose triangles lie in one plane across an axis, and so does what is asked of it.
struct FlatCase {
  scene::Scene scene;
  scene::ShadowQuery query;
};
inline FlatCase random_flat_case(Random& random) {
  const auto axis = static_cast<std::size_t>(random.below(3));
  const double level = float_point(random)[0];
  const auto point = [&] {
    Point3 p = float_point(random);
    p[axis] = level;
    return p;
  };
  scene::SceneBuilder builder;
  for (int i = random.between(1, 3); i > 0; --i) builder.add_triangle(point(), point(), point());
  return {builder.finish(), {point(), point(), scene::kNoFace}};
}

/// A ray from a point to another one, whose direction is exact on grids.
inline scene::RayQuery random_ray(Random& random, const scene::Scene& scene, bool grid,
                                  const Placement& place) {
  for (;;) {
    const scene::ShadowQuery q = random_query(random, scene, grid, place);
    scene::RayQuery ray{q.point, {}, q.own};
    for (std::size_t i = 0; i < 3; ++i) ray.direction[i] = q.light[i] - q.point[i];
    if (ray.direction != Point3{0, 0, 0}) return ray;
  }
}

/// A query as a line of the text corpus (of a ray, its direction in the light's place).
inline std::string corpus_text_of(const scene::Scene& scene, const scene::ShadowQuery& q) {
  return scene::corpus_text({scene, q}, "");
}

}  // namespace gnomon::tests
