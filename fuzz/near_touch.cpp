// SPDX-License-Identifier: GPL-3.0-or-later
// The distribution `near-touch`: cases within a few ulps of a decision boundary, on both sides of it.
#include <optional>

#include "fuzz/distributions.h"

namespace gnomon::fuzz {

namespace {

constexpr int kMostUlps = 4;

/// The edges that a plane of the shaft joins: on face f a is extreme, on face g b is.
struct Edges {
  std::size_t f, g;
};

template <class F>
std::optional<Edges> random_plane(CaseRandom& random, const Triple<F>& c) {
  std::array<std::size_t, 6> of_a{}, of_b{};
  int count_a = 0, count_b = 0;
  for (std::size_t face = 0; face < 6; ++face) {
    const F a = face < 3 ? -c.a.c[face] : c.a.c[face], b = face < 3 ? -c.b.c[face] : c.b.c[face];
    if (a > b) of_a[static_cast<std::size_t>(count_a++)] = face;
    if (b > a) of_b[static_cast<std::size_t>(count_b++)] = face;
  }
  if (count_a == 0 || count_b == 0) return std::nullopt;
  for (int attempt = 0; attempt < 8; ++attempt) {
    const int i = random.below(count_a), j = random.below(count_b);
    const Edges edges{of_a[static_cast<std::size_t>(i)], of_b[static_cast<std::size_t>(j)]};
    if (edges.f % 3 != edges.g % 3) return edges;
  }
  return std::nullopt;
}

/// Sets t's side on `face` (far corner: the side of that name; near corner: the opposite one) to x, and the
/// other side `size` away, so that t lies outwards of a near corner and inwards of a far one.
template <class F>
void set_corner(scene::Box<F>& t, std::size_t face, F x, F size, bool near) {
  const int axis = static_cast<int>(face % 3);
  const bool grow_up = (face >= 3) == near;
  set_axis(t, axis, x, grow_up ? x + size : x - size);
}

}  // namespace

template <class F>
Triple<F> near_touch_triple(CaseRandom& random) {
  Triple<F> c = uniform_triple<F>(random);
  const bool near = random.chance(0.6);
  const int ulps = random.integer(-kMostUlps, kMostUlps);
  const F s = random.unit<F>();
  const F size = near ? F(0.3) : F(0.01);
  const bool at_plane = random.chance(0.8);
  std::optional<Edges> edges;
  if (at_plane) edges = random_plane(random, c);
  // First a section of the shaft at s, which t meets (near) or lies in (far); then one corner on the
  // boundary.
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t i = static_cast<std::size_t>(axis);
    const F lo = side_at(c, i, s), hi = side_at(c, i + 3, s);
    const F x = random.between<F>(lo, hi);
    const F room = near ? random.unit<F>() / 4 : std::min(x - lo, hi - x) * random.unit<F>();
    set_around(c.t, axis, x, std::max(room, F(0)));
  }
  if (edges) {
    const F af = c.a.c[edges->f], ag = c.a.c[edges->g], bf = c.b.c[edges->f], bg = c.b.c[edges->g];
    const F x = af + s * (bf - af);
    // The point of the line through both edges at x, in long double: well within an ulp of the true one.
    const long double slope = (static_cast<long double>(bg) - ag) / (static_cast<long double>(bf) - af);
    const F y = static_cast<F>(ag + (static_cast<long double>(x) - af) * slope);
    set_corner(c.t, edges->f, x, size * random.unit<F>(), near);
    set_corner(c.t, edges->g, step_ulps(y, ulps), size * random.unit<F>(), near);
  } else {
    const std::size_t face = static_cast<std::size_t>(random.below(6));
    const F side = face < 3 ? extent_lo(c, static_cast<int>(face)) : extent_hi(c, static_cast<int>(face) - 3);
    set_corner(c.t, face, step_ulps(side, ulps), size * random.unit<F>(), near);
  }
  return c;
}

template <class F>
scene::ShaftBallCase near_touch_ball(CaseRandom& random) {
  const Triple<F> c = uniform_triple<F>(random);
  scene::ShaftBallCase result = with_ball(random, c);
  // Any t: what counts is the ball. The centre lies in the shaft for the inside boundary, anywhere for the
  // other.
  const bool outer = random.chance(0.6);
  if (!outer) {
    Triple<F> inner = c;
    place_near_section<F>(random, inner, F(0.7), F(0));
    for (std::size_t i = 0; i < 3; ++i) result.t.centre[i] = static_cast<double>(inner.t.c[i]);
  }
  const std::array<double, 3>& p = result.t.centre;
  // Distances by sampling s (outer) or by sides and planes (inner) in double, refined where it matters: for
  // the float cases doubles are exact enough, for the double cases the boundary lies within a few ulps of the
  // result.
  long double distance;
  if (outer) {
    const auto squared_at = [&](long double s) {
      long double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const long double lo = result.a.c[i] + s * (static_cast<long double>(result.b.c[i]) - result.a.c[i]);
        const long double hi =
            result.a.c[i + 3] + s * (static_cast<long double>(result.b.c[i + 3]) - result.a.c[i + 3]);
        const long double beyond = std::max({lo - p[i], p[i] - hi, 0.0L});
        sum += beyond * beyond;
      }
      return sum;
    };
    // The function is convex: a ternary search finds its minimum, and is flat there, so few steps do.
    long double from = 0, to = 1;
    for (int step = 0; step < 80; ++step) {
      const long double third = (to - from) / 3;
      if (squared_at(from + third) <= squared_at(to - third)) {
        to -= third;
      } else {
        from += third;
      }
    }
    distance = std::sqrt(squared_at((from + to) / 2));
  } else {
    distance = std::numeric_limits<long double>::max();
    for (std::size_t i = 0; i < 3; ++i) {
      distance = std::min({distance, p[i] - std::min<long double>(result.a.c[i], result.b.c[i]),
                           std::max<long double>(result.a.c[i + 3], result.b.c[i + 3]) - p[i]});
    }
    for (std::size_t f = 0; f < 6; ++f) {
      for (std::size_t g = 0; g < 6; ++g) {
        const long double sf = f < 3 ? -1 : 1, sg = g < 3 ? -1 : 1;
        const long double af = result.a.c[f], ag = result.a.c[g], bf = result.b.c[f], bg = result.b.c[g];
        if (f % 3 == g % 3 || !(sf * af > sf * bf) || !(sg * bg > sg * ag)) continue;
        const long double n0 = sf * std::fabs(bg - ag), n1 = sg * std::fabs(af - bf);
        distance =
            std::min(distance, -(n0 * (p[f % 3] - af) + n1 * (p[g % 3] - ag)) / std::sqrt(n0 * n0 + n1 * n1));
      }
    }
  }
  const F radius = step_ulps(static_cast<F>(std::max(distance, 0.0L)), random.integer(-kMostUlps, kMostUlps));
  result.t.radius = static_cast<double>(std::max(radius, F(0)));
  return result;
}

template Triple<float> near_touch_triple(CaseRandom&);
template Triple<double> near_touch_triple(CaseRandom&);
template scene::ShaftBallCase near_touch_ball<float>(CaseRandom&);
template scene::ShaftBallCase near_touch_ball<double>(CaseRandom&);

}  // namespace gnomon::fuzz
