// SPDX-License-Identifier: MIT
#include "scene/single.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "scene/float_text.h"
#include "scene/scalar.h"
#include "scene/scene_builder.h"

namespace gnomon::scene {
namespace {

[[noreturn]] void refuse(const char* what, double value) {
  throw std::runtime_error(std::string("expected ") + what + " within the range of floats, found " +
                           decimal_text(value));
}

double rounded(const char* what, double value) {
  // The first double that rounds to infinity lies half an ulp above the largest float.
  constexpr double kBeyond = 0x1.ffffffp127;
  if (!(std::fabs(value) < kBeyond)) refuse(what, value);
  return static_cast<double>(static_cast<float>(value));
}

std::array<double, 3> rounded(const char* what, const std::array<double, 3>& point) {
  return {rounded(what, point[0]), rounded(what, point[1]), rounded(what, point[2])};
}

Ball<double> rounded(const Ball<double>& ball) {
  const Ball<double> result{rounded("a ball's centre", ball.centre), rounded("a radius", ball.radius)};
  constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
  for (const double c : result.centre) {
    if (std::fabs(c) + result.radius > kLargest) refuse("a ball", std::fabs(c) + result.radius);
  }
  return result;
}

std::array<double, 3> rounded_light(const std::array<double, 3>& point, std::size_t& moved) {
  const std::array<double, 3> result = rounded("a light", point);
  moved += result != point ? 1U : 0U;
  return result;
}

}  // namespace

SingleScene rounded_to_floats(const Scene& scene) {
  SingleScene result;
  std::vector<std::array<double, 3>> points;
  points.reserve(scene.points.size());
  for (const std::array<double, 3>& point : scene.points) {
    points.push_back(rounded("a coordinate", point));
    result.moved += points.back() != point ? 1U : 0U;
  }
  SceneBuilder builder;
  for (const Object& object : scene.objects) {
    builder.begin_object(object.name, object.transmittance, object.one_sided);
    for (std::size_t t = object.first_triangle; t < object.first_triangle + object.triangle_count; ++t) {
      const auto& [a, b, c] = scene.triangles[t];
      builder.add_triangle(points[a], points[b], points[c]);
    }
    for (std::size_t b = object.first_ball; b < object.first_ball + object.ball_count; ++b) {
      const Ball<double> ball = rounded(scene.balls[b]);
      result.moved += ball != scene.balls[b] ? 1U : 0U;
      builder.add_ball(ball);
    }
    builder.scene().objects.back().declared_convex = object.declared_convex;
  }
  result.scene = builder.finish();
  result.merged = scene.points.size() - result.scene.points.size();
  for (const PointLight& light : scene.point_lights) {
    result.scene.point_lights.push_back({rounded_light(light.position, result.moved)});
  }
  for (const PolygonLight& light : scene.polygon_lights) {
    PolygonLight& added = result.scene.polygon_lights.emplace_back();
    for (const std::array<double, 3>& corner : light.corners) {
      added.corners.push_back(rounded_light(corner, result.moved));
    }
  }
  result.scene.view = scene.view;
  return result;
}

}  // namespace gnomon::scene
