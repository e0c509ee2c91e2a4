// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/silhouette.h"

#include <algorithm>
#include <tuple>

namespace gnomon::reports {
namespace {

Rational cross(const ExactPoint& o, const ExactPoint& p, const ExactPoint& q) {
  return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

/// Andrew's monotone chain.
std::vector<ExactPoint> hull_of(std::vector<ExactPoint> points) {
  std::sort(points.begin(), points.end(),
            [](const ExactPoint& p, const ExactPoint& q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<ExactPoint> hull;
  const auto chain = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), *first) <= 0)
        hull.pop_back();
      hull.push_back(*first);
    }
    hull.pop_back();  // the other chain starts there
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace

Silhouette silhouette(const scene::Box<double>& a, const scene::Box<double>& b, int along) {
  Silhouette s;
  s.along = along;
  s.right = along == 0 ? 1 : 0;
  s.up = along == 2 ? 1 : 2;
  std::vector<ExactPoint> points;
  for (const auto* box : {&a, &b}) {
    for (const double x : {box->lo(s.right), box->hi(s.right)}) {
      for (const double y : {box->lo(s.up), box->hi(s.up)}) points.push_back({Rational(x), Rational(y)});
    }
  }
  s.corners = hull_of(points);
  const auto least = [&](int axis) { return Rational(std::min(a.lo(axis), b.lo(axis))); };
  const auto most = [&](int axis) { return Rational(std::max(a.hi(axis), b.hi(axis))); };
  s.sides = {{-1, 0, least(s.right)}, {1, 0, -most(s.right)}, {0, -1, least(s.up)}, {0, 1, -most(s.up)}};
  for (std::size_t i = 0; i < s.corners.size() && s.corners.size() > 1; ++i) {
    const ExactPoint &p = s.corners[i], &q = s.corners[(i + 1) % s.corners.size()];
    const Rational normal_x = q.y - p.y, normal_y = p.x - q.x;
    if (normal_x == 0 || normal_y == 0) continue;
    s.sides.push_back({normal_x, normal_y, -(normal_x * p.x + normal_y * p.y)});
  }
  return s;
}

}  // namespace gnomon::reports
