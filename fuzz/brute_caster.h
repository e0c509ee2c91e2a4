// SPDX-License-Identifier: GPL-3.0-or-later
// All faces for every query, in floats: what everybody writes first.
#pragma once

#include <memory>

#include "fuzz/scene_method.h"

namespace gnomon::fuzz {

/// Triangles as Möller and Trumbore test them ("Fast, Minimum Storage Ray/Triangle Intersection", Journal of
/// Graphics Tools 2(1), 1997), both sides, without a tolerance but for a determinant of 0 (a segment in the
/// triangle's plane, or a degenerate triangle, meets nothing); balls by the roots of their quadratic. No
/// SIMD, no structure.
[[nodiscard]] std::unique_ptr<SceneCaster> make_brute_caster(const scene::Scene& scene);

}  // namespace gnomon::fuzz
