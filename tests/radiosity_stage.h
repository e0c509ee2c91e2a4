// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes with emitters and receivers: what the tests of lists cast rays between.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "exact/convexity.h"
#include "exact/polygons.h"
#include "exact/side_of_face.h"
#include "fast/list_builder.h"
#include "tests/scene_cases.h"

namespace gnomon::tests {

using fast::Reference;
using scene::Scene;

using FloatPoint = std::array<float, 3>;

/// A polygon with sample points a little in front of it, so that neither rounding nor its neighbours matter.
struct Patch {
  Reference reference;
  std::vector<FloatPoint> points;
};

inline std::array<double, 3> wide(const FloatPoint& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// `points` of the triangles (0, k, k + 1) of the corners.
inline Patch make_patch(Random& random, const std::vector<Point3>& corners, scene::FaceRun own, int points) {
  Patch patch;
  patch.reference.own = own;
  const auto narrow = [](const Point3& p) {
    return FloatPoint{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  };
  patch.reference.front = {narrow(corners[0]), narrow(corners[1]), narrow(corners[2])};
  Point3 e1, e2, normal;
  for (std::size_t k = 0; k < 3; ++k) {
    e1[k] = corners[1][k] - corners[0][k];
    e2[k] = corners[2][k] - corners[0][k];
  }
  double length = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    normal[k] = e1[(k + 1) % 3] * e2[(k + 2) % 3] - e1[(k + 2) % 3] * e2[(k + 1) % 3];
    length += normal[k] * normal[k];
  }
  // The box is that of the polygon and of its points.
  scene::Box<float>& box = patch.reference.box;
  const auto grow = [&](const FloatPoint& p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.c[axis] = std::min(box.c[axis], p[axis]);
      box.c[axis + 3] = std::max(box.c[axis + 3], p[axis]);
    }
  };
  for (std::size_t k = 0; k < 6; ++k) box.c[k] = (*patch.reference.front)[0][k % 3];
  for (const Point3& corner : corners) grow(narrow(corner));
  for (int i = 0; i < points; ++i) {
    const auto k = static_cast<std::size_t>(random.below(static_cast<int>(corners.size()) - 2)) + 1;
    double u = random.unit(), v = random.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    FloatPoint p{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double a = corners[0][axis];
      p[axis] = static_cast<float>(a + u * (corners[k][axis] - a) + v * (corners[k + 1][axis] - a) +
                                   1e-4 * normal[axis] / std::sqrt(length));
    }
    grow(p);
    patch.points.push_back(p);
  }
  return patch;
}

/// All points of `b` are in front of the polygon of `a`.
inline bool sees(const Patch& a, const Patch& b) {
  const auto& front = *a.reference.front;
  return std::all_of(b.points.begin(), b.points.end(), [&](const FloatPoint& p) {
    return exact::side_of_face({wide(front[0]), wide(front[1]), wide(front[2])}, wide(p)) > 0;
  });
}

/// Emitters and receivers of a scene.
struct Stage {
  Scene scene;
  std::vector<scene::FaceRun> polygons;
  std::vector<std::uint8_t> convex;
  std::vector<Patch> emitters, receivers;

  Stage() = default;
  Stage(Random& random, Scene&& s, int receivers_of, int points) : scene(std::move(s)) {
    polygons = exact::polygons_of(scene);
    for (const scene::Object& object : scene.objects) convex.push_back(exact::is_convex(scene, object));
    for (const scene::PolygonLight& light : scene.polygon_lights)
      emitters.push_back(make_patch(random, light.corners, {}, 4));
    for (const scene::FaceRun& run : polygons) {
      if (run.first >= scene.triangles.size() || !random.chance(receivers_of)) continue;
      std::vector<Point3> corners{scene.corner(run.first, 0), scene.corner(run.first, 1)};
      for (std::uint32_t k = 0; k < run.count; ++k) corners.push_back(scene.corner(run.first + k, 2));
      if (exact::is_degenerate({corners[0], corners[1], corners[2]})) continue;
      const bool emits = scene.polygon_lights.empty() && random.chance(20);
      (emits ? emitters : receivers).push_back(make_patch(random, corners, run, points));
    }
  }
};

}  // namespace gnomon::tests
