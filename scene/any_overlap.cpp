// SPDX-License-Identifier: MIT
#include "scene/any_overlap.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "scene/orientation.h"

namespace gnomon::scene {
namespace {

using Point = std::array<double, 2>;

struct Triangle {
  std::array<Point, 3> corners;
  Point lo, hi;
};

/// True when the line through a side of `a` has `b` on its right.
bool separates(const Triangle& a, const Triangle& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &from = a.corners[k], &to = a.corners[(k + 1) % 3];
    if (std::ranges::all_of(b.corners, [&](const Point& p) { return orientation(from, to, p) <= 0; }))
      return true;
  }
  return false;
}

}  // namespace

bool any_overlap(std::span<const Point> points, std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<Triangle> sorted;
  sorted.reserve(triangles.size());
  for (const auto& t : triangles) {
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    if (orientation(a, b, c) == 0) continue;
    const auto [x_lo, x_hi] = std::minmax({a[0], b[0], c[0]});
    const auto [y_lo, y_hi] = std::minmax({a[1], b[1], c[1]});
    sorted.push_back({{a, b, c}, {x_lo, y_lo}, {x_hi, y_hi}});
  }
  std::ranges::sort(sorted, {}, [](const Triangle& t) { return t.lo[0]; });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Triangle& a = sorted[i];
    for (std::size_t k = i + 1; k < sorted.size() && sorted[k].lo[0] < a.hi[0]; ++k) {
      const Triangle& b = sorted[k];
      if (b.lo[1] >= a.hi[1] || b.hi[1] <= a.lo[1]) continue;
      // Convex sets of the plane whose interiors don't meet are parted by a side of one of them.
      if (!separates(a, b) && !separates(b, a)) return true;
    }
  }
  return false;
}

}  // namespace gnomon::scene
