// SPDX-License-Identifier: GPL-3.0-or-later
// A second reference for `first-hit`: rational arithmetic on the definitions. Times that are no rationals are
// ordered by their common factors, and by halving intervals.
#pragma once

#include <utility>
#include <vector>

#include "exact/first_hit.h"
#include "scene/ray_query.h"
#include "tests/shadow_by_definition.h"

namespace gnomon::tests {

/// A real number: a rational (lo = hi), or the root of a ball's function between two rationals at which its
/// signs differ.
struct RealTime {
  mpq_class lo, hi;
  std::optional<BallFunction> f;

  /// Halves the interval.
  void refine() {
    if (!f) return;
    const mpq_class middle = (lo + hi) / 2;
    const int sign = sgn(f->at(middle));
    if (sign == 0) {
      lo = hi = middle;
      f.reset();
    } else if (sign == sgn(f->at(lo))) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  [[nodiscard]] bool is(const mpq_class& t) const {
    return f ? lo <= t && t <= hi && f->at(t) == 0 : t == lo;
  }
};

/// True when both are the same number. The functions of two balls on one line differ by a linear function, so
/// that a common root is rational unless the functions are the same.
inline bool same_time(const RealTime& a, const RealTime& b) {
  if (!a.f) return b.is(a.lo);
  if (!b.f) return a.is(b.lo);
  const mpq_class at0 = a.f->at(0) - b.f->at(0), slope = a.f->at(1) - b.f->at(1) - at0;
  if (slope != 0) return a.is(-at0 / slope) && b.is(-at0 / slope);
  if (at0 != 0) return false;
  // The same function: the same root when both are on one side of its least place.
  const mpq_class middle = a.f->least_at();
  return (a.hi <= middle) == (b.hi <= middle);
}

inline int order_of_times(RealTime a, RealTime b) {
  if (same_time(a, b)) return 0;
  while (!(a.hi < b.lo) && !(b.hi < a.lo)) {
    a.refine();
    b.refine();
  }
  return a.hi < b.lo ? -1 : 1;
}

/// Where a ball's function is 0 on one side of its least place, which it is not positive at; `later`: the
/// root after it.
inline RealTime root_of(const BallFunction& f, bool later) {
  const mpq_class middle = f.least_at();
  if (f.at(middle) >= 0) return {middle, middle, std::nullopt};
  mpq_class step = 1;
  while (f.at(later ? mpq_class(middle + step) : mpq_class(middle - step)) <= 0) step *= 2;
  if (later) return {middle, middle + step, f};
  return {middle - step, middle, f};
}

/// By the definitions of exact/first_hit.h.
inline exact::FirstHit first_hit_by_definition(const scene::Scene& scene, const scene::RayQuery& ray,
                                               std::size_t* root_comparisons = nullptr) {
  const RationalPath path(rational(ray.origin), rational(ray.direction), false);
  const Definition definition(scene, path);
  std::vector<std::pair<std::uint32_t, Meeting>> nearest;
  RealTime first;
  bool end = false;
  for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
    RealTime time;
    Meeting meeting = Meeting::none;
    if (face < scene.triangles.size()) {
      if (face == ray.own) continue;
      meeting = definition.meeting(face);
      if (meeting > Meeting::end) {
        const Times times = *line_in_triangle(path.origin, path.direction, definition.corners(face)).times;
        time.lo = time.hi = std::max(mpq_class(0), *times.lo);
      }
    } else {
      const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
      const BallFunction f(path.origin, path.direction, ball);
      if (face == ray.own) {
        const int product = sgn(scalar_product(f.to_start, path.direction));
        meeting = product < 0 ? Meeting::firm : product == 0 ? Meeting::end : Meeting::none;
        if (product < 0) time = root_of(f, true);
      } else {
        meeting = definition.meeting(face);
        if (meeting > Meeting::end && f.at(0) > 0) time = root_of(f, false);
      }
    }
    end |= meeting == Meeting::end;
    if (meeting <= Meeting::end) continue;
    if (root_comparisons != nullptr) *root_comparisons += !nearest.empty() && first.f && time.f;
    const int order = nearest.empty() ? -1 : order_of_times(time, first);
    if (order < 0) {
      nearest.clear();
      first = time;
    }
    if (order <= 0) nearest.emplace_back(face, meeting);
  }
  exact::FirstHit hit;
  bool firm = nearest.empty();
  for (const auto& [face, meeting] : nearest) {
    hit.faces.push_back(face);
    firm |= meeting == Meeting::firm || (meeting == Meeting::border && definition.is_sealed(face, ray.own));
  }
  hit.touching = end || !firm;
  return hit;
}

}  // namespace gnomon::tests
