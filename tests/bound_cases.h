// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases for the error bounds, and climbs to harder ones.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "fuzz/random.h"
#include "fuzz/shapes.h"
#include "tests/bound_shares.h"

namespace gnomon::tests {

/// Just above a power of two, where a rounding costs most; either sign.
template <class F>
F just_above_one(fuzz::CaseRandom& random) {
  const double unit = random.unit<double>();
  const int exponent = random.below(8);
  return random.sign<F>() * static_cast<F>(1 + std::ldexp(unit, -exponent));
}

/// Another number near x: up to nine ulps away, or by a factor.
template <class F>
F nearby(fuzz::CaseRandom& random, F x) {
  if (random.chance(0.5)) return fuzz::step_ulps(x, random.integer(-9, 9));
  const double unit = random.unit<double>() - 0.5;
  const int exponent = random.below(30);
  return static_cast<F>(static_cast<double>(x) * (1 + std::ldexp(unit, -exponent)));
}

/// A shaft with a plane in x and y, and a point, most often on the line through both edges.
template <class F>
class EdgesCase {
 public:
  explicit EdgesCase(fuzz::CaseRandom& random) {
    for (F& x : n_) x = just_above_one<F>(random);
    const double far = random.unit<double>(), near = random.unit<double>();
    const int far_exponent = random.below(20), near_exponent = random.below(20);
    if (random.chance(0.7)) x() = static_cast<F>(-n_[0] * (1 - std::ldexp(far, -far_exponent)));
    if (random.chance(0.5)) n_[2] = static_cast<F>(n_[0] - std::ldexp(near, -near_exponent));
    if (random.chance(0.7)) put_on_line(random);
  }
  /// Moves a's corner towards the origin, and the lower corner of the extent box with it.
  void shrink_a(fuzz::CaseRandom& random) {
    for (const std::size_t i : {0u, 1u, 6u, 7u}) n_[i] = std::ldexp(n_[i], -random.below(12));
    put_on_line(random);
  }
  /// About as small as makes products of two numbers underflow.
  void make_products_underflow(fuzz::CaseRandom& random) {
    constexpr int kHalf = (std::numeric_limits<F>::min_exponent - std::numeric_limits<F>::digits) / 2;
    const int exponent = kHalf + random.integer(-2, 6);
    for (F& x : n_) x = std::ldexp(x, exponent);
  }
  void change(fuzz::CaseRandom& random) {
    F& x = n_[static_cast<std::size_t>(random.below(8))];
    x = nearby(random, x);
    if (random.chance(0.3)) put_on_line(random);
  }
  [[nodiscard]] scene::Box<F> a() const { return box(n_[0], n_[1]); }
  [[nodiscard]] scene::Box<F> b() const { return box(n_[2], n_[3]); }
  /// The point's coordinate on the axis of a face.
  [[nodiscard]] F point(fast::Face face) const {
    return n_[4 + static_cast<std::size_t>(fast::axis_of(face))];
  }

  void measure(BoundShares& shares) const {
    const fast::Shaft<F> of_box = fast::form_certified_box_shaft(a(), b());
    const fast::Shaft<F> of_ball = fast::form_certified_ball_shaft(a(), b());
    for (std::size_t i = 0; i < of_box.plane_count; ++i) {
      const fast::ShaftPlane<F>& plane = of_box.plane_set[i];
      add_box_shares(shares, of_box, plane, point(plane.far0), point(plane.far1));
      add_ball_shares(shares, of_ball, of_ball.plane_set[i], point(plane.far0), point(plane.far1));
    }
  }

 private:
  [[nodiscard]] scene::Box<F> box(F x, F y) const {
    return {{std::min({n_[0], n_[2], n_[6]}), std::min({n_[1], n_[3], n_[7]}), 0, x, y, 0}};
  }
  F& x() { return n_[4]; }
  void put_on_line(fuzz::CaseRandom& random) {
    const double slope = (double(n_[3]) - double(n_[1])) / (double(n_[2]) - double(n_[0]));
    const double y = double(n_[1]) + slope * (double(n_[4]) - double(n_[0]));
    if (std::fabs(y) < 1e6) n_[5] = fuzz::step_ulps(static_cast<F>(y), random.integer(-2, 2));
  }

  std::array<F, 8> n_{};  ///< the upper corners of a and of b, the point, the lower corner of the extent box
};

/// A centre beyond the upper corner of a box.
template <class F>
class DistanceCase {
 public:
  explicit DistanceCase(fuzz::CaseRandom& random) {
    for (F& x : n_) x = just_above_one<F>(random);
  }
  void change(fuzz::CaseRandom& random) {
    F& x = n_[static_cast<std::size_t>(random.below(6))];
    x = nearby(random, x);
    if (random.chance(0.1)) x = just_above_one<F>(random);
  }
  void measure(BoundShares& shares) const {
    scene::Box<F> box;
    for (std::size_t i = 0; i < 3; ++i) {
      box.c[i] = -16;
      box.c[i + 3] = n_[i];
    }
    const scene::Box<F> point;
    const fast::BallSlack<F> slack = fast::form_certified_ball_shaft(point, point).slack;
    add_distance_share(shares, slack, {n_[3], n_[4], n_[5]}, box);
  }

 private:
  std::array<F, 6> n_{};
};

/// Climbs by small changes of single numbers, from the best of some random cases, to a large share.
template <class Case>
BoundShares climb(Bound aim, std::uint64_t seed, std::uint64_t start, int steps) {
  fuzz::CaseRandom random(seed, fuzz::stream_of("climb"), start * kBounds + static_cast<std::uint64_t>(aim));
  BoundShares all;
  double best = -1;
  Case winner(random);
  for (int step = 0; step < steps; ++step) {
    Case next = winner;
    if (step < steps / 4) {
      next = Case(random);
    } else {
      next.change(random);
    }
    BoundShares shares;
    next.measure(shares);
    all.add(shares);
    if (shares.of(aim) < best) continue;
    best = shares.of(aim);
    winner = next;
  }
  return all;
}

}  // namespace gnomon::tests
