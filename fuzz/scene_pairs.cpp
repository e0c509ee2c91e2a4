// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/scene_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/polygons.h"
#include "fuzz/shapes.h"

namespace gnomon::fuzz {

namespace {

using Box = scene::Box<float>;
using Point = std::array<double, 3>;
using Corners = std::array<Point, 3>;

constexpr float kLargest = std::numeric_limits<float>::max();

Box nothing() {
  return {{kLargest, kLargest, kLargest, -kLargest, -kLargest, -kLargest}};
}

void add(Box& box, const Box& more) {
  for (int axis = 0; axis < 3; ++axis) {
    box.lo(axis) = std::min(box.lo(axis), more.lo(axis));
    box.hi(axis) = std::max(box.hi(axis), more.hi(axis));
  }
}

/// A finite float near x.
float to_float(double x) {
  return std::clamp(static_cast<float>(x), -kLargest, kLargest);
}

Point to_floats(const Point& p) {
  return {static_cast<double>(to_float(p[0])), static_cast<double>(to_float(p[1])),
          static_cast<double>(to_float(p[2]))};
}

Box box_of_point(const Point& p) {
  const float x = to_float(p[0]), y = to_float(p[1]), z = to_float(p[2]);
  return {{x, y, z, x, y, z}};
}

/// Every third bit, from bit 0 on.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Where the box's centre lies along a Z-order curve through the bounds.
std::uint64_t curve_key(const Box& box, const Box& bounds) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = bounds.lo(axis), width = static_cast<double>(bounds.hi(axis)) - lo;
    const double centre = (static_cast<double>(box.lo(axis)) + box.hi(axis)) / 2;
    const double share = width > 0 ? std::clamp((centre - lo) / width, 0.0, 1.0) : 0;
    key |= spread(static_cast<std::uint64_t>(share * 0x1fffff)) << axis;
  }
  return key;
}

/// The part of the triangle that is `scale` times as large, around a point of it, rounded.
Corners part_of(CaseRandom& random, const Corners& corners) {
  const double u = random.unit<double>(), v = random.unit<double>();
  const double a = std::min(u, v), b = std::max(u, v) - a, c = 1 - a - b;
  const double scale = std::ldexp(1.0, -random.integer(1, 9));
  Corners part;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double centre = a * corners[0][axis] + b * corners[1][axis] + c * corners[2][axis];
    for (std::size_t k = 0; k < 3; ++k) part[k][axis] = centre + scale * (corners[k][axis] - centre);
  }
  for (Point& p : part) p = to_floats(p);
  return part;
}

}  // namespace

ScenePairs::ScenePairs(const scene::Scene& scene) : scene_(scene), polygons_(exact::polygons_of(scene)) {
  const std::uint32_t count = static_cast<std::uint32_t>(scene.face_count());
  std::vector<Box> boxes(count);
  bounds_ = nothing();
  for (std::uint32_t face = 0; face < count; ++face) {
    boxes[face] = box_of_face(face);
    add(bounds_, boxes[face]);
  }
  polygon_of_.resize(count);
  for (const scene::FaceRun& run : polygons_) {
    Box box = nothing();
    for (std::uint32_t face = run.first; face < run.first + run.count; ++face) {
      polygon_of_[face] = static_cast<std::uint32_t>(polygon_boxes_.size());
      add(box, boxes[face]);
    }
    polygon_boxes_.push_back(box);
  }
  object_of_.resize(count);
  for (const scene::Object& object : scene.objects) {
    Box box = nothing();
    const auto take = [&](std::size_t first, std::size_t faces) {
      for (std::size_t face = first; face < first + faces; ++face) {
        object_of_[face] = static_cast<std::uint32_t>(object_boxes_.size());
        add(box, boxes[face]);
      }
    };
    take(object.first_triangle, object.triangle_count);
    take(scene.triangles.size() + object.first_ball, object.ball_count);
    object_boxes_.push_back(box);
  }

  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(count);
  for (std::uint32_t face = 0; face < count; ++face) keys[face] = {curve_key(boxes[face], bounds_), face};
  std::sort(keys.begin(), keys.end());
  order_.resize(count);
  place_.resize(count);
  levels_.emplace_back(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    order_[i] = keys[i].second;
    place_[keys[i].second] = i;
    levels_[0][i] = boxes[keys[i].second];
  }
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> level((below.size() + 1) / 2, nothing());
    for (std::size_t i = 0; i < below.size(); ++i) add(level[i / 2], below[i]);
    levels_.push_back(std::move(level));
  }

  first_at_point_.assign(scene.points.size() + 1, 0);
  for (const auto& corners : scene.triangles) {
    for (const std::uint32_t point : corners) ++first_at_point_[point + 1];
  }
  std::partial_sum(first_at_point_.begin(), first_at_point_.end(), first_at_point_.begin());
  at_points_.resize(3 * scene.triangles.size());
  std::vector<std::uint32_t> next = first_at_point_;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    for (const std::uint32_t point : scene.triangles[t]) at_points_[next[point]++] = t;
  }
}

