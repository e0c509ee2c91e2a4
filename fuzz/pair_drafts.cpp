// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_drafts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fuzz/shapes.h"
#include "scene/scene_builder.h"

namespace gnomon::fuzz {

namespace {

using Box = scene::Box<double>;
using Point = std::array<double, 3>;
using Corners = std::array<Point, 3>;

constexpr std::uint64_t kMostFaces = 16;
constexpr double kLargest = std::numeric_limits<float>::max();

double to_float(double x) {
  return static_cast<double>(static_cast<float>(std::clamp(x, -kLargest, kLargest)));
}

/// Corner number `which` of 0 .. 7.
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

/// Three different corners of the box.
Corners three_corners(CaseRandom& random, const Box& box) {
  const int first = random.below(8), second = random.below(7), third = random.below(6);
  const int b = (first + 1 + second) % 8;
  int c = third;
  for (const int taken : {std::min(first, b), std::max(first, b)}) c += c >= taken ? 1 : 0;
  return {corner_of(box, first), corner_of(box, b), corner_of(box, c)};
}

/// A ball reaches no further than floats do.
bool reaches_too_far(const scene::Ball<double>& ball) {
  return std::any_of(ball.centre.begin(), ball.centre.end(),
                     [&](double c) { return std::fabs(c) + ball.radius > kLargest; });
}

/// The boxes and balls of one trial: a shaft, and what lies about it.
struct Shapes {
  Box a, b;
  std::vector<Box> boxes;
  std::vector<scene::Ball<double>> balls;
};

/// The draws of one trial: `random` says what is made of the shapes, which have sequences of their own.
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

class CandidateDrafts final : public PairSource<BoxPair> {
 public:
  explicit CandidateDrafts(ShaftStyle style) : style_(std::move(style)) {}

  void make(const TrialId& id, PairCase<BoxPair>& c) const override {
    CaseRandom random = own_random(id);
    const std::size_t count = static_cast<std::size_t>(random.integer(1, 10));
    const std::size_t balls = static_cast<std::size_t>(random.below(static_cast<int>(count + 1))) / 2;
    const Shapes shapes = draw_shapes(style_, id, std::max<std::size_t>(count - balls, 1), balls);
    scene::SceneBuilder builder;
    // Where few faces lie about the shaft, its list is empty in a fair share of trials.
    const std::size_t triangles = random.chance(0.3) ? 1 : shapes.boxes.size();
    for (std::size_t j = 0; j < triangles; ++j) {
      const Corners corners = face_of(random, style_, shapes, j);
      builder.add_triangle(corners[0], corners[1], corners[2]);
    }
    if (triangles > 1) {
      for (const scene::Ball<double>& ball : shapes.balls) builder.add_ball(ball);
    }
    c.scene = builder.finish();
    c.query = {scene::converted<float>(shapes.a), scene::converted<float>(shapes.b)};
  }

 private:
  ShaftStyle style_;
};

/// The axis along which the boxes' centres are farthest apart.
int axis_between(const Box& a, const Box& b) {
  int widest = 0;
  double most = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = std::fabs((a.lo(axis) / 2 + a.hi(axis) / 2) - (b.lo(axis) / 2 + b.hi(axis) / 2));
    if (d > most) most = d, widest = axis;
  }
  return widest;
}

class PatchDrafts final : public PairSource<scene::PatchPair> {
 public:
  explicit PatchDrafts(ShaftStyle style) : style_(std::move(style)) {}

  void make(const TrialId& id, PairCase<scene::PatchPair>& c) const override {
    CaseRandom random = own_random(id);
    const int clutter = random.below(10);
    const std::size_t count = clutter < 5 ? 1 : static_cast<std::size_t>(random.integer(1, 6));
    const std::size_t balls = clutter < 5 ? 0 : static_cast<std::size_t>(random.below(3));
    const Shapes shapes = draw_shapes(style_, id, count, balls);
    scene::PatchPair& pair = c.query;
    const bool facing = random.chance(0.6);
    pair.a.corners = patch_in(random, shapes.a, shapes.b, facing);
    pair.b.corners = patch_in(random, shapes.b, shapes.a, facing);
    const int shared = random.below(20);  // neighbours share a corner or an edge
    if (shared < 2) pair.b.corners[0] = pair.a.corners[0];
    if (shared == 0) pair.b.corners[1] = pair.a.corners[1];

    scene::SceneBuilder builder;
    std::uint32_t triangles = 0;
    const auto add = [&](const Corners& corners) {
      builder.add_triangle(corners[0], corners[1], corners[2]);
      return triangles++;
    };
    for (scene::Patch* patch : {&pair.a, &pair.b}) {
      const bool in_scene = random.chance(0.8), twice = random.chance(0.03);
      patch->face = in_scene ? add(patch->corners) : scene::kNoFace;
      if (twice) add(patch->corners);  // one that coincides with it is not its own
    }
    const bool across = random.chance(0.55);
    if (across) add(across_the_way(random, shapes, pair));
    if (!across || clutter >= 5) {
      for (std::size_t j = 0; j < shapes.boxes.size(); ++j) {
        const bool touch = style_.near_touch && random.chance(0.7);
        add(touch ? at_plane(random, pair, shapes.boxes[j]) : face_of(random, style_, shapes, j));
      }
    }
    for (const scene::Ball<double>& ball : shapes.balls) builder.add_ball(ball);
    if (triangles + shapes.balls.size() == 0) add(face_of(random, style_, shapes, 0));
    c.scene = builder.finish();
  }

