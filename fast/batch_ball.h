// SPDX-License-Identifier: MIT
// One shaft against many balls, in vector registers: the kernels of fast/shaft_ball.h, and an exact tier. As
// fast/batch_box.h, every instruction set gives the same bytes.
#pragma once

#include <span>

#include "fast/batch_types.h"
#include "fast/shaft.h"

namespace gnomon::fast {

/// A shaft laid out for classify_balls(): made once a shaft, from one with unit normals (naive) or
/// form_certified_ball_shaft().
template <class F>
class BatchBallShaft {
 public:
  BatchBallShaft(const Shaft<F>& shaft);  // NOLINT(google-explicit-constructor): the same shaft, rearranged

  struct Plane {
    F n0, n1, d, outside_threshold, inside_threshold;
    std::uint8_t axis0, axis1;
  };
  scene::Box<F> extent;
  std::array<Plane, 8> planes;
  std::size_t plane_count;
  BallSlack<F> slack;
};

/// answers[i] becomes 0 (outside), 1 (overlap) or 2 (inside): bit for bit what classify(shaft,
/// balls[i]).answer of fast/shaft_ball.h says, for every input, NaN and infinity included; the promise is the
/// shaft's. `answers` must hold balls.count bytes.
template <class F>
void classify_balls(const BatchBallShaft<F>& shaft, const BallsSoA<F>& balls,
                    std::span<std::uint8_t> answers);

/// The same as bit planes; without `answers.inside` the inside test is left out.
template <class F>
void classify_balls(const BatchBallShaft<F>& shaft, const BallsSoA<F>& balls, BitPlanes answers);

/// The shaft between two boxes laid out for classify_balls_exact(), made once a shaft. Both boxes must be
/// valid (scene::is_valid). See batch_ball_exact.cpp for what the members mean.
template <class F>
class ExactBallShaft {
 public:
  ExactBallShaft(const scene::Box<F>& a, const scene::Box<F>& b);

  /// Stage 1: a shortened normal, and d lowered by twice the certified threshold.
  struct Filter {
    F n0, n1, d;
    std::uint8_t axis0, axis1;
  };
  /// Stage 2: the plane n0 (x - a_far0) + n1 (y - a_far1) <= 0, normals as exact sums; length is rounded.
  struct Plane {
    double n0_high, n0_low, n1_high, n1_low, length;
    Face far0, far1;
  };
  /// Stage 2: a side of the moving box lies beyond the centre by p + q s.
  struct Run {
    double q, inverse;  ///< inverse is 0 where q is 0, and not exact
    bool is_exact;
  };
  /// The grid's stage: the plane n0 p_far0 + n1 p_far1 <= 0, with p the distances beyond the sides of a.
  struct GridPlane {
    F n0, n1, squared_length;
    Face far0, far1;
  };
  struct Grid {
    bool is_usable = false;  ///< the shaft's coordinates are multiples of some power of two g, and few
    F rounder = 0;           ///< added and taken away again, it rounds to multiples of g
    scene::Box<F> range{};   ///< of centres
    std::array<F, 6> q{};    ///< Run::q
    std::array<GridPlane, 8> planes{};
  };
  scene::Box<F> a, b, extent;
  std::array<Filter, 8> filters;
  std::array<Plane, 8> planes;
  std::array<Run, 6> runs;
  std::size_t plane_count = 0;
  F inner_margin;  ///< below minus this the filters' largest value proves the centre within all planes; NaN:
                   ///< never
  BallSlack<F> slack;
  Grid grid;
  bool has_error_free;

 private:
  void find_grid();
};

/// The exact category of every valid ball: the certified test; exact arithmetic on a grid, where shaft and
/// ball have one; certificates and error-free transforms in double precision; all three in vector registers,
/// then `predicate` for what is left. The answers for invalid balls (NaN, infinity, negative radius) are
/// unspecified categories.
template <class F>
BatchCounters classify_balls_exact(const ExactBallShaft<F>& shaft, const BallsSoA<F>& balls,
                                   std::span<std::uint8_t> answers, ExactPredicate<scene::Ball<F>> predicate);

/// The same as bit planes; without `answers.inside` the inside test is left out.
template <class F>
BatchCounters classify_balls_exact(const ExactBallShaft<F>& shaft, const BallsSoA<F>& balls,
                                   BitPlanes answers, ExactPredicate<scene::Ball<F>> predicate);

}  // namespace gnomon::fast
