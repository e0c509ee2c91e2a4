// SPDX-License-Identifier: MIT
// Point lights.
#pragma once

#include <array>

namespace gnomon::scene {

/// Light from one point, in scene units. Colours decide no question of visibility and are not kept.
struct PointLight {
  std::array<double, 3> position{};

  friend bool operator==(const PointLight&, const PointLight&) = default;
};

}  // namespace gnomon::scene
