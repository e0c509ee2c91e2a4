// SPDX-License-Identifier: GPL-3.0-or-later
// Workloads: what is recorded, and that it is the same each time.
#include "fuzz/workload.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "fuzz/camera.h"
#include "fuzz/scene_variant.h"
#include "scene/scalar.h"
#include "tests/shadow_scenes.h"

namespace gnomon::fuzz {
namespace {

using scene::ShadowQuery;
using tests::single_scene;
using tests::slow_oracle;

std::vector<ShadowQuery> record(const std::string& name, const scene::Scene& scene,
                                const WorkloadOptions& options) {
  return record_workload(name, scene, slow_oracle(scene), options).queries;
}

scene::Scene lamp_scene() {
  scene::Scene scene = single_scene(tests::kBallsNff);
  scene.polygon_lights.push_back({{{-1, -1, 4}, {1, -1, 4}, {1, 1, 4}, {-1, 1, 4}}});
  return scene;
}

TEST(Workloads, HoldFloatsAndFacesOfTheSceneAndNoMoreThanAskedFor) {
  const scene::Scene scene = lamp_scene();
  for (const WorkloadKind& kind : workload_kinds()) {
    for (const std::size_t count : {1UL, 7UL, 1000UL}) {
      const std::vector<ShadowQuery> queries = record(std::string(kind.name), scene, {count, 1});
      EXPECT_LE(queries.size(), count) << kind.name;
      if (count == 1000) {
        EXPECT_GE(queries.size(), 600u) << kind.name;
      }
      for (const ShadowQuery& query : queries) {
        for (const double c : query.point) ASSERT_TRUE(scene::is_float(c) && std::isfinite(c)) << kind.name;
        for (const double c : query.light) ASSERT_TRUE(scene::is_float(c) && std::isfinite(c)) << kind.name;
        ASSERT_TRUE(query.own == scene::kNoFace || query.own < scene.face_count()) << kind.name;
      }
    }
  }
}

TEST(Workloads, AreTheSameEachTimeAndOthersForOtherSeeds) {
  const scene::Scene scene = lamp_scene();
  for (const WorkloadKind& kind : workload_kinds()) {
    const std::string name(kind.name);
    const std::vector<ShadowQuery> first = record(name, scene, {500, 1});
    EXPECT_EQ(first, record(name, scene, {500, 1})) << name;
    const bool same = first == record(name, scene, {500, 2});
    EXPECT_EQ(same, name == "primary") << name;  // pixels are where they are
  }
}

TEST(Workloads, HaveBothAnswers) {
  const scene::Scene scene = lamp_scene();
  for (const WorkloadKind& kind : workload_kinds()) {
    std::size_t lit = 0, dark = 0;
    for (const ShadowQuery& query : record(std::string(kind.name), scene, {1000, 1})) {
      const bool is_lit = exact::shadow_by_all_faces(scene, query).answer == scene::Shadow::lit;
      (is_lit ? lit : dark) += 1;
    }
    EXPECT_GT(lit, 100u) << kind.name;
    // Most of the polygons are sides of the cone, which little hides from the lamp.
    EXPECT_GT(dark, kind.name == "radiosity" ? 0U : 50U) << kind.name;
  }
}

TEST(Workloads, EmitterAsksPointsOfPolygonLights) {
  EXPECT_TRUE(record("emitter", single_scene(tests::kBallsNff), {1000, 1}).empty());
  const std::vector<ShadowQuery> queries = record("emitter", lamp_scene(), {1000, 1});
  double least = 1, most = -1;
  for (const ShadowQuery& query : queries) {
    EXPECT_EQ(query.light[2], 4);
    EXPECT_TRUE(std::fabs(query.light[0]) <= 1 && std::fabs(query.light[1]) <= 1);
    least = std::min(least, query.light[0]);
    most = std::max(most, query.light[0]);
  }
  EXPECT_TRUE(least < -0.8 && most > 0.8);  // all over it
}

TEST(RayWorkloads, HoldFloatsAndAreTheSameEachTime) {
  for (const std::string& nff : {tests::kBallsNff, tests::kTrianglesNff, std::string("s 0 0 0 1\n")}) {
    const scene::Scene scene = single_scene(nff);
    for (const WorkloadKind& kind : ray_workload_kinds()) {
      for (const std::size_t count : {1UL, 7UL, 1000UL}) {
        const std::vector<scene::RayQuery> rays = record_rays(kind.name, scene, {count, 1});
        EXPECT_LE(rays.size(), count) << kind.name;
        EXPECT_GE(rays.size(), count == 1000 ? 300u : 1u) << kind.name;
        EXPECT_EQ(rays, record_rays(kind.name, scene, {count, 1}));
        for (const scene::RayQuery& ray : rays) {
          for (const double c : ray.origin) ASSERT_TRUE(scene::is_float(c) && std::isfinite(c)) << kind.name;
          for (const double c : ray.direction) ASSERT_TRUE(scene::is_float(c) && std::isfinite(c));
          ASSERT_NE(ray.direction, (std::array<double, 3>{})) << kind.name;
          ASSERT_TRUE(ray.own == scene::kNoFace || ray.own < scene.face_count()) << kind.name;
        }
      }
      EXPECT_EQ(record_rays(kind.name, scene, {500, 1}) == record_rays(kind.name, scene, {500, 2}),
                kind.name == "primary-rays");
    }
  }
  EXPECT_TRUE(record_rays("hard-rays", scene::Scene{}, {10, 1}).empty());
  EXPECT_THROW((void)record_rays("primary", single_scene(tests::kBallsNff), {}), std::runtime_error);
  EXPECT_THROW((void)record("hard-rays", single_scene(tests::kBallsNff), {}), std::runtime_error);
}

TEST(RayWorkloads, HardOnesTieTouchRunAlongAxesAndLeaveSurfaces) {
  const scene::Scene scene = single_scene(tests::kBallsNff);
  std::size_t ties = 0, touching = 0, parallel = 0, own = 0, misses = 0;
  for (const scene::RayQuery& ray : record_rays("hard-rays", scene, {4000, 1})) {
    const exact::FirstHit hit = exact::first_hit_by_all_faces(scene, ray);
    ties += hit.faces.size() > 1 ? 1 : 0;
    touching += hit.touching ? 1 : 0;
    misses += hit.faces.empty() ? 1 : 0;
    parallel += std::count(ray.direction.begin(), ray.direction.end(), 0.0) == 2 ? 1 : 0;
    own += ray.own != scene::kNoFace ? 1 : 0;
  }
  EXPECT_GE(ties, 300u);
  EXPECT_GE(touching, 200u);
  EXPECT_GE(parallel, 600u);
  EXPECT_GE(own, 1000u);
  EXPECT_GE(misses, 400u);
}

TEST(Workloads, ThatDoNotExistAreRefused) {
  EXPECT_THROW((void)record("primry", single_scene(tests::kBallsNff), {}), std::runtime_error);
}

bool are_neighbours(const ShadowQuery& a, const ShadowQuery& b) {
  if (a.light != b.light || a.own != b.own || a.point == b.point) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = static_cast<float>(a.point[k]), y = static_cast<float>(b.point[k]);
    if (x != y && std::nextafter(x, y) != y) return false;
  }
  return true;
}

TEST(HardWorkload, HasBoundariesToTheLastBitTouchingAndAxisParallelSegments) {
  const scene::Scene scene = single_scene(tests::kBallsNff);
  const std::vector<ShadowQuery> queries = record("hard", scene, {4000, 1});
  std::size_t boundaries = 0, touching = 0, parallel = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const exact::ShadowTruth truth = exact::shadow_by_all_faces(scene, queries[i]);
    touching += truth.touching ? 1 : 0;
    int equal = 0;
    for (std::size_t k = 0; k < 3; ++k) equal += queries[i].point[k] == queries[i].light[k] ? 1 : 0;
    parallel += equal == 2 ? 1 : 0;
    if (i + 1 < queries.size() && are_neighbours(queries[i], queries[i + 1])) {
      boundaries += exact::shadow_by_all_faces(scene, queries[i + 1]).answer != truth.answer ? 1 : 0;
    }
  }
  EXPECT_GE(boundaries, 200u);
  EXPECT_GE(touching, 100u);
  EXPECT_GE(parallel, 500u);
}

