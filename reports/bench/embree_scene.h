// SPDX-License-Identifier: GPL-3.0-or-later
// A scene of triangles in Embree 3, one ray at a time: the speed to compare with.
#pragma once

#ifdef GNOMON_HAS_EMBREE
#include <embree3/rtcore.h>

#include <array>
#include <span>

#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::bench {

class EmbreeScene {
 public:
  /// Triangles only. With `robust` it is asked to miss no shared edge.
  EmbreeScene(const scene::Scene& scene, bool robust)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), scene.points.size()));
    for (const auto& point : scene.points) {
      for (const double x : point) *points++ = static_cast<float>(x);
    }
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), scene.triangles.size()));
    for (const auto& triangle : scene.triangles) {
      for (const unsigned corner : triangle) *corners++ = corner;
    }
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_);
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// How many segments are blocked. It knows no own faces: segments start at 1e-4 of their length.
  [[nodiscard]] std::size_t count_shadowed(std::span<const scene::ShadowQuery> queries) const {
    std::size_t shadowed = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (const scene::ShadowQuery& q : queries) {
      std::array<float, 3> p, d;
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = static_cast<float>(q.point[k]);
        d[k] = static_cast<float>(q.light[k]) - p[k];
      }
      RTCRay ray{p[0], p[1], p[2], 1e-4f, d[0], d[1], d[2], 0, 1, ~0u, 0, 0};
      rtcOccluded1(scene_, &context, &ray);
      shadowed += ray.tfar < 0;
    }
    return shadowed;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace gnomon::bench
#endif
