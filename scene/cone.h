// SPDX-License-Identifier: MIT
// Cones and cylinders as flat sides.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace gnomon::scene {

/// How many flat sides stand for the round surface of a cone or cylinder. The choice is ours: with 32 the
/// sides lie within 1 - cos(pi / 32), 0.5 %, of the radius below the surface.
inline constexpr std::size_t kConeSides = 32;

/// The lateral surface of a cone, truncated cone or cylinder; it has no end caps. Radii are at least 0.
struct Cone {
  std::array<double, 3> base{}, apex{};
  double base_radius = 0, apex_radius = 0;
};

/// The corners of the flat sides, on two rings around the ends, counterclockwise as seen from the apex.
struct ConeRings {
  std::array<std::array<double, 3>, kConeSides> base, apex;
};

/// The rings of a cone whose ends differ; nothing when they are the same point or a corner is beyond the
/// range of doubles. Corners lie on the cone but for rounding. Only +, -, *, / and square roots are used, so
/// the same cone has the same corners everywhere.
[[nodiscard]] std::optional<ConeRings> rings_of(const Cone& cone);

}  // namespace gnomon::scene
