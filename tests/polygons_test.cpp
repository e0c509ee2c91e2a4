// SPDX-License-Identifier: GPL-3.0-or-later
// exact/polygons.h and exact/side_of_face.h by areas and determinants in whole and rational numbers.
#include "exact/polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "exact/side_of_face.h"
#include "scene/find_scene.h"
#include "scene/scene_builder.h"
#include "tests/exact_lines.h"
#include "tests/pair_trials.h"

namespace gnomon::tests {
namespace {

using scene::FaceRun;
using Point = std::array<double, 3>;
using Spot = std::array<long, 2>;
using Runs = std::vector<FaceRun>;

long twice_area(const Spot& a, const Spot& b, const Spot& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Twice the area of the convex hull: of all lines through two points with no point on their right, those
/// between the outermost points of each line bound it.
long twice_hull_area(const std::vector<Spot>& points) {
  long area = 0;
  const std::set<Spot> distinct(points.begin(), points.end());
  for (const Spot& a : distinct) {
    for (const Spot& b : distinct) {
      if (a == b) continue;
      const bool bounds = std::all_of(distinct.begin(), distinct.end(), [&](const Spot& p) {
        const long side = twice_area(a, b, p);
        const long along = (p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1]);
        const long length = (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
        return side > 0 || (side == 0 && along >= 0 && along <= length);
      });
      if (bounds) area += a[0] * b[1] - a[1] * b[0];
    }
  }
  return area;
}

struct FlatTriangle {
  std::array<Spot, 3> v;
  bool lifted = false;  ///< its last corner has left the plane
};

/// Runs by the definition: a polygon is convex when its triangles' areas sum up to its hull's.
Runs runs_by_areas(const std::vector<FlatTriangle>& triangles, std::size_t of_first_object) {
  Runs runs;
  for (std::uint32_t first = 0; first < triangles.size();) {
    const FlatTriangle& start = triangles[first];
    const long sign = twice_area(start.v[0], start.v[1], start.v[2]);
    long area = std::labs(sign);
    std::vector<Spot> corners(start.v.begin(), start.v.end());
    std::uint32_t next = first + 1;
    for (; next < triangles.size() && next != of_first_object && sign != 0 && !start.lifted; ++next) {
      const FlatTriangle &before = triangles[next - 1], &t = triangles[next];
      const long turn = twice_area(t.v[0], t.v[1], t.v[2]);
      if (t.v[0] != start.v[0] || t.v[1] != before.v[2] || t.lifted || before.lifted) break;
      if (turn == 0 || (turn > 0) != (sign > 0)) break;
      corners.push_back(t.v[2]);
      area += std::labs(turn);
      if (twice_hull_area(corners) != area) break;
    }
    runs.push_back({first, next - first});
    first = next;
  }
  return runs;
}

/// Whole coordinates of a plane in space, where all stays whole; a lifted one is a step off it.
Point placed(const Spot& p, int plane, bool lifted) {
  const double x = static_cast<double>(p[0]), y = static_cast<double>(p[1]), step = lifted ? 1 : 0;
  switch (plane) {
    case 0:
      return {x, y, step};
    case 1:
      return {step, x, y};
    case 2:
      return {-y, 7 + step, x};
    default:
      return {x * 0x1p-3 - y, 3 * x + y + 1e6, x - 2 * y + step};
  }
}

TEST(Polygons, AreFansThatAreConvex) {
  Random random(5);
  std::array<int, 6> lengths{};
  for (int trial = 0; trial < affordable(3000); ++trial) {
    const int size = random.between(2, 5), plane = trial % 4;
    const auto spot = [&] { return Spot{random.below(size), random.below(size)}; };
    std::vector<FlatTriangle> triangles;
    const bool round = random.chance(50);  // around the hub, so that fans grow long
    const std::vector<Spot> ring{{4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}, {0, 0}, {2, 0}};
    std::size_t at = static_cast<std::size_t>(random.below(8));
    FlatTriangle t{{round ? ring[at] : spot(), spot(), spot()}};
    if (round) t.v = {ring[at], ring[(at + 1) % 8], ring[(at + 2) % 8]};
    for (int i = 0; i < 6; ++i) {
      t.lifted = random.chance(4);
      triangles.push_back(t);
      const Spot next = round ? ring[(at + 3 + static_cast<std::size_t>(i)) % 8] : spot();
      if (random.chance(85)) {
        t.v = {t.v[0], t.v[2], random.chance(90) ? next : spot()};
      } else {
        t.v = {spot(), spot(), spot()};
      }
    }
    const std::size_t split = random.chance(30) ? 1 + static_cast<std::size_t>(random.below(5)) : 0;
    scene::SceneBuilder builder;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (i == split) builder.begin_object("next", 0, false);
      const auto& v = triangles[i].v;
      builder.add_triangle(placed(v[0], plane, false), placed(v[1], plane, false),
                           placed(v[2], plane, triangles[i].lifted));
    }
    builder.add_ball({{0, 0, 0}, 1});
    builder.add_ball({{0, 0, 0}, 1});
    Runs expected = runs_by_areas(triangles, split);
    for (const FaceRun& run : expected) ++lengths[run.count - 1];
    expected.push_back({6, 1});
    expected.push_back({7, 1});
    ASSERT_EQ(exact::polygons_of(builder.finish()), expected) << "trial " << trial;
  }
  for (const int count : lengths) EXPECT_GE(count, affordable(50));
}

TEST(Polygons, OfScenesCoverAllFacesOnce) {
  for (const char* name : {"office:2", "city:3", "sphereflake:1", "gears:1"}) {
    const scene::Scene scene = scene::find_scene(name).loaded.scene;
    std::uint32_t next = 0;
    std::size_t quads = 0;
    for (const FaceRun& run : exact::polygons_of(scene)) {
      ASSERT_EQ(run.first, next) << name;
      ASSERT_GE(run.count, 1u) << name;
      next += run.count;
      quads += run.count == 2;
    }
    EXPECT_EQ(next, scene.face_count()) << name;
    if (std::string(name).starts_with("office")) {
      EXPECT_GE(quads, scene.face_count() / 4);
    }
  }
  EXPECT_TRUE(exact::polygons_of(scene::Scene()).empty());
}

TEST(SideOfFace, IsTheSignOfADeterminant) {
  std::array<int, 3> seen{};
  int degenerate = 0;
  for (const Finish finish :
       {Finish::grid, Finish::turned, Finish::stretched, Finish::huge, Finish::denormal}) {
    PairTrials trials(55, finish);
    for (int i = 0; i < affordable(1200); ++i) {
      const PairTrial trial = trials.next(i % 3);
      const auto& v = trial.pair.a.corners;
      const Rational3 o = rational(v[0]);
      const Rational3 n = vector_product(rational(v[1]) - o, rational(v[2]) - o);
      EXPECT_EQ(exact::is_degenerate(v), (n == Rational3{0, 0, 0}));
      degenerate += exact::is_degenerate(v);
      std::vector<Point> points(trial.scene.points);
      points.insert(points.end(), trial.pair.b.corners.begin(), trial.pair.b.corners.end());
      for (const Point& p : points) {
        const int side = sgn(scalar_product(n, rational(p) - o));
        EXPECT_EQ(exact::side_of_face(v, p), side);
        ++seen[static_cast<std::size_t>(side + 1)];
      }
    }
  }
  for (const int count : seen) EXPECT_GE(count, affordable(800));
  EXPECT_GE(degenerate, affordable(100));
  scene::SceneBuilder builder;
  builder.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(exact::side_of_face(builder.finish(), 0, {9, 9, 0x1p-1074}), 1);
}

}  // namespace
}  // namespace gnomon::tests
