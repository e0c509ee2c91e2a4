// SPDX-License-Identifier: MIT
// On which side of a line a point lies, and whether a triangle is flat: exactly.
#pragma once

#include <array>

namespace gnomon::scene {

/// 1 when a, b, c turn counterclockwise (x to the right, y up), -1 clockwise, 0 when they lie on one line.
/// Exact for all finite doubles.
[[nodiscard]] int orientation(const std::array<double, 2>& a, const std::array<double, 2>& b,
                              const std::array<double, 2>& c);

/// True when the three points lie on one line (or two are equal). Exact for all finite doubles.
[[nodiscard]] bool are_collinear(const std::array<double, 3>& a, const std::array<double, 3>& b,
                                 const std::array<double, 3>& c);

}  // namespace gnomon::scene
