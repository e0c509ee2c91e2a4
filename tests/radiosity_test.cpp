// SPDX-License-Identifier: GPL-3.0-or-later
// Radiosity: the pairs and steps that are recorded, and candidate lists counted on them.
#include "fuzz/radiosity.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact/polygons.h"
#include "exact/shadow.h"
#include "fuzz/list_runner.h"
#include "fuzz/radiosity_steps.h"
#include "fuzz/workload.h"
#include "scene/find_scene.h"
#include "scene/scalar.h"
#include "tests/shadow_scenes.h"

namespace gnomon::fuzz {
namespace {

using tests::single_scene;

/// A floor, a screen above it that leaves two points of the floor in light, and a lamp above both.
scene::Scene screened_floor() {
  scene::Scene scene = single_scene(
      "v\nfrom 9 9 9\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 8 8\nl 0 0 9\nf 1 1 1 1 0 0 0 1\n"
      "p 4\n-4 -4 0\n4 -4 0\n4 4 0\n-4 4 0\np 4\n-1 -1 2\n1 -1 2\n1 1 2\n-1 1 2\n");
  scene.polygon_lights.push_back({{{-1, -1, 4}, {1, -1, 4}, {1, 1, 4}, {-1, 1, 4}}});
  return scene;
}

/// Planes that no float lies on, in general, and polygons of three to twelve corners.
scene::Scene oblique_scene() {
  scene::Scene scene = single_scene(tests::kTrianglesNff);
  scene.polygon_lights.push_back({{{-1, -1, 4}, {1.1, -0.9, 4.2}, {0.7, 1, 4.1}}});
  return scene::rounded_to_floats(scene).scene;
}

bool is_shadowed(const scene::Scene& scene, const scene::ShadowQuery& query) {
  return exact::shadow_by_all_faces(scene, query).answer == scene::Shadow::shadowed;
}

TEST(Radiosity, PointsAreFloatsOnOrBeforeTheirPatchesAndFaceAsAWhole) {
  std::size_t off_the_plane = 0, rays = 0;
  for (const scene::Scene& scene : {oblique_scene(), screened_floor()}) {
    const std::vector<RadiosityPatch> patches = patches_of(scene), lights = light_patches_of(scene);
    const std::vector<RadiosityPair> pairs = record_pairs(scene, {16, 1000, 1});
    ASSERT_GE(pairs.size(), 60u);
    for (const RadiosityPair& pair : pairs) {
      const RadiosityPatch &from = patches[pair.receiver], &to = lights[pair.emitter];
      EXPECT_EQ(pair.rays(), 16u);
      for (const auto& [samples, patch, other] :
           {std::tuple{&pair.from, &from, &to}, std::tuple{&pair.to, &to, &from}}) {
        for (const Vector3& point : samples->points) {
          EXPECT_GE(side_of(*patch, point), 0);
          EXPECT_GT(side_of(*other, point), 0);
          off_the_plane += side_of(*patch, point) > 0 ? 1 : 0;
          for (int axis = 0; axis < 3; ++axis) {
            const double c = point[static_cast<std::size_t>(axis)];
            EXPECT_TRUE(scene::is_float(c));
            EXPECT_TRUE(samples->box.lo(axis) <= c && c <= samples->box.hi(axis));
          }
        }
      }
      for (std::size_t i = 0; i < pair.rays(); ++i) {
        scene::ShadowQuery query = pair.query(i);
        EXPECT_TRUE(pair.from.own.contains(query.own));
        const bool shadowed = is_shadowed(scene, query);
        query.own = scene::kNoFace;  // leaving out the own face must change nothing
        EXPECT_EQ(is_shadowed(scene, query), shadowed);
        ++rays;
      }
    }
  }
  EXPECT_GT(off_the_plane, 100u) << "no point had to be moved";
  EXPECT_GT(rays, 1500u);
}

TEST(Radiosity, IsTheSameEachTimeAndHasOtherPairsForOtherSeeds) {
  const scene::Scene scene = oblique_scene();
  const auto queries = [&](std::uint64_t seed) { return queries_of(record_pairs(scene, {4, 400, seed})); };
  EXPECT_EQ(queries(1).size(), 400u);
  EXPECT_EQ(queries(1), queries(1));
  EXPECT_NE(queries(1), queries(2));
  scene::Scene dark = scene;  // without polygon lights its polygons send
  dark.polygon_lights.clear();
  const std::vector<RadiosityPair> pairs = record_pairs(dark, {4, 400, 1});
  EXPECT_EQ(pairs.size(), 100u);
  for (const RadiosityPair& pair : pairs) EXPECT_GT(pair.to.own.count, 0u);
}

TEST(Radiosity, PointsThatDoNotFaceAreLeftOut) {
  const scene::Scene scene = screened_floor();
  const RadiosityPatch floor = patches_of(scene).front(), lamp = light_patches_of(scene).front();
  const Vector3 from[] = {{0, 0, 0}, {0, 0, 4}, {1, 0, 5}}, to[] = {{0, 0, 4}, {0, 0, 0}, {1, 1, -1}};
  const RadiosityPair pair = facing_pair(scene, floor, from, lamp, to);
  EXPECT_EQ(pair.from.points, (std::vector<Vector3>{from[0]}));
  EXPECT_EQ(pair.to.points, (std::vector<Vector3>{to[0]}));
}

TEST(Radiosity, StepsBeginWithTheLightsAndGoOnWithTheBrightest) {
  const scene::Scene scene = screened_floor();
  const std::vector<RadiosityStep> steps =
      record_steps(scene, [&](const auto& query) { return is_shadowed(scene, query); }, {3, 2, 0.5});
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_TRUE(steps[0].emitter.is_light());
  ASSERT_EQ(steps[0].pairs.size(), 2u);
  EXPECT_EQ(steps[0].pairs[0].rays(), 4u * 256);
  // The screen gets more than the floor, but is a sixteenth of its size; nothing faces either.
  EXPECT_EQ(steps[1].emitter.area, 64);
  EXPECT_EQ(steps[2].emitter.area, 4);
  EXPECT_EQ(steps[1].pairs.size() + steps[2].pairs.size(), 0u);
  const std::vector<bool>& hidden = steps[0].hidden[0];
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    EXPECT_EQ(hidden[i], is_shadowed(scene, steps[0].pairs[0].query(i)));
  }
}

TEST(Radiosity, LightsShineWhereTheSceneLies) {
  scene::Scene scene = screened_floor();
  const auto front = [&] { return side_of(light_patches_of(scene).front(), {0, 0, 0}); };
  EXPECT_EQ(front(), 1);
  std::reverse(scene.polygon_lights[0].corners.begin(), scene.polygon_lights[0].corners.end());
  EXPECT_EQ(front(), 1);
  for (auto& point : scene.points) point[2] = 8 - point[2];
  EXPECT_EQ(front(), -1);
}

TEST(Radiosity, PatchesAreMeshedAsWideAsAsked) {
  const std::vector<RadiosityPatch> patches = patches_of(screened_floor());
  ASSERT_EQ(patches.size(), 2u);
  EXPECT_EQ(patches[0].corners.size(), 4u);
  EXPECT_EQ(patches[0].area, 64);
  EXPECT_EQ(mesh_of(patches[0], 1).size(), 64u);
  EXPECT_EQ(mesh_of(patches[0], 0.3).size(), 27u * 27u);
  EXPECT_EQ(mesh_of(patches[1], 8).size(), 4u);  // as many as corners, at the least
  EXPECT_EQ(samples_of(patches[1], 1), (std::vector<Vector3>{{0, 0, 2}}));
  EXPECT_EQ(samples_of(patches[1], 2).size(), 4u);
}

TEST(Radiosity, WorkloadsAreNamedByTheRaysOfAPair) {
  EXPECT_EQ(pair_rays_of("radiosity"), 64u);
  EXPECT_EQ(pair_rays_of("radiosity@400"), 400u);
  for (const char* const bad : {"radiosity@", "radiosity@0", "radiosity@15", "radiosity@016",
                                "radiosity@10201", "radiosity@4x", "radiosity@-4"}) {
    EXPECT_THROW((void)workload_kind(bad), std::runtime_error) << bad;
  }
  const scene::Scene scene = screened_floor();
  const Workload workload = record_workload("radiosity@9", scene, tests::slow_oracle(scene), {100, 1});
  EXPECT_EQ(workload.pairs.size(), 11u);
  EXPECT_EQ(workload.queries.size(), 99u);
}

/// One pair whose rays are known: three points of the floor at one light, two behind the screen.
struct KnownStep {
  scene::Scene scene = screened_floor();
  std::vector<RadiosityStep> steps;