TEST(Thinning, IsEvenAndKeepsTheOrder) {
  std::vector<ShadowQuery> queries(1000);
  for (std::size_t i = 0; i < queries.size(); ++i) queries[i].point[0] = static_cast<double>(i);
  std::vector<ShadowQuery> few = queries;
  thin(few, 300);
  ASSERT_EQ(few.size(), 300u);
  for (std::size_t i = 0; i + 1 < few.size(); ++i) {
    const double step = few[i + 1].point[0] - few[i].point[0];
    EXPECT_TRUE(step == 3 || step == 4) << i;
  }
  EXPECT_GE(few.back().point[0], 990);
  thin(queries, 1000);
  EXPECT_EQ(queries.size(), 1000u);
  thin(queries, 0);
  EXPECT_TRUE(queries.empty());
}

TEST(ShuffledOrder, IsAPermutation) {
  std::vector<std::uint32_t> order = shuffled_order(1000);
  EXPECT_EQ(order, shuffled_order(1000));
  std::size_t in_place = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) in_place += order[i] == i ? 1 : 0;
  EXPECT_LT(in_place, 10u);
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(order[i], i);
  EXPECT_TRUE(shuffled_order(0).empty());
}

TEST(PictureSize, KeepsProportionsAndStaysBelow) {
  scene::View view;
  view.columns = 400, view.rows = 300;
  EXPECT_EQ(picture_size(view, 1'000'000), (std::array<std::size_t, 2>{400, 300}));
  EXPECT_EQ(picture_size(view, 1200), (std::array<std::size_t, 2>{40, 30}));
  EXPECT_EQ(picture_size(view, 1), (std::array<std::size_t, 2>{1, 1}));
  view.columns = 1'000'000, view.rows = 1;
  EXPECT_EQ(picture_size(view, 100), (std::array<std::size_t, 2>{100, 1}));
}

