// SPDX-License-Identifier: MIT
// The question `first-hit`: which face does a ray meet first?
#pragma once

#include <array>
#include <cstdint>

#include "scene/shadow_query.h"

namespace gnomon::scene {

/// The points origin + t * direction for all t > 0, in exact arithmetic. The direction need not have length 1
/// and must not be 0. The face `own`, if any, is the one that the ray starts on: left out when it is a
/// triangle; when it is a ball, met exactly if (origin - centre) * direction < 0, and then where the ray
/// leaves it. All numbers must be finite.
struct RayQuery {
  std::array<double, 3> origin{}, direction{};
  std::uint32_t own = kNoFace;

  friend bool operator==(const RayQuery&, const RayQuery&) = default;
};

}  // namespace gnomon::scene
