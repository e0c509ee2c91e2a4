// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes with a pair, made anew for every trial.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "fuzz/generator.h"
#include "fuzz/pair_source.h"

namespace gnomon::fuzz {

/// Boxes and balls as one of the shaft questions' distributions makes them: what coordinates are like.
struct ShaftStyle {
  std::unique_ptr<Generator<scene::ShaftBoxCase>> boxes;
  std::unique_ptr<Generator<scene::ShaftBallCase>> balls;
  bool on_corners = false;  ///< corners of faces are corners of boxes alone: other points leave the grid
  bool integers = false;
  bool near_touch = false;  ///< faces of patch-pair are put on planes through corners of the patches

  /// The style of the distribution of that name, for floats. Throws UsageError for a bad argument.
  [[nodiscard]] static ShaftStyle of(const std::string& distribution);
};

/// A shaft between two of the style's boxes, and triangles and balls of its third ones: in it, at it, about
/// it.
[[nodiscard]] std::unique_ptr<PairSource<BoxPair>> make_candidate_drafts(ShaftStyle style);
/// Patches in two of the style's boxes, mostly faces of the scene themselves; faces as above, and in some
/// trials a large one across the way from one patch to the other.
[[nodiscard]] std::unique_ptr<PairSource<scene::PatchPair>> make_patch_drafts(ShaftStyle style);

/// Terraces with walls between them under a ceiling with holes, of squares that are coplanar, sometimes
/// exactly and sometimes but for rounding, and loose panels between; boxes of its squares, and its triangles.
[[nodiscard]] std::unique_ptr<PairSource<BoxPair>> make_coplanar_candidates();
[[nodiscard]] std::unique_ptr<PairSource<scene::PatchPair>> make_coplanar_patches();

}  // namespace gnomon::fuzz
