// SPDX-License-Identifier: MIT
// Polygons to triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gnomon::scene {

struct Triangulation {
  /// Indices into the polygon, turning as it does: always two fewer than it has corners.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// True when triangles overlap or are turned over in the projection, as it crosses itself.
  bool crossing = false;
};

/// Cuts a polygon of at least 3 corners, in order around it and finite, into triangles that use its corners
/// alone. Seen along the dominant axis of its area vector (the axis of the greatest component, the first one
/// of equals; decided exactly), they don't overlap and none is turned over, unless the polygon itself crosses
/// itself there (`crossing`; the triangles are then as many, but no partition of anything). Repeated corners,
/// corners in the middle of an edge, spikes and holes joined by a doubled edge are no crossings; repeated
/// corners and spikes give degenerate triangles. A polygon without an area along any axis becomes a fan.
///
/// Ear clipping (Meisters 1975: every simple polygon of over 3 corners has two ears) with exact signs. Time
/// for n corners: n when the polygon is convex; else each test of an ear looks at every reflex corner and
/// every two triangles may have to be compared, about n * n, and n * n * n for spirals.
[[nodiscard]] Triangulation triangulate(std::span<const std::array<double, 3>> polygon);

}  // namespace gnomon::scene
