// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the proved error bounds real errors use up, in 113-bit arithmetic: independent of GMP and of
// the exact kernels, and quick enough for 10^8 trials. Rounding of its own is below 2^-50 of any bound.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "fast/box_relation.h"
#include "fast/certified_shaft.h"

namespace gnomon::tests {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#else
using Quad = long double;
static_assert(std::numeric_limits<Quad>::digits >= 113);
#endif

inline Quad magnitude(Quad x) {
  return x < 0 ? -x : x;
}
inline Quad root(Quad x) {
  if (!(x > 0)) return 0;
  Quad y = std::sqrt(static_cast<long double>(x));
  for (int step = 0; step < 2; ++step) y = (y + x / y) / 2;
  return y;
}
/// The least number of the format that is at least x.
template <class F>
F rounded_up(Quad x) {
  const F nearest = static_cast<F>(x);
  return Quad(nearest) < x ? std::nextafter(nearest, std::numeric_limits<F>::infinity()) : nearest;
}

/// What is bounded. A share is the error over the bound; above 1 the bound would be wrong.
enum class Bound : std::uint8_t {
  plane_value,       ///< |T - exact| over 4.000002 u S + 5 eta
  box_threshold,     ///< the same over the threshold as computed, in the extent box
  false_cull,        ///< T over the threshold where exactly T <= 0
  false_inside,      ///< -T over the threshold where exactly T > 0
  ball_outside,      ///< T - r over the threshold, r the least radius that reaches it in the extent
  ball_inside,       ///< -r - T over the threshold, r the least radius that sticks out of it
  squared_distance,  ///< what Arvo's sum exceeds the exact r^2 by, over what the slack allows; r as above
};
inline constexpr std::size_t kBounds = 7;
inline constexpr std::array<const char*, kBounds> kBoundNames{
    "T", "threshold", "false cull", "false ins.", "ball outs.", "ball ins.", "distance"};

/// The largest shares seen, and how many trials there were. `broken` counts wrong decisions, made as the code
/// makes them.
struct BoundShares {
  std::array<double, kBounds> largest{};
  std::array<std::uint64_t, kBounds> trials{};
  std::uint64_t broken = 0;

  void add(Bound bound, Quad share) {
    const auto i = static_cast<std::size_t>(bound);
    largest[i] = std::max(largest[i], static_cast<double>(share));
    ++trials[i];
  }
  void add(const BoundShares& other) {
    for (std::size_t i = 0; i < kBounds; ++i) {
      largest[i] = std::max(largest[i], other.largest[i]);
      trials[i] += other.trials[i];
    }
    broken += other.broken;
  }
  [[nodiscard]] double of(Bound bound) const { return largest[static_cast<std::size_t>(bound)]; }
};

/// The plane through two edges, N0 (x - a0) + N1 (y - a1).
template <class F>
struct QuadPlane {
  Quad n0, n1, a0, a1;

