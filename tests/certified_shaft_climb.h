// SPDX-License-Identifier: GPL-3.0-or-later
// The planes of a shaft in rationals, and a search for the points at which their floating-point values err
// most.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fast/shaft.h"
#include "tests/certified_shaft_cases.h"

namespace gnomon::tests {

template <class F>
mpq_class rational(F x) {
  return mpq_class(static_cast<double>(x));
}

/// The plane through two edges, N0 (x - a0) + N1 (y - a1), and the largest magnitudes in the extent box.
template <class F>
struct ExactPlane {
  mpq_class n0, n1, a0, a1, b0, b1, most0, most1;

  ExactPlane(const fast::Shaft<F>& shaft, const fast::ShaftPlane<F>& plane)
      : a0(rational(shaft.a.c[plane.far0])),
        a1(rational(shaft.a.c[plane.far1])),
        b0(rational(shaft.b.c[plane.far0])),
        b1(rational(shaft.b.c[plane.far1])) {
    n0 = abs(b1 - a1);
    n1 = abs(a0 - b0);
    if (!fast::is_max(plane.far0)) n0 = -n0;
    if (!fast::is_max(plane.far1)) n1 = -n1;
    const auto most = [&shaft](int axis) {
      return std::max(mpq_class(abs(rational(shaft.extent.lo(axis)))),
                      mpq_class(abs(rational(shaft.extent.hi(axis)))));
    };
    most0 = most(fast::axis_of(plane.far0));
    most1 = most(fast::axis_of(plane.far1));
  }
  [[nodiscard]] mpq_class value(F x, F y) const { return n0 * (rational(x) - a0) + n1 * (rational(y) - a1); }
};

/// What a climb looks for: the largest |T - exact|; the largest T of a point that is not outside the plane;
/// the least T of one that is.
enum class Aim { error, false_cull, false_inside };

/// The error (or the false T) over its threshold, for a point of the extent box. Above 1 the bound is broken.
template <class F>
double share_of_threshold(Aim aim, const fast::Shaft<F>& shaft, const fast::ShaftPlane<F>& plane, F x, F y) {
  const mpq_class exact = ExactPlane<F>(shaft, plane).value(x, y), value = rational(plane.value(x, y));
  switch (aim) {
    case Aim::error:
      return mpq_class(abs(value - exact) / rational(plane.outside_threshold)).get_d();
    case Aim::false_cull:
      return exact > 0 ? 0 : mpq_class(value / rational(plane.outside_threshold)).get_d();
    case Aim::false_inside:
      return exact <= 0 ? 0 : mpq_class(value / rational(plane.inside_threshold)).get_d();
  }
  return 0;
}

/// A shaft with a plane in x and y, and a point.
template <class F>
struct ClimbCase {
  std::array<F, 8> n{};  ///< the upper corners of a and of b, the point, the lower corner of the extent box

  [[nodiscard]] double share(Aim aim,
                             fast::Shaft<F> (*form)(const scene::Box<F>&, const scene::Box<F>&)) const {
    scene::Box<F> a{{0, 0, 0, n[0], n[1], 0}}, b{{0, 0, 0, n[2], n[3], 0}};
    a.lo(0) = b.lo(0) = std::min({n[0], n[2], n[6]});
    a.lo(1) = b.lo(1) = std::min({n[1], n[3], n[7]});
    const fast::Shaft<F> shaft = form(a, b);
    double largest = 0;
    for (const fast::ShaftPlane<F>& plane : shaft.planes()) {
      const int axis0 = fast::axis_of(plane.far0), axis1 = fast::axis_of(plane.far1);
      const F x = axis0 == 0 ? n[4] : n[5], y = axis1 == 0 ? n[4] : n[5];
      const bool within = x >= shaft.extent.lo(axis0) && x <= shaft.extent.hi(axis0) &&
                          y >= shaft.extent.lo(axis1) && y <= shaft.extent.hi(axis1);
      if (within) largest = std::max(largest, share_of_threshold(aim, shaft, plane, x, y));
    }
    return largest;
  }
};

/// The largest share seen: random shafts, then a climb from the best by small changes of single numbers.
template <class F>
double largest_share(Aim aim, fast::Shaft<F> (*form)(const scene::Box<F>&, const scene::Box<F>&),
                     std::uint64_t seed, int trials) {
  Random random(seed);
  double best = 0;
  ClimbCase<F> winner;
  for (int i = 0; i < trials; ++i) {
    ClimbCase<F> c = winner;
    if (i < trials / 3) {
      // Errors are largest for numbers just above powers of two, x at the other end from a0.
      for (F& x : c.n)
        x = F((1 + std::ldexp(random.unit(), -random.below(8))) * (random.chance(50) ? 1 : -1));
      if (random.chance(70)) c.n[4] = F(-c.n[0] * (1 - std::ldexp(random.unit(), -random.below(20))));
      if (random.chance(50)) c.n[2] = F(c.n[0] - std::ldexp(random.unit(), -random.below(20)));
    } else {
      F& x = c.n[static_cast<std::size_t>(random.below(8))];
      x = random.chance(50) ? ulps_away(x, random.between(-9, 9))
                            : F(double(x) * (1 + std::ldexp(random.unit() - 0.5, -random.below(30))));
    }
    if (aim != Aim::error && random.chance(50)) {  // back onto the line through both edges
      const double slope = (double(c.n[3]) - double(c.n[1])) / (double(c.n[2]) - double(c.n[0]));
      c.n[5] =
          ulps_away(F(double(c.n[1]) + slope * (double(c.n[4]) - double(c.n[0]))), random.between(-2, 2));
    }
    const double share = c.share(aim, form);
    if (share > best) {
      best = share;
      winner = c;
    }
  }
  return best;
}

}  // namespace gnomon::tests
