// SPDX-License-Identifier: MIT
#include "scene/triangulate.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "scene/any_overlap.h"
#include "scene/exact_sum.h"
#include "scene/orientation.h"

namespace gnomon::scene {
namespace {

using Point = std::array<double, 2>;
using Index = std::uint32_t;

/// Cuts ears off a polygon that turns counterclockwise until a triangle is left.
class EarClipper {
 public:
  /// `corners` must outlive the clipper.
  explicit EarClipper(std::span<const Point> corners) : corners_(corners) {
    const auto n = static_cast<Index>(corners_.size());
    nodes_.resize(n);
    for (Index i = 0; i < n; ++i) nodes_[i] = {i == 0 ? n - 1 : i - 1, i + 1 == n ? 0 : i + 1};
    for (Index i = 0; i < n; ++i) look_at(i);
  }

  /// True when the polygon turns left at every corner and goes around once: it then changes its direction
  /// (right or left, straight up counting as right) twice.
  [[nodiscard]] bool is_convex() const {
    int changes = 0;
    for (Index i = 0; i < nodes_.size(); ++i) {
      const Node& node = nodes_[i];
      if (node.turn <= 0) return false;
      changes += (corners_[node.before] < corners_[i]) != (corners_[i] < corners_[node.after]) ? 1 : 0;
    }
    return changes == 2;
  }

  /// Call it once.
  Triangulation clip() {
    std::size_t left = corners_.size(), refused = 0;
    result_.triangles.reserve(left - 2);
    Index i = 0;
    while (left > 3) {
      if (!spikes_.empty()) {
        const Index spike = spikes_.back();
        spikes_.pop_back();
        if (nodes_[spike].gone || !is_spike(spike)) continue;
        i = cut(spike);
      } else if (is_ear(i)) {
        i = cut(i);
      } else if (++refused < left) {
        i = nodes_[i].after;
        continue;
      } else {
        // No ear is left: the polygon crosses itself, and what is left becomes a fan.
        result_.crossing = true;
        i = cut(i);
        for (--left; left > 3; --left) i = cut(i);
        break;
      }
      refused = 0;
      --left;
    }
    const Node last = nodes_[i];
    if (orientation(corners_[last.before], corners_[i], corners_[last.after]) < 0) result_.crossing = true;
    result_.triangles.push_back({last.before, i, last.after});
    return std::move(result_);
  }

 private:
  struct Node {
    Index before, after;
    int turn = 1;         ///< the orientation of before, this, after
    bool listed = false;  ///< in blockers_
    bool gone = false;    ///< cut off
  };

  /// Finds out how the polygon turns at corner i. Only corners where it turns not left can lie in an ear: of
  /// several in one, the farthest from the ear's base is such a corner.
  void look_at(Index i) {
    Node& node = nodes_[i];
    node.turn = orientation(corners_[node.before], corners_[i], corners_[node.after]);
    if (node.turn <= 0 && !node.listed) {
      node.listed = true;
      blockers_.push_back(i);
    }
    if (is_spike(i)) spikes_.push_back(i);
  }

  /// True when the polygon stands still at corner i or goes straight back. Such corners bound no area, so
  /// they are cut off at once: between two of them, an ear may lie outside the polygon.
  [[nodiscard]] bool is_spike(Index i) const {
    const Node& node = nodes_[i];
    const Point &a = corners_[node.before], &b = corners_[i], &c = corners_[node.after];
    return node.turn == 0 && (a == b || b == c || (a < b) == (c < b));
  }

  /// Cuts corner i off and returns the one after it.
  Index cut(Index i) {
    const Node node = nodes_[i];
    result_.triangles.push_back({node.before, i, node.after});
    nodes_[node.before].after = node.after;
    nodes_[node.after].before = node.before;
    nodes_[i].turn = 1;
    nodes_[i].gone = true;
    look_at(node.before);
    look_at(node.after);
    std::erase_if(blockers_, [this](Index p) {
      if (nodes_[p].turn > 0) nodes_[p].listed = false;
      return nodes_[p].turn > 0;
    });
    return node.after;
  }

