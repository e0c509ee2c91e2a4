// SPDX-License-Identifier: MIT
// The shaft's sphere test without false positives: the least distance over s.
#pragma once

#include "fast/shaft.h"
#include "scene/ball.h"
#include "scene/category.h"

namespace gnomon::fast {

/// The least squared distance from `p` to the boxes (1-s)a + sb, 0 <= s <= 1: a convex, piecewise quadratic
/// function of s with at most six kinks, minimised piece by piece with +, -, *, / alone.
template <class F>
[[nodiscard]] F squared_distance_to_shaft(const scene::Box<F>& a, const scene::Box<F>& b,
                                          const std::array<F, 3>& p);

/// Ball `t` against the shaft: outside when the least squared distance exceeds r^2; inside by sides and
/// planes with v <= 0 and v^2 >= r^2 |n|^2 (planes as formed: no square root). Exact in real arithmetic;
/// promises nothing in floating point.
template <class F>
[[nodiscard]] scene::Category classify_by_slabs(const Shaft<F>& shaft, const scene::Ball<F>& t);

}  // namespace gnomon::fast
