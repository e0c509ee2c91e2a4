// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shadow and first-hit, peers too, against exact answers face by face.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/first_hit.h"
#include "fast/fp_environment.h"
#include "fuzz/camera.h"
#include "reports/peers/flush_denormals.h"
#include "reports/peers/peers.h"
#include "scene/scene_builder.h"
#include "tests/shadow_scenes.h"

namespace gnomon::tests {
namespace {

using fuzz::Answer;
using fuzz::Promise;
using fuzz::SceneMethod;
using scene::Shadow;
using scene::ShadowQuery;

std::vector<Answer> answers_of(const SceneMethod& method, const scene::Scene& scene,
                               std::span<const ShadowQuery> queries) {
  std::vector<Answer> answers(queries.size(), fuzz::kRejected);
  method.make(scene)->shadows(queries, answers);
  return answers;
}

Shadow answer_of(const SceneMethod& method, const scene::Scene& scene, const ShadowQuery& query) {
  return static_cast<Shadow>(answers_of(method, scene, {&query, 1}).front());
}

struct Errors {
  std::size_t wrong = 0, undecided = 0;
};

Errors errors_of(const SceneMethod& method, const scene::Scene& scene, std::span<const ShadowQuery> queries) {
  const std::vector<Answer> answers = answers_of(method, scene, queries);
  Errors errors;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto truth = static_cast<Answer>(exact::shadow_by_all_faces(scene, queries[i]).answer);
    errors.undecided += answers[i] >= fuzz::kUndecided ? 1 : 0;
    errors.wrong += answers[i] < fuzz::kUndecided && answers[i] != truth ? 1 : 0;
  }
  return errors;
}

class EveryRow : public testing::Test {
 protected:
  /// Each row is asked about triangles alone, and about balls if it knows them.
  template <class Check>
  static void on_scenes(Check check) {
    for (const SceneMethod& method : reports::all_scene_methods()) {
      for (const std::string& nff : {kTrianglesNff, kBallsNff}) {
        const scene::Scene scene = single_scene(nff);
        if (method.has_balls || scene.balls.empty()) check(method, scene);
      }
    }
  }
};

TEST_F(EveryRow, AgreesOnRandomPoints) {
  on_scenes([](const SceneMethod& method, const scene::Scene& scene) {
    const auto queries = fuzz::record_workload("surface", scene, slow_oracle(scene), {2000, 3}).queries;
    ASSERT_EQ(queries.size(), 2000u);
    const Errors errors = errors_of(method, scene, queries);
    EXPECT_LE(errors.wrong, 2u) << method.name;
    EXPECT_LE(errors.undecided, 20u) << method.name;
    if (method.promise == Promise::always_agrees) {
      EXPECT_EQ(errors.wrong + errors.undecided, 0u);
    }
    if (method.promise == Promise::never_unsound) {
      EXPECT_EQ(errors.wrong, 0u);
    }
  });
}

TEST_F(EveryRow, KeepsItsPromiseOnHardQueriesAndOthersErrThere) {
  on_scenes([](const SceneMethod& method, const scene::Scene& scene) {
    const auto queries = fuzz::record_workload("hard", scene, slow_oracle(scene), {4000, 3}).queries;
    const Errors errors = errors_of(method, scene, queries);
    if (method.promise != Promise::none) {
      EXPECT_EQ(errors.wrong, 0u) << method.name;
    }
    if (method.promise == Promise::always_agrees) {
      EXPECT_EQ(errors.undecided, 0u) << method.name;
    }
    if (method.name.ends_with("f32") && method.promise == Promise::none) {
      EXPECT_GT(errors.wrong, 100u) << method.name << ": the workload is not hard";
    }
    if (method.name.starts_with("embree")) {
      EXPECT_GT(errors.wrong, 100u) << method.name;
    }
  });
}

TEST_F(EveryRow, SeesAFaceThatIsFirst) {
  on_scenes([](const SceneMethod& method, const scene::Scene& scene) {
    const fuzz::Camera camera(*scene.view, 40, 30);
    std::vector<scene::RayQuery> rays;
    for (std::size_t pixel = 0; pixel < 1200; ++pixel) rays.push_back(camera.ray(pixel % 40, pixel / 40));
    std::vector<std::uint32_t> faces(rays.size(), 12345);
    method.make(scene)->first_hits(rays, faces);
    std::size_t wrong = 0, hits = 0, undecided = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::vector<std::uint32_t> truth = exact::first_hit_by_all_faces(scene, rays[i]).faces;
      hits += truth.empty() ? 0 : 1;
      const bool right = truth.empty() ? faces[i] == scene::kNoFace
                                       : std::find(truth.begin(), truth.end(), faces[i]) != truth.end();
      undecided += faces[i] == fuzz::kUndecidedFace ? 1 : 0;
      wrong += right || faces[i] == fuzz::kUndecidedFace ? 0 : 1;
    }
    EXPECT_GT(hits, 200u);
    EXPECT_LE(undecided, 60u) << method.name;
    EXPECT_LE(wrong, method.promise == Promise::none ? 2u : 0u) << method.name;
  });
}

/// A one-sided floor, a two-sided wall and a ball, the faces 0, 1 and 2.
scene::Scene own_faces(bool ball) {
  scene::SceneBuilder builder;
  builder.begin_object("floor", 0, true);
  builder.add_triangle({-4, -4, 0}, {4, -4, 0}, {0, 4, 0});
  builder.begin_object("wall", 0, false);
  builder.add_triangle({-1, 8, -1}, {1, 8, -1}, {0, 8, 1});
  if (ball) builder.add_ball({{0, -8, 1}, 0.5});
  return builder.finish();
}

