// SPDX-License-Identifier: MIT
// Polygon lights.
#pragma once

#include <array>
#include <vector>

namespace gnomon::scene {

/// Light from the closed polygon with these corners, in scene units: at least 3, in order around it.
struct PolygonLight {
  std::vector<std::array<double, 3>> corners;

  friend bool operator==(const PolygonLight&, const PolygonLight&) = default;
};

}  // namespace gnomon::scene