  QuadPlane(const fast::Shaft<F>& shaft, const fast::ShaftPlane<F>& plane)
      : n0(magnitude(Quad(shaft.b.c[plane.far1]) - Quad(shaft.a.c[plane.far1]))),
        n1(magnitude(Quad(shaft.a.c[plane.far0]) - Quad(shaft.b.c[plane.far0]))),
        a0(shaft.a.c[plane.far0]),
        a1(shaft.a.c[plane.far1]) {
    if (!fast::is_max(plane.far0)) n0 = -n0;
    if (!fast::is_max(plane.far1)) n1 = -n1;
  }
  [[nodiscard]] Quad value(F x, F y) const { return n0 * (Quad(x) - a0) + n1 * (Quad(y) - a1); }
  [[nodiscard]] Quad distance(F x, F y) const { return value(x, y) / root(n0 * n0 + n1 * n1); }
};

/// How far a point lies from the plane's half-space within the extent box, over the two axes of the plane:
/// what the radius of a ball that meets the shaft is at least. The line crosses the extent box from a's edge
/// to b's.
template <class F>
Quad distance_to_half_space_in_extent(const fast::Shaft<F>& shaft, const fast::ShaftPlane<F>& plane, F x,
                                      F y) {
  const auto outwards = [](fast::Face face, Quad coordinate) {
    return fast::is_max(face) ? coordinate : -coordinate;
  };
  const fast::Face f = plane.far0, g = plane.far1;
  const Quad p = outwards(f, Quad(x)), q = outwards(g, Quad(y));
  const Quad a_p = outwards(f, Quad(shaft.a.c[f])), a_q = outwards(g, Quad(shaft.a.c[g]));
  const Quad b_p = outwards(f, Quad(shaft.b.c[f])), b_q = outwards(g, Quad(shaft.b.c[g]));
  const Quad least_p = outwards(f, Quad(shaft.extent.c[fast::opposite(f)]));
  const Quad least_q = outwards(g, Quad(shaft.extent.c[fast::opposite(g)]));
  const Quad run = a_p - b_p, rise = b_q - a_q;  // both positive
  const auto beyond = [](Quad value, Quad lo, Quad hi) {
    return value < lo ? lo - value : value > hi ? value - hi : Quad(0);
  };
  const Quad value = rise * (p - a_p) + run * (q - a_q);
  const Quad along = rise * (q - a_q) - run * (p - a_p), length = run * run + rise * rise;
  if (value > 0 && along >= 0 && along <= length) return value / root(length);
  // Next to a side of the extent box, or behind the line.
  const Quad over_p = beyond(p, least_p, value > 0 && along > length ? b_p : a_p);
  const Quad over_q = beyond(q, least_q, value > 0 && along < 0 ? a_q : b_q);
  return root(over_p * over_p + over_q * over_q);
}

template <class F>
bool in_extent(const fast::Shaft<F>& shaft, const fast::ShaftPlane<F>& plane, F x, F y) {
  const int i = fast::axis_of(plane.far0), j = fast::axis_of(plane.far1);
  return x >= shaft.extent.lo(i) && x <= shaft.extent.hi(i) && y >= shaft.extent.lo(j) &&
         y <= shaft.extent.hi(j);
}

/// One point against one plane of a certified box shaft.
template <class F>
void add_box_shares(BoundShares& shares, const fast::Shaft<F>& shaft, const fast::ShaftPlane<F>& plane, F x,
                    F y) {
  if (std::isinf(plane.outside_threshold)) return;
  const QuadPlane<F> quad(shaft, plane);
  const F value = plane.value(x, y);
  if (!std::isfinite(value)) return;
  const Quad exact = quad.value(x, y), error = magnitude(Quad(value) - exact);
  const Quad sum = magnitude(quad.n0) * (magnitude(Quad(x)) + magnitude(quad.a0)) +
                   magnitude(quad.n1) * (magnitude(Quad(y)) + magnitude(quad.a1));
  const Quad u = fast::Rounding<F>::u, eta = Quad(fast::Rounding<F>::two_eta) / 2;
  shares.add(Bound::plane_value, error / (Quad(4.000002) * u * sum + 5 * eta));
  shares.broken += error > Quad(4.000002) * u * sum + 5 * eta;
  if (!in_extent(shaft, plane, x, y)) return;

  const Quad threshold = plane.outside_threshold;
  shares.add(Bound::box_threshold, error / threshold);
  if (exact <= 0) {
    shares.add(Bound::false_cull, Quad(value) / threshold);
    shares.broken += value > plane.outside_threshold;
  } else {
    shares.add(Bound::false_inside, -Quad(value) / threshold);
    shares.broken += value <= plane.inside_threshold;
  }
}

/// One centre against one plane of a certified ball shaft, with the hardest radii there are.
template <class F>
void add_ball_shares(BoundShares& shares, const fast::Shaft<F>& shaft, const fast::ShaftPlane<F>& plane, F x,
                     F y) {
  if (std::isinf(plane.outside_threshold)) return;
  const F value = plane.value(x, y);
  const Quad distance = QuadPlane<F>(shaft, plane).distance(x, y);
  const F reaching = rounded_up<F>(distance_to_half_space_in_extent(shaft, plane, x, y));
  if (!std::isfinite(value) || !(reaching <= shaft.slack.largest_radius)) return;
  shares.add(Bound::ball_outside, (Quad(value) - Quad(reaching)) / Quad(plane.outside_threshold));
  shares.broken += value > reaching + plane.outside_threshold;
  if (!in_extent(shaft, plane, x, y)) return;

  F sticking_out = rounded_up<F>(distance < 0 ? -distance : 0);
  if (Quad(sticking_out) == -distance) {
    sticking_out = std::nextafter(sticking_out, std::numeric_limits<F>::infinity());
  }
  shares.add(Bound::ball_inside, (-Quad(sticking_out) - Quad(value)) / -Quad(plane.inside_threshold));
  shares.broken += value <= plane.inside_threshold - sticking_out;
}

/// Arvo's test of a centre against a box, with the least radius that reaches it.
template <class F>
void add_distance_share(BoundShares& shares, const fast::BallSlack<F>& slack, const std::array<F, 3>& centre,
                        const scene::Box<F>& box) {
  const F sum = fast::squared_distance(centre, box);
  Quad exact = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Quad x = centre[axis], below = Quad(box.c[axis]) - x, above = x - Quad(box.c[axis + 3]);
    const Quad beyond = below > above ? below : above;
    if (beyond > 0) exact += beyond * beyond;
  }
  F radius = rounded_up<F>(root(exact));
  if (Quad(radius) * Quad(radius) < exact)
    radius = std::nextafter(radius, std::numeric_limits<F>::infinity());
  const F bound = radius * radius * slack.square_factor + slack.square_offset;
  if (!std::isfinite(sum) || !std::isfinite(bound)) return;
  const Quad square = Quad(radius) * Quad(radius);
  shares.add(Bound::squared_distance, (Quad(sum) - square) / (Quad(bound) - square));
  shares.broken += sum > bound;
}

}  // namespace gnomon::tests
