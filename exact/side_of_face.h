// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a triangle's plane a point lies, exactly.
#pragma once

#include <array>
#include <cstdint>

#include "scene/scene.h"

namespace gnomon::exact {

/// The sign (-1, 0, 1) of n * (p - v0), n = (v1 - v0) x (v2 - v0): 1 in front, where the corners are seen to
/// run counterclockwise. 0 for every point when the triangle has no normal. Any finite doubles; intervals
/// first, exact floats where they leave it open. Sets the rounding mode for the time of the call and restores
/// it.
[[nodiscard]] int side_of_face(const std::array<std::array<double, 3>, 3>& corners,
                               const std::array<double, 3>& p);
/// The same for a triangle of the scene.
[[nodiscard]] int side_of_face(const scene::Scene& scene, std::uint32_t triangle,
                               const std::array<double, 3>& p);

/// True when the corners lie on one line, exactly: the triangle has no normal.
[[nodiscard]] bool is_degenerate(const std::array<std::array<double, 3>, 3>& corners);

}  // namespace gnomon::exact
