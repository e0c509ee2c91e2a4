// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/scene_variant.h"
#include "scene/printable.h"

#include <stdexcept>
#include <string>

namespace gnomon::fuzz {
namespace {

constexpr SceneVariant kVariants[] = {
    {"given", "as the scene is", 1, 0},
    {"moved", "1e5 added to every coordinate: the bits that are left are fewer", 1, 1e5},
    {"scaled-up",
     "times 2^30: in floats, balls' products of four lengths overflow, triangles' of three don't", 0x1p30, 0},
    {"scaled-down", "times 2^-40: products of three or four lengths are denormal floats or zero", 0x1p-40, 0},
};

}  // namespace

std::span<const SceneVariant> scene_variants() {
  return kVariants;
}

const SceneVariant& scene_variant(std::string_view name) {
  std::string known;
  for (const SceneVariant& variant : kVariants) {
    if (variant.name == name) return variant;
    known += (known.empty() ? "" : ", ") + std::string(variant.name);
  }
  throw std::runtime_error("--variant: expected a variant (" + known + "), found \"" +
                           scene::printable(name) + "\"");
}

scene::Scene transformed(const scene::Scene& scene, const SceneVariant& variant) {
  scene::Scene result = scene;
  const auto move = [&](std::array<double, 3>& point) {
    for (double& c : point) c = c * variant.scale + variant.offset;
  };
  for (std::array<double, 3>& point : result.points) move(point);
  for (scene::Ball<double>& ball : result.balls) {
    move(ball.centre);
    ball.radius *= variant.scale;
  }
  for (scene::PointLight& light : result.point_lights) move(light.position);
  for (scene::PolygonLight& light : result.polygon_lights) {
    for (std::array<double, 3>& corner : light.corners) move(corner);
  }
  if (result.view) {
    move(result.view->from);
    move(result.view->at);
    result.view->hither *= variant.scale;
  }
  return result;
}

}  // namespace gnomon::fuzz
