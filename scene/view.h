// SPDX-License-Identifier: MIT
// Where a scene is looked at from.
#pragma once

#include <array>
#include <cstdint>

namespace gnomon::scene {

/// A viewpoint as NFF gives it. Nothing need be normalised or perpendicular, and `from` may equal `at`: who
/// makes a frame of it has to check that there is one.
struct View {
  std::array<double, 3> from{}, at{}, up{};
  double angle = 0;   ///< in degrees, between the centres of the top and the bottom row; 0 < angle < 180
  double hither = 0;  ///< distance from the eye to the near plane, in scene units
  std::int64_t columns = 0, rows = 0;  ///< of the picture; from 1 to kMaxResolution

  /// So that a product of the two is far from overflow.
  static constexpr std::int64_t kMaxResolution = 1'000'000;

  friend bool operator==(const View&, const View&) = default;
};

}  // namespace gnomon::scene