  [[nodiscard]] bool is_ear(Index i) const {
    const Node& node = nodes_[i];
    if (node.turn <= 0) return false;
    const Point &a = corners_[node.before], &b = corners_[i], &c = corners_[node.after];
    const auto [x_lo, x_hi] = std::minmax({a[0], b[0], c[0]});
    const auto [y_lo, y_hi] = std::minmax({a[1], b[1], c[1]});
    for (const Index p : blockers_) {
      const Point& q = corners_[p];
      if (p == node.before || p == node.after || q[0] < x_lo || q[0] > x_hi || q[1] < y_lo || q[1] > y_hi)
        continue;
      if (q == a || q == b || q == c) {
        if (enters(p, a, b, c)) return false;
      } else if (orientation(a, b, q) >= 0 && orientation(b, c, q) >= 0 && orientation(c, a, q) >= 0) {
        return false;
      }
    }
    return true;
  }

  /// True when an edge from corner p, which lies on a corner of the triangle, leads into the triangle.
  [[nodiscard]] bool enters(Index p, const Point& a, const Point& b, const Point& c) const {
    const Point& q = corners_[p];
    // The two sides at that corner, in their own directions.
    const bool at_a = q == a, at_b = q == b;
    const Point &s0 = at_a ? c : at_b ? a : b, &s1 = at_a ? a : at_b ? b : c;
    const Point& s2 = at_a ? b : at_b ? c : a;
    return std::ranges::any_of(std::array{nodes_[p].before, nodes_[p].after}, [&](Index other) {
      const Point& o = corners_[other];
      return orientation(s0, s1, o) > 0 && orientation(s1, s2, o) > 0;
    });
  }

  std::span<const Point> corners_;
  std::vector<Node> nodes_;
  std::vector<Index> blockers_, spikes_;
  Triangulation result_;
};

/// Twice the polygon's area as seen along an axis, exactly: positive when it turns counterclockwise there.
ExactSum area_along(std::size_t axis, std::span<const std::array<double, 3>> polygon) {
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  ExactSum area;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& p = polygon[i];
    const auto& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    area.add(p[x], q[y]);
    area.subtract(p[y], q[x]);
  }
  return area;
}

Triangulation fan(std::span<const std::array<double, 3>> polygon) {
  Triangulation result;
  for (Index i = 2; i < polygon.size(); ++i) {
    result.triangles.push_back({0, i - 1, i});
    result.crossing |= !are_collinear(polygon[0], polygon[i - 1], polygon[i]);
  }
  return result;
}

}  // namespace

Triangulation triangulate(std::span<const std::array<double, 3>> polygon) {
  if (polygon.size() == 3) return {{{0, 1, 2}}, false};
  const std::array<ExactSum, 3> areas{area_along(0, polygon), area_along(1, polygon), area_along(2, polygon)};
  std::size_t axis = areas[1].exceeds(areas[0]) ? 1 : 0;
  if (areas[2].exceeds(areas[axis])) axis = 2;
  const int turn = areas[axis].sign();
  if (turn == 0) return fan(polygon);
  // Seen from the other side (the two coordinates exchanged), a clockwise polygon is counterclockwise.
  const std::size_t x = turn > 0 ? (axis + 1) % 3 : (axis + 2) % 3, y = 3 - axis - x;
  std::vector<Point> projected;
  projected.reserve(polygon.size());
  for (const auto& p : polygon) projected.push_back({p[x], p[y]});
  EarClipper clipper(projected);
  const bool convex = clipper.is_convex();
  Triangulation result = clipper.clip();
  // Some polygons that cross themselves, such as a star drawn in one stroke, have ears all the same.
  result.crossing = result.crossing || (!convex && any_overlap(projected, result.triangles));
  return result;
}

}  // namespace gnomon::scene
