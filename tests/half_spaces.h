// SPDX-License-Identifier: GPL-3.0-or-later
// Half-spaces in integers: which of them a volume can do without, and whether some have a common point. By
// Farkas' lemma and Caratheodory's theorem, over all sets of three or four.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace gnomon::tests {

using Integer3 = std::array<long, 3>;

/// n.x + d <= 0.
struct HalfSpace {
  Integer3 n;
  long d;
};

inline long determinant(const Integer3& p, const Integer3& q, const Integer3& r) {
  return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
         p[2] * (q[0] * r[1] - q[1] * r[0]);
}

/// True when the other half-spaces, which have a common point and whose normals span space, imply the one at
/// `index`: its normal is a sum u p + v q + w r of three others' with u, v, w >= 0, and they reach no
/// farther.
inline bool is_redundant(const std::vector<HalfSpace>& all, std::size_t index) {
  const HalfSpace& h = all[index];
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        if (i == index || j == index || k == index) continue;
        const HalfSpace &p = all[i], &q = all[j], &r = all[k];
        const long whole = determinant(p.n, q.n, r.n);
        if (whole == 0) continue;
        const long sign = whole > 0 ? 1 : -1;
        const long u = sign * determinant(h.n, q.n, r.n);
        if (u < 0) continue;
        const long v = sign * determinant(p.n, h.n, r.n);
        if (v < 0) continue;
        const long w = sign * determinant(p.n, q.n, h.n);
        if (w < 0) continue;
        // h.d = max n.x negated: the others allow n.x up to -(u p.d + v q.d + w r.d) / |whole|.
        if (u * p.d + v * q.d + w * r.d >= sign * whole * h.d) return true;
      }
    }
  }
  return false;
}

/// True when half-spaces, whose normals span space, have no common point: four of them sum up to
/// 0.x + something positive <= 0.
inline bool have_no_common_point(const std::vector<HalfSpace>& all) {
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        for (std::size_t l = k + 1; l < count; ++l) {
          const HalfSpace &p = all[i], &q = all[j], &r = all[k], &t = all[l];
          std::array<long, 4> weight{determinant(q.n, r.n, t.n), -determinant(p.n, r.n, t.n),
                                     determinant(p.n, q.n, t.n), -determinant(p.n, q.n, r.n)};
          bool positive = true, negative = true;
          for (const long x : weight) {
            positive &= x >= 0;
            negative &= x <= 0;
          }
          if (positive == negative) continue;  // both: all are 0
          const long sum = weight[0] * p.d + weight[1] * q.d + weight[2] * r.d + weight[3] * t.d;
          if (positive ? sum > 0 : sum < 0) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace gnomon::tests