ScenePairs::Box ScenePairs::box_of_face(std::uint32_t face) const {
  if (face >= scene_.triangles.size()) {
    const scene::Ball<double>& ball = scene_.balls[face - scene_.triangles.size()];
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      const double c = ball.centre[static_cast<std::size_t>(axis)];
      box.lo(axis) = to_float(c - ball.radius);
      box.hi(axis) = to_float(c + ball.radius);
    }
    return box;
  }
  Box box = nothing();
  for (std::size_t k = 0; k < 3; ++k) add(box, box_of_point(scene_.corner(face, k)));
  return box;
}

std::uint32_t ScenePairs::relative(CaseRandom& random, std::uint32_t face, bool triangles) const {
  const std::uint32_t count =
      static_cast<std::uint32_t>(triangles ? scene_.triangles.size() : scene_.face_count());
  const int kind = random.below(10);
  std::uint32_t other = face;
  if (kind < 3 && face < scene_.triangles.size()) {  // shares a corner
    const std::uint32_t point = scene_.triangles[face][static_cast<std::size_t>(random.below(3))];
    const std::uint32_t first = first_at_point_[point], last = first_at_point_[point + 1];
    other = at_points_[first + static_cast<std::uint32_t>(random.below(static_cast<int>(last - first)))];
  } else if (kind < 5) {  // near
    const std::int64_t step = random.integer(-12, 12);
    const std::int64_t most = static_cast<std::int64_t>(order_.size()) - 1;
    other = order_[static_cast<std::size_t>(std::clamp<std::int64_t>(place_[face] + step, 0, most))];
  } else if (kind < 6) {  // of the same surface, often: coplanar, or facing the same way
    const std::int64_t step = random.integer(-3, 3);
    other = static_cast<std::uint32_t>(std::clamp<std::int64_t>(static_cast<std::int64_t>(face) + step, 0,
                                                                static_cast<std::int64_t>(count) - 1));
  }
  if (kind >= 6 || other >= count) other = static_cast<std::uint32_t>(random.below(static_cast<int>(count)));
  return other;
}

ScenePairs::Point ScenePairs::point_on(CaseRandom& random, std::uint32_t face) const {
  const double u = random.unit<double>(), v = random.unit<double>();
  if (face >= scene_.triangles.size()) {
    const scene::Ball<double>& ball = scene_.balls[face - scene_.triangles.size()];
    const double z = 2 * u - 1, around = 6.283185307179586 * v, flat = std::sqrt(1 - z * z);
    const std::array<double, 3> direction{flat * std::cos(around), flat * std::sin(around), z};
    Point p;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = ball.centre[axis] + ball.radius * direction[axis];
    return to_floats(p);
  }
  const double a = std::min(u, v), b = std::max(u, v) - a, c = 1 - a - b;
  Point p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p[axis] = a * scene_.corner(face, 0)[axis] + b * scene_.corner(face, 1)[axis] +
              c * scene_.corner(face, 2)[axis];
  }
  return to_floats(p);
}

ScenePairs::Box ScenePairs::box_in_the_air(CaseRandom& random, const Point& centre) const {
  const double size = std::ldexp(1.0, -random.integer(3, 12));
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const double width = static_cast<double>(bounds_.hi(axis)) - bounds_.lo(axis);
    const double half = width * size * random.unit<double>(), c = centre[static_cast<std::size_t>(axis)];
    box.lo(axis) = to_float(c - half);
    box.hi(axis) = to_float(c + half);
  }
  return box;
}

