// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `shaft-slabs`.
#pragma once

#include <cstdint>
#include <span>

#include "exact/gap.h"
#include "exact/volume_reference.h"
#include "scene/volume_case.h"

namespace gnomon::exact {

/// True when no point lies in all seven slabs, which lo <= hi does not rule out. Exact.
[[nodiscard]] bool is_empty(const scene::SlabSet<double>& t);

/// Answers every case: intervals first, exact numbers where they leave something open. Returns how many
/// needed those. The spans have one size. Both boxes must be valid; any finite doubles. The set must have a
/// point (is_empty()): an empty one is bad input. Sets the rounding mode for the time of the call and
/// restores it.
std::uint64_t refer(std::span<const scene::ShaftSlabsCase> cases, std::span<VolumeReference> references);

/// The same for one case, in rationals alone.
[[nodiscard]] VolumeReference refer_in_rationals(const scene::ShaftSlabsCase& c);

/// The truth of one case: the exact predicate that the exact tier hands its undecided cases to.
[[nodiscard]] scene::Category classify(const scene::ShaftSlabsCase& c);

/// The gap to a boundary, a length. Outside: the maximum over all separating axes n of (the distance between
/// both ranges of n.x) / (|n_x| + |n_y| + |n_z|); when positive, the least amount by which t must grow on all
/// sides (by a cube) to meet the shaft, and when negative, minus the least translation, by its largest
/// coordinate, that makes t touch from outside. Inside: the maximum over sides and planes of (n.x + d) /
/// (|n_x| + |n_y| + |n_z|) over t.
[[nodiscard]] Gap gap(const scene::ShaftSlabsCase& c, Boundary boundary);

/// An upper bound on |gap|, from intervals: infinity where they overflow.
[[nodiscard]] double gap_bound(const scene::ShaftSlabsCase& c, Boundary boundary);

/// The answer of the exact plane test after t has grown by `growth` >= 0 on all sides, exactly: every plane
/// takes the volume to reach farther by growth (|n_x| + |n_y| + |n_z|).
[[nodiscard]] scene::Category classify_grown(const scene::ShaftSlabsCase& c, double growth);

}  // namespace gnomon::exact
