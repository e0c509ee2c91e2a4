// SPDX-License-Identifier: MIT
// The plane of a patch's own triangle, and on which side the patch's points lie. Internal to fast/pair_*.
#pragma once

#include "fast/pair_patch.h"
#include "scene/scene.h"

namespace gnomon::fast {

/// Sets patch.plane to that of the own run's first triangle that has a normal. The scene, the points and
/// everything else must be in the certified tier's domain; nothing is set when there is no such triangle.
void set_own_plane(const scene::Scene& scene, PairPatch& patch);

}  // namespace gnomon::fast
