// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring: methods that lie are caught, counts are what they say.
#include "fuzz/measure_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reports/peers/peers.h"
#include "tests/shadow_scenes.h"

namespace gnomon::fuzz {
namespace {

/// Says one thing of everything.
template <Answer kAlways>
class Parrot : public SceneCaster {
 public:
  void shadows(std::span<const scene::ShadowQuery> /*queries*/, std::span<Answer> answers) const override {
    std::fill(answers.begin(), answers.end(), kAlways);
  }
  void first_hits(std::span<const scene::RayQuery> /*rays*/, std::span<std::uint32_t> faces) const override {
    std::fill(faces.begin(), faces.end(), scene::kNoFace);
  }
  [[nodiscard]] std::size_t bytes() const override { return 42; }
};

template <Answer kAlways>
SceneMethod parrot(Promise promise) {
  return {"parrot", "naive", promise, "", "", false, true, [](const scene::Scene&) {
            return std::unique_ptr<SceneCaster>(std::make_unique<Parrot<kAlways>>());
          }};
}

Measurement measure(const SceneMethod& method, const std::vector<std::string>& workloads = {"surface"}) {
  MeasureOptions options;
  options.workload.queries = 500;
  options.workloads = workloads;
  options.methods = {&method};
  options.rounds = 2;
  Measurement measurement;
  measure_scene("s", scene::read_nff_text(tests::kBallsNff).scene, scene_variant("given"), options,
                measurement, {});
  return measurement;
}

TEST(MeasureScene, FindsBrokenPromises) {
  EXPECT_FALSE(measure(parrot<0>(Promise::none)).promise_broken());
  EXPECT_TRUE(measure(parrot<0>(Promise::never_unsound)).promise_broken());
  EXPECT_TRUE(measure(parrot<1>(Promise::never_unsound)).promise_broken());
  EXPECT_TRUE(measure(parrot<2>(Promise::never_unsound)).promise_broken());
  EXPECT_FALSE(measure(parrot<kUndecided>(Promise::never_unsound)).promise_broken());
  EXPECT_TRUE(measure(parrot<kUndecided>(Promise::always_agrees)).promise_broken());
  EXPECT_TRUE(measure(parrot<kRejected>(Promise::always_agrees)).promise_broken());
}

TEST(MeasureScene, CountsErrorsByDirection) {
  const Measurement lit = measure(parrot<0>(Promise::none)), dark = measure(parrot<1>(Promise::none));
  ASSERT_EQ(lit.rows.size(), 1u);
  const ShadowRow &a = lit.rows[0], &b = dark.rows[0];
  EXPECT_EQ(a.queries(), 500u);
  EXPECT_EQ(ShadowRow::false_lit(a.matrix), a.dark());
  EXPECT_EQ(ShadowRow::false_shadowed(a.matrix), 0u);
  EXPECT_EQ(ShadowRow::false_shadowed(b.matrix), ShadowRow::truths(b.matrix, 0));
  EXPECT_EQ(ShadowRow::wrong_reason(b.matrix), ShadowRow::truths(b.matrix, 2));
  EXPECT_GT(ShadowRow::truths(b.matrix, 2), 0u);
  EXPECT_EQ(ShadowRow::unsound(b.matrix), 500 - ShadowRow::truths(b.matrix, 1));
  EXPECT_EQ(a.faces, 2u + 64 + 2 + 1);
  EXPECT_FALSE(a.tests);
  ASSERT_EQ(lit.set_ups.size(), 1u);
  EXPECT_EQ(lit.set_ups[0].bytes, 42u);
  EXPECT_EQ(lit.times.size(), 1u);
}

TEST(MeasureScene, CountsTouchingApart) {
  const Measurement measured = measure(parrot<0>(Promise::none), {"hard"});
  const ShadowRow& row = measured.rows.at(0);
  const scene::Scene scene = tests::single_scene(tests::kBallsNff);
  std::array<std::uint64_t, 3> touching{};
  for (const scene::ShadowQuery& query :
       record_workload("hard", scene, tests::slow_oracle(scene), {500, 1}).queries) {
    const exact::ShadowTruth truth = exact::shadow_by_all_faces(scene, query);
    touching[static_cast<std::size_t>(truth.answer)] += truth.touching ? 1 : 0;
  }
  EXPECT_GT(touching[1], 10u);
  for (std::size_t truth = 0; truth < 3; ++truth) {
    EXPECT_EQ(ShadowRow::truths(row.touching, truth), touching[truth]) << truth;
  }
  EXPECT_EQ(ShadowRow::unsound(row.touching), touching[1] + touching[2]);
}

/// Says one number of every ray.
template <std::uint32_t kAlways>
class HitParrot : public Parrot<0> {
 public:
  void first_hits(std::span<const scene::RayQuery> /*rays*/, std::span<std::uint32_t> faces) const override {
    std::fill(faces.begin(), faces.end(), kAlways);
  }
};

template <std::uint32_t kAlways>
SceneMethod hit_parrot(Promise promise) {
  return {"parrot", "naive", promise, "", "", false, true, [](const scene::Scene&) {
            return std::unique_ptr<SceneCaster>(std::make_unique<HitParrot<kAlways>>());
          }};
}

TEST(MeasureScene, JudgesFirstHitsByAllFacesThatTie) {
  const scene::Scene scene = tests::single_scene(tests::kBallsNff);
  const std::vector<scene::RayQuery> rays = record_rays("hard-rays", scene, {500, 1});
  std::uint64_t misses = 0, first = 0, ties = 0, touching = 0;
  for (const scene::RayQuery& ray : rays) {
    const exact::FirstHit hit = exact::first_hit_by_all_faces(scene, ray);
    misses += hit.faces.empty() ? 1 : 0;
    first += std::find(hit.faces.begin(), hit.faces.end(), 1U) != hit.faces.end() ? 1 : 0;
    ties += hit.faces.size() > 1 ? 1 : 0;
    touching += hit.touching ? 1 : 0;
  }
  ASSERT_GT(misses, 20u);
  ASSERT_GT(first, 20u);
  ASSERT_GT(ties, 20u);
  ASSERT_GT(touching, 20u);

  const Measurement one = measure(hit_parrot<1>(Promise::none), {"hard-rays"});
  EXPECT_TRUE(one.rows.empty());
  ASSERT_EQ(one.hit_rows.size(), 1u);
  ASSERT_EQ(one.hit_times.size(), 1u);
  const FirstHitRow& row = one.hit_rows[0];
  EXPECT_EQ(row.queries(), rays.size());
  EXPECT_EQ(row.ties, ties);
  EXPECT_EQ(FirstHitRow::truths(row.touching, 0) + FirstHitRow::truths(row.touching, 1), touching);
  EXPECT_EQ(row.matrix[1][FirstHitRow::right], first);
  EXPECT_EQ(FirstHitRow::false_hit(row.matrix), misses);
  EXPECT_EQ(FirstHitRow::false_miss(row.matrix), 0u);
  EXPECT_EQ(FirstHitRow::wrong_face(row.matrix), rays.size() - misses - first);
  const Measurement none = measure(hit_parrot<scene::kNoFace>(Promise::none), {"hard-rays"});
  EXPECT_EQ(FirstHitRow::false_miss(none.hit_rows.at(0).matrix), rays.size() - misses);
  EXPECT_EQ(FirstHitRow::unsound(none.hit_rows.at(0).matrix), rays.size() - misses);
}

TEST(MeasureScene, FindsBrokenPromisesOfFirstHit) {
  const std::vector<std::string> rays{"hard-rays"};
  EXPECT_FALSE(measure(hit_parrot<1>(Promise::none), rays).promise_broken());
  EXPECT_TRUE(measure(hit_parrot<1>(Promise::never_unsound), rays).promise_broken());
  EXPECT_TRUE(measure(hit_parrot<scene::kNoFace>(Promise::never_unsound), rays).promise_broken());
  EXPECT_FALSE(measure(hit_parrot<kUndecidedFace>(Promise::never_unsound), rays).promise_broken());
  EXPECT_TRUE(measure(hit_parrot<kUndecidedFace>(Promise::always_agrees), rays).promise_broken());
  // A number of no face is no answer.
  const SceneMethod method = hit_parrot<1000>(Promise::always_agrees);  // rows point to it
  const Measurement rejected = measure(method, rays);
  EXPECT_TRUE(rejected.promise_broken());
  const FirstHitRow& row = rejected.hit_rows.at(0);
  EXPECT_EQ(FirstHitRow::column(row.matrix, FirstHitRow::rejected), row.queries());
}

TEST(MeasureScene, SaysWhatItLeavesOut) {
  const auto methods = reports::choose_scene_methods({"cgal-epick"});
  const Measurement measured = measure(*methods.front(), {"surface", "emitter"});
  EXPECT_TRUE(measured.rows.empty());
  ASSERT_EQ(measured.notes.size(), 3u);
  EXPECT_NE(measured.notes[0].find("rounded to floats"), std::string::npos) << measured.notes[0];
  EXPECT_NE(measured.notes[1].find("cgal-epick left out"), std::string::npos) << measured.notes[1];
  EXPECT_NE(measured.notes[2].find("emitter left out"), std::string::npos) << measured.notes[2];
}

TEST(MeasureScene, RefusesScenesBeyondTheRangeOfFloats) {
  scene::Scene scene = scene::read_nff_text("s 0 0 0 1e38\n").scene;
  MeasureOptions options;
  Measurement measurement;
  EXPECT_THROW(measure_scene("s", scene, scene_variant("scaled-up"), options, measurement, {}),
               std::runtime_error);
}

TEST(Spread, IsOfQuartiles) {
  const Spread five = spread_of({5, 1, 4, 2, 3});
  EXPECT_EQ(five.median, 3);
  EXPECT_EQ(five.low25, 2);
  EXPECT_EQ(five.high75, 4);
  const Spread two = spread_of({2, 1});
  EXPECT_EQ(two.median, 1.5);
  EXPECT_EQ(two.low25, 1.25);
  EXPECT_EQ(spread_of({7}).high75, 7);
}

}  // namespace
}  // namespace gnomon::fuzz
