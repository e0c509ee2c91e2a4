// SPDX-License-Identifier: GPL-3.0-or-later
// The answers to `shadow` and `first-hit` from their definitions, in rationals: a point of a triangle on a
// line is a solution of three equations and three inequalities, found by elimination; nothing is shared with
// fast/ or exact/, no determinant and no case of touching.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "scene/ray_query.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::tests {

using Rational = mpq_class;
using RationalPoint = std::array<Rational, 3>;

inline RationalPoint rational(const std::array<double, 3>& p) {
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}
inline RationalPoint operator-(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// x[0] t + x[1] a + x[2] b + x[3] >= 0, or > 0 when strict.
struct Inequality {
  std::array<Rational, 4> x;
  bool strict = false;
};

/// Parameters t from an end to an end, closed or open; no end means infinity.
struct Parameters {
  std::optional<Rational> from, to;
  bool open_from = false, open_to = false;
};

/// Eliminates variable k (Fourier and Motzkin).
inline std::vector<Inequality> without(const std::vector<Inequality>& all, std::size_t k) {
  std::vector<Inequality> result;
  for (const Inequality& p : all) {
    if (p.x[k] == 0) result.push_back(p);
    if (p.x[k] <= 0) continue;
    for (const Inequality& n : all) {
      if (n.x[k] >= 0) continue;
      Inequality sum;
      for (std::size_t i = 0; i < 4; ++i) sum.x[i] = Rational(p.x[i] / p.x[k] - n.x[i] / n.x[k]);
      sum.strict = p.strict || n.strict;
      result.push_back(sum);
    }
  }
  return result;
}

/// All t > 0 (and < 1 for segments) with p + t d in the closed triangle; none when there are none.
inline std::optional<Parameters> on_triangle(const scene::Scene& scene, std::size_t triangle,
                                             const RationalPoint& p, const RationalPoint& d, bool segment) {
  const RationalPoint v0 = rational(scene.corner(triangle, 0));
  const RationalPoint e1 = rational(scene.corner(triangle, 1)) - v0,
                      e2 = rational(scene.corner(triangle, 2)) - v0;
  // p + t d = v0 + a e1 + b e2, as pairs of inequalities after elimination by rows.
  std::vector<std::array<Rational, 4>> rows;
  for (std::size_t k = 0; k < 3; ++k) {
    rows.push_back({d[k], Rational(-e1[k]), Rational(-e2[k]), Rational(p[k] - v0[k])});
  }
  std::vector<Inequality> all = {{{0, 1, 0, 0}, false}, {{0, 0, 1, 0}, false}, {{0, -1, -1, 1}, false}};
  all.push_back({{1, 0, 0, 0}, true});
  if (segment) all.push_back({{-1, 0, 0, 1}, true});
  // b, then a, by an equation where there is one.
  for (const std::size_t k : {2u, 1u}) {
    std::optional<std::size_t> pivot;
    for (std::size_t r = 0; r < rows.size() && !pivot; ++r) {
      if (rows[r][k] != 0) pivot = r;
    }
    if (!pivot) {
      all = without(all, k);
      continue;
    }
    const std::array<Rational, 4> by = rows[*pivot];
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(*pivot));
    const auto substitute = [&](std::array<Rational, 4>& x) {
      const Rational factor = x[k] / by[k];
      for (std::size_t i = 0; i < 4; ++i) x[i] -= factor * by[i];
    };
    for (auto& row : rows) substitute(row);
    for (Inequality& inequality : all) substitute(inequality.x);
  }
  for (const auto& row : rows) {  // equations in t alone
    all.push_back({row, false});
    all.push_back({{Rational(-row[0]), 0, 0, Rational(-row[3])}, false});
  }
  Parameters t;
  for (const Inequality& inequality : all) {
    const Rational &slope = inequality.x[0], &rest = inequality.x[3];
    if (slope == 0) {
      if (rest < 0 || (inequality.strict && rest == 0)) return std::nullopt;
      continue;
    }
    const Rational at = -rest / slope;
    if (slope > 0) {
      if (!t.from || at > *t.from) {
        t.from = at;
        t.open_from = inequality.strict;
      } else if (at == *t.from) {
        t.open_from |= inequality.strict;
      }
    } else if (!t.to || at < *t.to) {
      t.to = at;
      t.open_to = inequality.strict;
    } else if (at == *t.to) {
      t.open_to |= inequality.strict;
    }
  }
  if (t.to && (*t.from > *t.to || (*t.from == *t.to && (t.open_from || t.open_to)))) return std::nullopt;
  return t;
}

/// Is some point of the open segment in the ball? The distance from the centre is least where its derivative
/// is 0, or at an end, which itself is left out.
inline bool on_ball(const scene::Ball<double>& ball, const RationalPoint& p, const RationalPoint& d) {
  const RationalPoint m = rational(ball.centre) - p;
  const Rational r(ball.radius), dd = dot(d, d);
  const auto beyond = [&](const Rational& t) -> Rational {  // squared distance less squared radius
    const RationalPoint q{Rational(m[0] - t * d[0]), Rational(m[1] - t * d[1]), Rational(m[2] - t * d[2])};
    return dot(q, q) - r * r;
  };
  if (dd == 0) return false;
  const Rational closest = dot(m, d) / dd;
  if (closest <= 0) return beyond(0) < 0;
  if (closest >= 1) return beyond(1) < 0;
  return beyond(closest) <= 0;
}

inline scene::Shadow true_shadow(const scene::Scene& scene, const scene::ShadowQuery& query) {
  const RationalPoint p = rational(query.point), d = rational(query.light) - p;
  const bool empty = dot(d, d) == 0;
  if (query.own < scene.triangles.size()) {
    for (const scene::Object& object : scene.objects) {
      if (!object.one_sided || query.own - object.first_triangle >= object.triangle_count) continue;
      const RationalPoint v0 = rational(scene.corner(query.own, 0));
      const RationalPoint a = rational(scene.corner(query.own, 1)) - v0,
                          b = rational(scene.corner(query.own, 2)) - v0;
      Rational product = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        product += d[k] * (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
      }
      if (product < 0) return scene::Shadow::facing;
    }
  }
  for (std::size_t face = 0; face < scene.face_count(); ++face) {
    bool blocked = false;
    if (face < scene.triangles.size()) {
      blocked = face != query.own && !empty && on_triangle(scene, face, p, d, true).has_value();
    } else {
      const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
      blocked = face == query.own ? dot(p - rational(ball.centre), d) < 0 : on_ball(ball, p, d);
    }
    if (blocked) return scene::Shadow::shadowed;
  }
  return scene::Shadow::lit;
}

/// All triangles that the ray meets first, in rising order; the scene must have no balls.
inline std::vector<std::uint32_t> true_first_triangles(const scene::Scene& scene,
                                                       const scene::RayQuery& ray) {
  const RationalPoint p = rational(ray.origin), d = rational(ray.direction);
  std::vector<std::uint32_t> first;
  Rational least;
  for (std::uint32_t face = 0; face < scene.triangles.size(); ++face) {
    if (face == ray.own) continue;
    const auto t = on_triangle(scene, face, p, d, false);
    if (!t || (!first.empty() && *t->from > least)) continue;
    if (!first.empty() && *t->from < least) first.clear();
    least = *t->from;
    first.push_back(face);
  }
  return first;
}

}  // namespace gnomon::tests
