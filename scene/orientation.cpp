// SPDX-License-Identifier: MIT
#include "scene/orientation.h"

#include <cmath>
#include <cstddef>

#include "scene/exact_sum.h"

namespace gnomon::scene {
namespace {

int exact_orientation(const std::array<double, 2>& a, const std::array<double, 2>& b,
                      const std::array<double, 2>& c) {
  ExactSum sum;
  const auto add_cross = [&sum](const std::array<double, 2>& p, const std::array<double, 2>& q) {
    sum.add(p[0], q[1]);
    sum.subtract(p[1], q[0]);
  };
  add_cross(a, b);
  add_cross(b, c);
  add_cross(c, a);
  return sum.sign();
}

}  // namespace

int orientation(const std::array<double, 2>& a, const std::array<double, 2>& b,
                const std::array<double, 2>& c) {
  // Each product errs by a factor of at most (1 + u)^3, their difference by another (1 + u), u = 2^-53: in
  // all by less than 4.01 u times the sum of magnitudes, also as computed, and 2^-1000 is more than what
  // underflow takes. Infinities and NaN fail both comparisons. (Shewchuk 1997 has the sharper 3 u + 16 u^2.)
  constexpr double kRelative = 0x1.2p-51, kAbsolute = 0x1p-1000;
  const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
  const double bound = kRelative * (std::fabs(left) + std::fabs(right)) + kAbsolute;
  if (left - right > bound) return 1;
  if (left - right < -bound) return -1;
  // Both products are 0 because a factor is: a difference of doubles is 0 only between equals.
  if ((b[0] == a[0] || c[1] == a[1]) && (b[1] == a[1] || c[0] == a[0])) return 0;
  return exact_orientation(a, b, c);
}

bool are_collinear(const std::array<double, 3>& a, const std::array<double, 3>& b,
                   const std::array<double, 3>& c) {
  for (std::size_t x = 0; x < 3; ++x) {
    const std::size_t y = (x + 1) % 3;
    if (orientation({a[x], a[y]}, {b[x], b[y]}, {c[x], c[y]}) != 0) return false;
  }
  return true;
}

}  // namespace gnomon::scene
