// SPDX-License-Identifier: MIT
// Internal to scene/: do triangles of the plane overlap?
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace gnomon::scene {

/// True when the interiors of two of the triangles (indices into `points`) meet; decided exactly for finite
/// points. Every triangle must be counterclockwise or flat; flat ones have no interior. Time: m log m for m
/// triangles and a test for each two whose boxes meet.
[[nodiscard]] bool any_overlap(std::span<const std::array<double, 2>> points,
                               std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace gnomon::scene
