// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/lights.h"

#include "fuzz/camera.h"
#include "fuzz/triangle_sample.h"
#include "scene/scene_facts.h"

namespace gnomon::fuzz {

void replace_lights(scene::Scene& scene, const std::vector<std::array<double, 3>>& lights) {
  if (lights.empty()) return;
  scene.point_lights.clear();
  scene.polygon_lights.clear();
  for (const Vector3& light : lights) scene.point_lights.push_back({light});
}

void complete(scene::Scene& scene) {
  const bool dark = scene.point_lights.empty() && scene.polygon_lights.empty();
  if (!dark && scene.view) return;
  const scene::Box<double> extent = scene::extent_of(scene);
  if (!scene.view) scene.view = view_of(extent);
  if (!dark) return;
  const Vector3 lo{extent.lo(0), extent.lo(1), extent.lo(2)}, hi{extent.hi(0), extent.hi(1), extent.hi(2)};
  const Vector3 centre = plus(times(lo, 0.5), times(hi, 0.5));
  const double diagonal = length_of(minus(hi, lo));
  for (const Vector3& direction : {Vector3{0.3, 2, 1}, Vector3{-1.5, 1, 0.7}}) {
    scene.point_lights.push_back({as_floats(along(centre, unit_of(direction), 1.5 * diagonal))});
  }
}

std::array<double, 3> point_on(const scene::PolygonLight& light, CaseRandom& random) {
  const auto area = [&](std::size_t k) {
    return length_of(cross_product(minus(light.corners[k], light.corners[0]),
                                   minus(light.corners[k + 1], light.corners[0])));
  };
  double whole = 0;
  for (std::size_t k = 1; k + 1 < light.corners.size(); ++k) whole += area(k);
  double left = random.unit<double>() * whole;
  std::size_t chosen = 1;
  while (chosen + 2 < light.corners.size() && left >= area(chosen)) left -= area(chosen++);
  return as_floats(
      point_in_triangle(light.corners[0], light.corners[chosen], light.corners[chosen + 1], random));
}

std::vector<std::array<double, 3>> light_points(const scene::Scene& scene) {
  std::vector<Vector3> points;
  for (const scene::PointLight& light : scene.point_lights) points.push_back(light.position);
  for (std::size_t i = 0; i < scene.polygon_lights.size(); ++i) {
    CaseRandom random(1, stream_of("light points"), i);
    for (std::size_t k = 0; k < kPointsPerPolygonLight; ++k) {
      points.push_back(point_on(scene.polygon_lights[i], random));
    }
  }
  return points;
}

}  // namespace gnomon::fuzz
