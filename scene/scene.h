// SPDX-License-Identifier: MIT
// Scenes: faces, the objects that group them, lights and a view.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/ball.h"
#include "scene/object.h"
#include "scene/point_light.h"
#include "scene/polygon_light.h"
#include "scene/view.h"

namespace gnomon::scene {

/// The faces are closed triangles and closed balls, numbered through: first all triangles, then all balls.
/// Degenerate and duplicate ones are faces like any other. Coordinates are in scene units, whatever these
/// are.
struct Scene {
  /// The corners of triangles, in order of first use. No two are equal (-0 equals 0), so corners are equal
  /// exactly when their indices are, and triangles share an edge exactly when they share two indices.
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise as seen from the front
  std::vector<Ball<double>> balls;
  std::vector<Object> objects;  ///< every face belongs to exactly one, in the order of faces
  std::vector<PointLight> point_lights;
  std::vector<PolygonLight> polygon_lights;
  std::optional<View> view;

  [[nodiscard]] std::size_t face_count() const { return triangles.size() + balls.size(); }

  /// Corner k of triangle t.
  [[nodiscard]] const std::array<double, 3>& corner(std::size_t t, std::size_t k) const {
    return points[triangles[t][k]];
  }

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// True when there is a face; every coordinate, and every ball's least and greatest coordinate, is finite and
/// no radius negative; every corner is the index of a point; the objects' runs cover the faces in order with
/// no empty object; transmittances are from 0 to 1; lights and view are as their types say. What all readers
/// promise, except that nobody checks again that points differ. Linear in the scene's size.
[[nodiscard]] bool is_valid(const Scene& scene);

}  // namespace gnomon::scene
