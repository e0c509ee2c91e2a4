// SPDX-License-Identifier: MIT
// Solids of which the built-in scenes are made. Internal to scene/.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/scene_builder.h"

namespace gnomon::scene {

using Point3 = std::array<double, 3>;
using Point2 = std::array<double, 2>;

/// How a drawing is put into the scene: turned around the vertical, then moved.
struct Placement {
  double x = 0, y = 0, z = 0;
  double cos = 1, sin = 0;  ///< of the turn; quarter turns keep boxes along the axes
};

/// The placement of something that is drawn within something placed.
[[nodiscard]] inline Placement within(const Placement& outer, const Placement& inner) {
  return {outer.x + outer.cos * inner.x - outer.sin * inner.y,
          outer.y + outer.sin * inner.x + outer.cos * inner.y, outer.z + inner.z,
          outer.cos * inner.cos - outer.sin * inner.sin, outer.sin * inner.cos + outer.cos * inner.sin};
}

enum class Shape : std::uint8_t { convex, concave };

/// Draws closed solids, turned outward, on a lattice: every coordinate becomes the nearest multiple of a
/// power of two, so that what lies in a plane does so exactly. That is true of sides of boxes and vertical
/// prisms anyway, and of other lofts where the caller's points are on the lattice. The lattice must be coarse
/// enough for its points to be floats. The z axis points up.
class Modeller {
 public:
  explicit Modeller(double step) : step_(step) {}

  /// What follows belongs to a new object, declared convex or not. A convex object holds one solid.
  void object(std::string name, Shape shape, double transmittance = 0);
  /// Holds for the solids that follow; lights and view are given in the scene's coordinates.
  void place(const Placement& placement) { placement_ = placement; }

  /// 12 triangles.
  void box(const Point3& lo, const Point3& hi);
  /// A box whose sides are cut into cells: 4 (xy + yz + zx) triangles for x, y and z cells.
  void meshed_box(const Point3& lo, const Point3& hi, const std::array<std::uint32_t, 3>& cells);
  /// A vertical prism on a counterclockwise polygon of n corners: 4n - 4 triangles.
  void prism(std::span<const Point2> outline, double bottom, double top);
  /// A pyramid on a convex polygon of n corners: 2n - 2 triangles.
  void pyramid(std::span<const Point2> outline, double bottom, const Point3& apex);
  /// 4 triangles; the first three corners turn counterclockwise as seen from outside, away from the last.
  void tetrahedron(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
  /// Rings of n corners each, in the same order; seen from beyond the last ring they turn counterclockwise.
  /// The first and last, which must be flat, are closed by polygons: 2n (rings - 1) + 2 (n - 2) triangles.
  void loft(std::span<const std::vector<Point3>> rings);
  /// A solid of revolution with upright axis: radius and height of each ring, upward.
  void turned(std::span<const Point2> profile, std::uint32_t sides);
  void ball(const Point3& centre, double radius);

  void point_light(const Point3& position) { scene().point_lights.push_back({on_lattice(position)}); }
  /// A rectangle of light that shines down, and a point light at its middle for renderers of shadow rays.
  void ceiling_light(const Point2& lo, const Point2& hi, double height);
  /// A picture of 512 x 512 with the z axis upward.
  void view(const Point3& from, const Point3& at, double angle);

  [[nodiscard]] Scene finish() { return builder_.finish(); }

 private:
  [[nodiscard]] Scene& scene() { return builder_.scene(); }
  [[nodiscard]] double on_lattice(double x) const;
  [[nodiscard]] Point3 on_lattice(const Point3& p) const;
  [[nodiscard]] Point3 placed(const Point3& p) const;
  void quadrangle(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
  void cap(const std::vector<Point3>& polygon);
  void loft_placed(std::span<const std::vector<Point3>> rings);

  SceneBuilder builder_;
  Placement placement_;
  Shape shape_ = Shape::convex;
  double step_;
};

/// The corners of a regular polygon around the origin: corner k in direction k/n of a turn, plus half a side
/// when `side_first`, so that a side faces along x.
[[nodiscard]] std::vector<Point2> regular_polygon(std::uint32_t corners, double radius,
                                                  bool side_first = false);

}  // namespace gnomon::scene
