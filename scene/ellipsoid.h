// SPDX-License-Identifier: MIT
// Ellipsoids.
#pragma once

#include <array>
#include <cmath>

namespace gnomon::scene {

/// The closed set of all points centre + M u with |u| <= 1, where M has the columns axes[0], axes[1],
/// axes[2]. They need not be the principal axes, nor independent: flat ellipses, segments and points are
/// ellipsoids too.
template <class F>
struct Ellipsoid {
  std::array<F, 3> centre{};
  std::array<std::array<F, 3>, 3> axes{};

  friend bool operator==(const Ellipsoid&, const Ellipsoid&) = default;
};

/// True when all twelve numbers are finite.
template <class F>
[[nodiscard]] bool is_valid(const Ellipsoid<F>& t) {
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
[[nodiscard]] Ellipsoid<To> converted(const Ellipsoid<From>& t) {
  Ellipsoid<To> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = static_cast<To>(t.centre[i]);
    for (std::size_t j = 0; j < 3; ++j) result.axes[i][j] = static_cast<To>(t.axes[i][j]);
  }
  return result;
}

}  // namespace gnomon::scene
