// SPDX-License-Identifier: MIT
// Balls.
#pragma once

#include <array>
#include <cmath>

namespace gnomon::scene {

/// The closed ball of all points at distance <= radius from the centre; radius 0 is a point.
template <class F>
struct Ball {
  std::array<F, 3> centre{};
  F radius{};

  friend bool operator==(const Ball&, const Ball&) = default;
};

/// True when all four numbers are finite and radius >= 0.
template <class F>
[[nodiscard]] bool is_valid(const Ball<F>& ball) {
  return std::isfinite(ball.centre[0]) && std::isfinite(ball.centre[1]) && std::isfinite(ball.centre[2]) &&
         std::isfinite(ball.radius) && ball.radius >= F(0);
}

/// The ball with its numbers converted: widening is exact, narrowing needs numbers that are floats.
template <class To, class From>
[[nodiscard]] Ball<To> converted(const Ball<From>& ball) {
  return {{static_cast<To>(ball.centre[0]), static_cast<To>(ball.centre[1]), static_cast<To>(ball.centre[2])},
          static_cast<To>(ball.radius)};
}

}  // namespace gnomon::scene
