// SPDX-License-Identifier: GPL-3.0-or-later
// The distribution `near-touch` for the other volumes: moved to within a few ulps of a boundary.
#pragma once

#include "fuzz/shapes.h"
#include "scene/volume_case.h"

namespace gnomon::fuzz {

/// Moves the volume of a case until it touches a side or plane of the shaft, from outside or from within, or,
/// for polytopes, an axis across an edge of each; then by up to 4 ulps of one number.
template <class F>
void move_to_touch(CaseRandom& random, scene::ShaftOrientedBoxCaseOf<F>& c);
template <class F>
void move_to_touch(CaseRandom& random, scene::ShaftEllipsoidCaseOf<F>& c);
template <class F>
void move_to_touch(CaseRandom& random, scene::ShaftSlabsCaseOf<F>& c);

}  // namespace gnomon::fuzz
