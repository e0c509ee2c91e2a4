// SPDX-License-Identifier: GPL-3.0-or-later
// Radiosity: the pairs and steps that are recorded, candidate lists counted on them, and what is told of it.
#include "fuzz/radiosity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "exact/polygons.h"
#include "exact/shadow.h"
#include "fuzz/list_runner.h"
#include "fuzz/radiosity_steps.h"
#include "fuzz/workload.h"
#include "reports/html_radiosity.h"
#include "reports/json_node.h"
#include "reports/list_json.h"
#include "reports/radiosity_ratio.h"
#include "scene/find_scene.h"
#include "scene/input_error.h"
#include "scene/scalar.h"
#include "tests/cli_run.h"
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

namespace gnomon::reports {
namespace {

using tests::Folder;
using tests::Outcome;
using tests::run_gnomon;

/// Two rows of Table 1 as if measured on the paper's standard office.
std::vector<ListFigures> two_rows() {
  ListRate rate;
  rate.pairs = 10, rate.rays = 1000, rate.shadowed = 540, rate.uncached = 500;
  rate.boxes = 20000, rate.objects = 2300;
  rate.ray = fuzz::Spread{787, 700, 800};
  ListFigures base{"office", "table1", "baseline", "", {rate, rate}};
  rate.shafts = 50, rate.items = 400, rate.cull_tests = 1234, rate.checked = 7, rate.lacking = 1;
  rate.boxes = 14000, rate.objects = 200;
  rate.ray = fuzz::Spread{642.5, 600, 700};
  rate.list = fuzz::Spread{1000, 900, 1100};
  ListFigures closed{"office", "table1", "keep closed", "strategy=keep-closed", {rate, rate}};
  closed.rates[1].ray = fuzz::Spread{900, 800, 1000};  // slower than the baseline
  closed.rates[1].false_lit = 3;
  return {base, closed};
}

std::vector<ListFigures> read_back(const nlohmann::ordered_json& json) {
  const Json plain = Json::parse(json.dump());
  return read_lists(Node(plain, "f.json", "the top"));
}

TEST(ListFigures, AreReadBackAsTheyWereWritten) {
  const std::vector<ListFigures> rows = two_rows();
  nlohmann::ordered_json json{{"lists", lists_json(rows)}, {"measured", {{"lists", list_times_json(rows)}}}};
  const std::vector<ListFigures> read = read_back(json);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(lists_json(read), lists_json(rows));
  EXPECT_EQ(list_times_json(read), list_times_json(rows));
  EXPECT_EQ(lists_text(read), lists_text(rows));
  for (const char* const name : {"uncached", "cache_hits", "false_lit"}) {
    nlohmann::ordered_json more = json;
    more["lists"][0]["low"][name] = 1001;  // more than rays
    EXPECT_THROW((void)read_back(more), scene::InputError) << name;
  }
  json["lists"].push_back(json["lists"][0]);
  EXPECT_THROW((void)read_back(json), scene::InputError);
}

TEST(ListFigures, StandBesideThePrintedOnes) {
  const std::vector<ListFigures> rows = two_rows();
  const std::array<Table1Cell, 3> cells = table1_cells(rows, rows[1]);
  EXPECT_DOUBLE_EQ(cells[0].value, 28.4);
  EXPECT_EQ(cells[0].printed, 28.4);
  EXPECT_EQ(cells[0].direction, "same");
  EXPECT_DOUBLE_EQ(*cells[1].printed_ratio, 642.0 / 787);
  EXPECT_EQ(cells[1].direction, "same");
  EXPECT_EQ(cells[2].direction, "opposite");
  // 1000 ns a list over ten rays leave 542.5 of casting, which saves 244.5.
  EXPECT_NEAR(*break_even(rows[0], rows[1], 0), 1000 / 244.5, 1e-9);
  std::vector<ListFigures> elsewhere = rows;
  for (ListFigures& row : elsewhere) row.scene = "classroom";
  EXPECT_EQ(table1_cells(elsewhere, elsewhere[1])[0].printed, std::nullopt);
  const std::string html = radiosity_section(std::vector<MeasureFile>{{"f.json", {}, rows}});
  for (const char* const said : {"keep closed", "28.4 <small>0.64</small>", "642 <small>0.82</small>",
                                 "<b class=\"warn\">opposite</b>", "<td class=\"num bad\">3</td>"}) {
    EXPECT_NE(html.find(said), std::string::npos) << said;
  }
  EXPECT_EQ(radiosity_section({}), "");
}

TEST(RadiosityRatios, AreToTheQuickestRowThatAsksRayByRay) {
  const RadiosityTime times[] = {
      {"a", "embree", 100}, {"a", "embree-high", 80}, {"a", "mine", 20}, {"a", "embree-packet8", 1},
      {"b", "embree", 50},  {"b", "mine", 50},        {"c", "mine", 7}};
  const std::vector<RadiosityRatio> ratios = ratios_to_embree(times);
  ASSERT_EQ(ratios.size(), 4u);
  EXPECT_EQ(ratios[2].method, "mine");
  EXPECT_EQ(ratios[2].places, 2u);
  EXPECT_NEAR(ratios[2].mean, 0.5, 1e-12);
  EXPECT_EQ(ratios[2].least, 0.25);
  EXPECT_EQ(ratios[2].most, 1);
}

TEST(CommandLineRadiosity, MeasuresTellsWritesAndCompares) {
  const Folder folder;
  folder.write("s.nff", tests::kTrianglesNff);
  const Outcome run =
      run_gnomon({"measure",  "s.nff",       "--workload", "radiosity", "--rays",   "4",
                  "--rays",   "16",          "--queries",  "200",       "--rounds", "1",
                  "--method", "shaft-exact", "--method",   "bvh-exact", "--shaft",  "strategy=keep-closed",
                  "--json",   "m.json",      "--variant",  "given"},
                 folder.path());
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* const said : {"candidate lists on s.nff", "ratio open 0.8", "radiosity@16", "shaft-exact",
                                 "strategy=keep-closed", "faces each"}) {
    EXPECT_NE(run.out.find(said), std::string::npos) << said;
  }
  auto json = nlohmann::json::parse(tests::contents_of(folder / "m.json"));
  EXPECT_EQ(json.at("rows").size(), 4u);
  std::size_t by_pairs = 0;
  for (const auto& row : json.at("rows")) {
    EXPECT_EQ(row.at("unsound"), 0);
    by_pairs += row.contains("pairs") ? 1 : 0;
  }
  EXPECT_EQ(by_pairs, 2u);
  EXPECT_GT(json.at("lists").size(), 30u);
  folder.write("n.json", json.dump());
  EXPECT_EQ(run_gnomon({"compare", "m.json", "n.json"}, folder.path()).status, 0);
  json["lists"][1]["low"]["false_lit"] = 1;
  folder.write("n.json", json.dump());
  const Outcome worse = run_gnomon({"compare", "m.json", "n.json"}, folder.path());
  EXPECT_EQ(worse.status, 1);
  EXPECT_NE(worse.out.find("lists s.nff table1 keep closed low"), std::string::npos) << worse.out;
}

TEST(CommandLineRadiosity, RefusesWhatItDoesNotKnow) {
  for (const std::vector<std::string>& bad :
       {std::vector<std::string>{"--workload", "radiosity", "--rays", "5"},
        {"--rays", "4"},
        {"--workload", "radiosity@5"},
        {"--shaft", "ratio=0.5"},
        {"--workload", "radiosity", "--shaft", "ratio=2"},
        {"--workload", "radiosity", "--shaft", "ratio=0.5", "--variant", "moved"},
        {"--workload", "radiosity", "--shaft", "colour=on"}}) {
    std::vector<std::string> words{"measure", "office"};
    words.insert(words.end(), bad.begin(), bad.end());
    const Outcome run = run_gnomon(words);
    EXPECT_EQ(run.status, 2) << bad.back();
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find("expected"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace gnomon::reports
