// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that the distributions are put together from.
//
// A rule for all of them: never two draws in one expression. The order of evaluation is the compiler's
// choice, and the same seed has to give the same cases everywhere. Another: what a and b depend on is drawn
// as Part::shaft, the rest as Part::t, where each ends.
#pragma once

#include <algorithm>
#include <cmath>

#include "fuzz/random.h"
#include "scene/shaft_case.h"

namespace gnomon::fuzz {

template <class F>
using Triple = scene::ShaftBoxCaseOf<F>;

/// Coordinates of one axis in order.
template <class F>
void set_axis(scene::Box<F>& box, int axis, F x, F y) {
  box.lo(axis) = std::min(x, y);
  box.hi(axis) = std::max(x, y);
}

/// The box around a centre; rounding is monotone, so lo <= hi.
template <class F>
void set_around(scene::Box<F>& box, int axis, F centre, F half) {
  box.lo(axis) = centre - half;
  box.hi(axis) = centre + half;
}

template <class F>
[[nodiscard]] F extent_lo(const Triple<F>& c, int axis) {
  return std::min(c.a.lo(axis), c.b.lo(axis));
}
template <class F>
[[nodiscard]] F extent_hi(const Triple<F>& c, int axis) {
  return std::max(c.a.hi(axis), c.b.hi(axis));
}

/// The side of the box (1-s)a + sb, rounded.
template <class F>
[[nodiscard]] F side_at(const Triple<F>& c, std::size_t face, F s) {
  return c.a.c[face] + s * (c.b.c[face] - c.a.c[face]);
}

/// Puts t around a random point of the shaft: `reach` 1 takes centres from all of (1-s)a + sb, larger ones
/// from beyond; half sizes are `size` times a random share of the section's.
template <class F>
void place_near_section(CaseRandom& random, Triple<F>& c, F reach, F size) {
  const F s = random.unit<F>();
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t i = static_cast<std::size_t>(axis);
    const F lo = side_at(c, i, s), hi = side_at(c, i + 3, s);
    const F half = (hi - lo) / 2;
    const F centre = lo + half + random.between<F>(-1, 1) * half * reach;
    set_around(c.t, axis, centre, half * size * random.unit<F>());
  }
}

/// Puts t around a random point of the extent box widened by `margin` of its size.
template <class F>
void place_in_extent(CaseRandom& random, Triple<F>& c, F margin, F size) {
  for (int axis = 0; axis < 3; ++axis) {
    const F lo = extent_lo(c, axis), hi = extent_hi(c, axis), width = hi - lo;
    const F centre = random.between<F>(lo - margin * width, hi + margin * width);
    set_around(c.t, axis, centre, width * size * random.unit<F>());
  }
}

/// Two small boxes at random places of the unit cube, and t by a mixture: in the shaft, at it, and anywhere
/// about. What `uniform` is; others start from it.
template <class F>
[[nodiscard]] Triple<F> uniform_triple(CaseRandom& random) {
  Triple<F> c;
  for (scene::Box<F>* box : {&c.a, &c.b}) {
    for (int axis = 0; axis < 3; ++axis) {
      const F centre = random.unit<F>();
      set_around(*box, axis, centre, random.between<F>(0, F(0.15)));
    }
  }
  random.part(Part::t);
  const F kind = random.unit<F>();
  if (kind < F(0.25)) {
    place_near_section<F>(random, c, F(0.6), F(0.35));
  } else if (kind < F(0.45)) {
    place_near_section<F>(random, c, F(2), F(1));
  } else {
    place_in_extent<F>(random, c, F(0.05), F(0.1));
  }
  return c;
}

/// x moved by `steps` neighbouring numbers of the format.
template <class F>
[[nodiscard]] F step_ulps(F x, int steps) {
  const F towards = steps > 0 ? std::numeric_limits<F>::infinity() : -std::numeric_limits<F>::infinity();
  for (int i = std::abs(steps); i > 0; --i) x = std::nextafter(x, towards);
  return std::isfinite(x) ? x : std::copysign(std::numeric_limits<F>::max(), x);
}

/// The ball that takes t's place: its centre, and a radius between half of t's least and greatest half side.
template <class F>
[[nodiscard]] scene::ShaftBallCase with_ball(CaseRandom& random, const Triple<F>& c) {
  scene::ShaftBallCase result{scene::converted<double>(c.a), scene::converted<double>(c.b), {}};
  F least = std::numeric_limits<F>::max(), most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const F half = c.t.hi(axis) / 2 - c.t.lo(axis) / 2;
    result.t.centre[static_cast<std::size_t>(axis)] =
        static_cast<double>(c.t.lo(axis) / 2 + c.t.hi(axis) / 2);
    least = std::min(least, half);
    most = std::max(most, half);
  }
  result.t.radius = static_cast<double>(random.between<F>(least / 2, most));
  return result;
}

}  // namespace gnomon::fuzz
