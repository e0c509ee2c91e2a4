// SPDX-License-Identifier: MIT
// Consecutive faces.
#pragma once

#include <cstdint>

#include "scene/shadow_query.h"

namespace gnomon::scene {

/// The faces first .. first + count - 1 of a scene; none when count is 0.
struct FaceRun {
  std::uint32_t first = kNoFace, count = 0;

  [[nodiscard]] bool contains(std::uint32_t face) const { return face - first < count; }

  friend bool operator==(const FaceRun&, const FaceRun&) = default;
};

}  // namespace gnomon::scene
