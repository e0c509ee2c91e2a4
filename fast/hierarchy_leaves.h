// SPDX-License-Identifier: MIT
// The leaves of a Hierarchy, and what their set-up has to round outward. Internal to fast/hierarchy*.
#pragma once

#include <array>
#include <cstdint>

#include "fast/hierarchy_layout.h"
#include "scene/scene.h"

namespace gnomon::fast {

/// The faces' numbers may repeat.
[[nodiscard]] TriangleBlock make_triangle_block(const scene::Scene& scene,
                                                const std::array<std::uint32_t, kWidth>& faces);
[[nodiscard]] BallBlock make_ball_block(const scene::Scene& scene,
                                        const std::array<std::uint32_t, kWidth>& faces);

/// Minima, then maxima, of a box of floats that holds the ball, whose numbers must be floats.
[[nodiscard]] std::array<float, 6> box_around_ball(const scene::Ball<double>& ball);

}  // namespace gnomon::fast
