// SPDX-License-Identifier: GPL-3.0-or-later
// The shaft between two boxes in the arithmetic of a CGAL kernel: the twin of fast/shaft.h. Internal to
// exact/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "exact/number.h"
#include "scene/box.h"

namespace gnomon::exact {

/// Offsets of coordinates in Box::c, as in the paper: 0..2 minima, 3..5 maxima.
using Face = std::uint8_t;

/// One plane n0 x + n1 y + d <= 0 through the edges of both boxes on the faces far0 and far1.
template <class K>
struct ShaftPlane {
  using FT = typename K::FT;
  FT n0, n1, d;
  Face far0, far1;

  [[nodiscard]] FT value(double x, double y) const { return n0 * FT(x) + n1 * FT(y) + d; }
  [[nodiscard]] FT far_value(const scene::Box<double>& t) const { return value(t.c[far0], t.c[far1]); }
  [[nodiscard]] FT near_value(const scene::Box<double>& t) const {
    return value(t.c[(far0 + 3) % 6], t.c[(far1 + 3) % 6]);
  }
  [[nodiscard]] FT value_at(const std::array<double, 3>& p) const { return value(p[far0 % 3], p[far1 % 3]); }
  /// |N0| + |N1|: what the value grows by when the box grows by 1 on all sides.
  [[nodiscard]] FT growth() const { return (far0 >= 3 ? n0 : FT(-n0)) + (far1 >= 3 ? n1 : FT(-n1)); }
  [[nodiscard]] FT squared_length() const { return CGAL::square(n0) + CGAL::square(n1); }
};

/// Extent box and plane set, formed as the paper forms them. Which box is extreme on a face is decided on the
/// doubles themselves, so the intervals of the filter never blur the combinatorics.
template <class K>
class Shaft {
 public:
  using FT = typename K::FT;

  Shaft(const scene::Box<double>& a, const scene::Box<double>& b) {
    std::array<Face, 6> of_a{}, of_b{};
    std::size_t count_a = 0, count_b = 0;
    for (Face face = 0; face < 6; ++face) {
      const bool max = face >= 3;
      const double x = a.c[face], y = b.c[face];
      extent_.c[face] = max == (x > y) ? x : y;
      if (x == y) continue;
      if (max == (x > y)) {
        of_a[count_a++] = face;
      } else {
        of_b[count_b++] = face;
      }
    }
    for (std::size_t i = 0; i < count_a; ++i) {
      for (std::size_t j = 0; j < count_b; ++j) {
        if (of_a[i] % 3 != of_b[j] % 3) planes_[count_++] = through_edges(a, b, of_a[i], of_b[j]);
      }
    }
  }

  [[nodiscard]] const scene::Box<double>& extent() const { return extent_; }
  [[nodiscard]] std::span<const ShaftPlane<K>> planes() const { return {planes_.data(), count_}; }

 private:
  static ShaftPlane<K> through_edges(const scene::Box<double>& a, const scene::Box<double>& b, Face f,
                                     Face g) {
    // a is extreme on f, b on g: |b_g - a_g| and |a_f - b_f| have known signs.
    ShaftPlane<K> plane;
    plane.far0 = f;
    plane.far1 = g;
    const bool same = (f >= 3) == (g >= 3);
    const FT run0 = FT(b.c[g]) - FT(a.c[g]), run1 = FT(a.c[f]) - FT(b.c[f]);
    plane.n0 = same ? run0 : FT(-run0);
    plane.n1 = same ? run1 : FT(-run1);
    plane.d = -(plane.n0 * FT(a.c[f]) + plane.n1 * FT(a.c[g]));
    return plane;
  }

  scene::Box<double> extent_;
  std::array<ShaftPlane<K>, 8> planes_;
  std::size_t count_ = 0;
};

}  // namespace gnomon::exact
