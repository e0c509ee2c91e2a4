// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to reports/peers/: Embree 3 as a scene method.
#pragma once

#include <cstdint>
#include <memory>

#include "fuzz/scene_method.h"

namespace gnomon::reports {

/// How a row builds and asks.
struct EmbreeOptions {
  bool robust = false;        ///< RTC_SCENE_FLAG_ROBUST
  bool high_quality = false;  ///< RTC_BUILD_QUALITY_HIGH
  unsigned packet = 1;        ///< queries at a time for shadow: 1, 8 or 16
  /// The own face is not left out, so no filter is called: right in exact arithmetic for points on their face
  /// or in front of it and lights strictly in front.
  bool filter = true;
};

/// Embree on one thread. Triangles are Embree's triangles, balls its sphere points. The segment is open: from
/// 0 to the largest float below 1. The own face is excluded by its number, in a filter of the context, and
/// not by starting a little further on: the question must be the same for everybody. The rules about own
/// faces are answered before, in floats. Denormals are flushed while Embree runs, as its manual asks.
[[nodiscard]] std::unique_ptr<fuzz::SceneCaster> make_embree_caster(const scene::Scene& scene,
                                                                    EmbreeOptions options);

}  // namespace gnomon::reports
