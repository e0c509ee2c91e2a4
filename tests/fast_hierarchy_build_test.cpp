// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of the tree, whatever the scene; and what Hierarchy says at the borders of its domain.
#include "fast/hierarchy_build.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/first_hit.h"
#include "exact/shadow.h"
#include "fast/hierarchy.h"
#include "fast/hierarchy_query.h"
#include "fast/is_float.h"
#include "tests/batch_cases.h"
#include "tests/hard_scenes.h"

namespace gnomon::tests {

using fast::Hierarchy;
using fast::ShadowAnswer;
using Tier = fast::Hierarchy::Tier;

namespace {

const fast::ExactFaces kExactFaces{exact::blocks, exact::faces_away, exact::meets, exact::compare_hits};

scene::Scene scene_of_triangles(const std::vector<std::array<Point3, 3>>& triangles) {
  scene::Scene scene;
  for (const auto& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(scene.points.size());
    for (const Point3& p : triangle) scene.points.push_back(p);
    scene.triangles.push_back({first, first + 1, first + 2});
  }
  scene.objects.resize(1);
  scene.objects[0].triangle_count = triangles.size();
  return scene;
}

/// Walks the tree: every face once and where `places` says, within all boxes above it.
struct Walker {
  const scene::Scene& scene;
  const fast::HierarchyArrays& arrays;
  std::vector<int> seen = std::vector<int>(scene.face_count());
  std::size_t depth = 0, most_waiting = 0, lanes = 0;

  using Box = std::array<float, 6>;

  void visit_face(std::uint32_t face, std::size_t block, std::size_t lane, bool ball,
                  const std::vector<Box>& above) {
    ++seen[face];
    EXPECT_EQ(arrays.places[face].block, block);
    EXPECT_EQ(arrays.places[face].lane, lane);
    EXPECT_EQ(face >= scene.triangles.size(), ball);
    for (const Box& box : above) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (ball) {
          const auto& b = scene.balls[face - scene.triangles.size()];
          const long double c = b.centre[k], r = b.radius;
          EXPECT_LE(static_cast<long double>(box[k]), c - r);
          EXPECT_GE(static_cast<long double>(box[k + 3]), c + r);
        } else {
          for (std::size_t v = 0; v < 3; ++v) {
            EXPECT_LE(static_cast<double>(box[k]), scene.corner(face, v)[k]);
            EXPECT_GE(static_cast<double>(box[k + 3]), scene.corner(face, v)[k]);
          }
        }
      }
    }
  }

  void visit(fast::ChildLink link, std::vector<Box> above, std::size_t waiting) {
    depth = std::max(depth, above.size() + 1);
    most_waiting = std::max(most_waiting, waiting);
    if (link.is_leaf()) {
      lanes += link.count();
      for (std::size_t lane = 0; lane < link.count(); ++lane) {
        const std::uint32_t face = link.has_balls() ? arrays.balls[link.block()].face[lane]
                                                    : arrays.triangles[link.block()].face[lane];
        visit_face(face, link.block(), lane, link.has_balls(), above);
      }
      return;
    }
    const fast::WideNode& node = arrays.nodes[link.index()];
    std::size_t count = 0;
    while (count < fast::kWidth && node.bounds[0][count] <= node.bounds[3][count]) ++count;
    for (std::size_t i = 0; i < count; ++i) {
      auto path = above;
      Box box;
      for (std::size_t k = 0; k < 6; ++k) box[k] = node.bounds[k][i];
      path.push_back(box);
      visit(node.children[i], std::move(path), waiting + count - 1);
    }
  }
};

void expect_sound(const scene::Scene& scene, std::size_t* depth = nullptr) {
  const fast::HierarchyArrays arrays = fast::build_hierarchy(scene);
  Walker walker{scene, arrays};
  walker.visit(fast::ChildLink::node(0), {}, 1);
  for (const int times : walker.seen) ASSERT_EQ(times, 1);
  EXPECT_EQ(walker.lanes, scene.face_count());
  EXPECT_LE(walker.depth, fast::kMostDepth);
  EXPECT_LE(walker.most_waiting + fast::kWidth, fast::kStackSize);
  if (depth != nullptr) *depth = walker.depth;
}

/// Triangles whose sizes and places shrink geometrically: the heuristic takes off a few at a time.
scene::Scene shrinking(int count) {
  std::vector<std::array<Point3, 3>> triangles;
  for (int i = 0; i < count; ++i) {
    const double x = std::ldexp(1.0, 38 - i % 180), y = x * 0.25;
    triangles.push_back({{{x, 0, 0}, {x, y, 0}, {x, 0, y}}});
  }
  return scene_of_triangles(triangles);
}

}  // namespace

