// SPDX-License-Identifier: GPL-3.0-or-later
// A shaft along a coordinate axis, in exact arithmetic.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "scene/box.h"

namespace gnomon::reports {

using Rational = boost::multiprecision::cpp_rational;

/// A point of the projection.
struct ExactPoint {
  Rational x, y;

  friend bool operator==(const ExactPoint&, const ExactPoint&) = default;
};

/// The points with a x + b y + c <= 0; (a, b) != (0, 0) points out of the shaft.
struct HalfPlane {
  Rational a, b, c;

  [[nodiscard]] Rational at(const ExactPoint& p) const { return a * p.x + b * p.y + c; }
};

/// The convex hull of two projected boxes: what a shaft looks like along axis `along` (0, 1, 2 for x, y, z).
/// Flat and pointlike shafts have a silhouette too; then some sides face each other.
struct Silhouette {
  int along = 2, right = 0, up = 1;  ///< the axes: looked along, and those of the picture
  std::vector<ExactPoint> corners;   ///< counterclockwise, no three on a line; one or two when flat
  std::vector<HalfPlane>
      sides;  ///< the extent box's four, then the slanted ones; they bound the hull exactly
};

[[nodiscard]] Silhouette silhouette(const scene::Box<double>& a, const scene::Box<double>& b, int along);

}  // namespace gnomon::reports
