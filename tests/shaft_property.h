// SPDX-License-Identifier: GPL-3.0-or-later
// RapidCheck generators of shaft cases (its own floats are poor), and a runner with a fixed seed.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <sstream>
#include <utility>

#include "scene/shaft_case.h"
#include "tests/shaft_random.h"
#include "tests/shaft_text.h"

namespace gnomon::scene {

template <class F>
std::ostream& operator<<(std::ostream& out, const ShaftBoxCaseOf<F>& c) {
  return out << tests::text_of(c);
}
template <class F>
std::ostream& operator<<(std::ostream& out, const ShaftBallCaseOf<F>& c) {
  return out << tests::text_of(c);
}

}  // namespace gnomon::scene

namespace gnomon::tests {

/// Runs a property `successes` times with a fixed seed; RC_PARAMS in the environment overrides both.
template <class Property>
void hold(int successes, Property property) {
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  if (std::getenv("RC_PARAMS") == nullptr) {
    params.seed = 20260101;
    params.maxSuccess = kSanitized ? affordable(successes) / 2 : successes;
  }
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  rc::detail::TestMetadata metadata;
  metadata.id = std::string(info->test_suite_name()) + "/" + info->name();
  metadata.description = info->name();
  const rc::detail::TestResult result = rc::detail::checkTestable(std::move(property), metadata, params);
  if (!result.template is<rc::detail::SuccessResult>()) {
    std::ostringstream text;
    rc::detail::printResultMessage(result, text);
    FAIL() << text.str();
  }
}

/// lo .. hi - 1, all of them from the first trial on: RapidCheck's own begins with the least alone.
inline rc::Gen<int> in_range(int lo, int hi) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(lo, hi));
}

/// Floats by kind, all well away from under- and overflow and held exactly by both formats.
inline rc::Gen<float> number(int kind) {
  switch (kind) {
    case 0:  // small integers: ties and touching
      return rc::gen::map(in_range(-4, 5), [](int n) { return static_cast<float>(n); });
    case 1:  // dyadic fractions
      return rc::gen::map(in_range(-1024, 1025), [](int n) { return static_cast<float>(n) / 64; });
    case 2:  // integers and the floats around them
      return rc::gen::map(rc::gen::pair(in_range(-4, 5), in_range(-2, 3)), [](const std::pair<int, int>& p) {
        float x = static_cast<float>(p.first);
        for (int i = 0; i < std::abs(p.second) && x != 0; ++i)
          x = std::nextafter(x, p.second > 0 ? 100.0f : -100.0f);
        return x;
      });
    default:  // full significands of many magnitudes
      return rc::gen::map(
          rc::gen::pair(in_range(-(1 << 24) + 1, 1 << 24), in_range(-34, -14)),
          [](const std::pair<int, int>& p) { return std::ldexp(static_cast<float>(p.first), p.second); });
  }
}

template <class F>
scene::Box<F> box_of(int kind) {
  scene::Box<F> box;
  for (int axis = 0; axis < 3; ++axis) {
    const float x = *number(kind),
                y = *rc::gen::weightedOneOf<float>({{1, rc::gen::just(x)}, {5, number(kind)}});
    box.lo(axis) = static_cast<F>(std::min(x, y));
    box.hi(axis) = static_cast<F>(std::max(x, y));
  }
  return box;
}

/// The box (1-s)a + sb for s = k/8, rounded to floats.
template <class F>
scene::Box<F> slice_of(const scene::Box<F>& a, const scene::Box<F>& b) {
  const float s = static_cast<float>(*in_range(0, 9)) / 8;
  scene::Box<F> cut;
  for (std::size_t i = 0; i < 6; ++i) {
    cut.c[i] = static_cast<F>((1 - s) * static_cast<float>(a.c[i]) + s * static_cast<float>(b.c[i]));
  }
  return cut;
}

template <class F>
rc::Gen<scene::ShaftBoxCaseOf<F>> box_cases(int kinds = 4) {
  return rc::gen::exec([kinds] {
    const int kind = *in_range(0, kinds);
    scene::ShaftBoxCaseOf<F> c{box_of<F>(kind), box_of<F>(kind), {}};
    switch (*in_range(0, 3)) {
      case 0:
        c.t = box_of<F>(kind);
        break;
      case 1:
        c.t = slice_of(c.a, c.b);
        break;
      default:  // a corner of a slice, and away from it or into it
        c.t = slice_of(c.a, c.b);
        for (int axis = 0; axis < 3; ++axis) {
          const F x = *rc::gen::element(c.t.lo(axis), c.t.hi(axis)), y = static_cast<F>(*number(kind));
          c.t.lo(axis) = std::min(x, y);
          c.t.hi(axis) = std::max(x, y);
        }
    }
    return c;
  });
}

template <class F>
rc::Gen<scene::ShaftBallCaseOf<F>> ball_cases(int kinds = 4) {
  return rc::gen::exec([kinds] {
    const int kind = *in_range(0, kinds);
    scene::ShaftBallCaseOf<F> c{box_of<F>(kind), box_of<F>(kind), {}};
    const scene::Box<F> around = *in_range(0, 2) == 0 ? box_of<F>(kind) : slice_of(c.a, c.b);
    F side = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const F x = *rc::gen::element(around.lo(axis), around.hi(axis), static_cast<F>(*number(kind)));
      c.t.centre[static_cast<std::size_t>(axis)] = x;
      side = std::max(side, static_cast<F>(static_cast<float>(std::fabs(x - c.a.lo(axis)))));
    }
    c.t.radius = *rc::gen::element(F(0), side, static_cast<F>(std::fabs(*number(kind))));
    return c;
  });
}

}  // namespace gnomon::tests
