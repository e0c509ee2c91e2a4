// SPDX-License-Identifier: GPL-3.0-or-later
// Cases about as hard for thresholds as floats allow: planes solved for a coordinate or a radius, then a few
// ulps to either side.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "fast/shaft.h"
#include "scene/category.h"
#include "tests/shaft_generator.h"

namespace gnomon::tests {

inline const std::vector<Numbers> kHardNumbers{
    Numbers::coarse, Numbers::grid,   Numbers::pool,   Numbers::unit, Numbers::unit,     Numbers::mixed,
    Numbers::offset, Numbers::offset, Numbers::offset, Numbers::unit, Numbers::denormal, Numbers::huge};

/// What a run of trials against the truth has seen.
struct Tally {
  using Category = scene::Category;
  int false_culls = 0, false_insides = 0, wastes = 0, undecided = 0;
  int of_truth[3] = {0, 0, 0};

  void add(Category answer, Category truth) {
    ++of_truth[static_cast<int>(truth)];
    false_culls += answer == Category::outside && truth != Category::outside;
    false_insides += answer == Category::inside && truth != Category::inside;
    wastes += answer == Category::overlap && truth != Category::overlap;
  }
  [[nodiscard]] int unsound() const { return false_culls + false_insides; }
  void record(const std::string& name) const {
    testing::Test::RecordProperty(name + "_false_culls", false_culls);
    testing::Test::RecordProperty(name + "_false_insides", false_insides);
    testing::Test::RecordProperty(name + "_wastes", wastes);
    testing::Test::RecordProperty(name + "_undecided", undecided);
  }
};

template <class F>
F ulps_away(F x, int steps) {
  for (; steps > 0; --steps) x = std::nextafter(x, std::numeric_limits<F>::max());
  for (; steps < 0; ++steps) x = std::nextafter(x, std::numeric_limits<F>::lowest());
  return x;
}

/// Mostly as near as can be, now and then about where thresholds end.
inline int some_ulps(Random& random) {
  return random.between(-3, 3) * (random.chance(20) ? random.between(1, 6) : 1);
}

/// The plane n0 x + n1 y + d of two edges, in double precision (double overflows where F is double: callers
/// check that what they get is finite).
template <class F>
struct WidePlane {
  double n0, n1, a0, a1;

