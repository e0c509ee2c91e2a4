// SPDX-License-Identifier: GPL-3.0-or-later
// Where along a shaft, or between two patches, a triangle is met: exactly, as people are shown it.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>

#include "scene/box.h"
#include "scene/patch_pair.h"
#include "scene/scene.h"

namespace gnomon::exact {

/// All s from least to greatest.
struct BlockedRange {
  mpq_class least, greatest;
};

/// The s of [0, 1] for which the closed triangle meets the box (1-s)a + sb; nothing when there is none.
[[nodiscard]] std::optional<BlockedRange> blocked_range(const scene::Scene& scene, std::uint32_t triangle,
                                                        const scene::Box<double>& a,
                                                        const scene::Box<double>& b);

/// The s of (0, 1) for which the closed triangle holds a point (1-s)p + sq, p of one and q of the other
/// patch: 0 and 1 themselves never belong to the range.
[[nodiscard]] std::optional<BlockedRange> blocked_range(const scene::Scene& scene, std::uint32_t triangle,
                                                        const scene::PatchPair& pair);

}  // namespace gnomon::exact
