// SPDX-License-Identifier: GPL-3.0-or-later
// What may be left off candidate lists (claims S21 and S22): back faces of solids, and what adjoins the
// receiver. proofs/BackFaces.v proves what is tested on small integers here, where floats calculate exactly.
#include <gtest/gtest.h>

#include "exact/convexity.h"
#include "tests/candidate_cases.h"

namespace gnomon::tests {
namespace {

Solid tetrahedron(std::array<Point, 4> p) {
  const auto solid = [&] {
    return Solid{{p[0], p[1], p[2]}, {p[0], p[2], p[3]}, {p[0], p[3], p[1]}, {p[1], p[3], p[2]}};
  };
  const scene::Scene scene = scene_of({solid()});
  if (scene.points.size() == 4 && !exact::is_convex(scene, scene.objects[0])) std::swap(p[0], p[1]);
  return solid();
}
std::vector<std::uint8_t> convex_objects(const scene::Scene& scene) {
  std::vector<std::uint8_t> convex;
  for (const scene::Object& object : scene.objects) convex.push_back(exact::is_convex(scene, object) ? 1 : 0);
  return convex;
}

/// Behind or on all faces of a convex object; exact for small integers.
bool is_in_a_solid(const scene::Scene& scene, std::span<const std::uint8_t> convex, const Point& p) {
  for (std::size_t o = 0; o < convex.size(); ++o) {
    bool inside = convex[o] != 0;
    for (std::size_t t = 0; inside && t < scene.objects[o].triangle_count; ++t) {
      std::array<std::array<double, 3>, 3> e{};
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis)
          e[k][axis] = scene.corner(scene.objects[o].first_triangle + t, k)[axis] - p[axis];
      }
      const double volume = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                            e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
      inside = volume >= 0;
    }
    if (inside) return true;
  }
  return false;
}

/// S21: what the culled lists' faces exactly block is what all faces do, for points on no solid.
TEST(BackFaceClaims, CulledBackFacesChangeNoAnswer) {
  Random random(21);
  int culled = 0, blocked = 0, inside = 0;
  for (int i = 0; i < affordable(2000); ++i) {
    const auto coarse = [&] {
      Point p = grid_point(random, 6);
      for (float& x : p) x = 2 * x;
      return p;
    };
    std::vector<Solid> solids;
    for (int k = random.between(1, 3); k > 0; --k)
      solids.push_back(tetrahedron({coarse(), coarse(), coarse(), coarse()}));
    const scene::Scene scene = scene_of(solids, true);
    const std::vector<std::uint8_t> convex = convex_objects(scene);
    const ItemTree tree = tree_of(scene, random.bits());
    const Point corner = grid_point(random, 12);
    Box a = box_of(corner, corner);
    for (int axis = 0; axis < 3; ++axis) a.hi(axis) += static_cast<float>(random.below(3));
    const Box b = box_of(grid_point(random, 12), grid_point(random, 12));
    ListOptions options;
    options.back_faces = true;
    options.arithmetic = random.chance(50) ? Arithmetic::naive : Arithmetic::certified;
    const Made made(tree, scene, options, a, b, convex);
    const std::vector<std::uint32_t> faces = faces_of(tree, made.list);
    options.back_faces = false;
    culled += faces.size() < faces_of(tree, Made(tree, scene, options, a, b, convex).list).size() ? 1 : 0;
    for (int k = 0; k < 4; ++k) {
      const Point from = corner_within(random, b), to = corner_within(random, a);
      const scene::ShadowQuery query = query_of(from, to);
      // Where the emitter's point is on a solid, its own polygon says which receivers it faces: not asked
      // here.
      if (is_in_a_solid(scene, convex, to)) continue;
      const bool truth = is_blocked_exactly(scene, from, to);
      EXPECT_EQ(std::ranges::any_of(faces, [&](std::uint32_t f) { return exact::blocks(scene, f, query); }),
                truth)
          << i;
      blocked += truth ? 1 : 0;
    }
    inside += made.builder.emitter_list().marks.any() ? 0 : 1;
  }
  EXPECT_GT(culled, affordable(2000) / 10);
  EXPECT_GT(blocked, affordable(2000) / 4);
  EXPECT_GT(inside, 0);
}

