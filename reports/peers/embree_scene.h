// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to reports/peers/: a scene in Embree's hands.
#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <cstddef>

#include "fuzz/float_faces.h"
#include "reports/peers/embree_caster.h"

namespace gnomon::reports {

/// A device of its own with one committed scene: geometry kTriangles has the triangles, kBalls the balls, by
/// their numbers. Throws std::runtime_error with Embree's words.
class EmbreeScene {
 public:
  static constexpr unsigned kTriangles = 0, kBalls = 1;

  EmbreeScene(const fuzz::FloatFaces& faces, const EmbreeOptions& options);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  [[nodiscard]] RTCScene get() const { return scene_; }
  /// What Embree has allocated, buffers included.
  [[nodiscard]] std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }

 private:
  void add_triangles(const fuzz::FloatFaces& faces, RTCBuildQuality quality);
  void add_balls(const fuzz::FloatFaces& faces, RTCBuildQuality quality);
  void attach(RTCGeometry geometry, RTCBuildQuality quality, unsigned id);
  void check() const;
  void release();

  std::atomic<std::ptrdiff_t> bytes_{0};
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace gnomon::reports