TEST(FastHierarchyBuild, HoldsEveryFaceOnceWithinItsBoxes) {
  for (const HardKind kind : kHardKinds) {
    for (const int triangles : {1, 2, 7, 8, 9, 100, affordable(800)}) {
      expect_sound(hard_scene(kind, 70, triangles, triangles / 4));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(FastHierarchyBuild, StaysShallowEnoughForItsStack) {
  std::size_t depth = 0;
  expect_sound(shrinking(2000), &depth);
  std::printf("depth %zu of at most %zu\n", depth, fast::kMostDepth);
  EXPECT_GT(depth, 10u);
  // Equal boxes: no split by area, and still a balanced tree.
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  expect_sound(scene_of_triangles(std::vector<std::array<Point3, 3>>(affordable(4000), {a, b, c})), &depth);
  EXPECT_LE(depth, 12u);
  expect_sound(scene_of_triangles(std::vector<std::array<Point3, 3>>(1000, {a, a, a})), &depth);
  EXPECT_LE(depth, 12u);
}

TEST(FastHierarchyBuild, IsTheSameForTheSameScene) {
  const scene::Scene scene = hard_scene(HardKind::soup, 71, 500, 50);
  const auto a = fast::build_hierarchy(scene), b = fast::build_hierarchy(scene);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) EXPECT_EQ(a.nodes[i].bounds, b.nodes[i].bounds);
  for (std::size_t i = 0; i < a.triangles.size(); ++i) EXPECT_EQ(a.triangles[i].face, b.triangles[i].face);
}

TEST(FastHierarchyBuild, BeamsThatCrossAllOfADeepTreeAreAnswered) {
  scene::Scene scene = shrinking(2000);
  const Hierarchy hierarchy(scene);
  // Along the axis on which all triangles have a corner, and slightly off it.
  for (const double off : {0.0, 0x1p-149, 0x1p-60, -0x1p-60}) {
    const scene::ShadowQuery query{{0, off, off}, {0x1p39, off, off}};
    const auto truth = static_cast<ShadowAnswer>(exact::shadow_by_all_faces(scene, query).answer);
    for_each_target([&](const std::string& target) {
      EXPECT_EQ(hierarchy.shadow_exact(kExactFaces, query), truth) << target << off;
      const ShadowAnswer certified = hierarchy.shadow(Tier::certified, query);
      EXPECT_TRUE(certified == truth || certified == ShadowAnswer::undecided) << target << off;
    });
  }
}

TEST(FastHierarchy, NoFaceAndOneFace) {
  const scene::Scene empty;
  const Hierarchy nothing(empty);
  const scene::ShadowQuery query{{0.25, 0.25, -1}, {0.25, 0.25, 1}};
  const scene::RayQuery ray = ray_of(query);
  const scene::Scene one = scene_of_triangles({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  const Hierarchy triangle(one);
  scene::Scene ball;
  ball.balls.push_back({{0, 0, 0}, 0.5});
  ball.objects.resize(1);
  ball.objects[0].ball_count = 1;
  const Hierarchy round(ball);
  EXPECT_GT(triangle.bytes(), 400u);
  for_each_target([&](const std::string& target) {
    for (const Tier tier : {Tier::naive, Tier::certified}) {
      EXPECT_EQ(nothing.shadow(tier, query), ShadowAnswer::lit) << target;
      EXPECT_EQ(nothing.first_hit(tier, ray), scene::kNoFace) << target;
      for (const Hierarchy* hierarchy : {&triangle, &round}) {
        EXPECT_EQ(hierarchy->shadow(tier, query), ShadowAnswer::shadowed) << target;
        EXPECT_EQ(hierarchy->first_hit(tier, ray), 0u) << target;
        const scene::ShadowQuery own{query.point, query.light, 0};
        EXPECT_EQ(hierarchy->shadow(tier, own),
                  hierarchy == &round ? ShadowAnswer::shadowed : ShadowAnswer::lit);
        const scene::ShadowQuery away{query.light, {0.25, 0.25, 2}, scene::kNoFace};
        EXPECT_EQ(hierarchy->shadow(tier, away), ShadowAnswer::lit) << target;
      }
    }
  });
}

TEST(FastHierarchy, TellsFloatsFromDoubles) {
  Random random(9);
  const double most = std::numeric_limits<float>::max();
  for (const double x : {0.0, -0.0, 1.0, -0x1p-149, 0x3p-149, 0x1p-126, 0x1.fffffcp-127, most, -most}) {
    EXPECT_TRUE(fast::is_float(x)) << x;
  }
  for (const double x :
       {0.1, 1 + 0x1p-24, 0x1p-150, 0x1.8p-149, 0x1p-1074, 0x1.0p-126 + 0x1p-150, 0x1p128, 1e300,
        std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(fast::is_float(x)) << x;
  }
  for (int i = 0; i < 10000; ++i) {
    const double x =
        std::ldexp(static_cast<double>(random.bits() >> random.between(30, 50)), random.between(-180, 90));
    const volatile float rounded = static_cast<float>(x);
    EXPECT_EQ(fast::is_float(x), static_cast<double>(rounded) == x && x < 0x1p128) << x;
  }
}

TEST(FastHierarchy, HitsThatFoundNoRoomAreNotForgotten) {
  const scene::Scene scene;
  const scene::RayQuery ray;
  fast::HitCandidates hits(scene, ray, nullptr);
  for (std::uint32_t face = 0; face < 30; ++face) hits.add(face, 5, 10, false);
  hits.add(30, 0, 1, false);  // nearer, but the others don't leave room
  hits.add(31, 3, 4, true);
  EXPECT_EQ(hits.resolve(), fast::kUndecidedFace);
  fast::HitCandidates roomy(scene, ray, nullptr);
  for (std::uint32_t face = 0; face < 20; ++face) roomy.add(face, 5, 10, false);
  roomy.add(31, 3, 4, true);
  EXPECT_EQ(roomy.resolve(), 31u);
}

TEST(FastHierarchy, CountsItsTests) {
  const scene::Scene scene = hard_scene(HardKind::soup, 72, 200, 20);
  const Hierarchy hierarchy(scene);
  const auto queries = hard_queries(HardKind::soup, scene, 72, 100);
  std::vector<ShadowAnswer> plain(queries.size()), counted(queries.size());
  fast::TestCounters counters;
  hierarchy.shadows_exact(kExactFaces, queries, plain);
  hierarchy.shadows_exact(kExactFaces, queries, counted, counters);
  EXPECT_EQ(plain, counted);
  EXPECT_EQ(counters.boxes, 8 * counters.nodes);
  EXPECT_GE(counters.faces, counters.leaves);
  EXPECT_LE(counters.faces, 8 * counters.leaves);
  EXPECT_GT(counters.leaves, 0u);
  EXPECT_GT(counters.exact, 0u);
  EXPECT_LT(counters.exact, counters.faces);
}

TEST(FastHierarchy, NaiveWalksEndWhateverTheDirection) {
  // Directions that are infinite or NaN on all axes meet every box, those of missing children too.
  scene::Scene scene = scene_of_triangles({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  scene::Scene balls;
  for (int i = 0; i < 20; ++i) balls.balls.push_back({{2.0 * i, 0, 0}, 1});
  balls.objects.resize(1);
  balls.objects[0].ball_count = balls.balls.size();
  const double most = std::numeric_limits<float>::max();
  for (const scene::Scene* each : {&scene, &balls}) {
    const Hierarchy hierarchy(*each);
    for (const double odd :
         {most, std::numeric_limits<double>::infinity(), 1e300, std::numeric_limits<double>::quiet_NaN()}) {
      for_each_target([&](const std::string& target) {
        const scene::ShadowQuery query{{-odd, -odd, -odd}, {odd, odd, odd}};
        EXPECT_LE(hierarchy.shadow(Tier::naive, query), ShadowAnswer::facing) << target << odd;
        const std::uint32_t face = hierarchy.first_hit(Tier::naive, {{0, 0, 1}, {odd, -odd, odd}});
        EXPECT_TRUE(face < each->face_count() || face == scene::kNoFace) << target << odd;
      });
    }
  }
}

TEST(FastHierarchy, RaysThatHardlyMoveOnAnAxis) {
  // Directions of about 2^-80 on one axis and less than 2^-81 on the others, which all the same lead to
  // triangles aside; and some of them 2^-149, which leads nowhere.
  Random random(31);
  std::vector<std::array<Point3, 3>> triangles;
  const auto corner = [&]() -> Point3 {
    return {as_float(1 + random.unit()), as_float((random.unit() - 0.5) * 0x1p-3),
            as_float((random.unit() - 0.5) * 0x1p-3)};
  };
  for (int i = 0; i < 60; ++i) triangles.push_back({corner(), corner(), corner()});
  const scene::Scene scene = scene_of_triangles(triangles);
  const Hierarchy hierarchy(scene);
  int hits = 0, decided = 0;
  constexpr int kRays = 500;
  for (int i = 0; i < kRays; ++i) {
    scene::RayQuery ray;
    ray.direction[0] = 0x1p-80;
    for (std::size_t k = 1; k < 3; ++k) {
      ray.origin[k] = random.chance(30) ? 0 : as_float((random.unit() - 0.5) * 0x1p-4);
      ray.direction[k] = as_float((random.unit() - 0.5) * 0x1p-83);
      if (random.chance(20)) ray.direction[k] = random.chance(50) ? 0x1p-149 : -0x1p-149;
    }
    const auto faces = exact::first_hit_by_all_faces(scene, ray).faces;
    const std::uint32_t right = faces.empty() ? scene::kNoFace : faces[0];
    hits += !faces.empty();
    for_each_target([&](const std::string& target) {
      fast::TestCounters counters;
      std::uint32_t found = 0;
      hierarchy.first_hits_exact(kExactFaces, {&ray, 1}, {&found, 1}, counters);
      EXPECT_EQ(found, right) << target << i;
      EXPECT_LT(counters.exact, scene.face_count() / 2);
      const std::uint32_t certified = hierarchy.first_hit(Tier::certified, ray);
      EXPECT_TRUE(certified == right || certified == fast::kUndecidedFace) << target << i;
      decided += certified == right;
    });
  }
  EXPECT_GT(hits, kRays / 2);
  EXPECT_GT(decided, kRays / 2);
  // Slower on every axis nothing is decided.
  const scene::RayQuery slow{{}, {0x1p-82, 0, 0}};
  EXPECT_EQ(hierarchy.first_hit(Tier::certified, slow), fast::kUndecidedFace);
}

TEST(FastHierarchy, ScenesAndQueriesOutsideTheDomain) {
  scene::Scene scene = scene_of_triangles({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  const Hierarchy hierarchy(scene);
  const double kNaN = std::numeric_limits<double>::quiet_NaN(),
               kInfinity = std::numeric_limits<double>::infinity();
  for (const double odd : {0.1, 0x1.000002p40, 0x1p127, 0x1p300, kNaN, kInfinity, -kInfinity, 0x1p-150}) {
    for (int which = 0; which < 6; ++which) {
      scene::ShadowQuery query{{0.25, 0.25, -1}, {0.25, 0.25, 1}};
      (which < 3 ? query.point : query.light)[static_cast<std::size_t>(which % 3)] = odd;
      scene::RayQuery ray{query.point, {0.25, 0.25, 1}};
      ray.direction = query.light;
      for_each_target([&](const std::string& target) {
        EXPECT_EQ(hierarchy.shadow(Tier::certified, query), ShadowAnswer::undecided) << target << odd;
        EXPECT_EQ(hierarchy.first_hit(Tier::certified, ray), fast::kUndecidedFace) << target << odd;
        (void)hierarchy.shadow(Tier::naive, query);  // any answer, but an answer
        (void)hierarchy.first_hit(Tier::naive, ray);
        if (!std::isfinite(odd)) return;
        EXPECT_EQ(hierarchy.shadow_exact(kExactFaces, query),
                  static_cast<ShadowAnswer>(exact::shadow_by_all_faces(scene, query).answer))
            << target << odd;
        const auto faces = exact::first_hit_by_all_faces(scene, ray).faces;
        EXPECT_EQ(hierarchy.first_hit_exact(kExactFaces, ray), faces.empty() ? scene::kNoFace : faces[0]);
      });
    }
  }
  // At the border of the domain all is decided.
  const double most = 0x1p40;
  const scene::Scene wide = scene_of_triangles({{{{-most, -most, 0}, {most, -most, 0}, {0, most, 0}}}});
  const Hierarchy at_border(wide);
  EXPECT_TRUE(at_border.in_domain());
  for (const double z : {1.0, -1.0}) {
    const scene::ShadowQuery far{{1, 1, -z * most}, {1, 1, z * most}};
    EXPECT_EQ(at_border.shadow(Tier::certified, far), ShadowAnswer::shadowed);
    EXPECT_EQ(at_border.first_hit(Tier::certified, {far.point, {0, 0, z * most}}), 0u);
    const scene::ShadowQuery beside{{most, most, -z * most}, {0.75 * most, most, z * most}};
    EXPECT_EQ(at_border.shadow(Tier::certified, beside), ShadowAnswer::lit);
  }

  scene.points[2] = {0, 0x1p41, 0};
  const Hierarchy large(scene);
  EXPECT_FALSE(large.in_domain());
  const scene::ShadowQuery query{{0.25, 0.25, -1}, {0.25, 0.25, 1}};
  EXPECT_EQ(large.shadow(Tier::certified, query), ShadowAnswer::undecided);
  EXPECT_EQ(large.shadow_exact(kExactFaces, query), ShadowAnswer::shadowed);
  EXPECT_EQ(large.first_hit_exact(kExactFaces, ray_of(query)), 0u);
  scene.points[2] = {0, 0.1, 0};
  EXPECT_THROW(Hierarchy{scene}, std::runtime_error);
  scene.points[2] = {0, 1e39, 0};
  EXPECT_THROW(Hierarchy{scene}, std::runtime_error);
}

}  // namespace gnomon::tests
