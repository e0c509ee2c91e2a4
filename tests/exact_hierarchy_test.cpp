// SPDX-License-Identifier: GPL-3.0-or-later
// exact/hierarchy.h against asking face by face, touching included.
#include "exact/hierarchy.h"

#include <gtest/gtest.h>

#include <thread>

#include "exact/hierarchy_build.h"
#include "exact/hierarchy_walk.h"
#include "tests/scene_cases.h"

namespace gnomon::tests {
namespace {

using exact::FirstHit;
using exact::Hierarchy;
using exact::ShadowTruth;
using scene::RayQuery;
using scene::Scene;
using scene::SceneBuilder;
using scene::Shadow;
using scene::ShadowQuery;

struct Mix {
  std::size_t lit = 0, shadowed = 0, touching = 0, hits = 0, ties = 0;
};

void check_shadow(const Scene& scene, const Hierarchy& hierarchy, const ShadowQuery& q, Mix& mix) {
  const ShadowTruth expected = exact::shadow_by_all_faces(scene, q);
  ASSERT_EQ(hierarchy.shadow(q), expected) << corpus_text_of(scene, q);
  mix.lit += expected.answer == Shadow::lit;
  mix.shadowed += expected.answer == Shadow::shadowed;
  mix.touching += expected.touching;
}

void check_hit(const Scene& scene, const Hierarchy& hierarchy, const RayQuery& ray, Mix& mix) {
  const FirstHit expected = exact::first_hit_by_all_faces(scene, ray);
  ASSERT_EQ(hierarchy.first_hit(ray), expected)
      << corpus_text_of(scene, {ray.origin, ray.direction, ray.own});
  mix.hits += !expected.faces.empty();
  mix.ties += expected.faces.size() > 1;
}

void check_scenes(std::uint64_t seed, int scenes, bool grid, Mix& mix) {
  Random random(seed);
  for (int trial = 0; trial < scenes; ++trial) {
    const Placement place =
        grid ? kPlacements[static_cast<std::size_t>(trial) % kPlacements.size()] : Placement();
    const int faces = random.chance(50) ? random.between(1, 12) : random.between(1, 300);
    const int balls = random.chance(30) ? 0 : random.chance(30) ? faces : random.below(faces + 1);
    const Scene scene = random_scene(random, {faces - balls, balls, grid}, place);
    const Hierarchy hierarchy(scene);
    for (int i = 0; i < 12; ++i) {
      check_shadow(scene, hierarchy, random_query(random, scene, grid, place), mix);
      check_hit(scene, hierarchy, random_ray(random, scene, grid, place), mix);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(ExactHierarchy, GridScenesAreAnsweredAsFaceByFace) {
  Mix mix;
  check_scenes(6, affordable(200), true, mix);
  const auto least = static_cast<std::size_t>(affordable(400));
  EXPECT_GE(mix.lit, least / 2);
  EXPECT_GE(mix.shadowed, least);
  EXPECT_GE(mix.touching, least);
  EXPECT_GE(mix.hits, least);
  EXPECT_GE(mix.ties, least);
}

TEST(ExactHierarchy, RandomScenesAreAnsweredAsFaceByFace) {
  Mix mix;
  check_scenes(7, affordable(300), false, mix);
  const auto least = static_cast<std::size_t>(affordable(300));
  EXPECT_GE(mix.lit, least);
  EXPECT_GE(mix.shadowed, least);
  EXPECT_GE(mix.hits, least);
}

/// Hierarchy takes the best instructions that the processor has; these are what it takes on others.
TEST(ExactHierarchy, BaselineInstructionsAnswerAsFaceByFace) {
  Random random(31);
  Mix mix;
  for (int trial = 0; trial < affordable(120); ++trial) {
    const bool grid = random.chance(50);
    const int faces = random.between(1, 200), balls = random.chance(50) ? 0 : random.below(faces + 1);
    const Scene scene = random_scene(random, {faces - balls, balls, grid}, Placement());
    const exact::BuiltHierarchy built = exact::build_hierarchy(scene);
    for (int i = 0; i < 12; ++i) {
      const ShadowQuery q = random_query(random, scene, grid, Placement());
      const ShadowTruth truth = exact::shadow_by_all_faces(scene, q);
      ASSERT_EQ(exact::baseline::shadow(scene, built, q, nullptr), truth) << corpus_text_of(scene, q);
      const RayQuery ray = random_ray(random, scene, grid, Placement());
      const FirstHit hit = exact::first_hit_by_all_faces(scene, ray);
      ASSERT_EQ(exact::baseline::first_hit(scene, built, ray, nullptr), hit)
          << corpus_text_of(scene, {ray.origin, ray.direction, ray.own});
      mix.shadowed += truth.answer == Shadow::shadowed;
      mix.touching += truth.touching;
      mix.hits += !hit.faces.empty();
    }
  }
  const auto least = static_cast<std::size_t>(affordable(100));
  EXPECT_GE(mix.shadowed, least);
  EXPECT_GE(mix.touching, least);
  EXPECT_GE(mix.hits, least);
}

/// Arrays of a size that has large pages asked for, and of one that has not.
TEST(ExactHierarchy, LargePagesHoldWhatOthersHold) {
  for (const std::size_t count : {std::size_t{3}, std::size_t{50000}}) {
    scene::LargeVector<exact::Leaf<float>> leaves(count / 3);
    for (std::uint32_t i = 0; leaves.size() < count; ++i) leaves.emplace_back().face[0] = i;
    leaves.shrink_to_fit();
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(leaves.data()) % alignof(exact::Leaf<float>), 0u);
    EXPECT_EQ(leaves[count - 1].face[0], count - count / 3 - 1);
  }
}

/// Balls beside which a path passes within a rounding error, triangles that it passes through near an edge, a
/// vertex, or with an end near the plane: what plain doubles can't decide.
TEST(ExactHierarchy, PathsThatNearlyTouch) {
  Random random(14);
  Mix mix;
  exact::HierarchyCounters counters;
  const auto point = [&] { return Point3{random.unit(), random.unit(), random.unit()}; };
  for (int trial = 0; trial < affordable(3000); ++trial) {
    const Point3 p = point(), light = point();
    SceneBuilder builder;
    Point3 on = p;  // a point of the path, beyond an end now and then
    const double t = random.chance(30) ? random.below(2) : random.unit();
    Point3 d{}, beside = point();
    for (std::size_t i = 0; i < 3; ++i) d[i] = light[i] - p[i];
    for (std::size_t i = 0; i < 3; ++i) on[i] = p[i] + t * d[i];
    if (random.chance(50)) {
      const double along = (beside[0] * d[0] + beside[1] * d[1] + beside[2] * d[2]) /
                           (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      double length = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        beside[i] -= along * d[i];
        length += beside[i] * beside[i];
      }
      for (std::size_t i = 0; i < 3; ++i) beside[i] += on[i];
      builder.add_ball({beside, std::sqrt(length)});
    } else {
      const Point3 a = point(), b = point();
      Point3 c;
      const double u = random.chance(30) ? 0 : random.unit();
      // `on` lies near the side between b and c, at u of it, or near the corner c.
      for (std::size_t i = 0; i < 3; ++i) c[i] = b[i] + (on[i] - b[i]) / (1 - u / 2);
      builder.add_triangle(a, b, c);
    }
    const Scene scene = builder.finish();
    const Hierarchy hierarchy(scene);
    check_shadow(scene, hierarchy, {p, light, scene::kNoFace}, mix);
    check_hit(scene, hierarchy, {p, d, scene::kNoFace}, mix);
    if (HasFatalFailure()) return;
    (void)hierarchy.shadow({p, light, scene::kNoFace}, counters);

    SceneBuilder near_ties;  // triangles with the same centre but for rounding: which one is first?
    for (int i = 0; i < 3; ++i) {
      const Point3 a = point(), b = point();
      near_ties.add_triangle(a, b,
                             {3 * on[0] - a[0] - b[0], 3 * on[1] - a[1] - b[1], 3 * on[2] - a[2] - b[2]});
    }
    const Scene tied = near_ties.finish();
    check_hit(tied, Hierarchy(tied), {p, d, scene::kNoFace}, mix);
  }
  const auto least = static_cast<std::size_t>(affordable(800));
  EXPECT_GE(mix.lit, least);
  EXPECT_GE(mix.shadowed, least);
  EXPECT_GE(counters.exact_face_tests, least);
}

/// Numbers from the whole range of doubles in one scene: boxes overflow floats, paths overflow doubles.
TEST(ExactHierarchy, AnyFiniteNumbers) {
  Random random(8);
  Mix mix;
  const auto number = [&] {
    const int exponent = random.chance(50) ? random.between(-1074, 1022) : random.between(-3, 3);
    return std::ldexp(static_cast<double>(random.between(-3, 3)), exponent - (exponent > 1000 ? 2 : 0));
  };
  const auto point = [&] { return Point3{number(), number(), number()}; };
  for (int trial = 0; trial < affordable(300); ++trial) {
    SceneBuilder builder;
    for (int i = random.between(1, 30); i > 0; --i) {
      if (random.chance(70)) {
        builder.add_triangle(point(), point(), point());
      } else {
        builder.add_ball({point(), std::fabs(number())});
      }
    }
    const Scene scene = builder.finish();
    ASSERT_TRUE(is_valid(scene));
    const Hierarchy hierarchy(scene);
    for (int i = 0; i < 10; ++i) {
      const ShadowQuery q{point(), point(), scene::kNoFace};
      check_shadow(scene, hierarchy, q, mix);
      RayQuery ray{point(), point(), scene::kNoFace};
      if (ray.direction == Point3{0, 0, 0}) ray.direction[0] = -0x1p-1074;
      check_hit(scene, hierarchy, ray, mix);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GE(mix.lit, 10u);
  EXPECT_GE(mix.shadowed, 10u);
  EXPECT_GE(mix.hits, 10u);
}

TEST(ExactHierarchy, PathsFarLongerThanTheScene) {
  SceneBuilder builder;
  builder.add_triangle({0, -1, -1}, {0, 2, -1}, {0, -1, 2});
  builder.add_ball({{1, 0, 0}, 0.5});
  const Scene scene = builder.finish();
  const Hierarchy hierarchy(scene);
  for (const double far : {1e10, 1e40, 1e290, 1e305, 1.7e308}) {
    for (const double sign : {-1.0, 1.0}) {
      const ShadowQuery q{{-sign * far, 0, 0}, {sign * far, 0, 0}, scene::kNoFace};
      EXPECT_EQ(hierarchy.shadow(q), (ShadowTruth{Shadow::shadowed, false})) << far;
      EXPECT_EQ(hierarchy.first_hit({q.point, {sign, 0, 0}, scene::kNoFace}),
                (FirstHit{{sign > 0 ? 0u : 1u}, false}));
      // All but parallel to the triangle, which it meets after a time beyond all floats.
      if (sign > 0) {
        EXPECT_EQ(hierarchy.first_hit({{-1, 0, 0}, {1 / far, 0, 0}, 1}), (FirstHit{{0}, false})) << far;
      }
      EXPECT_EQ(hierarchy.shadow({{-1, sign * far, 0}, {1, sign * far, 0}, scene::kNoFace}), ShadowTruth());
    }
  }
}

/// A field of 20,000 triangles over the unit square, at a distance from 0 where doubles are coarse.
Scene field(double offset) {
  constexpr int kCells = 100;
  Random random(9);
  std::vector<double> heights;
  for (int i = 0; i < (kCells + 1) * (kCells + 1); ++i) heights.push_back(random.unit() / 20 + offset);
  const auto at = [&](int i, int j) {
    return Point3{offset + i / static_cast<double>(kCells), offset + j / static_cast<double>(kCells),
                  heights[static_cast<std::size_t>(i * (kCells + 1) + j)]};
  };
  SceneBuilder builder;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      builder.add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      builder.add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return builder.finish();
}

TEST(ExactHierarchy, AFieldOfTrianglesIsAnsweredAsFaceByFace) {
  for (const double offset : {0.0, 1e5}) {
    const Scene scene = field(offset);
    const Hierarchy hierarchy(scene);
    EXPECT_GT(hierarchy.bytes(), scene.triangles.size() * 36);
    Random random(10);
    Mix mix;
    exact::HierarchyCounters counters;
    const int queries = affordable(60);
    for (int i = 0; i < queries; ++i) {
      const auto corner = [&] {
        return scene.points[static_cast<std::size_t>(random.below(static_cast<int>(scene.points.size())))];
      };
      const Point3 from = corner();
      Point3 to =
          random.chance(50) ? corner() : Point3{offset + random.unit(), offset + random.unit(), offset + 0.3};
      // From below through a corner, or from a corner: borders and ends of six triangles at once.
      const ShadowQuery q{from, to, scene::kNoFace};
      check_shadow(scene, hierarchy, q, mix);
      const Point3 above{from[0], from[1], offset + 1}, below{from[0], from[1], offset - 1};
      check_shadow(scene, hierarchy, {below, above, scene::kNoFace}, mix);
      const RayQuery ray{above, {0, 0, -1}, scene::kNoFace};
      check_hit(scene, hierarchy, ray, mix);
      if (HasFatalFailure()) return;
      // Counting changes no answer.
      EXPECT_EQ(hierarchy.shadow(q, counters), hierarchy.shadow(q));
      EXPECT_EQ(hierarchy.first_hit(ray, counters), hierarchy.first_hit(ray));
    }
    EXPECT_GE(mix.lit, static_cast<std::size_t>(queries / 8));
    EXPECT_GE(mix.shadowed, static_cast<std::size_t>(queries));
    EXPECT_GE(mix.ties, static_cast<std::size_t>(queries / 2));
    EXPECT_LT(counters.face_tests, static_cast<std::uint64_t>(queries) * 200) << "hardly a hierarchy";
    EXPECT_GE(counters.face_tests, counters.exact_face_tests);
    EXPECT_GT(counters.exact_face_tests, 0u);
    EXPECT_GT(counters.box_tests, static_cast<std::uint64_t>(queries));
  }
}

TEST(ExactHierarchy, EmptyScenesAndManyEqualFaces) {
  const Scene empty;
  const Hierarchy nothing(empty);
  EXPECT_EQ(nothing.shadow({{0, 0, 0}, {1, 1, 1}, scene::kNoFace}), ShadowTruth());
  EXPECT_EQ(nothing.first_hit({{0, 0, 0}, {1, 1, 1}, scene::kNoFace}), FirstHit());
  SceneBuilder builder;
  for (int i = 0; i < 5000; ++i) builder.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Scene scene = builder.finish();
  const Hierarchy hierarchy(scene);
  EXPECT_EQ(hierarchy.first_hit({{0.25, 0.25, 1}, {0, 0, -1}, 17}).faces.size(), 4999u);
  EXPECT_EQ(hierarchy.shadow({{0.25, 0.25, 1}, {0.25, 0.25, -1}, 17}),
            (ShadowTruth{Shadow::shadowed, false}));
  EXPECT_EQ(hierarchy.shadow({{2, 2, 1}, {2, 2, -1}, 17}), ShadowTruth());
}

TEST(ExactHierarchy, ThreadsShareOne) {
  Random random(11);
  const Scene scene = random_scene(random, {200, 50, true}, {});
  const Hierarchy hierarchy(scene);
  std::vector<ShadowQuery> queries;
  std::vector<ShadowTruth> alone;
  for (int i = 0; i < 200; ++i) {
    queries.push_back(random_query(random, scene, true, {}));
    alone.push_back(hierarchy.shadow(queries.back()));
  }
  std::array<std::size_t, 2> different{};
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 2; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = 0; i < queries.size(); ++i)
          different[t] += hierarchy.shadow(queries[i]) != alone[i];
      });
    }
  }
  EXPECT_EQ(different[0] + different[1], 0u);
}

}  // namespace
}  // namespace gnomon::tests
