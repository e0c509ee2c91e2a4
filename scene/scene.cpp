// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace gnomon::scene {
namespace {

bool is_finite(const std::array<double, 3>& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

bool is_valid(const View& view) {
  const auto in_range = [](std::int64_t size) { return size >= 1 && size <= View::kMaxResolution; };
  return is_finite(view.from) && is_finite(view.at) && is_finite(view.up) && view.angle > 0 &&
         view.angle < 180 && std::isfinite(view.hither) && in_range(view.columns) && in_range(view.rows);
}

bool has_finite_ends(const Ball<double>& ball) {
  return is_valid(ball) && std::ranges::all_of(ball.centre, [&](double c) {
           return std::isfinite(c - ball.radius) && std::isfinite(c + ball.radius);
         });
}

bool covers_faces(const std::vector<Object>& objects, std::size_t triangles, std::size_t balls) {
  std::size_t triangle = 0, ball = 0;
  for (const Object& object : objects) {
    if (object.first_triangle != triangle || object.triangle_count > triangles - triangle) return false;
    if (object.first_ball != ball || object.ball_count > balls - ball) return false;
    if (object.face_count() == 0 || !(object.transmittance >= 0 && object.transmittance <= 1)) return false;
    triangle += object.triangle_count;
    ball += object.ball_count;
  }
  return triangle == triangles && ball == balls;
}

}  // namespace

bool is_valid(const Scene& scene) {
  return scene.face_count() > 0 && std::ranges::all_of(scene.points, is_finite) &&
         std::ranges::all_of(scene.triangles,
                             [&](const std::array<std::uint32_t, 3>& corners) {
                               return std::ranges::all_of(
                                   corners, [&](std::uint32_t c) { return c < scene.points.size(); });
                             }) &&
         std::ranges::all_of(scene.balls, has_finite_ends) &&
         covers_faces(scene.objects, scene.triangles.size(), scene.balls.size()) &&
         std::ranges::all_of(scene.point_lights,
                             [](const PointLight& light) { return is_finite(light.position); }) &&
         std::ranges::all_of(scene.polygon_lights,
                             [](const PolygonLight& light) {
                               return light.corners.size() >= 3 &&
                                      std::ranges::all_of(light.corners, is_finite);
                             }) &&
         (!scene.view || is_valid(*scene.view));
}

}  // namespace gnomon::scene