ScenePairs::Box ScenePairs::pick_box(CaseRandom& random, std::uint32_t face) const {
  const int kind = random.below(20);
  Box box;
  if (kind < 1) {
    box = object_boxes_[object_of_[face]];
  } else if (kind < 5) {
    box = polygon_boxes_[polygon_of_[face]];
  } else if (kind < 9) {
    box = levels_[0][place_[face]];
  } else if (kind < 13) {  // sample points of a patch
    box = nothing();
    for (int k = random.integer(1, 4); k > 0; --k) add(box, box_of_point(point_on(random, face)));
  } else if (kind < 16) {
    const int most = static_cast<int>(levels_.size());
    const int first = random.below(most), second = random.below(most);
    const std::size_t level = static_cast<std::size_t>(std::min(first, second));
    box = levels_[level][place_[face] >> level];
  } else if (kind < 18) {
    box = face < scene_.triangles.size()
              ? box_of_point(scene_.corner(face, static_cast<std::size_t>(random.below(3))))
              : box_of_point(scene_.balls[face - scene_.triangles.size()].centre);
  } else {  // flat: a side of a box
    box = kind == 18 ? levels_[0][place_[face]] : polygon_boxes_[polygon_of_[face]];
    const int axis = random.below(3);
    const bool upper = random.chance(0.5);
    (upper ? box.lo(axis) : box.hi(axis)) = upper ? box.hi(axis) : box.lo(axis);
  }
  if (random.chance(0.1)) {
    for (int axis = 0; axis < 3; ++axis) {
      const int below = random.integer(-2, 2), above = random.integer(-2, 2);
      set_axis(box, axis, step_ulps(box.lo(axis), below), step_ulps(box.hi(axis), above));
    }
  }
  return box;
}

BoxPair ScenePairs::boxes(CaseRandom& random) const {
  const std::uint32_t face = static_cast<std::uint32_t>(random.below(static_cast<int>(scene_.face_count())));
  if (random.chance(0.2)) {  // a little way between points that mostly lie on nothing
    const Point on = point_on(random, face);
    Point from, to;
    const double away = std::ldexp(1.0, -random.integer(1, 6));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double lo = bounds_.c[axis], width = static_cast<double>(bounds_.c[axis + 3]) - lo;
      const double any = lo + width * random.unit<double>();
      from[axis] = on[axis] + 0.5 * (any - on[axis]);
      to[axis] = from[axis] + away * width * random.between(-1.0, 1.0);
    }
    const Box a = box_in_the_air(random, from);
    return {a, box_in_the_air(random, to)};
  }
  const std::uint32_t other = relative(random, face, false);
  const Box a = pick_box(random, face);
  return {a, pick_box(random, other)};
}

scene::Patch ScenePairs::pick_patch(CaseRandom& random, std::uint32_t face) const {
  const Corners corners{scene_.corner(face, 0), scene_.corner(face, 1), scene_.corner(face, 2)};
  const bool whole = random.chance(0.45);
  return {whole ? corners : part_of(random, corners), face};
}

scene::Patch ScenePairs::pick_light(CaseRandom& random) const {
  const auto which = random.below(static_cast<int>(scene_.polygon_lights.size()));
  const std::vector<Point>& corners = scene_.polygon_lights[static_cast<std::size_t>(which)].corners;
  const std::size_t k = static_cast<std::size_t>(random.integer(1, static_cast<int>(corners.size()) - 2));
  const Corners triangle{to_floats(corners[0]), to_floats(corners[k]), to_floats(corners[k + 1])};
  const bool whole = random.chance(0.3);
  return {whole ? triangle : part_of(random, triangle), scene::kNoFace};
}

scene::PatchPair ScenePairs::patches(CaseRandom& random) const {
  const std::uint32_t face =
      static_cast<std::uint32_t>(random.below(static_cast<int>(scene_.triangles.size())));
  const bool light = random.chance(0.2) && !scene_.polygon_lights.empty();
  const scene::Patch a = light ? pick_light(random) : pick_patch(random, face);
  return {a, pick_patch(random, relative(random, face, true))};
}

}  // namespace gnomon::fuzz
