// SPDX-License-Identifier: GPL-3.0-or-later
// The distributions over boxes, as functions. Each makes one triple A, B, T from one trial's random numbers.
#pragma once

#include "fuzz/shapes.h"

namespace gnomon::fuzz {

/// `offset`: uniform, 16 times as large, moved away by `magnitude` along each axis (random signs).
template <class F>
[[nodiscard]] Triple<F> offset_triple(CaseRandom& random, double magnitude);
/// `integer-grid`: all coordinates are integers in [0, size).
template <class F>
[[nodiscard]] Triple<F> grid_triple(CaseRandom& random, int size);
/// `near-touch`: a corner of t is put on a plane or side of the shaft and walked off by up to 4 ulps.
template <class F>
[[nodiscard]] Triple<F> near_touch_triple(CaseRandom& random);
/// `nested`: boxes within boxes, some sides shared.
template <class F>
[[nodiscard]] Triple<F> nested_triple(CaseRandom& random);
/// `degenerate`: flat boxes, points, coordinates shared between all three boxes.
template <class F>
[[nodiscard]] Triple<F> degenerate_triple(CaseRandom& random);
/// `thin`: sides from 2^-20 to 1 in one box.
template <class F>
[[nodiscard]] Triple<F> thin_triple(CaseRandom& random);
/// `mixed-magnitude`: coordinates of sizes 2^-range to 2^range side by side.
template <class F>
[[nodiscard]] Triple<F> mixed_triple(CaseRandom& random, int from_exponent, int to_exponent);
/// `denormal`: integer multiples of the smallest denormal, up to 2^12 or 2^26 of them.
template <class F>
[[nodiscard]] Triple<F> denormal_triple(CaseRandom& random);

/// `near-touch` for balls: the radius is the distance to a boundary, walked off by up to 4 ulps.
template <class F>
[[nodiscard]] scene::ShaftBallCase near_touch_ball(CaseRandom& random);

}  // namespace gnomon::fuzz
