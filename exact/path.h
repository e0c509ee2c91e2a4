// SPDX-License-Identifier: GPL-3.0-or-later
// What faces are met by: the open segment of `shadow` or the ray of `first-hit`. Internal to exact/.
#pragma once

#include <array>
#include <cstdint>

#include "scene/ray_query.h"
#include "scene/shadow_query.h"

namespace gnomon::exact {

/// The points from + t (to - from) for 0 < t < 1, or from + t to for t > 0 when `to` is a direction.
struct Path {
  enum class Kind : std::uint8_t { segment, ray };

  std::array<double, 3> from{}, to{};
  Kind kind = Kind::segment;

  explicit Path(const scene::ShadowQuery& q) : from(q.point), to(q.light) {}
  explicit Path(const scene::RayQuery& q) : from(q.origin), to(q.direction), kind(Kind::ray) {}
};

}  // namespace gnomon::exact