/// S21 where the emitter is inside: every face of the solid is a back face, and one of them blocks. The lists
/// don't cull there.
TEST(BackFaceClaims, EmitterInsideASolidSeesBackFacesAlone) {
  const scene::Scene scene = scene_of({tetrahedron({Point{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}})}, true);
  ASSERT_TRUE(exact::is_convex(scene, scene.objects[0]));
  const ItemTree tree = tree_of(scene);
  const Point to{0.5F, 0.5F, 0.5F}, from{8, 8, 8};
  for (std::uint32_t f = 0; f < 4; ++f) {
    EXPECT_TRUE(fast::form_front_plane(tree.triangle(f), tree.item(0).box, Arithmetic::certified)
                    .none_in_front(box_of(to, to)));
  }
  ASSERT_TRUE(is_blocked_exactly(scene, from, to));
  ListOptions options;
  options.back_faces = true;
  const std::vector<std::uint8_t> convex{1};
  const Made made(tree, scene, options, box_of(to, to), box_of(from, from), convex);
  EXPECT_TRUE(hits(tree, made.list, from, to));
}

/// S21 in floats: the face by which the ray enters is just in front, and the naive plane says it is not.
TEST(BackFaceClaims, NaivePlaneCullsTheFaceThatBlocks) {
  const std::array<Point, 4> p{
      Point{1001.20001F, 1003.79999F, 1002.59998F}, Point{1003.79999F, 1002.5F, 1003.59998F},
      Point{1001.20001F, 1002.70001F, 1002.09998F}, Point{1002.5F, 1002.09998F, 1003.79999F}};
  const scene::Scene scene = scene_of({tetrahedron(p)}, true);
  const std::vector<std::uint8_t> convex = convex_objects(scene);
  ASSERT_EQ(convex, std::vector<std::uint8_t>{1});
  const ItemTree tree = tree_of(scene);
  const Point to{997.259827F, 1005.29913F, 1000.87042F}, from{1007.4129F, 1000.72211F, 1005.00256F};
  ASSERT_TRUE(is_blocked_exactly(scene, from, to));
  ListOptions options;
  options.back_faces = true;
  for (const Arithmetic arithmetic : {Arithmetic::naive, Arithmetic::certified}) {
    options.arithmetic = arithmetic;
    const Made made(tree, scene, options, box_of(to, to), box_of(from, from), convex);
    EXPECT_EQ(hits(tree, made.builder.emitter_list(), from, to), arithmetic == Arithmetic::certified);
  }
}

/// S22: a wall near the rim of the receiver, not on it. Without the tolerance it is on the list.
TEST(BackFaceClaims, AdjacencyToleranceLosesABlocker) {
  const Solid wall{{Point{0.25F, 3, 0.125F}, {0.25F, 5, 0.125F}, {0.25F, 4, 2}}};
  const scene::Scene scene = scene_of({wall});
  const ItemTree tree = tree_of(scene);
  const Box receiver = box_of({0, 0, 0}, {8, 8, 0}), light = box_of({3, 3, 8}, {5, 5, 8});
  const Point from{0, 4, 0}, to{4, 4, 8};
  ASSERT_TRUE(is_blocked_exactly(scene, from, to));
  ListOptions options;
  for (const Arithmetic arithmetic : {Arithmetic::naive, Arithmetic::certified}) {
    options.arithmetic = arithmetic;
    options.adjacency = 0.125F;
    EXPECT_FALSE(hits(tree, Made(tree, scene, options, light, receiver).list, from, to));
    options.adjacency = 0;
    EXPECT_TRUE(hits(tree, Made(tree, scene, options, light, receiver).list, from, to));
  }
}

}  // namespace
}  // namespace gnomon::tests