  KnownStep() {
    const RadiosityPatch floor = patches_of(scene).front(), lamp = light_patches_of(scene).front();
    const Vector3 points[] = {{0, 0, 0}, {0.5, 0.5, 0}, {3.5, 3.5, 0}}, light[] = {{0, 0, 4}};
    RadiosityStep step{lamp, {facing_pair(scene, floor, points, lamp, light)}, {{true, true, false}}};
    steps.push_back(step);
  }
  ListCounts count(const ListSpec& spec, const fast::OnList& on_list = {}) const {
    const fast::ItemTree tree(scene, exact::polygons_of(scene));
    ListRunner runner(scene, tree, spec, {});
    const std::vector<ListStep> ready = list_steps_of(steps);
    const ListCounts counts = runner.count(ready, on_list);
    EXPECT_GT(runner.time(ready, true), 0);
    return counts;
  }
};

TEST(ListStatistics, CountsOfThreeKnownRays) {
  const KnownStep known;
  // The list is the screen alone. The first ray meets its box and it; the second is the cache's; the third is
  // not, and misses the box.
  const ListCounts open = known.count({"", ListStart::lists, parse_list_setup("strategy=always-open")});
  EXPECT_EQ(open.rays, 3u);
  EXPECT_EQ(open.shadowed, 2u);
  EXPECT_EQ(open.cast.rays, 2u);
  EXPECT_EQ(open.cast.cache_tests, 2u);
  EXPECT_EQ(open.cast.cache_hits, 1u);
  EXPECT_EQ(open.cast.boxes, 2u);
  EXPECT_EQ(open.cast.objects, 1u);
  EXPECT_EQ(open.cull.lists, 1u);
  EXPECT_EQ(open.cull.items, 1u);
  EXPECT_EQ(open.false_lit + open.false_shadowed, 0u);
  // From the root, without the cache: every ray meets the root's box, then the screen's; the floor is its
  // own.
  const ListCounts root = known.count(uncached_spec());
  EXPECT_EQ(root.cast.rays, 3u);
  EXPECT_EQ(root.cast.boxes, 6u);
  EXPECT_EQ(root.cast.objects, 2u);
  EXPECT_EQ(root.cull.lists, 0u);
}

TEST(ListStatistics, WrongAnswersAreCounted) {
  KnownStep known;
  known.steps[0].hidden = {{true, false, true}};
  const ListCounts counts = known.count(table1_specs().back());
  EXPECT_EQ(counts.false_shadowed, 1u);
  EXPECT_EQ(counts.false_lit, 1u);
}

/// A box on the emitter, over its sample: every ray leaves through a side that looks away from the emitter.
TEST(ListStatistics, BackFacesOfABodyOnTheEmitterAreKept) {
  scene::Scene scene = single_scene(
      "v\nfrom 9 9 9\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 8 8\nl 0 0 9\nf 1 1 1 1 0 0 0 1\n"
      "p 4\n-4 -4 0\n4 -4 0\n4 4 0\n-4 4 0\np 4\n-4 -4 4\n-4 4 4\n4 4 4\n4 -4 4\n");
  const auto first = static_cast<std::uint32_t>(scene.points.size());
  for (int i = 0; i < 8; ++i) scene.points.push_back({i % 2 - 0.5, i / 2 % 2 - 0.5, i / 4 + 0.0});
  scene::Object box{"box", scene.triangles.size(), 12, 0, 0, 0, true, true};
  const std::uint32_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& s : sides) {
    scene.triangles.push_back({first + s[0], first + s[1], first + s[2]});
    scene.triangles.push_back({first + s[0], first + s[2], first + s[3]});
  }
  scene.objects.push_back(box);
  ASSERT_TRUE(scene::is_valid(scene));
  const std::vector<RadiosityPatch> patches = patches_of(scene);
  const Vector3 points[] = {{0, 0, 4}, {1, 2, 4}, {-3, 3, 4}}, samples[] = {{0.25, 0.25, 0}, {3, 3, 0}};
  RadiosityStep step{patches[0], {facing_pair(scene, patches[1], points, patches[0], samples)}, {{}}};
  std::size_t blocked = 0;
  for (std::size_t i = 0; i < step.pairs[0].rays(); ++i) {
    step.hidden[0].push_back(is_shadowed(scene, step.pairs[0].query(i)));
    blocked += step.hidden[0].back() ? 1 : 0;
  }
  EXPECT_EQ(blocked, 3u);
  const fast::ItemTree tree(scene, exact::polygons_of(scene));
  std::vector<std::uint8_t> convex(scene.objects.size(), 0);
  convex.back() = 1;
  for (const char* const setup : {"back-faces=on", "back-faces=on,arithmetic=certified"}) {
    for (const bool tight : {false, true}) {
      ListRunner runner(scene, tree, {"", ListStart::lists, parse_list_setup(setup), tight}, convex);
      const ListCounts counts = runner.count(list_steps_of({step}), {});
      EXPECT_EQ(counts.false_lit + counts.false_shadowed, 0u) << setup;
    }
  }
}

