// SPDX-License-Identifier: GPL-3.0-or-later
// Where a scene's light comes from, as points.
#pragma once

#include <array>
#include <vector>

#include "fuzz/random.h"
#include "scene/polygon_light.h"
#include "scene/scene.h"

namespace gnomon::fuzz {

/// Fixed points that stand for each polygon light in workloads of point lights and in pictures.
inline constexpr std::size_t kPointsPerPolygonLight = 4;

/// Puts point lights in the place of all lights that the scene has; leaves it as it is when there are none.
void replace_lights(scene::Scene& scene, const std::vector<std::array<double, 3>>& lights);

/// Gives a scene of floats what it lacks: without lights two point lights are made from its extent, above
/// and beside it (at most as far out as floats go), without a view one of everything.
void complete(scene::Scene& scene);

/// A point of the polygon, rounded to floats: uniform by area over the fan around its first corner, which is
/// the polygon where it is convex.
[[nodiscard]] std::array<double, 3> point_on(const scene::PolygonLight& light, CaseRandom& random);

/// The point lights, then kPointsPerPolygonLight points of each polygon light, the same each time.
[[nodiscard]] std::vector<std::array<double, 3>> light_points(const scene::Scene& scene);

}  // namespace gnomon::fuzz
