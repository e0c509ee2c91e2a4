// SPDX-License-Identifier: MIT
// Boxes that are not axis-aligned.
#pragma once

#include <array>
#include <cmath>

namespace gnomon::scene {

/// The closed set of all points centre + t0 axes[0] + t1 axes[1] + t2 axes[2] with |t_i| <= 1. The axes are
/// half edges as they are: neither orthogonal nor independent, so that parallelepipeds, parallelograms,
/// segments and points are oriented boxes too.
template <class F>
struct OrientedBox {
  std::array<F, 3> centre{};
  std::array<std::array<F, 3>, 3> axes{};

  friend bool operator==(const OrientedBox&, const OrientedBox&) = default;
};

/// True when all twelve numbers are finite.
template <class F>
[[nodiscard]] bool is_valid(const OrientedBox<F>& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(t.centre[i])) return false;
    for (const F x : t.axes[i]) {
      if (!std::isfinite(x)) return false;
    }
  }
  return true;
}

/// The same with its numbers converted: widening is exact, narrowing needs numbers that are floats.
template <class To, class From>
[[nodiscard]] OrientedBox<To> converted(const OrientedBox<From>& t) {
  OrientedBox<To> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = static_cast<To>(t.centre[i]);
    for (std::size_t j = 0; j < 3; ++j) result.axes[i][j] = static_cast<To>(t.axes[i][j]);
  }
  return result;
}

}  // namespace gnomon::scene
