// SPDX-License-Identifier: GPL-3.0-or-later
// A second reference for `shadow`: rational arithmetic on the definitions. Whether a border is sealed is
// found by moving the path a very little and asking again, not by sorting sectors.
#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "exact/shadow.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"
#include "tests/exact_lines.h"

namespace gnomon::tests {

/// What a path has in common with a face.
enum class Meeting : std::uint8_t { none, end, weak, border, firm };

/// A path in rationals: t from 0 to 1, or from 0 on; the ends don't belong to it.
struct RationalPath {
  Rational3 origin, direction;
  bool bounded = true;

  explicit RationalPath(const scene::ShadowQuery& q)
      : origin(rational(q.point)), direction(rational(q.light) - rational(q.point)) {}
  RationalPath(const Rational3& from, const Rational3& along, bool ends)
      : origin(from), direction(along), bounded(ends) {}

  [[nodiscard]] bool is_point() const { return direction == Rational3{0, 0, 0}; }
  /// True when the open path holds one of these times.
  [[nodiscard]] bool holds_one_of(const Times& times) const {
    return !is_point() && (!times.hi || *times.hi > 0) && !(bounded && times.lo && *times.lo >= 1);
  }
  [[nodiscard]] bool ends_at_one_of(const Times& times) const {
    const auto holds = [&](int t) { return !(times.lo && *times.lo > t) && !(times.hi && *times.hi < t); };
    return holds(0) || (bounded && holds(1));
  }
};

class Definition {
 public:
  Definition(const scene::Scene& scene, RationalPath path) : scene_(scene), path_(std::move(path)) {}

  [[nodiscard]] std::array<Rational3, 3> corners(std::size_t triangle) const {
    return {rational(scene_.corner(triangle, 0)), rational(scene_.corner(triangle, 1)),
            rational(scene_.corner(triangle, 2))};
  }

  [[nodiscard]] Meeting meeting(std::uint32_t face) const {
    if (face >= scene_.triangles.size()) return meeting(scene_.balls[face - scene_.triangles.size()]);
    const LineInTriangle line = line_in_triangle(path_.origin, path_.direction, corners(face));
    if (!line.times) return Meeting::none;
    if (!path_.holds_one_of(*line.times)) {
      return path_.ends_at_one_of(*line.times) ? Meeting::end : Meeting::none;
    }
    if (!line.weights) return Meeting::weak;
    const auto& w = *line.weights;
    return w[0] > 0 && w[1] > 0 && w[2] > 0 ? Meeting::firm : Meeting::border;
  }

  [[nodiscard]] Meeting meeting(const scene::Ball<double>& ball) const {
    const BallFunction f(path_.origin, path_.direction, ball);
    if (path_.is_point()) return f.at(0) <= 0 ? Meeting::end : Meeting::none;
    mpq_class t = std::max(mpq_class(0), f.least_at());
    if (path_.bounded) t = std::min(mpq_class(1), t);
    const int least = sgn(f.at(t));
    if (least != 0) return least < 0 ? Meeting::firm : Meeting::none;
    return t > 0 && !(path_.bounded && t == 1) ? Meeting::weak : Meeting::end;
  }

  /// For a triangle that the path meets on its border: true when no small move frees the path from the
  /// triangles (but for `own`) that share the edge or the vertex. Those have rays from the contact along
  /// their edges. Seen along the path, a gap between neighbouring rays is met by the sum of the two when it
  /// is less than half a turn, by its opposite when it is more, and by what is square to one of them else.
  [[nodiscard]] bool is_sealed(std::uint32_t triangle, std::uint32_t own) const {
    const auto v = corners(triangle);
    const LineInTriangle line = line_in_triangle(path_.origin, path_.direction, v);
    std::vector<Rational3> shared;
    for (std::size_t k = 0; k < 3; ++k) {
      if ((*line.weights)[k] > 0) shared.push_back(v[k]);
    }
    const Rational3 contact = path_.origin + *line.times->lo * path_.direction;
    std::vector<std::uint32_t> sharing;
    std::vector<Rational3> rays;
    for (std::uint32_t other = 0; other < scene_.triangles.size(); ++other) {
      const auto u = corners(other);
      const bool all = std::all_of(shared.begin(), shared.end(), [&](const Rational3& p) {
        return std::find(u.begin(), u.end(), p) != u.end();
      });
      if (!all || other == own) continue;
      sharing.push_back(other);
      for (const Rational3& p : u) {
        const Rational3 ray = p - contact;
        if (std::find(rays.begin(), rays.end(), ray) == rays.end()) rays.push_back(ray);
      }
    }
    for (const Rational3& a : rays) {
      const Rational3 beside = vector_product(path_.direction, a);
      if (frees(beside, sharing) || frees(Rational3{} - beside, sharing)) return false;
      for (const Rational3& b : rays) {
        if (frees(a + b, sharing) || frees(Rational3{} - (a + b), sharing)) return false;
      }
    }
    return true;
  }