TEST(ListStatistics, ListsOfAScene) {
  const scene::Scene scene = scene::rounded_to_floats(scene::find_scene("office:1").loaded.scene).scene;
  const ListMeasureOptions options{
      {{"lossy", ListStart::lists, parse_list_setup("adjacency=0.45"), false}}, 1, 40, 2};
  const std::vector<ListRow> rows = measure_lists("office:1", scene, options, {});
  ASSERT_EQ(rows.size(), table1_specs().size() + text_specs().size() + option_specs().size() + 2);
  for (const ListRow& row : rows) {
    for (std::size_t rate = 0; rate < row.rates; ++rate) {
      const ListCounts& c = row.counts[rate];
      EXPECT_EQ(c.rays, rows[0].counts[rate].rays);
      EXPECT_EQ(c.shadowed, rows[0].counts[rate].shadowed);
      EXPECT_EQ(c.cast.rays + c.cast.cache_hits, c.rays) << row.spec.name;
      EXPECT_GE(c.cast.boxes, c.cast.objects);
      EXPECT_GE(row.times[rate].ray.median, 0);
      const bool tolerant = row.spec.setup.options.adjacency > 0;
      if (!tolerant) {
        EXPECT_EQ(c.false_lit + c.false_shadowed, 0u) << row.spec.name;
        EXPECT_EQ(c.lacking, 0u) << row.spec.name;
      } else if (row.spec.name == "lossy") {
        EXPECT_GT(c.lacking, 0u);
      }
      if (row.spec.start == ListStart::lists) {
        EXPECT_GT(c.checked, 0u) << row.spec.name;
        EXPECT_GT(c.cull.lists, 0u) << row.spec.name;
      }
    }
  }
}

}  // namespace
}  // namespace gnomon::fuzz
