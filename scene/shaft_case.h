// SPDX-License-Identifier: MIT
// The cases of the questions shaft-box and shaft-sphere.
#pragma once

#include "scene/ball.h"
#include "scene/box.h"

namespace gnomon::scene {

/// One instance of `shaft-box`: the box `t` against the convex hull of `a` and `b`. Every finite number of
/// the format is in the domain.
template <class F>
struct ShaftBoxCaseOf {
  Box<F> a, b, t;

  friend bool operator==(const ShaftBoxCaseOf&, const ShaftBoxCaseOf&) = default;
};

/// One instance of `shaft-sphere`: the ball `t` against the convex hull of `a` and `b`.
template <class F>
struct ShaftBallCaseOf {
  Box<F> a, b;
  Ball<F> t;

  friend bool operator==(const ShaftBallCaseOf&, const ShaftBallCaseOf&) = default;
};

/// The form that references, files and witnesses use: a single-precision case is held as the doubles that it
/// is.
using ShaftBoxCase = ShaftBoxCaseOf<double>;
using ShaftBallCase = ShaftBallCaseOf<double>;

/// The case with its numbers converted, as converted() of boxes and balls.
template <class To, class From>
[[nodiscard]] ShaftBoxCaseOf<To> converted(const ShaftBoxCaseOf<From>& c) {
  return {converted<To>(c.a), converted<To>(c.b), converted<To>(c.t)};
}
template <class To, class From>
[[nodiscard]] ShaftBallCaseOf<To> converted(const ShaftBallCaseOf<From>& c) {
  return {converted<To>(c.a), converted<To>(c.b), converted<To>(c.t)};
}

}  // namespace gnomon::scene
