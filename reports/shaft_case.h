// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a shaft case, named.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "scene/ball.h"
#include "scene/box.h"

namespace gnomon::reports {

/// The shaft from a to b against a box or a ball.
struct ShaftCase {
  scene::Box<double> a, b;
  std::optional<scene::Box<double>> box;
  std::optional<scene::Ball<double>> ball;
  bool single = false;  ///< the case is of float32, and all its numbers are

  /// The distance from the case's largest coordinate to its neighbour in the case's scalar; a power of two, >
  /// 0.
  [[nodiscard]] double ulp() const;
};

/// The next number of float32 (single, x is one) or float64 above x, below for step < 0, |step| times; stops
/// at the largest one.
[[nodiscard]] double neighbour(double x, int step, bool single);

/// Nothing for another question, a wrong count, or numbers that are no boxes and ball.
[[nodiscard]] std::optional<ShaftCase> shaft_case(std::string_view question, std::span<const double> numbers,
                                                  std::string_view scalar);

}  // namespace gnomon::reports
