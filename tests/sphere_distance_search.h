// SPDX-License-Identifier: GPL-3.0-or-later
// A search for balls that the paper's sphere test keeps although they are far from the shaft, in radii. In
// doubles, from the definitions alone; what it finds is verified in rationals by its callers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "fuzz/random.h"
#include "scene/shaft_case.h"

namespace gnomon::tests {

/// Two boxes and a centre as fifteen numbers, free to move: sides are put in order when the case is made.
class SphereDistance {
 public:
  explicit SphereDistance(fuzz::CaseRandom& random) {
    for (double& x : numbers_) x = random.between(-2.0, 2.0);
  }

  /// Changes one number: a step of any size, a factor, a copy of the same coordinate elsewhere, a new sign.
  void change(fuzz::CaseRandom& random) {
    const auto i = static_cast<std::size_t>(random.below(15));
    double& x = numbers_[i];
    const int kind = random.below(8);
    if (kind < 4) {
      const double step = random.between(-1.0, 1.0);
      x += std::ldexp(step, random.integer(-24, 2));
    } else if (kind < 6) {
      const double factor = random.between(1.0, 2.0);
      x *= std::ldexp(factor, random.integer(-3, 2));
      if (!(std::fabs(x) < kLargest)) x = 1;
    } else if (kind == 6) {
      x = numbers_[(i + 3 * static_cast<std::size_t>(random.below(5))) % 15];
    } else {
      x = -x;
    }
  }

  /// The ball of the least radius that the sphere test keeps in exact arithmetic, rounded up by 2^-30.
  [[nodiscard]] scene::ShaftBallCase kept() const {
    scene::ShaftBallCase c;
    for (std::size_t i = 0; i < 3; ++i) {
      c.a.c[i] = std::min(numbers_[i], numbers_[i + 3]);
      c.a.c[i + 3] = std::max(numbers_[i], numbers_[i + 3]);
      c.b.c[i] = std::min(numbers_[i + 6], numbers_[i + 9]);
      c.b.c[i + 3] = std::max(numbers_[i + 6], numbers_[i + 9]);
      c.t.centre[i] = numbers_[i + 12];
    }
    c.t.radius = least_kept_radius(c) * (1 + 0x1p-30);
    return c;
  }

  /// The distance from the centre to the shaft over the radius; 0 for balls so small that rounding decides.
  [[nodiscard]] static double radii(const scene::ShaftBallCase& c) {
    return c.t.radius > 1 / kLargest ? distance(c) / c.t.radius : 0;
  }

 private:
  static constexpr double kLargest = 0x1p11;

  /// How far the centre lies beyond the side of (1-s)a + sb on a face.
  static double beyond(const scene::ShaftBallCase& c, std::size_t face, double s) {
    const double side = (1 - s) * c.a.c[face] + s * c.b.c[face], x = c.t.centre[face % 3];
    return face < 3 ? side - x : x - side;
  }

  static double distance(const scene::ShaftBallCase& c) {
    const auto squared = [&c](double s) {
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = std::max({beyond(c, axis, s), beyond(c, axis + 3, s), 0.0});
        sum += x * x;
      }
      return sum;
    };
    double from = 0, to = 1;  // squared() is convex
    for (int step = 0; step < 60; ++step) {
      const double third = (to - from) / 3;
      if (squared(from + third) <= squared(to - third)) {
        to -= third;
      } else {
        from += third;
      }
    }
    return std::sqrt(std::min({squared(0), squared(1), squared((from + to) / 2)}));
  }

  static double least_kept_radius(const scene::ShaftBallCase& c) {
    double square = 0, radius = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double below = std::min(beyond(c, axis, 0), beyond(c, axis, 1));
      const double above = std::min(beyond(c, axis + 3, 0), beyond(c, axis + 3, 1));
      const double x = std::max({below, above, 0.0});
      square += x * x;
    }
    radius = std::sqrt(square);
    for (std::size_t f = 0; f < 6; ++f) {
      for (std::size_t g = 0; g < 6; ++g) {
        // beyond() of f grows with s (a is extreme), that of g falls: their mean that does not depend on s.
        const double grows = beyond(c, f, 1) - beyond(c, f, 0), falls = beyond(c, g, 0) - beyond(c, g, 1);
        if (f % 3 == g % 3 || !(grows > 0) || !(falls > 0)) continue;
        const double value = falls * beyond(c, f, 0) + grows * beyond(c, g, 0);
        radius = std::max(radius, value / std::hypot(grows, falls));
      }
    }
    return radius;
  }

  std::array<double, 15> numbers_{};
};

/// The farthest ball, in radii, of one climb.
inline scene::ShaftBallCase farthest_kept_ball(std::uint64_t seed, std::uint64_t start, int steps) {
  fuzz::CaseRandom random(seed, fuzz::stream_of("farthest-kept-ball"), start);
  SphereDistance best(random);
  double most = SphereDistance::radii(best.kept());
  for (int step = 0; step < steps; ++step) {
    SphereDistance next = best;
    for (int changes = random.integer(1, 3); changes > 0; --changes) next.change(random);
    const double radii = SphereDistance::radii(next.kept());
    if (radii < most) continue;
    most = radii;
    best = next;
  }
  return best.kept();
}

}  // namespace gnomon::tests
