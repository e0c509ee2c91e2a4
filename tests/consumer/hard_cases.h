// SPDX-License-Identifier: GPL-3.0-or-later
// Cases on which floating point is wrong when anything is: small integers moved far away, and boxes walked to
// within a few ulps of a plane of the shaft. Own generator: shares nothing with fuzz/.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fast/shaft.h"
#include "scene/shaft_case.h"

namespace consumer {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  int below(int bound) { return static_cast<int>(next() % static_cast<std::uint64_t>(bound)); }

 private:
  std::uint64_t state_;
};

/// Integers, or thirds of them (which round), scaled and moved, so that differences and products round too.
template <class F>
gnomon::scene::Box<F> grid_box(Random& random, F scale, F offset) {
  gnomon::scene::Box<F> box;
  for (int axis = 0; axis < 3; ++axis) {
    const F x = F(random.below(12)) * scale + offset, y = F(random.below(12)) * scale + offset;
    box.lo(axis) = std::min(x, y);
    box.hi(axis) = std::max(x, y);
  }
  return box;
}

/// Moves one coordinate of t's near corner onto a plane of the shaft and up to three ulps off.
template <class F>
void walk_to_plane(gnomon::scene::ShaftBoxCaseOf<F>& c, Random& random) {
  using namespace gnomon;
  const fast::Shaft<F> shaft = fast::form_shaft(c.a, c.b, fast::Normals::as_formed);
  if (shaft.plane_count == 0) return;
  const auto& plane = shaft.plane_set[static_cast<std::size_t>(random.below(shaft.plane_count))];
  const fast::Face near0 = fast::opposite(plane.far0), near1 = fast::opposite(plane.far1);
  F x = -(plane.n1 * c.t.c[near1] + plane.d) / plane.n0;
  if (!std::isfinite(x)) return;
  for (int step = random.below(7) - 3; step != 0; step += step > 0 ? -1 : 1) {
    x = std::nextafter(x, step > 0 ? F(INFINITY) : F(-INFINITY));
  }
  c.t.c[near0] = x;
  F& far = c.t.c[plane.far0];
  far = fast::is_max(plane.far0) ? std::max(far, x) : std::min(far, x);
}

template <class F>
gnomon::scene::ShaftBoxCaseOf<F> hard_case(Random& random) {
  const F scales[] = {F(1), F(1) / 3, F(0.1), F(1e-3)}, offsets[] = {F(0), F(0), F(1e3), F(-12345.7)};
  const F scale = scales[random.below(4)], offset = offsets[random.below(4)];
  gnomon::scene::ShaftBoxCaseOf<F> c{grid_box(random, scale, offset), grid_box(random, scale, offset),
                                     grid_box(random, scale, offset)};
  if (random.below(2) == 0) walk_to_plane(c, random);
  return c;
}

}  // namespace consumer
