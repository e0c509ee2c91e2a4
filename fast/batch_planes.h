// SPDX-License-Identifier: MIT
// Plane normals as exact sums of two doubles. Internal to fast/batch_*_exact.cpp.
#pragma once

#include <cmath>

#include "fast/strict_float.h"

namespace gnomon::fast {

/// The exact difference of two numbers, high + low (Knuth's TwoSum; overflow makes it infinite or NaN).
struct ExactDifference {
  double high, low;

  /// What the error-free products ask of a factor (kLeastFactor and kLargestFactor there).
  [[nodiscard]] bool in_range() const { return std::fabs(high) >= 0x1p-450 && std::fabs(high) <= 0x1p450; }
};

[[nodiscard]] inline ExactDifference exact_difference(double a, double b) {
  const double high = a - b;
  const double of_b = a - high;
  return {high, (a - (high + of_b)) - (b - of_b)};
}

/// |p - q|, negated for a normal that points towards a minimum.
[[nodiscard]] inline ExactDifference outward_difference(double p, double q, bool towards_max) {
  return (p > q) == towards_max ? exact_difference(p, q) : exact_difference(q, p);
}

}  // namespace gnomon::fast