  WidePlane(const scene::Box<F>& a, const scene::Box<F>& b, const fast::ShaftPlane<F>& plane)
      : n0(std::fabs(double(b.c[plane.far1]) - double(a.c[plane.far1]))),
        n1(std::fabs(double(a.c[plane.far0]) - double(b.c[plane.far0]))),
        a0(double(a.c[plane.far0])),
        a1(double(a.c[plane.far1])) {
    if (!fast::is_max(plane.far0)) n0 = -n0;
    if (!fast::is_max(plane.far1)) n1 = -n1;
  }
  [[nodiscard]] double distance(double x, double y) const {
    return (n0 * (x - a0) + n1 * (y - a1)) / std::hypot(n0, n1);
  }
};

/// Moves t so that its near or far corner lies in some plane, up to ulps.
template <class F>
void move_onto_plane(scene::ShaftBoxCaseOf<F>& c, Random& random) {
  const fast::Shaft<F> shaft = fast::form_shaft(c.a, c.b, fast::Normals::as_formed);
  if (shaft.plane_count == 0) return;
  fast::ShaftPlane<F> plane = shaft.plane_set[static_cast<std::size_t>(random.below(shaft.plane_count))];
  const WidePlane<F> wide(c.a, c.b, plane);
  const bool near = random.chance(50);
  const std::size_t i = near ? fast::opposite(plane.far0) : plane.far0;
  const std::size_t j = near ? fast::opposite(plane.far1) : plane.far1;
  const std::size_t axis = i % 3;
  const double lo = double(shaft.extent.c[axis]), hi = double(shaft.extent.c[axis + 3]), s = random.unit();
  const F x = static_cast<F>((1 - s) * lo + s * hi);
  const F y = static_cast<F>(wide.a1 - wide.n0 / wide.n1 * (double(x) - wide.a0));
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  c.t.c[i] = x;
  c.t.c[j] = ulps_away(y, some_ulps(random));
  // The corner is what was asked for; the box reaches away from it as it did, or not at all.
  for (const std::size_t k : {i, j}) {
    F& other = c.t.c[(k + 3) % 6];
    if (k < 3 ? other < c.t.c[k] : other > c.t.c[k]) other = c.t.c[k];
  }
}

template <class F>
scene::ShaftBoxCaseOf<F> hard_box_case(CaseGenerator<F>& generator) {
  scene::ShaftBoxCaseOf<F> c = generator.box_case();
  if (generator.random().chance(60)) move_onto_plane(c, generator.random());
  return c;
}

/// Gives t the radius at which it touches some plane, the extent box or one of its sides, up to ulps.
template <class F>
void fit_radius(scene::ShaftBallCaseOf<F>& c, Random& random) {
  const fast::Shaft<F> shaft = fast::form_shaft(c.a, c.b, fast::Normals::as_formed);
  std::vector<double> distances;
  double square = 0, side = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis) {
    const double x = double(c.t.centre[static_cast<std::size_t>(axis)]);
    const double below = x - double(shaft.extent.lo(axis)), above = double(shaft.extent.hi(axis)) - x;
    const double beyond = std::max({-below, -above, 0.0});
    square += beyond * beyond;
    side = std::min({side, below, above});
  }
  distances.push_back(square > 0 ? std::sqrt(square) : side);
  for (const fast::ShaftPlane<F>& plane : shaft.planes()) {
    const WidePlane<F> wide(c.a, c.b, plane);
    distances.push_back(
        wide.distance(double(c.t.centre[plane.far0 % 3u]), double(c.t.centre[plane.far1 % 3u])));
  }
  // Outside: the farthest plane decides; within: the nearest; now and then any of them.
  double distance =
      *std::max_element(distances.begin() + 1, distances.end(), [](double x, double y) { return x < y; });
  if (shaft.plane_count == 0) distance = distances[0];
  if (random.chance(30)) distance = distances[static_cast<std::size_t>(random.below(shaft.plane_count + 1))];
  if (distance < 0 && -distance > side && side >= 0) distance = side;
  const double r = std::fabs(distance);
  if (!(r <= double(std::numeric_limits<F>::max()) / 4)) return;
  c.t.radius = std::max(ulps_away(static_cast<F>(r), some_ulps(random)), F(0));
}

/// Puts the centre so that a ball of radius 1e-3 .. 1e7 touches a plane about where the shaft lies.
template <class F>
void put_big_ball(scene::ShaftBallCaseOf<F>& c, Random& random) {
  const fast::Shaft<F> shaft = fast::form_shaft(c.a, c.b, fast::Normals::as_formed);
  if (shaft.plane_count == 0) return;
  const fast::ShaftPlane<F>& plane =
      shaft.plane_set[static_cast<std::size_t>(random.below(shaft.plane_count))];
  const WidePlane<F> wide(c.a, c.b, plane);
  const double r = std::pow(10.0, random.unit() * 10 - 3), s = random.unit(),
               length = std::hypot(wide.n0, wide.n1);
  const double b0 = double(c.b.c[plane.far0]), b1 = double(c.b.c[plane.far1]);
  const F x = static_cast<F>((1 - s) * wide.a0 + s * b0 + r * wide.n0 / length);
  const F y = static_cast<F>((1 - s) * wide.a1 + s * b1 + r * wide.n1 / length);
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  c.t.centre[plane.far0 % 3u] = x;
  c.t.centre[plane.far1 % 3u] = y;
  const int third = 3 - plane.far0 % 3 - plane.far1 % 3;
  c.t.centre[static_cast<std::size_t>(third)] = c.a.lo(third) / 2 + c.b.hi(third) / 2;
}

template <class F>
scene::ShaftBallCaseOf<F> hard_ball_case(CaseGenerator<F>& generator) {
  scene::ShaftBallCaseOf<F> c = generator.ball_case();
  Random& random = generator.random();
  if (random.chance(30)) put_big_ball(c, random);
  if (random.chance(75)) fit_radius(c, random);
  return c;
}

}  // namespace gnomon::tests
