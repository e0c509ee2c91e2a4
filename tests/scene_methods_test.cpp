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

/// The method's answer is this one, or a certified method can't tell.
bool says(const SceneMethod& method, const scene::Scene& scene, const ShadowQuery& query, Shadow expected) {
  const Answer answer = answers_of(method, scene, {&query, 1}).front();
  return answer == static_cast<Answer>(expected) ||
         (answer == fuzz::kUndecided && method.tier == "certified");
}

struct Errors {
  std::size_t wrong = 0, undecided = 0;
};

/// The errors of each row on a workload of a scene of triangles, and of one with balls if it knows them.
template <class Check>
void on_workload(const std::string& workload, std::size_t count, Check check) {
  for (const std::string& nff : {kTrianglesNff, kBallsNff}) {
    const scene::Scene scene = single_scene(nff);
    const auto queries = fuzz::record_workload(workload, scene, slow_oracle(scene), {count, 3}).queries;
    EXPECT_GE(queries.size(), count - count / 20);
    std::vector<Answer> truths;
    for (const ShadowQuery& query : queries) {
      truths.push_back(static_cast<Answer>(exact::shadow_by_all_faces(scene, query).answer));
    }
    for (const SceneMethod& method : reports::all_scene_methods()) {
      if (!method.has_balls && !scene.balls.empty()) continue;
      const std::vector<Answer> answers = answers_of(method, scene, queries);
      Errors errors;
      for (std::size_t i = 0; i < queries.size(); ++i) {
        errors.undecided += answers[i] >= fuzz::kUndecided ? 1 : 0;
        errors.wrong += answers[i] < fuzz::kUndecided && answers[i] != truths[i] ? 1 : 0;
      }
      check(method, errors);
    }
  }
}

TEST(EveryRow, AgreesOnRandomPoints) {
  on_workload("surface", 2000, [](const SceneMethod& method, const Errors& errors) {
    const bool promises = method.promise != Promise::none;
    EXPECT_LE(errors.wrong, promises ? 0u : 2u) << method.name;
    EXPECT_LE(errors.undecided, method.tier == "certified" ? 20u : 0u) << method.name;
  });
}

TEST(EveryRow, KeepsItsPromiseOnHardQueriesAndOthersErrThere) {
  on_workload("hard", 4000, [](const SceneMethod& method, const Errors& errors) {
    if (method.promise != Promise::none) {
      EXPECT_EQ(errors.wrong, 0u) << method.name;
    } else if (!method.name.starts_with("cgal")) {
      EXPECT_GT(errors.wrong, 100u) << method.name << ": the workload is not hard";
    }
    if (method.tier != "certified") {
      EXPECT_EQ(errors.undecided, 0u) << method.name;
    }
  });
}

TEST(EveryRow, SeesAFaceThatIsFirst) {
  for (const std::string& nff : {kTrianglesNff, kBallsNff}) {
    const scene::Scene scene = single_scene(nff);
    const fuzz::Camera camera(*scene.view, 40, 30);
    std::vector<scene::RayQuery> rays;
    std::vector<std::vector<std::uint32_t>> truths;
    std::size_t hits = 0;
    for (std::size_t pixel = 0; pixel < 1200; ++pixel) {
      rays.push_back(camera.ray(pixel % 40, pixel / 40));
      truths.push_back(exact::first_hit_by_all_faces(scene, rays.back()).faces);
      hits += truths.back().empty() ? 0 : 1;
    }
    EXPECT_GT(hits, 200u);
    for (const SceneMethod& method : reports::all_scene_methods()) {
      if (!method.has_balls && !scene.balls.empty()) continue;
      std::vector<std::uint32_t> faces(rays.size(), 12345);
      method.make(scene)->first_hits(rays, faces);
      std::size_t wrong = 0, undecided = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool right = truths[i].empty()
                               ? faces[i] == scene::kNoFace
                               : std::find(truths[i].begin(), truths[i].end(), faces[i]) != truths[i].end();
        undecided += faces[i] == fuzz::kUndecidedFace ? 1 : 0;
        wrong += right || faces[i] == fuzz::kUndecidedFace ? 0 : 1;
      }
      EXPECT_LE(undecided, method.tier == "certified" ? 60u : 0u) << method.name;
      EXPECT_LE(wrong, method.promise == Promise::none ? 2u : 0u) << method.name;
    }
  }
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
    EXPECT_TRUE(says(method, scene, {below, light, 0}, Shadow::lit)) << method.name;
    EXPECT_TRUE(says(method, scene, {below, light, scene::kNoFace}, Shadow::shadowed)) << method.name;
    EXPECT_TRUE(says(method, scene, {below, light, 1}, Shadow::shadowed)) << method.name;
  }
}

TEST(OwnFaces, ThatFaceAwayAreInShadow) {
  for (const SceneMethod& method : reports::all_scene_methods()) {
    const scene::Scene scene = own_faces(false);
    EXPECT_TRUE(says(method, scene, {{0, 0, 0}, {1, 0, -2}, 0}, Shadow::facing)) << method.name;
    EXPECT_TRUE(says(method, scene, {{0, 0, 0}, {1, 0, 2}, 0}, Shadow::lit)) << method.name;
    for (const double side : {-3.0, 20.0}) {
      EXPECT_TRUE(says(method, scene, {{0, 8, 0}, {0, side, 0.5}, 1}, Shadow::lit)) << method.name;
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
    EXPECT_TRUE(says(method, scene, {{0, -8, 1.5}, {0, -8, 5}, 2}, Shadow::lit)) << method.name;
    EXPECT_TRUE(says(method, scene, {{0, -8, 1.5}, {0, -7, 0.5}, 2}, Shadow::shadowed)) << method.name;
    // A little within the ball, on the way out: the own ball doesn't block, another's would.
    EXPECT_TRUE(says(method, scene, {{0, -8, 1.4375}, {0, -8, 5}, 2}, Shadow::lit)) << method.name;
    EXPECT_TRUE(says(method, scene, {{0, -8, 1.4375}, {0, -8, 5}, scene::kNoFace}, Shadow::shadowed))
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
      const Shadow truth = queries[i].own == 0 ? Shadow::lit : Shadow::shadowed;
      if (answers[i] == fuzz::kUndecided && method.tier == "certified") continue;
      EXPECT_EQ(static_cast<Shadow>(answers[i]), truth) << method.name << " " << i;
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
