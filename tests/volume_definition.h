// SPDX-License-Identifier: GPL-3.0-or-later
// A second reference for shaft-slabs, shaft-oriented-box and shaft-ellipsoid, straight from the definitions
// in GMP's rationals: points of the hull are sums of its sixteen corners. No planes, no separating axes,
// nothing shared with exact/ or fast/.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "scene/category.h"
#include "scene/volume_case.h"
#include "tests/exact_simplex.h"

namespace gnomon::tests {

using Q = mpq_class;
using PointQ = std::array<Q, 3>;

inline PointQ corner_of(const scene::Box<double>& box, std::size_t corner) {
  return {Q(box.c[corner & 1 ? 3 : 0]), Q(box.c[corner & 2 ? 4 : 1]), Q(box.c[corner & 4 ? 5 : 2])};
}

inline std::vector<PointQ> corners_of_hull(const scene::Box<double>& a, const scene::Box<double>& b) {
  std::vector<PointQ> all;
  for (const scene::Box<double>* box : {&a, &b}) {
    for (std::size_t corner = 0; corner < 8; ++corner) all.push_back(corner_of(*box, corner));
  }
  return all;
}

/// Do the hulls of two sets of points have a common point?
inline bool hulls_meet(const std::vector<PointQ>& p, const std::vector<PointQ>& q) {
  const std::size_t n = p.size() + q.size();
  std::vector<ExactSimplex::Row> rows(5, ExactSimplex::Row(n + 1, 0));
  for (std::size_t j = 0; j < n; ++j) {
    const bool of_p = j < p.size();
    for (std::size_t i = 0; i < 3; ++i) rows[i][j] = of_p ? p[j][i] : Q(-q[j - p.size()][i]);
    rows[of_p ? 3 : 4][j] = 1;
  }
  rows[3][n] = rows[4][n] = 1;
  return ExactSimplex(std::move(rows)).feasible();
}

inline std::vector<PointQ> vertices_of(const scene::OrientedBox<double>& t) {
  std::vector<PointQ> all;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    PointQ p;
    for (std::size_t j = 0; j < 3; ++j) {
      p[j] = t.centre[j];
      for (std::size_t i = 0; i < 3; ++i) {
        if (corner >> i & 1) {
          p[j] += Q(t.axes[i][j]);
        } else {
          p[j] -= Q(t.axes[i][j]);
        }
      }
    }
    all.push_back(p);
  }
  return all;
}

/// The points where three slabs' planes meet and that lie in all slabs: none when the set is empty.
inline std::vector<PointQ> vertices_of(const scene::SlabSet<double>& t) {
  const auto along = [](std::size_t k, const PointQ& p) {
    const auto& n = scene::kSlabNormals[k];
    return Q(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]);
  };
  std::vector<PointQ> all;
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t j = i + 1; j < 7; ++j) {
      for (std::size_t k = j + 1; k < 7; ++k) {
        const std::array<std::size_t, 3> slab{i, j, k};
        for (int sides = 0; sides < 8; ++sides) {
          // Gauss on three equations.
          std::array<std::array<Q, 4>, 3> m;
          for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) m[r][c] = scene::kSlabNormals[slab[r]][c];
            m[r][3] = sides >> r & 1 ? t.hi[slab[r]] : t.lo[slab[r]];
          }
          bool independent = true;
          for (std::size_t c = 0; c < 3 && independent; ++c) {
            std::size_t pivot = c;
            while (pivot < 3 && m[pivot][c] == 0) ++pivot;
            independent = pivot < 3;
            if (!independent) break;
            std::swap(m[c], m[pivot]);
            for (std::size_t r = 0; r < 3; ++r) {
              if (r == c) continue;
              const Q factor = m[r][c] / m[c][c];
              for (std::size_t x = c; x < 4; ++x) m[r][x] -= factor * m[c][x];
            }
          }
          if (!independent) continue;
          const PointQ p{Q(m[0][3] / m[0][0]), Q(m[1][3] / m[1][1]), Q(m[2][3] / m[2][2])};
          bool within = true;
          for (std::size_t s = 0; s < 7; ++s) {
            const Q at = along(s, p);
            within = within && at >= t.lo[s] && at <= t.hi[s];
          }
          if (within) all.push_back(p);
        }
      }
    }
  }
  return all;
}

/// The truth for a polytope T with these vertices.
inline scene::Category truth_of(const scene::Box<double>& a, const scene::Box<double>& b,
                                const std::vector<PointQ>& vertices) {
  const std::vector<PointQ> hull = corners_of_hull(a, b);
  if (vertices.empty() || !hulls_meet(hull, vertices)) return scene::Category::outside;
  for (const PointQ& p : vertices) {
    if (!hulls_meet(hull, {p})) return scene::Category::overlap;
  }
  return scene::Category::inside;
}

