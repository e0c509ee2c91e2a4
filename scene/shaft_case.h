// SPDX-License-Identifier: MIT
// The cases of the questions shaft-box and shaft-sphere.
#pragma once

#include "scene/ball.h"
#include "scene/box.h"

namespace gnomon::scene {

/// One instance of `shaft-box`: the box `t` against the convex hull of `a` and `b`. Every finite double is in
/// the domain; single-precision cases are held as the doubles that they are.
struct ShaftBoxCase {
  Box<double> a, b, t;

  friend bool operator==(const ShaftBoxCase&, const ShaftBoxCase&) = default;
};

/// One instance of `shaft-sphere`: the ball `t` against the convex hull of `a` and `b`.
struct ShaftBallCase {
  Box<double> a, b;
  Ball<double> t;

  friend bool operator==(const ShaftBallCase&, const ShaftBallCase&) = default;
};

}  // namespace gnomon::scene
