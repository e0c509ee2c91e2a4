// SPDX-License-Identifier: GPL-3.0-or-later
// Random shaft cases that reach every class of answers, touching ones included.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "scene/shaft_case.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {

/// Where the coordinates of a case come from.
enum class Numbers {
  coarse,    ///< integers 0..3: ties, flat boxes and touching all the time
  grid,      ///< integers 0..12
  pool,      ///< drawn from five random numbers a case: coincident faces at odd places
  unit,      ///< full significands in [-1, 1)
  mixed,     ///< magnitudes 2^-30 .. 2^30
  offset,    ///< unit numbers around a far point, up to 1e7 away
  denormal,  ///< small multiples of the smallest denormal, some normal numbers
  huge,      ///< up to the largest number
};

template <class F>
class CaseGenerator {
 public:
  CaseGenerator(std::uint64_t seed, std::vector<Numbers> kinds) : random_(seed), kinds_(std::move(kinds)) {}

  Random& random() { return random_; }

  /// Two reference boxes: apart, nested, sharing faces, flat.
  void boxes(scene::Box<F>& a, scene::Box<F>& b) {
    kind_ = kinds_[static_cast<std::size_t>(random_.below(static_cast<int>(kinds_.size())))];
    for (F& x : pool_) x = random_number(random_.chance(50) ? Numbers::unit : Numbers::grid);
    for (int axis = 0; axis < 3; ++axis) offset_[axis] = random_magnitude(1e7);
    a = any_box();
    b = any_box();
    const int relation = random_.below(10);
    for (int axis = 0; axis < 3; ++axis) {
      if (relation == 0) {  // b within a
        for (F* x : {&b.lo(axis), &b.hi(axis)}) *x = std::clamp(*x, a.lo(axis), a.hi(axis));
      } else if (relation < 4) {  // shared faces
        if (random_.chance(30)) b.lo(axis) = a.lo(axis);
        if (random_.chance(30)) b.hi(axis) = a.hi(axis);
        if (b.lo(axis) > b.hi(axis)) std::swap(b.lo(axis), b.hi(axis));
      }
    }
    if (random_.chance(3)) b = a;
    if (random_.chance(50)) std::swap(a, b);
  }

  scene::ShaftBoxCaseOf<F> box_case() {
    scene::ShaftBoxCaseOf<F> c;
    boxes(c.a, c.b);
    switch (random_.below(6)) {
      case 0:
        c.t = any_box();
        break;
      case 1:
        c.t = within(extent(c.a, c.b));
        break;
      case 2:
        c.t = within(slice(c.a, c.b));
        break;
      case 3:
        c.t = slice(c.a, c.b);
        break;
      case 4:
        c.t = beside(slice(c.a, c.b));
        break;
      default:
        c.t = on_plane(c.a, c.b);
    }
    return c;
  }

