// SPDX-License-Identifier: MIT
// A binary tree by the surface area heuristic. Internal to fast/item_tree*.
#pragma once

#include <span>

#include "fast/tree_sketch.h"

namespace gnomon::fast {

/// Top down: each set is split where the halves' surfaces, weighed by their number of boxes, are least, over
/// 32 bins of box centres on each axis; sets that no bin parts are halved in the order given. One box a leaf.
[[nodiscard]] TreeSketch sketch_by_sah(std::span<const scene::Box<float>> boxes);

}  // namespace gnomon::fast