TEST(OwnFaces, AreLeftOutByTheirNumber) {
  for (const SceneMethod& method : reports::all_scene_methods()) {
    const scene::Scene scene = own_faces(false);
    const std::array<double, 3> below{0.25, 0, -0x1p-20}, light{0.5, 0.25, 3};
    // Within an ulp of the face and behind it: an offset along the segment would start before it.
    EXPECT_EQ(answer_of(method, scene, {below, light, 0}), Shadow::lit) << method.name;
    EXPECT_EQ(answer_of(method, scene, {below, light, scene::kNoFace}), Shadow::shadowed) << method.name;
    EXPECT_EQ(answer_of(method, scene, {below, light, 1}), Shadow::shadowed) << method.name;
  }
}

TEST(OwnFaces, ThatFaceAwayAreInShadow) {
  for (const SceneMethod& method : reports::all_scene_methods()) {
    const scene::Scene scene = own_faces(false);
    EXPECT_EQ(answer_of(method, scene, {{0, 0, 0}, {1, 0, -2}, 0}), Shadow::facing) << method.name;
    EXPECT_EQ(answer_of(method, scene, {{0, 0, 0}, {1, 0, 2}, 0}), Shadow::lit) << method.name;
    for (const double side : {-3.0, 20.0}) {
      EXPECT_EQ(answer_of(method, scene, {{0, 8, 0}, {0, side, 0.5}, 1}), Shadow::lit) << method.name;
    }
  }
}

TEST(OwnFaces, OfBallsBlockWhatLeadsIntoThem) {
  for (const SceneMethod& method : reports::all_scene_methods()) {
    const scene::Scene scene = own_faces(true);
    if (!method.has_balls) {
      EXPECT_THROW((void)method.make(scene), std::runtime_error) << method.name;
      continue;
    }
    EXPECT_EQ(answer_of(method, scene, {{0, -8, 1.5}, {0, -8, 5}, 2}), Shadow::lit) << method.name;
    EXPECT_EQ(answer_of(method, scene, {{0, -8, 1.5}, {0, -7, 0.5}, 2}), Shadow::shadowed) << method.name;
    // A little within the ball, on the way out: the own ball doesn't block, another's would.
    EXPECT_EQ(answer_of(method, scene, {{0, -8, 1.4375}, {0, -8, 5}, 2}), Shadow::lit) << method.name;
    EXPECT_EQ(answer_of(method, scene, {{0, -8, 1.4375}, {0, -8, 5}, scene::kNoFace}), Shadow::shadowed)
        << method.name;
  }
}

TEST(OwnFaces, OfPacketsBelongToTheirQueries) {
  const scene::Scene scene = own_faces(true);
  std::vector<ShadowQuery> queries;
  for (int k = 0; k < 37; ++k) {  // full packets of 8 and 16, and a rest
    const std::uint32_t own = k % 3 == 0 ? 0 : k % 3 == 1 ? 1 : scene::kNoFace;
    queries.push_back({{0.125 * (k % 5), 0, -0x1p-20}, {0.5, 0.25, 3}, own});
  }
  for (const SceneMethod& method : reports::all_scene_methods()) {
    if (!method.has_balls) continue;
    const std::vector<Answer> answers = answers_of(method, scene, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      EXPECT_EQ(static_cast<Shadow>(answers[i]), queries[i].own == 0 ? Shadow::lit : Shadow::shadowed)
          << method.name << " " << i;
    }
  }
}

TEST(Peers, LeaveTheFloatingPointModesAsTheyWere) {
#if defined(__SSE2__)
  const unsigned before = _mm_getcsr() & ~0x3FU;  // but for the flags of what has happened
  {
    const reports::FlushDenormals flush;
    EXPECT_FALSE(fast::witness_fp_environment().keeps_denormals);
  }
  EXPECT_EQ(_mm_getcsr() & ~0x3FU, before);
  for (const SceneMethod& method : reports::all_scene_methods()) {
    const scene::Scene scene = single_scene(kTrianglesNff);
    const auto caster = method.make(scene);
    EXPECT_EQ(_mm_getcsr() & ~0x3FU, before) << method.name;
    const ShadowQuery query{{0, 0, 2}, {1, 1, 5}, scene::kNoFace};
    Answer answer{};
    caster->shadows({&query, 1}, {&answer, 1});
    EXPECT_EQ(_mm_getcsr() & ~0x3FU, before) << method.name;
    const scene::RayQuery ray{{0, 0, 2}, {0, 0, -1}, scene::kNoFace};
    std::uint32_t face{};
    caster->first_hits({&ray, 1}, {&face, 1});
    EXPECT_EQ(_mm_getcsr() & ~0x3FU, before) << method.name;
  }
#endif
  EXPECT_TRUE(fast::witness_fp_environment().is_strict());
}

TEST(SceneMethods, AreChosenByName) {
  EXPECT_EQ(reports::choose_scene_methods({}).size(), reports::all_scene_methods().size());
  const auto chosen = reports::choose_scene_methods({"reference", "bvh-naive-f32"});
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[0]->name, "bvh-naive-f32");  // in the registry's order
  EXPECT_THROW((void)reports::choose_scene_methods({"reference", "bvh"}), std::runtime_error);
}

}  // namespace
}  // namespace gnomon::tests
