// SPDX-License-Identifier: GPL-3.0-or-later
// Convexity from the definition, in rationals and quadratic time: what exact/convexity.h is held against.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "scene/object.h"
#include "scene/scene.h"

namespace gnomon::tests {

using RationalPoint = std::array<mpq_class, 3>;

/// The volume, times six, of the tetrahedron with these corners: positive when d sees a, b, c turn clockwise.
inline mpq_class six_volumes(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                             const RationalPoint& d) {
  std::array<RationalPoint, 3> rows;
  for (std::size_t k = 0; k < 3; ++k) {
    rows[0][k] = a[k] - d[k];
    rows[1][k] = b[k] - d[k];
    rows[2][k] = c[k] - d[k];
  }
  mpq_class total = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    total += rows[0][k] * (rows[1][l] * rows[2][m] - rows[1][m] * rows[2][l]);
  }
  return total;
}

/// True when two triangles of one plane have common inner points: no line through a side of either parts
/// them. `off` is any point off the plane, which turns sides into planes.
inline bool overlap_in_their_plane(const std::array<RationalPoint, 3>& s,
                                   const std::array<RationalPoint, 3>& t, const RationalPoint& off) {
  const auto parted = [&off](const std::array<RationalPoint, 3>& a, const std::array<RationalPoint, 3>& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalPoint &p = a[k], &q = a[(k + 1) % 3];
      const int inner = sgn(six_volumes(p, q, off, a[(k + 2) % 3]));
      bool all_beyond = true;
      for (const RationalPoint& corner : b) {
        if (sgn(six_volumes(p, q, off, corner)) == inner) all_beyond = false;
      }
      if (all_beyond) return true;
    }
    return false;
  };
  return !parted(s, t) && !parted(t, s);
}

/// The object is a body's boundary: no triangle is flat; every corner lies on the plane of each triangle or
/// behind it, not all on it; each directed side occurs once and so does its reverse; and triangles of one
/// plane don't overlap. (Each triangle then lies in a side of the hull, and the sides are covered once: the
/// triangles form a closed surface within the hull's, which has no closed part but the whole.)
inline bool is_convex_by_definition(const scene::Scene& scene, const scene::Object& object) {
  if (object.face_count() == 1) return true;
  if (object.ball_count > 0) return false;
  std::vector<std::array<RationalPoint, 3>> faces;
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& t : std::span(scene.triangles).subspan(object.first_triangle, object.triangle_count)) {
    std::array<RationalPoint, 3> face;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) face[k][axis] = scene.points[t[k]][axis];
      if (!sides.insert({t[k], t[(k + 1) % 3]}).second) return false;
    }
    faces.push_back(face);
  }
  for (const auto& [from, to] : sides) {
    if (from == to || !sides.contains({to, from})) return false;
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = faces[i];
    const RationalPoint* off = nullptr;
    std::vector<std::size_t> same_plane;
    for (std::size_t j = 0; j < faces.size(); ++j) {
      bool within = true;
      for (const RationalPoint& corner : faces[j]) {
        const int side = sgn(six_volumes(a, b, c, corner));
        if (side < 0) return false;
        if (side > 0) off = &corner;
        within &= side == 0;
      }
      if (within && j != i) same_plane.push_back(j);
    }
    if (off == nullptr) return false;
    for (const std::size_t j : same_plane) {
      if (overlap_in_their_plane(faces[i], faces[j], *off)) return false;
    }
  }
  return true;
}

}  // namespace gnomon::tests
