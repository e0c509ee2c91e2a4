// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/peers/embree_scene.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "reports/peers/flush_denormals.h"

namespace gnomon::reports {
namespace {

bool count_bytes(void* counter, ssize_t bytes, bool /*post*/) {
  static_cast<std::atomic<std::ptrdiff_t>*>(counter)->fetch_add(bytes);
  return true;
}

}  // namespace

EmbreeScene::EmbreeScene(const fuzz::FloatFaces& faces, const EmbreeOptions& options) {
  const FlushDenormals flush;
  device_ = rtcNewDevice("threads=1,set_affinity=0");
  if (device_ == nullptr) throw std::runtime_error("Embree makes no device");
  try {
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    scene_ = rtcNewScene(device_);
    const RTCBuildQuality quality = options.high_quality ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
    int flags = options.filter ? RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION : RTC_SCENE_FLAG_NONE;
    if (options.robust) flags |= RTC_SCENE_FLAG_ROBUST;
    rtcSetSceneFlags(scene_, static_cast<RTCSceneFlags>(flags));
    rtcSetSceneBuildQuality(scene_, quality);
    if (!faces.triangles.empty()) add_triangles(faces, quality);
    if (!faces.balls.empty()) add_balls(faces, quality);
    check();
    rtcCommitScene(scene_);
    check();
  } catch (...) {
    release();
    throw;
  }
}

EmbreeScene::~EmbreeScene() {
  release();
}

void EmbreeScene::add_triangles(const fuzz::FloatFaces& faces, RTCBuildQuality quality) {
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* const points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                               3 * sizeof(float), faces.points.size());
  void* const corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                3 * sizeof(unsigned), faces.triangles.size());
  if (points != nullptr && corners != nullptr) {
    std::copy(faces.points.begin(), faces.points.end(), static_cast<fuzz::Vector*>(points));
    std::copy(faces.triangles.begin(), faces.triangles.end(),
              static_cast<std::array<std::uint32_t, 3>*>(corners));
  }
  attach(geometry, quality, kTriangles);
}

void EmbreeScene::add_balls(const fuzz::FloatFaces& faces, RTCBuildQuality quality) {
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  void* const balls = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                              4 * sizeof(float), faces.balls.size());
  if (balls != nullptr) {
    std::copy(faces.balls.begin(), faces.balls.end(), static_cast<scene::Ball<float>*>(balls));
  }
  attach(geometry, quality, kBalls);
}

void EmbreeScene::attach(RTCGeometry geometry, RTCBuildQuality quality, unsigned id) {
  rtcSetGeometryBuildQuality(geometry, quality);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, id);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::check() const {
  const RTCError error = rtcGetDeviceError(device_);
  if (error == RTC_ERROR_NONE) return;
  throw std::runtime_error(error == RTC_ERROR_OUT_OF_MEMORY
                               ? "Embree runs out of memory"
                               : "Embree refuses the scene (error " + std::to_string(error) + ")");
}

void EmbreeScene::release() {
  if (scene_ != nullptr) rtcReleaseScene(scene_);
  if (device_ != nullptr) rtcReleaseDevice(device_);
}

}  // namespace gnomon::reports
