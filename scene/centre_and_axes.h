// SPDX-License-Identifier: MIT
// What volumes that are given by a centre and three vectors have in common.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace gnomon::scene {

/// A volume of numbers F with a centre and three vectors (scene/oriented_box.h, scene/ellipsoid.h).
template <template <class> class Volume, class F>
concept HasCentreAndAxes = requires(Volume<F> t) {
  t.centre[0] = F{};
  t.axes[0][0] = F{};
};

/// True when all twelve numbers are finite.
template <template <class> class Volume, class F>
requires HasCentreAndAxes<Volume, F>
[[nodiscard]] bool is_valid(const Volume<F>& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(t.centre[i])) return false;
    for (const F x : t.axes[i]) {
      if (!std::isfinite(x)) return false;
    }
  }
  return true;
}

/// The same with its numbers converted: widening is exact, narrowing needs numbers that are floats.
template <class To, template <class> class Volume, class From>
requires HasCentreAndAxes<Volume, From>
[[nodiscard]] Volume<To> converted(const Volume<From>& t) {
  Volume<To> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = static_cast<To>(t.centre[i]);
    for (std::size_t j = 0; j < 3; ++j) result.axes[i][j] = static_cast<To>(t.axes[i][j]);
  }
  return result;
}

}  // namespace gnomon::scene
