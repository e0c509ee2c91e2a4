// SPDX-License-Identifier: MIT
// The half-space in front of a polygon's plane.
#pragma once

#include <array>
#include <cstdint>

#include "fast/list_options.h"
#include "scene/box.h"

namespace gnomon::fast {

/// Three corners of a polygon, counterclockwise as seen from its front.
using FrontCorners = std::array<std::array<float, 3>, 3>;

/// The open half-space n.(x - v0) > 0, n = (v1 - v0) x (v2 - v0), as floats n and d and a threshold.
///
/// naive: threshold 0 (below only what floats make of it). certified: what is said below holds in exact
/// arithmetic for all points of the region that the plane was formed for.
struct FrontPlane {
  std::array<float, 3> n{};
  float d = 0;
  float threshold = 0;                ///< NaN: the plane says nothing
  std::array<std::uint8_t, 3> far{};  ///< offsets of the corner of a box that is farthest in front

  [[nodiscard]] float value(float x, float y, float z) const {
    return ((n[0] * x + n[1] * y) + n[2] * z) + d;
  }
  /// No point of the box is in front: all lie on the plane or behind it.
  [[nodiscard]] bool none_in_front(const scene::Box<float>& box) const {
    return value(box.c[far[0]], box.c[far[1]], box.c[far[2]]) <= -threshold;
  }
  /// No point of the box is behind: all lie on the plane or in front of it.
  [[nodiscard]] bool none_behind(const scene::Box<float>& box) const {
    return value(box.c[(far[0] + 3U) % 6], box.c[(far[1] + 3U) % 6], box.c[(far[2] + 3U) % 6]) >= threshold;
  }
  /// All points of the box are in front, none on the plane.
  [[nodiscard]] bool all_in_front(const scene::Box<float>& box) const {
    return value(box.c[(far[0] + 3U) % 6], box.c[(far[1] + 3U) % 6], box.c[(far[2] + 3U) % 6]) > threshold;
  }
};

/// Forms it for boxes within the region, which must be valid; corners must be finite. A plane of corners on a
/// line says nothing, and certified also one whose values might overflow, or whose normal may be 0 or have
/// any direction for all that doubles can tell.
[[nodiscard]] FrontPlane form_front_plane(const FrontCorners& corners, const scene::Box<float>& region,
                                          Arithmetic arithmetic);

}  // namespace gnomon::fast
