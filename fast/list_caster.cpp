// SPDX-License-Identifier: MIT
#include "fast/list_caster.h"

#include <algorithm>
#include <cmath>

namespace gnomon::fast {

namespace {

using Vector = std::array<float, 3>;

/// Two products, two differences and a quotient a component, none of them larger than twice the distance.
constexpr float kVolumeSlack = 0x1p-18F;

Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
float dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The line passes through the triangle when the three volumes over its edges have one sign; where along the
/// segment is the quotient of two distances to the triangle's plane.
bool triangle_blocks(const std::array<Vector, 3>& triangle, const Segment& s) {
  const Vector a = minus(triangle[0], s.from), b = minus(triangle[1], s.from), c = minus(triangle[2], s.from);
  const float u = dot(s.direction, cross(b, c));
  const float v = dot(s.direction, cross(c, a));
  const float w = dot(s.direction, cross(a, b));
  if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) return false;
  const Vector normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
  const float along = dot(normal, s.direction), distance = dot(normal, a);
  return along > 0 ? distance > 0 && distance < along : distance < 0 && distance > along;
}

/// The point nearest to the centre is off by some roundings of the centre's distance from the segment's
/// start: `slack` times its square is added to the radius's.
bool ball_blocks(const scene::Ball<float>& ball, const Segment& s, float slack) {
  const Vector centre = minus(ball.centre, s.from);
  const float length = dot(s.direction, s.direction);
  const float t = length > 0 ? std::clamp(dot(centre, s.direction) / length, 0.0F, 1.0F) : 0.0F;
  const Vector apart{centre[0] - t * s.direction[0], centre[1] - t * s.direction[1],
                     centre[2] - t * s.direction[2]};
  return dot(apart, apart) <= ball.radius * ball.radius + slack * dot(centre, centre);
}

/// Each end of a slab carries four roundings (two differences, a quotient, a product), so widening the far
/// one by twice their bound loses no box (as Ize, Journal of Computer Graphics Techniques 2,2, 2013, for
/// three). 0 times infinity, where a segment runs within a side's plane, is NaN: the comparisons below then
/// leave the interval as it was.
bool meets_box(const scene::Box<float>& box, const Segment& s) {
  constexpr float kWiden = 1 + 2 * (4 * 0x1p-24F / (1 - 4 * 0x1p-24F));
  float near = 0, far = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const bool down = s.inverse[k] < 0;
    const float enter = ((down ? box.hi(axis) : box.lo(axis)) - s.from[k]) * s.inverse[k];
    const float leave = ((down ? box.lo(axis) : box.hi(axis)) - s.from[k]) * s.inverse[k] * kWiden;
    near = enter > near ? enter : near;
    far = leave < far ? leave : far;
  }
  return near <= far;
}

}  // namespace

bool blocks(const ItemTree& tree, std::uint32_t primitive, const Segment& segment) {
  const Item& item = tree.item(primitive);
  if (tree.is_ball(item.first)) return ball_blocks(tree.scene_ball(item.first), segment, 0);
  for (std::uint32_t k = 0; k < item.count(); ++k) {
    if (triangle_blocks(tree.triangle(item.first + k), segment)) return true;
  }
  return false;
}

bool meets_volume(const ItemTree& tree, std::uint32_t item, const Segment& segment) {
  return tree.volumes() == Volumes::boxes ? meets_box(tree.item(item).box, segment)
                                          : ball_blocks(tree.ball(item), segment, kVolumeSlack);
}

bool ListCaster::cached_blocks(const Segment& segment, std::uint32_t own_from, std::uint32_t own_to) {
  if (cached_ == kNoItem || cached_ == own_from || cached_ == own_to) return false;
  ++counters_.cache_tests;
  const bool hit = blocks(tree_, cached_, segment);
  counters_.cache_hits += hit ? 1 : 0;
  return hit;
}

ListCaster::Hit ListCaster::cast(const CandidateList& list, const Segment& segment, std::uint32_t own_from,
                                 std::uint32_t own_to) {
  ++counters_.rays;
  const bool marks = list.has_marks();
  for (const std::uint32_t start : list.items) {
    stack_.clear();
    stack_.push_back(start);
    while (!stack_.empty()) {
      const std::uint32_t i = stack_.back();
      stack_.pop_back();
      if (i == own_from || i == own_to || (marks && list.is_marked(i))) continue;
      ++counters_.boxes;
      if (!meets_volume(tree_, i, segment)) continue;
      const Item& item = tree_.item(i);
      if (!item.is_primitive()) {
        for (std::uint32_t k = item.count(); k-- > 0;) stack_.push_back(item.first + k);
        continue;
      }
      ++counters_.objects;
      if (!blocks(tree_, i, segment)) continue;
      ++counters_.blocked;
      cached_ = i;
      return {i, start};
    }
  }
  return {};
}

}  // namespace gnomon::fast
