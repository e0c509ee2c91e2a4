// SPDX-License-Identifier: MIT
// Least boxes around boxes and points. Exact: no coordinate is rounded.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "fast/strict_float.h"
#include "scene/box.h"

namespace gnomon::fast {

/// The least box around both.
[[nodiscard]] inline scene::Box<float> box_around(const scene::Box<float>& a, const scene::Box<float>& b) {
  scene::Box<float> both;
  for (int axis = 0; axis < 3; ++axis) {
    both.lo(axis) = std::min(a.lo(axis), b.lo(axis));
    both.hi(axis) = std::max(a.hi(axis), b.hi(axis));
  }
  return both;
}

/// The least box around the points, of which there must be one.
[[nodiscard]] inline scene::Box<float> box_of(std::span<const std::array<float, 3>> points) {
  scene::Box<float> box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.c[axis] = box.c[axis + 3] = points.front()[axis];
    for (const auto& point : points) {
      box.c[axis] = std::min(box.c[axis], point[axis]);
      box.c[axis + 3] = std::max(box.c[axis + 3], point[axis]);
    }
  }
  return box;
}

}  // namespace gnomon::fast
