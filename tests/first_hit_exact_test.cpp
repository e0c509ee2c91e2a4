// SPDX-License-Identifier: GPL-3.0-or-later
// exact/first_hit.h against the definition in rationals.
#include "exact/first_hit.h"

#include <gtest/gtest.h>

#include "tests/first_hit_by_definition.h"
#include "tests/scene_cases.h"

namespace gnomon::tests {
namespace {

using exact::FirstHit;
using scene::RayQuery;
using scene::Scene;
using scene::SceneBuilder;

struct Mix {
  std::size_t none = 0, one = 0, tied = 0, touching = 0, roots = 0;
};

void check(const Scene& scene, const RayQuery& ray, Mix& mix) {
  const FirstHit expected = first_hit_by_definition(scene, ray, &mix.roots);
  const FirstHit found = exact::first_hit_by_all_faces(scene, ray);
  ASSERT_EQ(found.faces, expected.faces) << corpus_text_of(scene, {ray.origin, ray.direction, ray.own});
  ASSERT_EQ(found.touching, expected.touching) << corpus_text_of(scene, {ray.origin, ray.direction, ray.own});
  mix.none += found.faces.empty();
  mix.one += found.faces.size() == 1;
  mix.tied += found.faces.size() > 1;
  mix.touching += found.touching;
  for (const std::uint32_t face : found.faces) EXPECT_TRUE(exact::meets(scene, face, ray));
  for (std::size_t i = 1; i < found.faces.size(); ++i) {
    EXPECT_TRUE(exact::compare_hits(scene, found.faces[0], found.faces[i], ray) == 0);
  }
}

TEST(FirstHitExact, GridScenesAgreeWithTheDefinitionAtEveryScale) {
  Random random(3);
  Mix mix;
  for (int trial = 0; trial < affordable(reference_cases(6000)); ++trial) {
    const Placement& place = kPlacements[static_cast<std::size_t>(trial) % kPlacements.size()];
    const Scene scene = random_scene(random, {random.below(4), random.below(6), true}, place);
    for (int i = 0; i < 2; ++i) check(scene, random_ray(random, scene, true, place), mix);
    if (HasFatalFailure()) return;
  }
  const auto least = static_cast<std::size_t>(affordable(640));
  EXPECT_GE(mix.none, least);
  EXPECT_GE(mix.one, least);
  EXPECT_GE(mix.tied, least / 2);
  EXPECT_GE(mix.touching, least);
  EXPECT_GE(mix.roots, least / 2);
}

TEST(FirstHitExact, RandomScenesAgreeWithTheDefinition) {
  Random random(4);
  Mix mix;
  for (int trial = 0; trial < affordable(reference_cases(1500)); ++trial) {
    const Scene scene = random_scene(random, {random.below(4), random.below(16), false}, {});
    for (int i = 0; i < 2; ++i) check(scene, random_ray(random, scene, false, {}), mix);
    if (HasFatalFailure()) return;
  }
  const auto least = static_cast<std::size_t>(affordable(300));
  EXPECT_GE(mix.none, least);
  EXPECT_GE(mix.one, least);
  EXPECT_GE(mix.roots, least / 4);
}

TEST(FirstHitExact, RaysWithinThePlaneOfFacesAgreeWithTheDefinition) {
  Random random(16);
  Mix mix;
  for (int trial = 0; trial < affordable(600); ++trial) {
    const FlatCase c = random_flat_case(random);
    RayQuery ray{c.query.point, {}, c.query.own};
    for (std::size_t i = 0; i < 3; ++i) ray.direction[i] = c.query.light[i] - c.query.point[i];
    check(c.scene, ray, mix);
    if (HasFatalFailure()) return;
  }
  const auto least = static_cast<std::size_t>(affordable(100));
  EXPECT_GE(mix.none, least);
  EXPECT_GE(mix.one, least);
}

/// Hits that no double can tell apart, and ties of numbers that are not rational.
TEST(FirstHitExact, RootsAreComparedExactly) {
  SceneBuilder builder;
  // On the x axis, from 0: the first two begin at 10 - sqrt(3), and so does the fourth; the third begins at
  // 10 - sqrt(3 - 2^-80), behind them.
  builder.add_ball({{10, 1, 0}, 2});
  builder.add_ball({{10, 0, 1}, 2});
  builder.add_ball({{10, 1, 0x1p-40}, 2});
  builder.add_ball({{10, -1, 0}, 2});
  const Scene balls = builder.finish();
  const RayQuery ray{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(exact::first_hit_by_all_faces(balls, ray), (FirstHit{{0, 1, 3}, false}));
  EXPECT_TRUE(exact::compare_hits(balls, 2, 0, ray) > 0);
  EXPECT_TRUE(exact::compare_hits(balls, 0, 2, ray) < 0);

  SceneBuilder mixed;  // a 3-4-5 ball begins at 6 exactly, as the triangle does
  mixed.add_triangle({6, -1, -1}, {6, 2, -1}, {6, -1, 2});
  mixed.add_triangle({6 + 0x1p-50, -1, -1}, {6 + 0x1p-50, 2, -1}, {6 + 0x1p-50, -1, 2});
  mixed.add_ball({{10, 3, 0}, 5});
  EXPECT_EQ(exact::first_hit_by_all_faces(mixed.finish(), ray), (FirstHit{{0, 2}, false}));
}

TEST(FirstHitExact, StartsWithinFaces) {
  SceneBuilder builder;
  builder.add_ball({{0, 0, 0}, 2});
  builder.add_ball({{0.5, 0, 0}, 2});
  builder.add_triangle({1, -1, -1}, {1, 2, -1}, {1, -1, 2});
  const Scene scene = builder.finish();
  const RayQuery inside{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(exact::first_hit_by_all_faces(scene, inside), (FirstHit{{1, 2}, false}));
  // Leaving the first ball outwards, as its own face: not met again. The other one is.
  EXPECT_EQ(exact::first_hit_by_all_faces(scene, {{2, 0, 0}, {1, 0, 0}, 1}), (FirstHit{{2}, false}));
  // Crossing its own ball: met where it leaves, after all others.
  EXPECT_TRUE(exact::meets(scene, 1, {{-2, 0, 0}, {1, 0, 0}, 1}));
  EXPECT_TRUE(exact::compare_hits(scene, 1, 0, {{-2, 0, 0}, {1, 0, 0}, 1}) > 0);
  // Tangent to its own ball at the start: lit, and touching.
  SceneBuilder alone;
  alone.add_ball({{0, 0, 0}, 2});
  EXPECT_EQ(exact::first_hit_by_all_faces(alone.finish(), {{2, 0, 0}, {0, 1, 0}, 0}), (FirstHit{{}, true}));
  EXPECT_EQ(exact::first_hit_by_all_faces(Scene(), inside), FirstHit());
}

}  // namespace
}  // namespace gnomon::tests
