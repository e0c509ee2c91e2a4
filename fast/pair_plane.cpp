// SPDX-License-Identifier: MIT
//
// THE SIDE OF A POINT, from double precision, v = 2^-53: N . (p - a) with N = e1 x e2 is a sum of six
// products of three differences of floats. Each difference is off by at most v of itself, a product of three
// by two more roundings, the difference in a component of N by another, and the sum by two: each of the six
// products is off by g_v(3 + 2 + 1 + 2) of itself, so that
//     |computed - exact| <= g_v(8) S,   S the sum of the products' magnitudes,
// and S computed in the same way is at least (1 - g_v(8)) S. 10 v S is room for all. Products of three floats
// are at least 2^-447 and at most 2^123: there is neither underflow nor overflow. S = 0 makes it exact.
#include "fast/pair_plane.h"

#include <algorithm>
#include <cmath>

#include "fast/hierarchy_bounds.h"

namespace gnomon::fast {

namespace {

using Vector = std::array<double, 3>;

/// n = e1 x e2, and the same with the magnitudes added.
struct Normal {
  Vector corner, value, sum;

  Normal(const Vector& a, const Vector& b, const Vector& c) : corner(a) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const double x = (b[i] - a[i]) * (c[j] - a[j]), y = (b[j] - a[j]) * (c[i] - a[i]);
      value[k] = x - y;
      sum[k] = std::abs(x) + std::abs(y);
    }
  }
  /// N of fast/hierarchy_triangles_inl.h for this normal rounded to floats, as fast/hierarchy_leaves.cpp has
  /// it: what the normal is off by, and five roundings of products with it.
  [[nodiscard]] float error_of(const std::array<float, 3>& rounded) const {
    constexpr double u = Rounding<float>::u, v = Rounding<double>::u;
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double n = std::abs(static_cast<double>(rounded[k]));
      off += 4.2 * v * sum[k] + u * n * (1 + 2 * u) + static_cast<double>(Rounding<float>::two_eta) +
             kNormalOperations * u * n;
    }
    // Rounding it to a float takes at most u, or half of a denormal.
    return static_cast<float>(off * (1 + 18 * u) + static_cast<double>(Rounding<float>::two_eta));
  }
  /// True when there is a normal for certain.
  [[nodiscard]] bool exists() const {
    constexpr double v = Rounding<double>::u;
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k) any |= std::abs(value[k]) > 10 * v * sum[k];
    return any;
  }
};

/// Corners lie on the plane, whatever floats say.
bool is_corner(const scene::Scene& scene, std::uint32_t face, const std::array<float, 3>& p) {
  bool any = false;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Vector& c = scene.corner(face, corner);
    any |= c[0] == static_cast<double>(p[0]) && c[1] == static_cast<double>(p[1]) &&
           c[2] == static_cast<double>(p[2]);
  }
  return any;
}

}  // namespace

void set_own_plane(const scene::Scene& scene, PairPatch& patch) {
  constexpr double v = Rounding<double>::u;
  OwnPlane& plane = patch.plane;
  for (std::uint32_t i = 0; i < patch.own.count && patch.own.first + i < scene.triangles.size(); ++i) {
    const std::uint32_t face = patch.own.first + i;
    const Normal normal(scene.corner(face, 0), scene.corner(face, 1), scene.corner(face, 2));
    if (!normal.exists()) continue;
    plane.corners = scene.triangles[face];
    plane.error = 0;
    bool straight = false;
    for (std::size_t k = 0; k < 3; ++k) {
      plane.corner[k] = static_cast<float>(normal.corner[k]);
      plane.normal[k] = static_cast<float>(normal.value[k]);
      straight |= normal.sum[(k + 1) % 3] == 0 && normal.sum[(k + 2) % 3] == 0;
    }
    if (straight) {
      for (float& n : plane.normal) n = n > 0 ? 1.0f : n < 0 ? -1.0f : 0.0f;
    } else {
      plane.error = normal.error_of(plane.normal);
    }
    plane.none_behind = true;
    for (std::size_t p = 0; p < patch.size() && plane.none_behind; ++p) {
      double value = 0, sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = static_cast<double>(patch.coordinates(k)[p]) - normal.corner[k];
        value += normal.value[k] * x;
        sum += normal.sum[k] * std::abs(x);
      }
      plane.none_behind = sum == 0 || value > 10 * v * sum || is_corner(scene, face, patch.point(p));
    }
    return;
  }
}

}  // namespace gnomon::fast
