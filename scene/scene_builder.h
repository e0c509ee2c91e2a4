// SPDX-License-Identifier: MIT
// Scenes, put together face by face.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "scene/ball.h"
#include "scene/point_merger.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// Collects faces into objects and gives equal points one index. All numbers must be finite.
class SceneBuilder {
 public:
  SceneBuilder() = default;
  SceneBuilder(const SceneBuilder&) = delete;
  SceneBuilder& operator=(const SceneBuilder&) = delete;

  /// The faces that follow belong to this object; one without faces is dropped.
  void begin_object(std::string name, double transmittance, bool one_sided);
  /// Throws std::runtime_error when the scene would have more points than indices.
  void add_triangle(const std::array<double, 3>& a, const std::array<double, 3>& b,
                    const std::array<double, 3>& c);
  void add_ball(const Ball<double>& ball);
  /// Adds what triangulate() makes of a polygon of at least 3 corners; true when it crosses itself.
  bool add_polygon(std::span<const std::array<double, 3>> corners);

  /// The scene so far, for lights, view and questions about its faces.
  [[nodiscard]] Scene& scene() { return scene_; }

  /// The scene. The builder is then of no more use.
  [[nodiscard]] Scene finish();

 private:
  std::uint32_t index_of(const std::array<double, 3>& point);
  /// The object that the next face belongs to: a nameless opaque one when none was begun.
  Object& object();

  Scene scene_;
  PointMerger merger_{scene_.points};
};

}  // namespace gnomon::scene
