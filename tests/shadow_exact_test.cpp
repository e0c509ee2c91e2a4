// SPDX-License-Identifier: GPL-3.0-or-later
// exact/shadow.h against the definition in rationals, and against what must hold of closed meshes.
#include "exact/shadow.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "scene/float_text.h"
#include "tests/scene_cases.h"
#include "tests/shadow_by_definition.h"

namespace gnomon::tests {
namespace {

using exact::ShadowTruth;
using scene::kNoFace;
using scene::Scene;
using scene::SceneBuilder;
using scene::Shadow;
using scene::ShadowQuery;

std::string text_of(const Point3& p) {
  return scene::hex_text(p[0]) + " " + scene::hex_text(p[1]) + " " + scene::hex_text(p[2]) + " ";
}

std::string text_of(const Scene& scene, const ShadowQuery& q) {
  std::string text = "shadow " + text_of(q.point) + text_of(q.light) +
                     (q.own == kNoFace ? "-1" : std::to_string(q.own)) + " " +
                     std::to_string(scene.face_count());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    text += " tri " + text_of(scene.corner(t, 0)) + text_of(scene.corner(t, 1)) + text_of(scene.corner(t, 2));
  }
  for (const auto& ball : scene.balls) text += " ball " + text_of(ball.centre) + scene::hex_text(ball.radius);
  return text;
}

struct Mix {
  std::array<std::size_t, 3> answers{};
  std::array<std::size_t, 3> touching{};
  ContactCounts contacts;
};

/// Asks both references, and counts.
void check(const Scene& scene, const ShadowQuery& q, Mix& mix) {
  const ShadowTruth expected = shadow_by_definition(scene, q, &mix.contacts);
  const ShadowTruth found = exact::shadow_by_all_faces(scene, q);
  ASSERT_EQ(found, expected) << text_of(scene, q) << " answer " << static_cast<int>(found.answer) << " for "
                             << static_cast<int>(expected.answer) << ", touching " << found.touching;
  ++mix.answers[static_cast<std::size_t>(found.answer)];
  mix.touching[static_cast<std::size_t>(found.answer)] += found.touching;
  EXPECT_EQ(exact::faces_away(scene, q), found.answer == Shadow::facing);
  bool any = false;
  for (std::uint32_t face = 0; face < scene.face_count(); ++face) any |= exact::blocks(scene, face, q);
  if (found.answer == Shadow::facing) return;
  EXPECT_EQ(any, found.answer == Shadow::shadowed);
}

void expect_mix(const Mix& mix, std::size_t least) {
  EXPECT_GE(mix.answers[0], least);
  EXPECT_GE(mix.answers[1], least);
  EXPECT_GE(mix.answers[2], least / 4);
  EXPECT_GE(mix.contacts.firm, least);
}

TEST(ShadowExact, GridScenesAgreeWithTheDefinitionAtEveryScale) {
  Random random(1);
  Mix mix;
  for (int trial = 0; trial < affordable(reference_cases(9000)); ++trial) {
    const Placement& place = kPlacements[static_cast<std::size_t>(trial) % kPlacements.size()];
    const Scene scene = random_scene(random, {random.below(5), random.below(3), true}, place);
    for (int i = 0; i < 2 && !HasFatalFailure(); ++i)
      check(scene, random_query(random, scene, true, place), mix);
    if (HasFatalFailure()) return;
  }
  const auto least = static_cast<std::size_t>(affordable(1000));
  expect_mix(mix, least);
  EXPECT_GE(mix.touching[0], least);
  EXPECT_GE(mix.touching[1], least / 2);
  EXPECT_EQ(mix.touching[2], 0u);
  EXPECT_GE(mix.contacts.ends, least);
  EXPECT_GE(mix.contacts.weak, least);
  EXPECT_GE(mix.contacts.unsealed, least / 2);
  EXPECT_GE(mix.contacts.sealed, 1u);
  std::printf(
      "lit %zu shadowed %zu facing %zu; touching %zu %zu; ends %zu weak %zu sealed %zu unsealed %zu firm "
      "%zu\n",
      mix.answers[0], mix.answers[1], mix.answers[2], mix.touching[0], mix.touching[1], mix.contacts.ends,
      mix.contacts.weak, mix.contacts.sealed, mix.contacts.unsealed, mix.contacts.firm);
}

TEST(ShadowExact, RandomScenesAgreeWithTheDefinition) {
  Random random(2);
  Mix mix;
  for (int trial = 0; trial < affordable(reference_cases(1500)); ++trial) {
    const Scene scene = random_scene(random, {random.below(6), random.below(4), false}, {});
    for (int i = 0; i < 2; ++i) check(scene, random_query(random, scene, false, {}), mix);
    if (HasFatalFailure()) return;
  }
  expect_mix(mix, static_cast<std::size_t>(affordable(400)));
}

}  // namespace
}  // namespace gnomon::tests
