// SPDX-License-Identifier: MIT
// Boxes against boxes and balls against boxes: comparisons of coordinates, exact in every precision, and
// Arvo's squared distance, which is not.
#pragma once

#include <algorithm>

#include "fast/strict_float.h"
#include "scene/ball.h"
#include "scene/box.h"

namespace gnomon::fast {

/// True when the closed boxes have a common point. Exact; false where a coordinate is NaN.
template <class F>
[[nodiscard]] bool meets(const scene::Box<F>& t, const scene::Box<F>& box) {
  bool apart = false;
  for (int axis = 0; axis < 3; ++axis) {
    apart |= !(t.lo(axis) <= box.hi(axis));
    apart |= !(t.hi(axis) >= box.lo(axis));
  }
  return !apart;
}

/// True when `t` is a subset of `box`. Exact.
template <class F>
[[nodiscard]] bool contains(const scene::Box<F>& box, const scene::Box<F>& t) {
  bool within = true;
  for (int axis = 0; axis < 3; ++axis) {
    within &= t.lo(axis) >= box.lo(axis);
    within &= t.hi(axis) <= box.hi(axis);
  }
  return within;
}

/// Arvo's squared distance from a point to a box (Graphics Gems, 1990, 335-339): the differences to the
/// nearer sides, squared and summed; 0 within the box. Relative error at most (1+u)^5 - 1, and 3 eta from
/// underflow.
template <class F>
[[nodiscard]] F squared_distance(const std::array<F, 3>& p, const scene::Box<F>& box) {
  F sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const F x = p[static_cast<std::size_t>(axis)];
    // At most one of the two differences is positive.
    const F apart = std::max(std::max(box.lo(axis) - x, x - box.hi(axis)), F(0));
    sum += apart * apart;
  }
  return sum;
}

}  // namespace gnomon::fast
