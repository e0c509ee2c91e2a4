// SPDX-License-Identifier: GPL-3.0-or-later
// Interval analysis of the box test, over the parameter s: the boxes (1-s)a + sb of a range of s lie in one
// box; a t that misses it misses them all. Ranges that can't be told are halved.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "scene/shaft_case.h"

namespace gnomon::tests {

/// Conservative: `outside` is right. Every rounding goes outwards, by one number of the format.
class IntervalOverS {
 public:
  explicit IntervalOverS(const scene::ShaftBoxCase& c) : c_(c) {}

  /// The depth, up to `deepest`, at which t is told to be outside; deepest + 1 when it never is. Depth 0 is
  /// the test against the extent box.
  [[nodiscard]] int depth_of_outside(int deepest) const {
    for (int depth = 0; depth <= deepest; ++depth) {
      if (all_miss(0, 1, depth)) return depth;
    }
    return deepest + 1;
  }

 private:
  [[nodiscard]] bool all_miss(double from, double to, int depth) const {
    if (misses(from, to)) return true;
    if (depth == 0) return false;
    const double middle = (from + to) / 2;
    return all_miss(from, middle, depth - 1) && all_miss(middle, to, depth - 1);
  }
  [[nodiscard]] bool misses(double from, double to) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::fmin(side(axis, from, -HUGE_VAL), side(axis, to, -HUGE_VAL)) > c_.t.c[axis + 3]) return true;
      if (std::fmax(side(axis + 3, from, HUGE_VAL), side(axis + 3, to, HUGE_VAL)) < c_.t.c[axis]) return true;
    }
    return false;
  }
  /// The side of the box at s, a multiple of a power of two, rounded towards `end`.
  [[nodiscard]] double side(std::size_t face, double s, double end) const {
    const double of_a = s == 1 ? 0 : s == 0 ? c_.a.c[face] : std::nextafter((1 - s) * c_.a.c[face], end);
    const double of_b = s == 0 ? 0 : s == 1 ? c_.b.c[face] : std::nextafter(s * c_.b.c[face], end);
    return s == 0 || s == 1 ? of_a + of_b : std::nextafter(of_a + of_b, end);
  }

  scene::ShaftBoxCase c_;
};

}  // namespace gnomon::tests
