// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `shaft-box`.
#pragma once

#include <cstdint>
#include <span>

#include "exact/gap.h"
#include "scene/category.h"
#include "scene/shaft_case.h"

namespace gnomon::exact {

/// Everything that is decided exactly about one case. All boxes must be valid (scene::is_valid); any finite
/// doubles.
struct ShaftBoxReference {
  /// Geometric truth, from the definition: outside by the common s of six inequalities, inside by an s for
  /// each corner.
  scene::Category truth;
  /// The paper's plane test in exact arithmetic, corrected and as printed: the exact twins of the fast tests.
  scene::Category planes, printed;
  /// The answer changes under arbitrarily small translations of t: between outside and overlap, or overlap
  /// and inside.
  bool touches_outside, touches_inside;
};

/// Answers every case: intervals first, rationals where they leave something open. Returns how many needed
/// rationals. The spans have one size. Sets the rounding mode for the time of the call and restores it.
std::uint64_t refer(std::span<const scene::ShaftBoxCase> cases, std::span<ShaftBoxReference> references);

/// The same for one case, in rationals alone.
[[nodiscard]] ShaftBoxReference refer_in_rationals(const scene::ShaftBoxCase& c);

/// The truth of one case: the exact predicate that the exact tier hands its undecided cases to.
[[nodiscard]] scene::Category classify(const scene::ShaftBoxCase& c);

/// The gap to a boundary: the maximum over extent sides and planes of v / (|n_x| + |n_y| + |n_z|), v the
/// signed value of the near corner (outside boundary) or far corner (inside boundary).
[[nodiscard]] Gap gap(const scene::ShaftBoxCase& c, Boundary boundary);

/// An upper bound on |gap|, from intervals: infinity where they overflow.
[[nodiscard]] double gap_bound(const scene::ShaftBoxCase& c, Boundary boundary);

/// The answer of the exact plane test after t has grown by `growth` >= 0 on all sides, exactly.
[[nodiscard]] scene::Category classify_grown(const scene::ShaftBoxCase& c, double growth);

}  // namespace gnomon::exact
