// SPDX-License-Identifier: MIT
// The shaft's box test (Haines, Wallace: "Shaft Cull Testing").
#pragma once

#include "fast/banded.h"
#include "fast/shaft.h"

namespace gnomon::fast {

/// Box `t` against the closed shaft, by extent box, near corners and far corners: the corrected form, which
/// goes on to the inside test whatever the reference boxes say. One kernel for the tiers: naive on thresholds
/// 0, certified on those of form_certified_box_shaft(). A NaN in a plane's value keeps the box.
///
/// With certified thresholds: `outside` and `inside` are never wrong (for finite t, whatever its size), and
/// `certain` holds only where the answer is the exact one.
template <class F>
[[nodiscard]] Banded classify(const Shaft<F>& shaft, const scene::Box<F>& t);

/// The box test to the letter of the paper: whatever meets a reference box is said to overlap (step 2 ends
/// the test), also when it lies inside the shaft (erratum to claim S2).
template <class F>
[[nodiscard]] scene::Category classify_as_printed(const Shaft<F>& shaft, const scene::Box<F>& t);

}  // namespace gnomon::fast
