// SPDX-License-Identifier: GPL-3.0-or-later
// A ball against the open segments between two triangles. Internal to exact/.
#pragma once

#include <array>

#include "scene/ball.h"

namespace gnomon::exact {

/// The corners of two triangles.
using SixPoints = std::array<std::array<double, 3>, 6>;

/// True when the closed ball meets {(1-s)p + sq : 0 < s < 1} for a p of the first and a q of the second
/// triangle: when the distance from its centre to the hull of the six points is less than the radius, or when
/// it is the radius and the nearest point is one of these. Any finite doubles; `exactly` says whether
/// intervals were not enough.
[[nodiscard]] bool ball_blocks(const SixPoints& points, const scene::Ball<double>& ball, bool& exactly);

}  // namespace gnomon::exact
