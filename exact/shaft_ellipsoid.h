// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `shaft-ellipsoid`.
#pragma once

#include <cstdint>
#include <span>

#include "exact/gap.h"
#include "exact/volume_reference.h"
#include "scene/volume_case.h"

namespace gnomon::exact {

/// Answers every case: intervals first, exact numbers where they leave something open. Returns how many
/// needed those. The spans have one size. Both boxes must be valid; any finite doubles. All twelve numbers
/// must be finite. Sets the rounding mode for the time of the call and restores it.
std::uint64_t refer(std::span<const scene::ShaftEllipsoidCase> cases, std::span<VolumeReference> references);

/// The same for one case, in rationals alone.
[[nodiscard]] VolumeReference refer_in_rationals(const scene::ShaftEllipsoidCase& c);

/// The truth of one case: the exact predicate that the exact tier hands its undecided cases to.
[[nodiscard]] scene::Category classify(const scene::ShaftEllipsoidCase& c);

/// The gap to a boundary, a pure number from -1 to 1. Outside: (q - 1) / (q + 1), q the least |u|^2 of the
/// points centre + M u of the shaft, so that sqrt(q) is the factor by which t must grow to touch; 1 where q
/// exceeds 64, or where t is flat and no copy of it, however large, meets the shaft. Inside: the maximum over
/// sides and planes with v = n.c + d of (|M^T n|^2 - v^2) / (|M^T n|^2 + v^2) where v <= 0, and 1 where v >
/// 0.
[[nodiscard]] Gap gap(const scene::ShaftEllipsoidCase& c, Boundary boundary);

/// An upper bound on |gap|, from intervals: 1, the most that a gap can be, where they tell nothing.
[[nodiscard]] double gap_bound(const scene::ShaftEllipsoidCase& c, Boundary boundary);

/// The answer of the exact plane test after t has grown by `growth` >= 0 on all sides, exactly: every plane
/// takes the volume to reach farther by growth (|n_x| + |n_y| + |n_z|).
[[nodiscard]] scene::Category classify_grown(const scene::ShaftEllipsoidCase& c, double growth);

}  // namespace gnomon::exact
