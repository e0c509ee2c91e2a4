// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/distributions.h"

namespace gnomon::fuzz {

template <class F>
Triple<F> offset_triple(CaseRandom& random, double magnitude) {
  Triple<F> c = uniform_triple<F>(random);
  random.part(Part::shaft);
  for (int axis = 0; axis < 3; ++axis) {
    const F by = random.sign<F>() * static_cast<F>(magnitude);
    for (scene::Box<F>* box : {&c.a, &c.b, &c.t}) {
      box->lo(axis) = by + F(16) * box->lo(axis);
      box->hi(axis) = by + F(16) * box->hi(axis);
    }
  }
  random.part(Part::t);
  return c;
}

template <class F>
Triple<F> grid_triple(CaseRandom& random, int size) {
  Triple<F> c;
  for (scene::Box<F>* box : {&c.a, &c.b}) {
    for (int axis = 0; axis < 3; ++axis) {
      const int x = random.below(size);
      set_axis(*box, axis, F(x), F(random.below(size)));
    }
  }
  random.part(Part::t);
  const bool small = random.chance(0.5);
  for (int axis = 0; axis < 3; ++axis) {
    const int lo = random.below(size), draw = random.below(small ? 2 : size);
    const int hi = small ? std::min(size - 1, lo + draw) : draw;
    set_axis(c.t, axis, F(lo), F(hi));
  }
  return c;
}

template <class F>
Triple<F> nested_triple(CaseRandom& random) {
  Triple<F> c;
  scene::Box<F>* order[3] = {&c.a, &c.b, &c.t};
  for (int i = 2; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
  scene::Box<F> outer;
  for (int axis = 0; axis < 3; ++axis) {
    const F x = random.unit<F>();
    set_axis(outer, axis, x, random.unit<F>());
  }
  for (scene::Box<F>* box : order) {
    *box = outer;
    for (int axis = 0; axis < 3; ++axis) {
      // Each side stays or moves inwards; now and then a box sticks out instead.
      const F width = outer.hi(axis) - outer.lo(axis);
      const F cut = random.chance(0.3) ? F(0) : random.between<F>(0, F(0.5)) * width;
      const F other = random.chance(0.3) ? F(0) : random.between<F>(0, F(0.5)) * width;
      const F shift = random.chance(0.12) ? random.between<F>(-1, 1) * width : F(0);
      set_axis(*box, axis, outer.lo(axis) + cut + shift, outer.hi(axis) - other + shift);
    }
    outer = *box;
  }
  return c;
}

template <class F>
Triple<F> degenerate_triple(CaseRandom& random) {
  Triple<F> c;
  // A few values an axis, so that sides coincide; multiples of 0.1 are the decimals that people type.
  F pool[3][4];
  const int kind = random.below(3);
  for (auto& values : pool) {
    for (F& value : values) {
      value = kind == 0   ? F(random.integer(-4, 4))
              : kind == 1 ? F(random.integer(-20, 20)) * F(0.1)
                          : random.between<F>(-1, 1);
    }
  }
  for (scene::Box<F>* box : {&c.a, &c.b, &c.t}) {
    if (box == &c.t) random.part(Part::t);
    for (int axis = 0; axis < 3; ++axis) {
      const F x = pool[axis][random.below(4)];
      const bool flat = random.chance(0.35);
      const F y = flat ? x : pool[axis][random.below(4)];
      set_axis(*box, axis, x, y);
    }
  }
  return c;
}

template <class F>
Triple<F> thin_triple(CaseRandom& random) {
  const auto thin_half = [&random] {
    const int exponent = -random.below(21);
    return std::ldexp(F(0.25) + random.unit<F>() / 4, exponent);
  };
  Triple<F> c;
  for (scene::Box<F>* box : {&c.a, &c.b}) {
    for (int axis = 0; axis < 3; ++axis) {
      const F centre = random.between<F>(-1, 1);
      set_around(*box, axis, centre, thin_half());
    }
  }
  random.part(Part::t);
  const F kind = random.unit<F>();
  if (kind < F(0.4)) {
    place_near_section<F>(random, c, F(0.9), F(0.5));
  } else {
    place_near_section<F>(random, c, F(1.5), F(1));
    for (int axis = 0; axis < 3; ++axis) {
      if (random.chance(0.5)) set_around(c.t, axis, c.t.lo(axis), thin_half());
    }
  }
  return c;
}

template <class F>
Triple<F> mixed_triple(CaseRandom& random, int from_exponent, int to_exponent) {
  const auto number = [&] {
    const F sign = random.sign<F>();
    const int exponent = random.integer(from_exponent, to_exponent);
    return sign * std::ldexp(1 + random.unit<F>(), exponent);
  };
  Triple<F> c;
  for (scene::Box<F>* box : {&c.a, &c.b}) {
    for (int axis = 0; axis < 3; ++axis) {
      const F x = number();
      set_axis(*box, axis, x, number());
    }
  }
  random.part(Part::t);
  if (random.chance(0.4)) {
    place_near_section<F>(random, c, F(0.8), F(0.5));
    for (F& x : c.t.c) {
      if (!std::isfinite(x)) x = 0;
    }
    for (int axis = 0; axis < 3; ++axis) set_axis(c.t, axis, c.t.lo(axis), c.t.hi(axis));
  } else {
    for (int axis = 0; axis < 3; ++axis) {
      const F x =
          random.chance(0.5) ? number() : random.between<F>(extent_lo(c, axis) / 2, extent_hi(c, axis) / 2);
      const F size = random.chance(0.5) ? std::fabs(number()) : std::fabs(x) / 64;
      set_axis(c.t, axis, x, step_ulps(x + size, 0));
    }
  }
  return c;
}

template <class F>
Triple<F> denormal_triple(CaseRandom& random) {
  const int limit = random.chance(0.5) ? 1 << 12 : 1 << 26;
  const Triple<F> unit = uniform_triple<F>(random);
  Triple<F> c;
  const auto shrink = [limit](F x) {
    return std::round(x * F(limit)) * std::numeric_limits<F>::denorm_min();
  };
  for (std::size_t i = 0; i < 6; ++i) {
    c.a.c[i] = shrink(unit.a.c[i]);
    c.b.c[i] = shrink(unit.b.c[i]);
    c.t.c[i] = shrink(unit.t.c[i]);
  }
  return c;
}

template Triple<float> offset_triple(CaseRandom&, double);
template Triple<double> offset_triple(CaseRandom&, double);
template Triple<float> grid_triple(CaseRandom&, int);
template Triple<double> grid_triple(CaseRandom&, int);
template Triple<float> nested_triple(CaseRandom&);
template Triple<double> nested_triple(CaseRandom&);
template Triple<float> degenerate_triple(CaseRandom&);
template Triple<double> degenerate_triple(CaseRandom&);
template Triple<float> thin_triple(CaseRandom&);
template Triple<double> thin_triple(CaseRandom&);
template Triple<float> mixed_triple(CaseRandom&, int, int);
template Triple<double> mixed_triple(CaseRandom&, int, int);
template Triple<float> denormal_triple(CaseRandom&);
template Triple<double> denormal_triple(CaseRandom&);

}  // namespace gnomon::fuzz
