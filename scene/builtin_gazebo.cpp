// SPDX-License-Identifier: MIT
// A gazebo at night: eight posts with railings under a roof, seven lamps close together, and the moon.
#include "scene/builtin_list.h"
#include "scene/furniture.h"
#include "scene/modeller.h"
#include "scene/turn.h"

namespace gnomon::scene {
namespace {

constexpr double kPitch = 12, kEaves = 2.75, kRadius = 2.5;
constexpr std::uint32_t kSidesClosed = 7, kBalusters = 9;

constexpr std::size_t kGazeboFaces =
    3 * prism_faces(8)                                       // steps and floor
    + 8 * (prism_faces(8) + 12)                              // posts and the beams on them
    + kSidesClosed * (3 * 12 + kBalusters * prism_faces(6))  // railings and benches
    + 8 * 8 + 14 + 1                                         // roof, finial and its ball
    + prism_faces(12) + prism_faces(8)                       // table
    + 12 + prism_faces(8) + 7 * prism_faces(6)               // chandelier
    + 4 * (prism_faces(8) + 14);                             // shrubs

/// What stands between post k and the next, drawn along x from one post's axis to the other's. Posts are 0.25
/// thick.
void add_side(Modeller& modeller, double length) {
  const auto bar = [&modeller](const char* name, const Point3& lo, const Point3& hi) {
    modeller.object(name, Shape::convex);
    modeller.box(lo, hi);
  };
  bar("rail", {0.125, -0.03125, 0.5625}, {length - 0.125, 0.03125, 0.625});
  bar("rail", {0.125, -0.046875, 1.25}, {length - 0.125, 0.046875, 1.3125});
  const std::vector<Point2> baluster = regular_polygon(6, 0.0234375);
  for (std::uint32_t k = 1; k <= kBalusters; ++k) {
    std::vector<Point2> moved = baluster;
    for (Point2& p : moved) p[0] += length * k / (kBalusters + 1);
    modeller.object("baluster", Shape::convex);
    modeller.prism(moved, 0.625, 1.25);
  }
  bar("bench", {0.25, 0.125, 0.8125}, {length - 0.25, 0.5, 0.875});
}

void add_gazebo(Modeller& modeller, const Placement& at) {
  modeller.place(at);
  const auto prism = [&modeller](const char* name, std::span<const Point2> outline, double bottom,
                                 double top) {
    modeller.object(name, Shape::convex);
    modeller.prism(outline, bottom, top);
  };
  for (std::uint32_t step = 0; step < 3; ++step) {
    prism("step", regular_polygon(8, 3.25 - 0.25 * step, true), 0.125 * step, 0.125 * (step + 1));
  }
  const std::vector<Point2> post = regular_polygon(8, 0.125), posts = regular_polygon(8, kRadius, true);
  const std::vector<Point2> eaves = regular_polygon(8, kRadius + 0.5, true);
  const double length = 2 * kRadius * turn(1, 16).sin;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const Point2 &p = posts[k], &next = posts[(k + 1) % 8];
    const Placement along = within(at, {p[0], p[1], 0, (next[0] - p[0]) / length, (next[1] - p[1]) / length});
    modeller.place(along);
    prism("post", post, 0.375, kEaves - 0.25);
    modeller.object("beam", Shape::convex);
    modeller.box({0, -0.0625, kEaves - 0.25}, {length - 0.0625, 0.0625, kEaves - 0.125});
    if (k < kSidesClosed) add_side(modeller, length);
    modeller.place(at);
    // A board of the roof from the eaves to the top: a triangle, as thick as it is straight up. Neighbours
    // differ, so that they have no face in common.
    const Point2 &a = eaves[k], &b = eaves[(k + 1) % 8];
    std::vector<Point3> rings[2];
    for (const double lift : {0.0, k % 2 == 0 ? 0.0625 : 0.09375}) {
      rings[lift > 0] = {{a[0], a[1], kEaves - 0.125 + lift},
                         {b[0], b[1], kEaves - 0.125 + lift},
                         {0, 0, kEaves + 1.125 + lift}};
    }
    modeller.object("roof", Shape::convex);
    modeller.loft(rings);
  }
  modeller.object("finial", Shape::convex);
  modeller.pyramid(regular_polygon(8, 0.3125, true), kEaves + 1.21875, {0, 0, kEaves + 1.75});
  modeller.object("ball", Shape::convex);
  modeller.ball({0, 0, kEaves + 1.8125}, 0.09375);
  prism("table foot", regular_polygon(8, 0.0625), 0.375, 1.0625);
  prism("table", regular_polygon(12, 0.625), 1.0625, 1.125);
  // The chandelier: a rod, a hub, and seven sockets below it with a lamp under each.
  modeller.object("rod", Shape::convex);
  modeller.box({-0.015625, -0.015625, 2.4375}, {0.015625, 0.015625, kEaves + 0.75});
  prism("hub", regular_polygon(8, 0.25), 2.375, 2.4375);
  for (std::uint32_t k = 0; k < 7; ++k) {
    const Direction d = turn(k, 6);
    modeller.place(within(at, {k < 6 ? 0.1875 * d.cos : 0, k < 6 ? 0.1875 * d.sin : 0, 0}));
    prism("socket", regular_polygon(6, 0.03125), 2.3125, 2.375);
  }
  for (const Point2& p : {Point2{3.75, 3}, Point2{-3.75, 2.5}, Point2{-3.5, -3.25}, Point2{3.5, -3.5}}) {
    modeller.place(within(at, {p[0], p[1], 0}));
    prism("trunk", regular_polygon(8, 0.0625), 0, 0.5);
    modeller.object("shrub", Shape::convex);
    modeller.pyramid(regular_polygon(8, 0.5), 0.5, {0, 0, 1.75});
  }
  modeller.place({});
}

Scene make(std::uint32_t size) {
  Modeller modeller(0x1p-10);
  const double park = kPitch * size;
  modeller.object("lawn", Shape::convex);
  modeller.box({-kPitch, -kPitch, -0.25}, {park, park, 0});
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      add_gazebo(modeller, {kPitch * column, kPitch * row});
    }
  }
  // The gazebo in the middle is the one that is lit.
  const double middle = kPitch * (size / 2);
  for (std::uint32_t k = 0; k < 7; ++k) {
    const Direction d = turn(k, 6);
    modeller.point_light(
        {middle + (k < 6 ? 0.1875 * d.cos : 0), middle + (k < 6 ? 0.1875 * d.sin : 0), 2.28125});
  }
  modeller.point_light({middle - 40, middle - 25, 60});
  modeller.view({middle + 6, middle - 8.5, 2.75}, {middle, middle, 1.625}, 45);
  return modeller.finish();
}

}  // namespace

BuiltinScene gazebo_scene() {
  return {"gazebo",
          "gazebos in a park; seven lamps in a cluster, and the moon",
          "gazebos along each side of the park",
          "light buffer, \"Gazebo at Night\" (80 objects, 3222 polygons, 8 lights, 7 of them in a cluster)",
          1,
          30,
          [](std::uint32_t size) { return 12 + kGazeboFaces * size * size; },
          make};
}

}  // namespace gnomon::scene