 private:
  /// True when the path, moved by next to nothing in this direction, meets none of the triangles. A move
  /// along the path itself says nothing.
  [[nodiscard]] bool frees(const Rational3& move, const std::vector<std::uint32_t>& triangles) const {
    if (vector_product(move, path_.direction) == Rational3{0, 0, 0}) return false;
    // A move far smaller than the path, whatever the scale of both.
    mpq_class little = largest(path_.direction) / largest(move);
    mpq_div_2exp(little.get_mpq_t(), little.get_mpq_t(), 300);
    const Definition moved(scene_, {path_.origin + little * move, path_.direction, path_.bounded});
    return std::all_of(triangles.begin(), triangles.end(),
                       [&](std::uint32_t triangle) { return moved.meeting(triangle) <= Meeting::end; });
  }

  [[nodiscard]] static mpq_class largest(const Rational3& v) {
    return std::max({mpq_class(abs(v[0])), mpq_class(abs(v[1])), mpq_class(abs(v[2]))});
  }

  const scene::Scene& scene_;
  RationalPath path_;
};

/// Kinds of contact that a query has had, for the tests' class mix.
struct ContactCounts {
  std::size_t ends = 0, weak = 0, sealed = 0, unsealed = 0, firm = 0;
};

/// By the definitions of exact/shadow.h.
inline exact::ShadowTruth shadow_by_definition(const scene::Scene& scene, const scene::ShadowQuery& q,
                                               ContactCounts* counts = nullptr) {
  const RationalPath path(q);
  bool zero_facing = false;
  if (q.own < scene.triangles.size()) {
    const scene::Object* owner = nullptr;
    for (const scene::Object& object : scene.objects) {
      if (q.own >= object.first_triangle && q.own - object.first_triangle < object.triangle_count)
        owner = &object;
    }
    const Rational3 a = rational(scene.corner(q.own, 0));
    const Rational3 n =
        vector_product(rational(scene.corner(q.own, 1)) - a, rational(scene.corner(q.own, 2)) - a);
    const int facing = sgn(scalar_product(n, path.direction));
    if (owner->one_sided && facing < 0) return {scene::Shadow::facing, false};
    zero_facing = owner->one_sided && facing == 0 && n != Rational3{0, 0, 0};
  }
  const Definition definition(scene, path);
  bool met = false, firm = false, end = false;
  for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
    Meeting meeting = Meeting::none;
    if (face != q.own) {
      meeting = definition.meeting(face);
    } else if (face >= scene.triangles.size()) {
      const Rational3 centre = rational(scene.balls[face - scene.triangles.size()].centre);
      const int product = sgn(scalar_product(path.origin - centre, path.direction));
      meeting = product < 0 ? Meeting::firm : product == 0 ? Meeting::end : Meeting::none;
    }
    const bool sealed = meeting == Meeting::border && definition.is_sealed(face, q.own);
    met |= meeting > Meeting::end;
    firm |= meeting == Meeting::firm || sealed;
    end |= meeting == Meeting::end;
    if (counts == nullptr) continue;
    counts->ends += meeting == Meeting::end;
    counts->weak += meeting == Meeting::weak;
    counts->sealed += sealed;
    counts->unsealed += meeting == Meeting::border && !sealed;
    counts->firm += meeting == Meeting::firm;
  }
  if (firm) return {scene::Shadow::shadowed, zero_facing};
  if (met) return {scene::Shadow::shadowed, true};
  return {scene::Shadow::lit, zero_facing || end};
}

}  // namespace gnomon::tests