  scene::ShaftBallCaseOf<F> ball_case() {
    scene::ShaftBallCaseOf<F> c;
    if (random_.chance(25)) return pythagorean();
    boxes(c.a, c.b);
    const scene::Box<F> cut = random_.chance(30) ? extent(c.a, c.b) : slice(c.a, c.b);
    const scene::Box<F> around = random_.chance(20)   ? any_box()
                                 : random_.chance(50) ? within(cut)
                                                      : beside(cut);
    F least = std::numeric_limits<F>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const F x = random_.chance(30) ? around.lo(axis) : around.lo(axis) / 2 + around.hi(axis) / 2;
      c.t.centre[static_cast<std::size_t>(axis)] = x;
      least = std::min(least, std::max(std::fabs(x - cut.lo(axis)), std::fabs(cut.hi(axis) - x)));
      least = std::min(least, std::min(std::fabs(x - cut.lo(axis)), std::fabs(cut.hi(axis) - x)));
    }
    switch (random_.below(4)) {
      case 0:
        c.t.radius = 0;
        break;
      case 1:
        c.t.radius = std::fabs(number());
        break;
      default:
        c.t.radius = least;
    }
    if (!std::isfinite(c.t.radius)) c.t.radius = std::numeric_limits<F>::max();
    return c;
  }

  /// A ball whose nearest plane, edge or corner has a rational distance: touching from either side, exactly.
  scene::ShaftBallCaseOf<F> pythagorean() {
    static constexpr int kTriples[4][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}};
    static constexpr int kQuadruples[4][4] = {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {2, 6, 9, 11}};
    scene::ShaftBallCaseOf<F> c;
    // Axes x and y: a is extreme in +x, b in +y, and the edges (a.hi.x, a.hi.y) and (b.hi.x, b.hi.y) differ
    // by
    // (-n1, n0): the plane's normal is (n0, n1).
    const int* triple = kTriples[random_.below(4)];
    const int n0 = triple[random_.below(2)], n1 = triple[0] + triple[1] - n0, length = triple[2];
    for (int axis = 0; axis < 3; ++axis) {
      c.a.lo(axis) = F(-random_.below(60));
      c.b.lo(axis) = F(-random_.below(60));
    }
    const int k = random_.between(1, 3);
    c.a.hi(0) = F(k * n1);
    c.a.hi(1) = F(0);
    c.b.hi(0) = F(0);
    c.b.hi(1) = F(k * n0);
    c.a.hi(2) = F(random_.below(60));
    c.b.hi(2) = F(random_.below(60));
    const int step = random_.between(0, k), out = random_.between(0, 2) * (random_.chance(50) ? 1 : -1);
    c.t.radius = F(std::abs(out) * length);
    c.t.centre = {F((k - step) * n1 + out * n0), F(step * n0 + out * n1), F(random_.between(-20, 20))};
    if (random_.chance(35)) {  // a corner or, with a triple, an edge instead of the plane
      const int* q = kQuadruples[random_.below(4)];
      int order[3] = {q[0], q[1], q[2]};
      std::swap(order[0], order[random_.below(3)]);
      std::swap(order[1], order[random_.between(1, 2)]);
      c.t.radius = F(q[3]);
      if (random_.chance(50)) {
        order[0] = triple[0], order[1] = 0, order[2] = triple[1];
        c.t.radius = F(length);
      }
      for (std::size_t i = 0; i < 3; ++i) c.t.centre[i] = c.a.c[i + 3] + F(order[i]);
    }
    if (random_.chance(10)) c.t.radius += F(random_.between(-1, 1));
    c.t.radius = std::max(c.t.radius, F(0));
    return turn(c);
  }

 private:
  double random_magnitude(double most) {
    return std::ldexp(random_.unit() * 2 - 1, random_.below(static_cast<int>(std::log2(most))));
  }

  F random_number(Numbers kind) {
    switch (kind) {
      case Numbers::coarse:
        return F(random_.below(4));
      case Numbers::grid:
        return F(random_.below(13));
      case Numbers::pool:
        return pool_[static_cast<std::size_t>(random_.below(5))];
      case Numbers::unit:
      case Numbers::offset:
        return F(random_.unit() * 2 - 1);
      case Numbers::mixed:
        return F(std::ldexp(random_.unit() * 2 - 1, random_.between(-30, 30)));
      case Numbers::denormal: {
        const F few = F(random_.between(-40, 40)) * std::numeric_limits<F>::denorm_min();
        return random_.chance(80) ? few : F(std::ldexp(few, random_.below(40)));
      }
      case Numbers::huge:
        return F((random_.unit() * 2 - 1)) * std::ldexp(std::numeric_limits<F>::max(), -random_.below(12));
    }
    return F(0);
  }

  F number() { return random_number(kind_); }

  F coordinate(int axis) {
    const F x = number();
    return kind_ == Numbers::offset ? F(static_cast<double>(x) + offset_[axis]) : x;
  }

  scene::Box<F> any_box() {
    scene::Box<F> box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lo(axis) = coordinate(axis);
      box.hi(axis) = random_.chance(12) ? box.lo(axis) : coordinate(axis);
      if (box.lo(axis) > box.hi(axis)) std::swap(box.lo(axis), box.hi(axis));
    }
    return box;
  }

  static scene::Box<F> extent(const scene::Box<F>& a, const scene::Box<F>& b) {
    scene::Box<F> e;
    for (int axis = 0; axis < 3; ++axis) {
      e.lo(axis) = std::min(a.lo(axis), b.lo(axis));
      e.hi(axis) = std::max(a.hi(axis), b.hi(axis));
    }
    return e;
  }

  /// (1-s)a + sb for s = k/8, rounded.
  scene::Box<F> slice(const scene::Box<F>& a, const scene::Box<F>& b) {
    const F s = F(random_.below(9)) / 8;
    scene::Box<F> cut;
    for (std::size_t i = 0; i < 6; ++i) cut.c[i] = (1 - s) * a.c[i] + s * b.c[i];
    return cut;
  }

  /// A box with random sides within `box`: some of its faces are those of `box`.
  scene::Box<F> within(const scene::Box<F>& box) {
    scene::Box<F> t;
    for (int axis = 0; axis < 3; ++axis) {
      const F lo = box.lo(axis), hi = box.hi(axis);
      const auto part = [&] {
        const F s = kind_ == Numbers::unit ? F(random_.unit()) : F(random_.below(9)) / 8;
        return std::clamp((1 - s) * lo + s * hi, lo, hi);
      };
      t.lo(axis) = part();
      t.hi(axis) = random_.chance(15) ? t.lo(axis) : part();
      if (t.lo(axis) > t.hi(axis)) std::swap(t.lo(axis), t.hi(axis));
    }
    return t;
  }

  /// A box that begins where `box` ends on some axes and reaches away from it.
  scene::Box<F> beside(const scene::Box<F>& box) {
    scene::Box<F> t = within(box);
    for (int axis = 0; axis < 3; ++axis) {
      const F away = std::fabs(number());
      const int side = random_.below(3);
      if (side == 0) t.lo(axis) = box.hi(axis), t.hi(axis) = box.hi(axis) + away;
      if (side == 1) t.hi(axis) = box.lo(axis), t.lo(axis) = box.lo(axis) - away;
      if (!std::isfinite(t.lo(axis))) t.lo(axis) = t.hi(axis);
      if (!std::isfinite(t.hi(axis))) t.hi(axis) = t.lo(axis);
    }
    return t;
  }

  /// A box one of whose corners lies about on the line that joins two corners of a and b, up to a few ulps.
  scene::Box<F> on_plane(const scene::Box<F>& a, const scene::Box<F>& b) {
    scene::Box<F> t = random_.chance(50) ? within(slice(a, b)) : beside(slice(a, b));
    const F s = F(random_.unit());
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t i = static_cast<std::size_t>(axis + 3 * random_.below(2));
      F x = F(double(1 - s) * double(a.c[i]) + double(s) * double(b.c[i]));
      for (int steps = random_.between(-3, 3); steps != 0; steps += steps > 0 ? -1 : 1) {
        x = std::nextafter(x, steps > 0 ? std::numeric_limits<F>::max() : std::numeric_limits<F>::lowest());
      }
      F& edge = random_.chance(50) ? t.lo(axis) : t.hi(axis);
      edge = x;
      if (t.lo(axis) > t.hi(axis)) (random_.chance(50) ? t.lo(axis) : t.hi(axis)) = x;
      if (t.lo(axis) > t.hi(axis)) std::swap(t.lo(axis), t.hi(axis));
    }
    return t;
  }

  /// One of the 48 symmetries of the axes, and boxes swapped or not.
  scene::ShaftBallCaseOf<F> turn(scene::ShaftBallCaseOf<F> c) {
    std::array<int, 3> order{0, 1, 2};
    std::swap(order[0], order[static_cast<std::size_t>(random_.below(3))]);
    std::swap(order[1], order[static_cast<std::size_t>(random_.between(1, 2))]);
    scene::ShaftBallCaseOf<F> turned = c;
    for (int axis = 0; axis < 3; ++axis) {
      const int from = order[static_cast<std::size_t>(axis)];
      const bool mirror = random_.chance(50);
      for (const auto& [source, target] : {std::pair{&c.a, &turned.a}, std::pair{&c.b, &turned.b}}) {
        target->lo(axis) = mirror ? -source->hi(from) : source->lo(from);
        target->hi(axis) = mirror ? -source->lo(from) : source->hi(from);
      }
      const F x = c.t.centre[static_cast<std::size_t>(from)];
      turned.t.centre[static_cast<std::size_t>(axis)] = mirror ? -x : x;
    }
    if (random_.chance(50)) std::swap(turned.a, turned.b);
    return turned;
  }

  Random random_;
  std::vector<Numbers> kinds_;
  Numbers kind_ = Numbers::grid;
  std::array<F, 5> pool_{};
  double offset_[3] = {0, 0, 0};
};

}  // namespace gnomon::tests
