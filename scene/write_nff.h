// SPDX-License-Identifier: MIT
// Scenes as NFF.
#pragma once

#include <string>

#include "scene/scene.h"

namespace gnomon::scene {

/// The scene as Neutral File Format, which read_nff() reads back with the same numbers, bit for bit, in the
/// same order; numbers are the shortest decimals that do so. What the format has no place for is lost:
/// objects' names (written as comments), declared convexity, and that an object has two sides. Colours and
/// shading are those of a white matt surface. The format knows no polygon lights either: each becomes a
/// comment and a point light at the mean of its corners (rounded), unless a point light stands there already.
/// The scene must be is_valid().
[[nodiscard]] std::string nff_text(const Scene& scene);

}  // namespace gnomon::scene
