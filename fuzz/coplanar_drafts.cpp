// SPDX-License-Identifier: GPL-3.0-or-later
// The distribution `coplanar` of questions about pairs.
#include <algorithm>

#include "fuzz/pair_drafts.h"
#include "scene/scene_builder.h"

namespace gnomon::fuzz {

namespace {

using Point = std::array<double, 3>;

double to_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

/// Squares, two triangles each, and which squares are what.
struct Terraces {
  std::vector<std::array<Point, 4>> squares;
  int cells = 0;        ///< a side of the floor
  int ceiling = 0;      ///< the first square of the ceiling; the floor is first of all
  int ceiling_end = 0;  ///< walls and panels follow
};

Terraces draw_terraces(CaseRandom& random) {
  Terraces terraces;
  const int n = terraces.cells = random.integer(2, 4);
  const int kind = random.below(3);
  std::vector<int> heights;
  for (int i = 0; i < n * n; ++i) {
    const bool raised = random.chance(0.25);
    heights.push_back(raised ? random.integer(1, 2) : 0);
  }
  const auto add = [&](Point a, Point b, Point c, Point d) {
    std::array<Point, 4> square{a, b, c, d};
    for (Point& p : square) {
      if (kind == 1) p[2] += 2 * p[0] - 3 * p[1];  // a sloping plane, exactly
      if (kind == 2) {                             // decimals: coplanar but for rounding
        p[2] += 0.7 * p[0];
        for (double& x : p) x = to_float(x * 0.1);
      }
    }
    terraces.squares.push_back(square);
  };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const double z = heights[static_cast<std::size_t>(y * n + x)];
      add({x + 0., y + 0., z}, {x + 1., y + 0., z}, {x + 1., y + 1., z}, {x + 0., y + 1., z});
    }
  }
  terraces.ceiling = static_cast<int>(terraces.squares.size());
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (random.chance(0.3)) continue;
      add({x + 0., y + 0., 4.}, {x + 0., y + 1., 4.}, {x + 1., y + 1., 4.}, {x + 1., y + 0., 4.});
    }
  }
  terraces.ceiling_end = static_cast<int>(terraces.squares.size());
  for (int y = 0; y < n; ++y) {
    for (int x = 1; x < n; ++x) {
      const double left = heights[static_cast<std::size_t>(y * n + x - 1)];
      const double right = heights[static_cast<std::size_t>(y * n + x)];
      if (left == right) continue;
      add({x + 0., y + 0., left}, {x + 0., y + 1., left}, {x + 0., y + 1., right}, {x + 0., y + 0., right});
    }
  }
  for (int panels = random.below(3); panels > 0;
       --panels) {  // between floor and ceiling, some over all of it
    const bool whole = random.chance(0.5);
    const double x = random.below(n), y = random.below(n), wide = whole ? 3 * n : random.integer(1, 2);
    const double x0 = whole ? -n : x, y0 = whole ? -n : y;
    add({x0, y0, 3}, {x0 + wide, y0, 3}, {x0 + wide, y0 + wide, 3}, {x0, y0 + wide, 3});
  }
  return terraces;
}

scene::Scene scene_of(const Terraces& terraces) {
  scene::SceneBuilder builder;
  for (const auto& [a, b, c, d] : terraces.squares) {
    builder.add_triangle(a, b, c);
    builder.add_triangle(a, c, d);
  }
  return builder.finish();
}

struct TwoSquares {
  int a, b;
};

/// A square and one that is next to it, opposite, or anywhere.
TwoSquares pick_squares(CaseRandom& random, const Terraces& terraces) {
  const int all = static_cast<int>(terraces.squares.size()), n = terraces.cells;
  const int a = random.below(all), kind = random.below(6);
  int b = a;
  if (kind == 1) b = std::min(a + 1, all - 1);
  if (kind == 2) b = std::min(a + n, all - 1);
  if (kind == 3 || kind == 4) {  // across, from floor to ceiling
    const int high = terraces.ceiling_end - terraces.ceiling;
    const int floor = random.below(terraces.ceiling), above = random.below(std::max(high, 1));
    return {floor, high > 0 ? terraces.ceiling + above : floor};
  }
  if (kind == 5) b = random.below(all);
  return {a, b};
}

class CoplanarCandidates final : public PairSource<BoxPair> {
 public:
  void make(const TrialId& id, PairCase<BoxPair>& c) const override {
    CaseRandom random(id.seed, id.stream, id.trial);
    const Terraces terraces = draw_terraces(random);
    c.scene = scene_of(terraces);
    const TwoSquares two = pick_squares(random, terraces);
    c.query.a = box_at(random, terraces, two.a);
    c.query.b = box_at(random, terraces, two.b);
  }

 private:
  /// The box of a square's triangle, of the square, or of a corner; now and then outside of everything.
  static scene::Box<float> box_at(CaseRandom& random, const Terraces& terraces, int square) {
    const std::array<Point, 4>& corners = terraces.squares[static_cast<std::size_t>(square)];
    const int kind = random.below(4), which = random.below(4), lifted = random.below(4);
    const int count = kind == 0 ? 1 : kind == 1 ? 3 : 4;
    scene::Box<float> box;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t at = static_cast<std::size_t>(axis);
      float lo = static_cast<float>(corners[static_cast<std::size_t>(which)][at]), hi = lo;
      for (int k = 1; k < count; ++k) {
        const float x = static_cast<float>(corners[static_cast<std::size_t>((which + k) % 4)][at]);
        lo = std::min(lo, x);
        hi = std::max(hi, x);
      }
      const float by = axis == 2 && lifted == 0 ? 64.0F : 0.0F;
      box.lo(axis) = lo + by;
      box.hi(axis) = hi + by;
    }
    return box;
  }
};

class CoplanarPatches final : public PairSource<scene::PatchPair> {
 public:
  void make(const TrialId& id, PairCase<scene::PatchPair>& c) const override {
    CaseRandom random(id.seed, id.stream, id.trial);
    const Terraces terraces = draw_terraces(random);
    c.scene = scene_of(terraces);
    const TwoSquares two = pick_squares(random, terraces);
    const int half_a = random.below(2), half_b = two.a == two.b ? 1 - half_a : random.below(2);
    c.query = {patch(c.scene, 2 * two.a + half_a), patch(c.scene, 2 * two.b + half_b)};
  }

 private:
  static scene::Patch patch(const scene::Scene& scene, int face) {
    const std::size_t t = static_cast<std::size_t>(face);
    return {{scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)}, static_cast<std::uint32_t>(face)};
  }
};

}  // namespace

std::unique_ptr<PairSource<BoxPair>> make_coplanar_candidates() {
  return std::make_unique<CoplanarCandidates>();
}
std::unique_ptr<PairSource<scene::PatchPair>> make_coplanar_patches() {
  return std::make_unique<CoplanarPatches>();
}

}  // namespace gnomon::fuzz
