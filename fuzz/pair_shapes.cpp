// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::fuzz::drafts {

namespace {

constexpr std::uint64_t kMostFaces = 16;
constexpr double kLargest = std::numeric_limits<float>::max();

/// A ball reaches no further than floats do.
bool reaches_too_far(const scene::Ball<double>& ball) {
  return std::any_of(ball.centre.begin(), ball.centre.end(),
                     [&](double c) { return std::fabs(c) + ball.radius > kLargest; });
}

}  // namespace

double to_float(double x) {
  return static_cast<double>(static_cast<float>(std::clamp(x, -kLargest, kLargest)));
}

Point corner_of(const Box& box, int which) {
  Point p;
  for (int axis = 0; axis < 3; ++axis) {
    p[static_cast<std::size_t>(axis)] = ((which >> axis) & 1) != 0 ? box.hi(axis) : box.lo(axis);
  }
  return p;
}

Point point_in(CaseRandom& random, const Box& box) {
  Point p;
  for (int axis = 0; axis < 3; ++axis) {
    const double u = random.unit<double>();
    p[static_cast<std::size_t>(axis)] = to_float((1 - u) * box.lo(axis) + u * box.hi(axis));
  }
  return p;
}

Corners three_corners(CaseRandom& random, const Box& box) {
  const int first = random.below(8), second = random.below(7), third = random.below(6);
  const int b = (first + 1 + second) % 8;
  int c = third;
  for (const int taken : {std::min(first, b), std::max(first, b)}) c += c >= taken ? 1 : 0;
  return {corner_of(box, first), corner_of(box, b), corner_of(box, c)};
}

Shapes draw_shapes(const ShaftStyle& style, const TrialId& id, std::size_t boxes, std::size_t balls) {
  Shapes shapes;
  for (std::uint64_t j = 0; j < boxes + balls; ++j) {
    CaseRandom shared(id.seed, id.stream, id.trial * kMostFaces + j, kMostFaces);
    if (j < boxes) {
      const scene::ShaftBoxCase c = style.boxes->make(shared);
      if (j == 0) shapes.a = c.a, shapes.b = c.b;
      shapes.boxes.push_back(c.t);
    } else {
      const scene::Ball<double> ball = style.balls->make(shared).t;
      if (!reaches_too_far(ball)) shapes.balls.push_back(ball);
    }
  }
  return shapes;
}

CaseRandom own_random(const TrialId& id) {
  return {id.seed, id.stream ^ 0x5ca1ab1eu, id.trial};
}

Corners face_of(CaseRandom& random, const ShaftStyle& style, const Shapes& shapes, std::size_t j) {
  const int kind = random.below(10);
  if (kind < 5) return three_corners(random, shapes.boxes[j]);
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    // From one box, or a long triangle from box to box.
    const Box& box = kind < 7 ? shapes.boxes[j] : shapes.boxes[(j + k) % shapes.boxes.size()];
    corners[k] =
        style.on_corners || (kind == 5 && k == 0) ? corner_of(box, random.below(8)) : point_in(random, box);
  }
  return corners;
}

}  // namespace gnomon::fuzz::drafts
