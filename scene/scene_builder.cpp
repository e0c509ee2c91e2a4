// SPDX-License-Identifier: MIT
#include "scene/scene_builder.h"

#include <stdexcept>
#include <utility>

#include "scene/mesh.h"
#include "scene/triangulate.h"

namespace gnomon::scene {

void SceneBuilder::begin_object(std::string name, double transmittance, bool one_sided) {
  if (scene_.objects.empty() || scene_.objects.back().face_count() > 0) scene_.objects.emplace_back();
  scene_.objects.back() = {
      std::move(name), scene_.triangles.size(), 0, scene_.balls.size(), 0, transmittance, false, one_sided};
}

Object& SceneBuilder::object() {
  if (scene_.objects.empty()) begin_object("", 0, false);
  return scene_.objects.back();
}

std::uint32_t SceneBuilder::index_of(const std::array<double, 3>& point) {
  if (scene_.points.size() == kMaxMeshPoints) throw std::runtime_error("a scene of over 4294967295 points");
  return merger_.index_of(point);
}

void SceneBuilder::add_triangle(const std::array<double, 3>& a, const std::array<double, 3>& b,
                                const std::array<double, 3>& c) {
  const std::uint32_t i = index_of(a), j = index_of(b), k = index_of(c);
  ++object().triangle_count;
  scene_.triangles.push_back({i, j, k});
}

void SceneBuilder::add_ball(const Ball<double>& ball) {
  ++object().ball_count;
  scene_.balls.push_back(ball);
}

bool SceneBuilder::add_polygon(std::span<const std::array<double, 3>> corners) {
  const Triangulation triangulation = triangulate(corners);
  for (const auto& [a, b, c] : triangulation.triangles) add_triangle(corners[a], corners[b], corners[c]);
  return triangulation.crossing;
}

Scene SceneBuilder::finish() {
  if (!scene_.objects.empty() && scene_.objects.back().face_count() == 0) scene_.objects.pop_back();
  return std::move(scene_);
}

}  // namespace gnomon::scene