/// The least |u|^2 over the hull of points u, by all its simplices of up to three corners, or of two when all
/// lie in one plane through 0; 0 is looked for first.
inline Q least_square_of_hull(const std::vector<PointQ>& u, bool in_plane_through_0 = false) {
  if (hulls_meet(u, {PointQ{}})) return 0;
  const auto dot = [](const PointQ& p, const PointQ& q) {
    return Q(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
  };
  std::optional<Q> least;
  const auto take = [&](const Q& x) {
    if (!least || x < *least) least = x;
  };
  for (std::size_t i = 0; i < u.size(); ++i) {
    take(dot(u[i], u[i]));
    for (std::size_t j = 0; j < i; ++j) {
      const PointQ e{Q(u[j][0] - u[i][0]), Q(u[j][1] - u[i][1]), Q(u[j][2] - u[i][2])};
      const Q ee = dot(e, e), ue = dot(u[i], e);
      if (ee == 0) continue;
      if (ue < 0 && -ue < ee) take(Q(dot(u[i], u[i]) - ue * ue / ee));
      for (std::size_t k = 0; k < j && !in_plane_through_0; ++k) {
        const PointQ f{Q(u[k][0] - u[i][0]), Q(u[k][1] - u[i][1]), Q(u[k][2] - u[i][2])};
        const Q ff = dot(f, f), ef = dot(e, f), uf = dot(u[i], f), determinant = ee * ff - ef * ef;
        if (determinant == 0) continue;
        const Q s = (-ue * ff + uf * ef) / determinant, r = (-uf * ee + ue * ef) / determinant;
        if (s >= 0 && r >= 0 && s + r <= 1) take(Q(dot(u[i], u[i]) + s * ue + r * uf));
      }
    }
  }
  return *least;
}

/// The sign of (least |u|^2) - 1 over the points centre + M u of the hull; nothing for singular M.
inline std::optional<int> reach_sign(const scene::ShaftEllipsoidCase& c) {
  std::array<PointQ, 3> m;
  for (std::size_t i = 0; i < 3; ++i) m[i] = {Q(c.t.axes[i][0]), Q(c.t.axes[i][1]), Q(c.t.axes[i][2])};
  const auto cofactor = [&](std::size_t i, std::size_t j) {
    const PointQ &p = m[(i + 1) % 3], &q = m[(i + 2) % 3];
    return Q(p[(j + 1) % 3] * q[(j + 2) % 3] - p[(j + 2) % 3] * q[(j + 1) % 3]);
  };
  const Q determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  if (determinant == 0) return std::nullopt;
  std::vector<PointQ> u;
  for (const PointQ& p : corners_of_hull(c.a, c.b)) {
    PointQ inverse;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) inverse[i] += cofactor(i, j) * (p[j] - c.t.centre[j]) / determinant;
    }
    u.push_back(inverse);
  }
  return cmp(least_square_of_hull(u), Q(1));
}

/// How a flat ellipsoid, whose first two axes are independent and whose third one is 0 or the first again,
/// lies to the shaft.
struct FlatAnswer {
  bool meets = false, touches = false;
};

/// Of the points where the segments between the hull's corners meet the ellipsoid's plane, which span what
/// the plane has of the hull, the shortest u are taken. The ellipsoid can be freed by a hair when the least
/// of them is 1, or when no corner lies beyond one side of the plane.
inline FlatAnswer flat_answer(const scene::ShaftEllipsoidCase& c) {
  const auto cross = [](const PointQ& p, const PointQ& q) {
    return PointQ{Q(p[1] * q[2] - p[2] * q[1]), Q(p[2] * q[0] - p[0] * q[2]), Q(p[0] * q[1] - p[1] * q[0])};
  };
  const auto dot = [](const PointQ& p, const PointQ& q) {
    return Q(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
  };
  std::array<PointQ, 2> m;
  for (std::size_t i = 0; i < 2; ++i) m[i] = {Q(c.t.axes[i][0]), Q(c.t.axes[i][1]), Q(c.t.axes[i][2])};
  const bool twice = c.t.axes[2] == c.t.axes[0];
  const PointQ n = cross(m[0], m[1]);
  std::vector<PointQ> seen = corners_of_hull(c.a, c.b);
  for (PointQ& p : seen) {
    for (std::size_t i = 0; i < 3; ++i) p[i] -= Q(c.t.centre[i]);
  }
  std::vector<PointQ> u;
  bool any_above = false, any_below = false;
  for (const PointQ& p : seen) {
    const Q above = dot(n, p);
    any_above = any_above || above > 0;
    any_below = any_below || above < 0;
    for (const PointQ& q : seen) {
      const Q below = dot(n, q);
      if (above < 0 || below > 0) continue;
      PointQ x = p;
      if (above != below) {
        for (std::size_t i = 0; i < 3; ++i) x[i] = (above * q[i] - below * p[i]) / (above - below);
      }
      const Q first = dot(cross(x, m[1]), n) / dot(n, n), second = dot(cross(m[0], x), n) / dot(n, n);
      u.push_back({twice ? Q(first / 2) : first, second, twice ? Q(first / 2) : Q(0)});
    }
  }
  std::sort(u.begin(), u.end());
  u.erase(std::unique(u.begin(), u.end()), u.end());
  if (u.empty()) return {};
  const int against_1 = cmp(least_square_of_hull(u, true), Q(1));
  return {against_1 <= 0, against_1 == 0 || (against_1 < 0 && !(any_above && any_below))};
}

}  // namespace gnomon::tests
