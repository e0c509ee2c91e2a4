// SPDX-License-Identifier: MIT
// Axis-aligned boxes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace gnomon::scene {

/// The closed axis-aligned box [lo, hi]; flat boxes and points are boxes too.
///
/// The six coordinates lie in one array, lo.x lo.y lo.z hi.x hi.y hi.z, so that a plane can name the corner
/// that it needs by stored offsets, as Haines and Wallace do ("Shaft Cull Testing"): far = (near + 3) mod 6.
template <class F>
struct Box {
  std::array<F, 6> c{};

  [[nodiscard]] F lo(int axis) const { return c[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] F hi(int axis) const { return c[static_cast<std::size_t>(axis) + 3]; }
  F& lo(int axis) { return c[static_cast<std::size_t>(axis)]; }
  F& hi(int axis) { return c[static_cast<std::size_t>(axis) + 3]; }

  friend bool operator==(const Box&, const Box&) = default;
};

/// True when every coordinate is finite and lo <= hi on each axis: what all questions ask of a box.
template <class F>
[[nodiscard]] bool is_valid(const Box<F>& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(box.lo(axis)) || !std::isfinite(box.hi(axis)) || !(box.lo(axis) <= box.hi(axis)))
      return false;
  }
  return true;
}

/// The box with its coordinates converted: widening is exact, narrowing needs numbers that are floats.
template <class To, class From>
[[nodiscard]] Box<To> converted(const Box<From>& box) {
  Box<To> result;
  for (std::size_t i = 0; i < 6; ++i) result.c[i] = static_cast<To>(box.c[i]);
  return result;
}

}  // namespace gnomon::scene
