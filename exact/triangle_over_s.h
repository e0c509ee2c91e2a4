// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle against the shaft between two boxes, as inequalities in s. Internal to exact/: includes CGAL.
#pragma once

#include <algorithm>
#include <array>

#include "exact/range_of_s.h"
#include "exact/vector.h"
#include "scene/box.h"

namespace gnomon::exact {

/// Calls `add` with inequalities in s that hold together exactly for those s of [0, 1] for which the closed
/// triangle meets the box (1-s)a + sb; stops when `add` returns false, and returns what it returned last.
///
/// A triangle and a box are disjoint exactly when one of 13 directions separates them: the axes, the
/// triangle's normal, and the products of an axis and an edge (Akenine-Moller: "Fast 3D triangle-box overlap
/// testing", 2001). That is so for degenerate triangles and flat boxes, too: the difference of a box grown by
/// any e > 0 and a triangle is a solid whose faces have these normals, and what holds for all e > 0 holds for
/// e = 0, as the sets are compact. None of them depends on s, and along each, the ends of (1-s)a + sb are
/// linear in s.
template <class FT, class Add>
bool triangle_over_s(const std::array<std::array<double, 3>, 3>& v, const scene::Box<double>& a,
                     const scene::Box<double>& b, Add&& add) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    const FT least(std::min({v[0][i], v[1][i], v[2][i]})), greatest(std::max({v[0][i], v[1][i], v[2][i]}));
    if (!add({FT(greatest - FT(a.lo(axis))), FT(greatest - FT(b.lo(axis)))})) return false;
    if (!add({FT(FT(a.hi(axis)) - least), FT(FT(b.hi(axis)) - least)})) return false;
  }
  // Seen from v[0].
  const std::array<Vector<FT>, 3> edges{between<FT>(v[0], v[1]), between<FT>(v[0], v[2]),
                                        between<FT>(v[1], v[2])};
  const Vector<FT> normal = cross(edges[0], edges[1]);
  struct Sides {
    Vector<FT> lo, hi;
  };
  const auto seen = [&](const scene::Box<double>& box) {
    return Sides{between<FT>(v[0], {box.lo(0), box.lo(1), box.lo(2)}),
                 between<FT>(v[0], {box.hi(0), box.hi(1), box.hi(2)})};
  };
  const std::array<Sides, 2> boxes{seen(a), seen(b)};
  /// The ends of x * [lo, hi] of one axis of a box, added to [least, greatest].
  const auto extend = [](FT& least, FT& greatest, const FT& x, const FT& lo, const FT& hi) {
    const FT p = x * lo, q = x * hi;
    least = least + (CGAL::min)(p, q);
    greatest = greatest + (CGAL::max)(p, q);
  };
  std::array<FT, 2> least, greatest;
  for (std::size_t box = 0; box < 2; ++box) {
    least[box] = greatest[box] = FT(0);
    for (std::size_t i = 0; i < 3; ++i) {
      extend(least[box], greatest[box], normal[i], boxes[box].lo[i], boxes[box].hi[i]);
    }
  }
  if (!add({FT(-least[0]), FT(-least[1])}) || !add({greatest[0], greatest[1]})) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    // Along axis i times an edge, the triangle reaches from 0 to the normal's part i, or to its opposite.
    const FT reach = normal[i], zero(0);
    const std::array<FT, 2> low{(CGAL::min)(reach, zero), FT(-(CGAL::max)(reach, zero))},
        high{(CGAL::max)(reach, zero), FT(-(CGAL::min)(reach, zero))};
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const FT nj = -edges[edge][k], nk = edges[edge][j];
      for (std::size_t box = 0; box < 2; ++box) {
        least[box] = greatest[box] = FT(0);
        extend(least[box], greatest[box], nj, boxes[box].lo[j], boxes[box].hi[j]);
        extend(least[box], greatest[box], nk, boxes[box].lo[k], boxes[box].hi[k]);
      }
      const std::size_t turned = edge == 0 ? 0 : 1;
      if (!add({FT(high[turned] - least[0]), FT(high[turned] - least[1])})) return false;
      if (!add({FT(greatest[0] - low[turned]), FT(greatest[1] - low[turned])})) return false;
    }
  }
  return true;
}

}  // namespace gnomon::exact
