// SPDX-License-Identifier: GPL-3.0-or-later
// Making a disagreement small enough to read.
#pragma once

#include <functional>
#include <vector>

#include "scene/scalar.h"

namespace gnomon::fuzz {

/// Which numbers of a case lie on which axis: -1 for a radius. Numbers of one axis move together.
using AxisOfNumber = std::function<int(std::size_t)>;
/// True when the numbers are a valid case that still shows the disagreement.
using StillFails = std::function<bool(const std::vector<double>&)>;

/// How hard the numbers are to read: significand bits, exponents and signs; 0 for all zeros.
[[nodiscard]] double complexity(const std::vector<double>& numbers);

/// Looks for simpler numbers that still fail: moves and scales the case, rounds everything to a grid, makes
/// numbers equal, zero or shorter; each step must lower complexity(). Deterministic; `still_fails` is asked
/// at most `most_trials` times. Every number stays one of the scalar. Returns the numbers unchanged when
/// nothing helps.
[[nodiscard]] std::vector<double> shrink(std::vector<double> numbers, scene::Scalar scalar,
                                         const AxisOfNumber& axis_of, const StillFails& still_fails,
                                         int most_trials = 6000);

}  // namespace gnomon::fuzz