TEST(Variants, MoveAndScaleEverything) {
  const scene::Scene scene = lamp_scene();
  EXPECT_EQ(transformed(scene, scene_variant("given")), scene);
  const scene::Scene up = transformed(scene, scene_variant("scaled-up"));
  EXPECT_EQ(up.balls[0].radius, 0x1p30 * scene.balls[0].radius);
  EXPECT_EQ(up.points[5][1], 0x1p30 * scene.points[5][1]);
  EXPECT_EQ(up.view->from[0], 0x1p30 * scene.view->from[0]);
  const scene::Scene moved = transformed(scene, scene_variant("moved"));
  EXPECT_EQ(moved.balls[0].radius, scene.balls[0].radius);
  EXPECT_EQ(moved.point_lights[1].position[2], scene.point_lights[1].position[2] + 1e5);
  EXPECT_EQ(moved.polygon_lights[0].corners[3][0], scene.polygon_lights[0].corners[3][0] + 1e5);
  EXPECT_THROW((void)scene_variant("turned"), std::runtime_error);
}

// Powers of two change no answer: the same queries, the same truth.
TEST(Variants, ByPowersOfTwoAskTheSame) {
  const scene::Scene scene = single_scene(tests::kBallsNff);
  for (const char* name : {"scaled-up", "scaled-down"}) {
    const SceneVariant& variant = scene_variant(name);
    const scene::SingleScene scaled = scene::rounded_to_floats(transformed(scene, variant));
    EXPECT_EQ(scaled.moved, 0u) << name;
    const std::vector<ShadowQuery> queries = record("surface", scene, {300, 1}),
                                   others = record("surface", scaled.scene, {300, 1});
    ASSERT_EQ(queries.size(), others.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      EXPECT_EQ(others[i].point[0], variant.scale * queries[i].point[0]);
      EXPECT_EQ(exact::shadow_by_all_faces(scaled.scene, others[i]),
                exact::shadow_by_all_faces(scene, queries[i]));
    }
  }
}

/// FNV-1a over the bits of the numbers, and own faces.
class Fingerprint {
 public:
  void add(const std::array<double, 3>& numbers) {
    for (const double x : numbers) add(std::bit_cast<std::uint64_t>(x));
  }
  void add(std::uint64_t bits) { value_ = (value_ ^ bits) * 0x100000001b3; }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

// Results are compared between builds: compilers and libraries must not change what is asked.
TEST(Workloads, AreTheSameFromAllCompilers) {
  const scene::Scene scene = lamp_scene();
  const auto of_shadow = [&](const std::string& name) {
    Fingerprint print;
    for (const ShadowQuery& query : record(name, scene, {500, 1})) {
      print.add(query.point);
      print.add(query.light);
      print.add(std::uint64_t{query.own});
    }
    return print.value();
  };
  EXPECT_EQ(of_shadow("surface"), 15694200070336959381u);
  EXPECT_EQ(of_shadow("light-rays"), 7021727982918559u);
  EXPECT_EQ(of_shadow("emitter"), 7355379240816975032u);
  EXPECT_EQ(of_shadow("hard"), 17068271923859782451u);
  EXPECT_EQ(of_shadow("radiosity@16"), 9125571029771864089u);
  Fingerprint hard_rays;
  for (const scene::RayQuery& ray : record_rays("hard-rays", scene, {500, 1})) {
    hard_rays.add(ray.origin);
    hard_rays.add(ray.direction);
    hard_rays.add(std::uint64_t{ray.own});
  }
  EXPECT_EQ(hard_rays.value(), 17001985880014952240u);
}

}  // namespace
}  // namespace gnomon::fuzz
