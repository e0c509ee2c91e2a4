// SPDX-License-Identifier: GPL-3.0-or-later
// The polygons that a scene's triangles were cut from, as far as its faces tell.
#pragma once

#include <vector>

#include "scene/face_run.h"
#include "scene/scene.h"

namespace gnomon::exact {

/// The scene's faces as runs, in order: every face is in exactly one. A run is a fan: consecutive triangles
/// of one object with one first corner, where the third corner of each is the second one of the next; they
/// lie in one plane exactly, turn the same way, and together are a convex polygon (angles of half a turn
/// allowed). Runs are as long as can be, from the first face on. A triangle without a normal is a run of its
/// own, and so is every ball.
///
/// The scene must be is_valid(); any finite doubles. Linear in its size.
[[nodiscard]] std::vector<scene::FaceRun> polygons_of(const scene::Scene& scene);

}  // namespace gnomon::exact
