// SPDX-License-Identifier: GPL-3.0-or-later
// Lines against triangles and balls in rationals, straight from the definitions: a point of the line is a
// point of the triangle, so solve for the barycentric coordinates and eliminate what stays free. No
// determinants, no filter, nothing shared with exact/.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "scene/ball.h"

namespace gnomon::tests {
// One of its own: fast_hierarchy_truth.h has operators with the same signatures, and shares no code with
// this.
inline namespace lines {

using Rational3 = std::array<mpq_class, 3>;

inline Rational3 rational(const std::array<double, 3>& p) {
  return {mpq_class(p[0]), mpq_class(p[1]), mpq_class(p[2])};
}
inline Rational3 operator-(const Rational3& a, const Rational3& b) {
  return {mpq_class(a[0] - b[0]), mpq_class(a[1] - b[1]), mpq_class(a[2] - b[2])};
}
inline Rational3 operator+(const Rational3& a, const Rational3& b) {
  return {mpq_class(a[0] + b[0]), mpq_class(a[1] + b[1]), mpq_class(a[2] + b[2])};
}
inline Rational3 operator*(const mpq_class& s, const Rational3& a) {
  return {mpq_class(s * a[0]), mpq_class(s * a[1]), mpq_class(s * a[2])};
}
inline mpq_class scalar_product(const Rational3& a, const Rational3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Rational3 vector_product(const Rational3& a, const Rational3& b) {
  return {mpq_class(a[1] * b[2] - a[2] * b[1]), mpq_class(a[2] * b[0] - a[0] * b[2]),
          mpq_class(a[0] * b[1] - a[1] * b[0])};
}

/// The closed interval of all t at which a line has a point in a set; no bound where a bound is missing.
struct Times {
  std::optional<mpq_class> lo, hi;
};

/// How a line lies to a triangle.
struct LineInTriangle {
  std::optional<Times> times;
  /// The three weights of the point of the triangle when the equations have one solution; else the line lies
  /// within the plane, or the triangle is degenerate.
  std::optional<std::array<mpq_class, 3>> weights;
};

namespace detail {

/// constant + sum of coefficients times (t, second, third weight) >= 0.
using Inequality = std::array<mpq_class, 4>;

/// Eliminates one variable (Fourier and Motzkin); all inequalities hold with equality allowed.
inline std::vector<Inequality> eliminated(const std::vector<Inequality>& system, std::size_t variable) {
  std::vector<Inequality> rest;
  for (const Inequality& upper : system) {
    if (upper[variable] == 0) rest.push_back(upper);
    if (upper[variable] >= 0) continue;
    for (const Inequality& lower : system) {
      if (lower[variable] <= 0) continue;
      Inequality sum;
      for (std::size_t i = 0; i < 4; ++i) {
        sum[i] = upper[i] * lower[variable] - lower[i] * upper[variable];
      }
      rest.push_back(sum);
    }
  }
  return rest;
}

}  // namespace detail

/// origin + t * direction = v0 + x (v1 - v0) + y (v2 - v0) with x, y, 1 - x - y >= 0.
inline LineInTriangle line_in_triangle(const Rational3& origin, const Rational3& direction,
                                       const std::array<Rational3, 3>& v) {
  using detail::Inequality;
  // One equation an axis: constant + t d - x e - y f = 0.
  std::array<Inequality, 3> equations;
  for (std::size_t i = 0; i < 3; ++i) {
    equations[i] = {mpq_class(origin[i] - v[0][i]), direction[i], mpq_class(v[0][i] - v[1][i]),
                    mpq_class(v[0][i] - v[2][i])};
  }
  std::vector<Inequality> system{{0, 0, 1, 0}, {0, 0, 0, 1}, {1, 0, -1, -1}};
  std::array<bool, 4> solved{};
  std::array<std::size_t, 4> row_of{};
  std::size_t row = 0;
  for (std::size_t variable = 3; variable >= 1 && row < 3; --variable) {  // t last: free if it can be
    std::size_t pivot = row;
    while (pivot < 3 && equations[pivot][variable] == 0) ++pivot;
    if (pivot == 3) continue;
    std::swap(equations[row], equations[pivot]);
    const mpq_class by = equations[row][variable];
    for (mpq_class& x : equations[row]) x /= by;
    const auto substitute = [&](Inequality& other) {
      const mpq_class times = other[variable];
      if (times == 0) return;
      for (std::size_t i = 0; i < 4; ++i) other[i] -= times * equations[row][i];
    };
    for (std::size_t i = 0; i < 3; ++i) {
      if (i != row) substitute(equations[i]);
    }
    for (Inequality& inequality : system) substitute(inequality);
    solved[variable] = true;
    row_of[variable] = row++;
  }
  for (; row < 3; ++row) {
    if (equations[row][0] != 0) return {};
  }
  for (std::size_t variable = 2; variable <= 3; ++variable) {
    if (!solved[variable]) system = detail::eliminated(system, variable);
  }
  LineInTriangle result;
  Times times;
  for (const Inequality& inequality : system) {
    if (inequality[1] == 0) {
      if (inequality[0] < 0) return {};
      continue;
    }
    const mpq_class bound = -inequality[0] / inequality[1];
    if (inequality[1] > 0 && (!times.lo || *times.lo < bound)) times.lo = bound;
    if (inequality[1] < 0 && (!times.hi || *times.hi > bound)) times.hi = bound;
  }
  if (solved[1]) times.lo = times.hi = mpq_class(-equations[row_of[1]][0]);
  if (times.lo && times.hi && *times.lo > *times.hi) return {};
  result.times = times;
  if (solved[1] && solved[2] && solved[3]) {
    const mpq_class x = -equations[row_of[2]][0], y = -equations[row_of[3]][0];
    result.weights = {mpq_class(1 - x - y), x, y};
  }
  return result;
}

/// |origin + t * direction - centre|^2 - r^2 at t.
struct BallFunction {
  Rational3 to_start, direction;
  mpq_class squared_radius;

  BallFunction(const Rational3& origin, const Rational3& along, const scene::Ball<double>& ball)
      : to_start(origin - rational(ball.centre)), direction(along), squared_radius(ball.radius) {
    squared_radius *= squared_radius;
  }
  [[nodiscard]] mpq_class at(const mpq_class& t) const {
    const Rational3 from_centre = to_start + t * direction;
    return scalar_product(from_centre, from_centre) - squared_radius;
  }
  /// The t at which it is least; the direction must not be 0.
  [[nodiscard]] mpq_class least_at() const {
    return -scalar_product(to_start, direction) / scalar_product(direction, direction);
  }
};

}  // namespace lines
}  // namespace gnomon::tests
