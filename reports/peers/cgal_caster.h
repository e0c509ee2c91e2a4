// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to reports/peers/: CGAL's AABB_tree as a scene method.
#pragma once

#include <memory>

#include "fuzz/scene_method.h"

namespace gnomon::reports {

/// An AABB_tree of the triangles over Epick: do_intersect() with the closed segment, the own face left out by
/// its number, and the facing rule by the kernel's orientation, are exact but for the segment's ends. Its
/// first hits come from rounded constructions. Triangles that the kernel calls degenerate stay out, as its
/// preconditions ask. Throws std::runtime_error for scenes with balls.
[[nodiscard]] std::unique_ptr<fuzz::SceneCaster> make_cgal_epick_caster(const scene::Scene& scene);

/// The same over Simple_cartesian<double>: every sign as doubles give it.
[[nodiscard]] std::unique_ptr<fuzz::SceneCaster> make_cgal_double_caster(const scene::Scene& scene);

}  // namespace gnomon::reports
