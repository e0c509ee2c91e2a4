// SPDX-License-Identifier: GPL-3.0-or-later
// The patches that radiosity sends light between: a scene's polygons and polygon lights.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "fuzz/random.h"
#include "fuzz/vectors.h"
#include "scene/box.h"
#include "scene/face_run.h"
#include "scene/scene.h"

namespace gnomon::fuzz {

/// A convex polygon that sends or receives light on its front alone.
struct RadiosityPatch {
  scene::FaceRun own;            ///< its triangles; of a polygon light none
  std::vector<Vector3> corners;  ///< in order around it
  /// Three corners that don't lie on one line, counterclockwise as seen from the front.
  std::array<Vector3, 3> plane{};
  scene::Box<double> box;  ///< of the corners
  Vector3 middle{};        ///< the centroid, in doubles
  double area = 0;         ///< in doubles; more than 0
  bool one_sided = false;  ///< of a one-sided object: queries may be answered `facing`

  [[nodiscard]] bool is_light() const { return own.count == 0; }
};

/// The polygons of exact::polygons_of() that have an area, in their order: their front is where their
/// triangles' corners turn counterclockwise. Balls are no patches.
[[nodiscard]] std::vector<RadiosityPatch> patches_of(const scene::Scene& scene);

/// The polygon lights that have an area, in their order. A light's front is the side of its plane on which
/// more of the scene's surface lies (triangles by the side of their middles, weighed by area; of equal shares
/// the side from which its corners turn counterclockwise): a ceiling light sends its light into the room.
[[nodiscard]] std::vector<RadiosityPatch> light_patches_of(const scene::Scene& scene);

/// Which side of the patch's plane the point lies on, exactly: 1 in front, 0 in the plane, -1 behind.
[[nodiscard]] int side_of(const RadiosityPatch& patch, const Vector3& point);

/// The point with floats for coordinates, exactly on the patch's plane or in front of it: rounded, and moved
/// along the largest axis of the normal where it came to lie behind.
[[nodiscard]] Vector3 on_or_before(const RadiosityPatch& patch, const Vector3& point);

/// The triangle of the patch that a point of its plane lies on, as doubles find it; kNoFace of a light.
[[nodiscard]] std::uint32_t face_of(const RadiosityPatch& patch, const Vector3& point);

/// A point of the patch, uniform by area, as on_or_before() makes it.
[[nodiscard]] Vector3 point_on(const RadiosityPatch& patch, CaseRandom& random);

/// The points of a grid of cells over the patch, at most `spacing` wide, whose middles lie in it; where these
/// are fewer than its corners, the points halfway between the middle and the corners. All as on_or_before()
/// makes them.
[[nodiscard]] std::vector<Vector3> mesh_of(const RadiosityPatch& patch, double spacing);

/// `side` x `side` points: of a patch with four corners those of a grid, otherwise points drawn by area, the
/// same each time; for one its middle. All as on_or_before() makes them.
[[nodiscard]] std::vector<Vector3> samples_of(const RadiosityPatch& patch, std::size_t side);

}  // namespace gnomon::fuzz
