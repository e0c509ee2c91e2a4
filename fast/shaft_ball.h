// SPDX-License-Identifier: MIT
// The shaft's sphere test (Haines, Wallace: "Shaft Cull Testing").
#pragma once

#include "fast/banded.h"
#include "fast/shaft.h"
#include "scene/ball.h"

namespace gnomon::fast {

/// Ball `t` against the closed shaft by Arvo's box test and the plane set: the corrected form (inside a plane
/// when T <= -radius). The planes must be of unit length (Normals::unit; naive tier) or shortened
/// (form_certified_ball_shaft()). In real arithmetic the test has false positives and no false negatives
/// (claim S6).
///
/// With certified data: `outside` and `inside` are never wrong for any finite ball. `certain` is true for
/// those two only: that a ball overlaps can't be seen from the plane set.
template <class F>
[[nodiscard]] Banded classify(const Shaft<F>& shaft, const scene::Ball<F>& t);

/// The sphere test to the letter of the paper: a ball that meets a reference box is said to overlap, and one
/// that has T > -radius for every plane is said to be inside (erratum, claim S7).
template <class F>
[[nodiscard]] scene::Category classify_as_printed(const Shaft<F>& shaft, const scene::Ball<F>& t);

}  // namespace gnomon::fast
