// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/volume_touch.h"

#include "exact/shaft_slabs.h"
#include "fast/shaft.h"

namespace gnomon::fuzz {

namespace {

// All in long double: well within an ulp of what floats want, and within a few of what doubles do.
using Real = long double;
using Direction = std::array<Real, 3>;

struct Ends {
  Real least, most;
};

Direction cross(const Direction& p, const Direction& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

template <class Vector>
Real dot(const Direction& n, const Vector& p) {
  return n[0] * Real(p[0]) + n[1] * Real(p[1]) + n[2] * Real(p[2]);
}

template <class F>
Ends range_of(const scene::OrientedBox<F>& t, const Direction& n) {
  const Real middle = dot(n, t.centre);
  Real reach = 0;
  for (const auto& u : t.axes) reach += std::fabs(dot(n, u));
  return {middle - reach, middle + reach};
}

template <class F>
Ends range_of(const scene::Ellipsoid<F>& t, const Direction& n) {
  const Real middle = dot(n, t.centre);
  Real square = 0;
  for (const auto& u : t.axes) square += dot(n, u) * dot(n, u);
  return {middle - std::sqrt(square), middle + std::sqrt(square)};
}

/// By trying all vertices, each where three of the slabs' planes meet; nothing is lost by keeping a few
/// points that lie in the set up to rounding only.
template <class F>
Ends range_of(const scene::SlabSet<F>& t, const Direction& n) {
  Real scale = 0;
  std::array<Direction, 7> normals{};
  for (std::size_t k = 0; k < 7; ++k) {
    for (std::size_t i = 0; i < 3; ++i) normals[k][i] = Real(scene::kSlabNormals[k][i]);
    scale = std::max({scale, std::fabs(Real(t.lo[k])), std::fabs(Real(t.hi[k]))});
  }
  Ends ends{HUGE_VALL, -HUGE_VALL};
  for (std::size_t p = 0; p < 7; ++p) {
    for (std::size_t q = 0; q < p; ++q) {
      for (std::size_t r = 0; r < q; ++r) {
        const Direction qr = cross(normals[q], normals[r]), rp = cross(normals[r], normals[p]),
                        pq = cross(normals[p], normals[q]);
        const Real volume = dot(normals[p], qr);
        if (volume == 0) continue;
        for (int sides = 0; sides < 8; ++sides) {
          const Real at_p = Real(sides & 1 ? t.hi[p] : t.lo[p]), at_q = Real(sides & 2 ? t.hi[q] : t.lo[q]),
                     at_r = Real(sides & 4 ? t.hi[r] : t.lo[r]);
          Direction x{};
          for (std::size_t i = 0; i < 3; ++i) x[i] = (at_p * qr[i] + at_q * rp[i] + at_r * pq[i]) / volume;
          bool within = true;
          for (std::size_t k = 0; k < 7; ++k) {
            const Real at = dot(normals[k], x), slack = scale * 1e-17L;
            within = within && at >= Real(t.lo[k]) - slack && at <= Real(t.hi[k]) + slack;
          }
          if (!within) continue;
          ends.least = std::min(ends.least, dot(n, x));
          ends.most = std::max(ends.most, dot(n, x));
        }
      }
    }
  }
  return ends;
}

template <class Case>
Ends range_of_shaft(const Case& c, const Direction& n) {
  Ends ends{HUGE_VALL, -HUGE_VALL};
  for (const auto* box : {&c.a, &c.b}) {
    Real least = 0, most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real x = n[i] * Real(box->c[i]), y = n[i] * Real(box->c[i + 3]);
      least += std::min(x, y);
      most += std::max(x, y);
    }
    ends = {std::min(ends.least, least), std::max(ends.most, most)};
  }
  return ends;
}

/// The outward normal of a random side or plane of the shaft.
template <class Case>
Direction random_plane(CaseRandom& random, const Case& c) {
  const auto shaft = fast::form_shaft(scene::converted<double>(c.a), scene::converted<double>(c.b),
                                      fast::Normals::as_formed);
  Direction n{};
  const bool plane = random.chance(0.8);
  if (!plane || shaft.plane_count == 0) {
    const int face = random.below(6);
    n[static_cast<std::size_t>(face % 3)] = face < 3 ? -1 : 1;
    return n;
  }
  const auto& chosen = shaft.plane_set[static_cast<std::size_t>(random.below(shaft.plane_count))];
  n[chosen.far0 % 3] = chosen.n0;
  n[chosen.far1 % 3] = chosen.n1;
  return n;
}

/// A random edge of the shaft as a direction: along an axis or between both boxes.
template <class Case>
Direction random_edge(CaseRandom& random, const Case& c) {
  Direction edge{};
  const int kind = random.below(6), corner = random.below(8);
  if (kind < 3) {
    edge[static_cast<std::size_t>(kind)] = 1;
    return edge;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t at = corner >> i & 1 ? i + 3 : i;
    edge[i] = Real(c.b.c[at]) - Real(c.a.c[at]);
  }
  return edge;
}

template <class Volume, class F>
void move_centre(CaseRandom& random, Volume& t, const Direction& by) {
  for (std::size_t i = 0; i < 3; ++i) t.centre[i] = static_cast<F>(Real(t.centre[i]) + by[i]);
  const std::size_t which = static_cast<std::size_t>(random.below(3));
  t.centre[which] = step_ulps(t.centre[which], random.integer(-4, 4));
}

template <class F>
void move(CaseRandom& random, scene::OrientedBox<F>& t, const Direction& by) {
  move_centre<scene::OrientedBox<F>, F>(random, t, by);
}
template <class F>
void move(CaseRandom& random, scene::Ellipsoid<F>& t, const Direction& by) {
  move_centre<scene::Ellipsoid<F>, F>(random, t, by);
}
template <class F>
void move(CaseRandom& random, scene::SlabSet<F>& t, const Direction& by) {
  scene::SlabSet<F> moved;
  for (std::size_t k = 0; k < 7; ++k) {
    Real along = 0;
    for (std::size_t i = 0; i < 3; ++i) along += by[i] * Real(scene::kSlabNormals[k][i]);
    moved.lo[k] = static_cast<F>(Real(t.lo[k]) + along);
    moved.hi[k] = static_cast<F>(Real(t.hi[k]) + along);
  }
  const std::size_t which = static_cast<std::size_t>(random.below(7));
  const int ulps = random.integer(-4, 4);
  F& end = random.chance(0.5) ? moved.lo[which] : moved.hi[which];
  end = step_ulps(end, ulps);
  // Rounded bounds may contradict each other: the set stays where it was.
  const scene::SlabSet<double> exactly = scene::converted<double>(moved);
  if (is_valid(exactly) && !exact::is_empty(exactly)) t = moved;
}

/// Half as large three times over, so that what touches from within has room.
template <class Volume>
void make_small(Volume& t) {
  for (auto& axis : t.axes) {
    for (auto& x : axis) x /= 8;
  }
}

/// Moves t along n, from outside until least over t = most over S, or from within until most over t = most
/// over S.
template <class Case>
void move_along(CaseRandom& random, Case& c, const Direction& n, bool outer) {
  const Real square = dot(n, n);
  if (!(square > 0)) return;
  const Ends t = range_of(c.t, n), shaft = range_of_shaft(c, n);
  const Real by = (shaft.most - (outer ? t.least : t.most)) / square;
  if (!std::isfinite(by)) return;
  move(random, c.t, {by * n[0], by * n[1], by * n[2]});
}

}  // namespace

template <class F>
void move_to_touch(CaseRandom& random, scene::ShaftOrientedBoxCaseOf<F>& c) {
  const bool outer = random.chance(0.6), across_edges = random.chance(0.4);
  if (!outer) make_small(c.t);
  if (!outer || !across_edges) return move_along(random, c, random_plane(random, c), outer);
  const Direction edge = random_edge(random, c);
  const auto& axis = c.t.axes[static_cast<std::size_t>(random.below(3))];
  Direction n = cross({Real(axis[0]), Real(axis[1]), Real(axis[2])}, edge);
  if (dot(n, c.t.centre) * 2 < range_of_shaft(c, n).least + range_of_shaft(c, n).most)
    n = {-n[0], -n[1], -n[2]};
  move_along(random, c, n, true);
}

template <class F>
void move_to_touch(CaseRandom& random, scene::ShaftEllipsoidCaseOf<F>& c) {
  const bool outer = random.chance(0.6);
  if (!outer) make_small(c.t);
  move_along(random, c, random_plane(random, c), outer);
}

template <class F>
void move_to_touch(CaseRandom& random, scene::ShaftSlabsCaseOf<F>& c) {
  const bool outer = random.chance(0.6), across_edges = random.chance(0.4);
  if (!outer || !across_edges) return move_along(random, c, random_plane(random, c), outer);
  const Direction edge = random_edge(random, c);
  Direction across{};  // an edge of slab sets
  const int which = random.below(3);
  const Real sign = random.sign<float>();
  across[static_cast<std::size_t>((which + 1) % 3)] = 1;
  across[static_cast<std::size_t>((which + 2) % 3)] = sign;
  Direction n = cross(across, edge);
  const Ends shaft = range_of_shaft(c, n), t = range_of(c.t, n);
  if (t.least + t.most < shaft.least + shaft.most) n = {-n[0], -n[1], -n[2]};
  move_along(random, c, n, true);
}

template void move_to_touch(CaseRandom&, scene::ShaftOrientedBoxCaseOf<float>&);
template void move_to_touch(CaseRandom&, scene::ShaftOrientedBoxCaseOf<double>&);
template void move_to_touch(CaseRandom&, scene::ShaftEllipsoidCaseOf<float>&);
template void move_to_touch(CaseRandom&, scene::ShaftEllipsoidCaseOf<double>&);
template void move_to_touch(CaseRandom&, scene::ShaftSlabsCaseOf<float>&);
template void move_to_touch(CaseRandom&, scene::ShaftSlabsCaseOf<double>&);

}  // namespace gnomon::fuzz
