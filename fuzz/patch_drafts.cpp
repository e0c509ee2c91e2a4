// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fuzz/pair_drafts.h"
#include "fuzz/pair_shapes.h"
#include "fuzz/shapes.h"
#include "scene/scene_builder.h"

namespace gnomon::fuzz {

namespace {

using namespace drafts;

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

std::unique_ptr<PairSource<scene::PatchPair>> make_patch_drafts(ShaftStyle style) {
  return std::make_unique<PatchDrafts>(std::move(style));
}

}  // namespace gnomon::fuzz