 private:
  /// A triangle in the box; `facing` puts it into the side that faces the other box.
  [[nodiscard]] Corners patch_in(CaseRandom& random, Box box, const Box& other, bool facing) const {
    if (facing) {
      const int axis = axis_between(box, other);
      const bool up = other.lo(axis) / 2 + other.hi(axis) / 2 > box.lo(axis) / 2 + box.hi(axis) / 2;
      const double side = up ? box.hi(axis) : box.lo(axis);
      box.lo(axis) = box.hi(axis) = side;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const int left_out = random.below(4);  // three of the side's four corners
      Corners corners;
      for (int k = 0, at = 0; at < 4; ++at) {
        if (at == left_out) continue;
        corners[static_cast<std::size_t>(k++)] = corner_of(box, ((at & 1) << u) | ((at >> 1) << v));
      }
      return corners;
    }
    if (style_.on_corners || random.chance(0.4)) return three_corners(random, box);
    Corners corners;
    for (Point& p : corners) p = point_in(random, box);
    return corners;
  }

  /// A triangle across the way between the patches, about as wide as the boxes or much wider, mostly square
  /// to the axis that parts them.
  [[nodiscard]] Corners across_the_way(CaseRandom& random, const Shapes& shapes,
                                       const scene::PatchPair& pair) const {
    const Box &a = shapes.a, &b = shapes.b;
    const int axis = axis_between(a, b);
    const std::size_t k = static_cast<std::size_t>(axis);
    const double s = style_.on_corners ? 0.5 : random.between(0.1, 0.9);
    const double wide = std::ldexp(1.0, random.integer(-1, 3));
    const bool tilted = random.chance(0.25);
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const double turn[3][2] = {{-2, -1}, {2, -1}, {0, 2}};
      std::size_t side = 0;
      for (std::size_t at = 0; at < 3; ++at) {
        const int other = static_cast<int>(at);
        const double middle = (1 - s) * pair.a.corners[i % 2][at] + s * pair.b.corners[i % 2][at];
        if (at == k) {
          corners[i][at] = tilted ? middle : (1 - s) * pair.a.corners[0][at] + s * pair.b.corners[0][at];
          continue;
        }
        const double width = (a.hi(other) - a.lo(other)) + (b.hi(other) - b.lo(other));
        corners[i][at] = middle + turn[i][side++] * wide * width;
      }
      for (double& x : corners[i]) x = to_float(style_.integers ? std::round(x) : x);
    }
    return corners;
  }

  /// A triangle with a corner on a plane through three corners of the patches but for a few ulps, and the
  /// rest away from it.
  [[nodiscard]] static Corners at_plane(CaseRandom& random, const scene::PatchPair& pair, const Box& box) {
    const int left_out = random.below(3), which = random.below(3);
    const bool swapped = random.chance(0.5);
    const Corners& two = swapped ? pair.b.corners : pair.a.corners;
    const Corners& one = swapped ? pair.a.corners : pair.b.corners;
    const Point& p = two[static_cast<std::size_t>((left_out + 1) % 3)];
    const Point& q = two[static_cast<std::size_t>((left_out + 2) % 3)];
    const Point& r = one[static_cast<std::size_t>(which)];
    const double u = random.unit<double>(), s = random.unit<double>();
    const int axis = random.below(3), ulps = random.integer(-4, 4);
    Corners corners;
    for (std::size_t at = 0; at < 3; ++at) {
      corners[0][at] = to_float((1 - s) * ((1 - u) * p[at] + u * q[at]) + s * r[at]);
    }
    double& moved = corners[0][static_cast<std::size_t>(axis)];
    moved = static_cast<double>(step_ulps(static_cast<float>(moved), ulps));
    // Away: in the direction from the middle of the pair through the corner, turned a little.
    for (std::size_t k = 1; k < 3; ++k) {
      const double length = random.between(0.1, 2.0);
      for (std::size_t at = 0; at < 3; ++at) {
        double middle = 0;
        for (std::size_t i = 0; i < 3; ++i) middle += (pair.a.corners[i][at] + pair.b.corners[i][at]) / 6;
        const double turn =
            random.between(-0.2, 0.2) * (box.hi(static_cast<int>(at)) - box.lo(static_cast<int>(at)) + 0.1);
        corners[k][at] = to_float(corners[0][at] + length * (corners[0][at] - middle) + turn);
      }
    }
    return corners;
  }

  ShaftStyle style_;
};

}  // namespace

ShaftStyle ShaftStyle::of(const std::string& distribution) {
  const DistributionChoice choice = parse_distribution(distribution);
  const std::string_view name = choice.distribution->name;
  return {make_generator<scene::ShaftBoxCase>(choice, scene::Scalar::f32),
          make_generator<scene::ShaftBallCase>(choice, scene::Scalar::f32),
          name == "integer-grid" || name == "denormal", name == "integer-grid", name == "near-touch"};
}

std::unique_ptr<PairSource<BoxPair>> make_candidate_drafts(ShaftStyle style) {
  return std::make_unique<CandidateDrafts>(std::move(style));
}
std::unique_ptr<PairSource<scene::PatchPair>> make_patch_drafts(ShaftStyle style) {
  return std::make_unique<PatchDrafts>(std::move(style));
}

}  // namespace gnomon::fuzz
