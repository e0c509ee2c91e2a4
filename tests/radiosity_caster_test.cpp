// SPDX-License-Identifier: GPL-3.0-or-later
// fast/radiosity_caster.h: claim S16, and that every option does what it says; options as text.
#include "fast/radiosity_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "exact/hierarchy.h"
#include "exact/polygons.h"
#include "fast/box_around.h"
#include "fuzz/generator.h"
#include "fuzz/list_options_text.h"
#include "scene/builtin.h"
#include "tests/radiosity_stage.h"

namespace gnomon::tests {
namespace {

using fast::FrontCorners;
using fast::ItemTree;
using fast::RadiosityCaster;
using fast::RayAnswer;
using fuzz::ListSetup;
using fuzz::parse_list_setup;

struct Outcome {
  std::vector<std::uint8_t> blocked;
  fast::CastCounters cast;
  fast::CullCounters cull;
};

Outcome outcome_of(const Stage& stage, const ListSetup& setup) {
  const ItemTree tree(stage.scene, stage.polygons, setup.tree, setup.volumes, setup.seed);
  RadiosityCaster caster(tree, stage.scene, setup.options, stage.convex);
  std::vector<fast::ReceiverSamples> samples;
  for (const Patch& p : stage.receivers)
    samples.push_back({p.reference.own, static_cast<std::uint32_t>(p.points.size()), p.reference.box});
  caster.set_receivers(samples);
  Outcome outcome;
  for (const Patch& emitter : stage.emitters) {
    caster.begin_emitter(emitter.reference);
    for (const Patch& receiver : stage.receivers) {
      if (!sees(emitter, receiver) || !sees(receiver, emitter)) continue;
      const fast::PairPoints points{receiver.points, emitter.points};
      std::vector<RayAnswer> answers(points.rays());
      caster.receive(receiver.reference, points, answers);
      for (const RayAnswer answer : answers) outcome.blocked.push_back(answer != RayAnswer::lit ? 1 : 0);
    }
  }
  outcome.cast = caster.cast_counters();
  outcome.cull = caster.cull_counters();
  return outcome;
}

constexpr const char* kSetups[] = {
    "strategy=keep-closed",
    "strategy=always-open",
    "strategy=overlap-open",
    "ratio=0",
    "ratio=0.2",
    "ratio=0.8",
    "ratio=1",
    "discard-single=off",
    "enclosure=off",
    "emitter-list=off",
    "emitter-overlap=off",
    "behind-emitter=off",
    "emitter-list=off,behind-emitter=off",
    "back-faces=on",
    "mailbox=off",
    "shadow-cache=off",
    "wait-for-miss=off",
    "min-rays=30",
    "clump=8",
    "clump=8,nested=on",
    "super-least=40,super-most=400",
    "super-least=40,super-most=400,nested=on",
    "super-least=40,super-most=400,nested=on,clump=8",
    "sorting=solid-angle",
    "sorting=nearest",
    "sorting=hits",
    "sort-planes=on",
    "weak-planes=0.1",
    "open-from-rays=30",
    "patch-planes=on",
    "patch-planes=on,behind-emitter=off,clump=4",
    "tree=sah",
    "volumes=spheres",
    "volumes=spheres,strategy=always-open",
    "volumes=spheres,patch-planes=on,clump=8,nested=on,back-faces=on",
    "strategy=overlap-open,back-faces=on,patch-planes=on,sort-planes=on,clump=16,nested=on"};

void expect_same_visibility(const Stage& stage) {
  const Outcome root = outcome_of(
      stage, parse_list_setup("min-rays=4294967295,emitter-list=off,behind-emitter=off,shadow-cache=off"));
  EXPECT_EQ(root.cull.lists, 0u);
  for (const char* text : kSetups) {
    const Outcome outcome = outcome_of(stage, parse_list_setup(std::string(text) + ",arithmetic=certified"));
    EXPECT_EQ(outcome.blocked, root.blocked) << text;
  }
}

Scene office() {
  Scene scene = scene::find_builtin("office:1")->make();
  scene.polygon_lights.resize(3);
  return scene;
}

TEST(RadiosityCaster, EveryStrategyAndOptionGivesTheVisibilityOfCastingFromTheRoot) {
  Random random(1);
  expect_same_visibility(Stage(random, office(), kSanitized ? 5 : 30, 10));
  for (int trial = 0; trial < affordable(16) && !HasFailure(); ++trial) {
    Scene scene =
        random_scene(random, {random.between(20, 120), trial % 3 == 0 ? 10 : 0, false}, Placement());
    expect_same_visibility(Stage(random, std::move(scene), 100, 4));
  }
}

/// A light inside a closed box whose lid is larger than the light, boxes about the light, and a floor.
TEST(RadiosityCaster, BackFacesOfSolidsAroundTheEmitterAreKept) {
  Random random(2);
  std::size_t culled = 0;
  for (int trial = 0; trial < 40 && !HasFailure(); ++trial) {
    scene::SceneBuilder builder;
    const auto add_box = [&](const Point3& lo, const Point3& hi) {
      builder.begin_object("box", 0, true);
      const auto corner = [&](std::size_t i) {
        return Point3{(i & 1) != 0 ? hi[0] : lo[0], (i & 2) != 0 ? hi[1] : lo[1],
                      (i & 4) != 0 ? hi[2] : lo[2]};
      };
      constexpr std::size_t kSides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
      for (const auto& side : kSides) {
        builder.add_triangle(corner(side[0]), corner(side[1]), corner(side[2]));
        builder.add_triangle(corner(side[0]), corner(side[2]), corner(side[3]));
      }
    };
    add_box({-8, -8, -1}, {8, 8, 0});
    for (int i = 0; i < 8; ++i) {
      const Point3 p{random.between(-6, 5) + 0.25, random.between(-6, 5) + 0.25, random.between(0, 5) + 0.25};
      add_box(p, {p[0] + 1, p[1] + 1, p[2] + 1.5});
    }
    // The light lies within this one, crosses its walls, or hangs below it.
    const double bottom = random.between(3, 5);
    add_box({-1.5, -1.5, bottom}, {1.5, 1.5, bottom + 2});
    const double half = random.chance(50) ? 1 : 2, z = bottom + (random.chance(70) ? 1 : -0.25);
    builder.scene().polygon_lights.push_back(
        {{{-half, -half, z}, {-half, half, z}, {half, half, z}, {half, -half, z}}});
    const Stage stage(random, builder.finish(), 100, 4);
    const Outcome all = outcome_of(stage, parse_list_setup("arithmetic=certified"));
    const Outcome fronts = outcome_of(stage, parse_list_setup("arithmetic=certified,back-faces=on"));
    EXPECT_EQ(fronts.blocked, all.blocked);
    culled += all.cull.volumes > fronts.cull.volumes;
  }
  EXPECT_GT(culled, 20u);
}

// Claim S22: a blocker that stands on the receiver's rim is culled with what only touches the receiver.
TEST(RadiosityCaster, AdjacencyToleranceLosesBlockersOnTheRim) {
  scene::SceneBuilder builder;
  builder.add_polygon(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  builder.add_polygon(
      std::vector<Point3>{{0.015625, 0, 0}, {0.015625, 1, 0}, {0.015625, 1, 1}, {0.015625, 0, 1}});
  Stage stage;
  stage.scene = builder.finish();
  stage.polygons = exact::polygons_of(stage.scene);
  Patch light, floor;
  light.points = {{0.5F, 0.5F, 1}};
  light.reference = {{{0.5F, 0.5F, 1, 0.5F, 0.5F, 1}}, {}, FrontCorners{{{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}}};
  floor.points = {{0.0078125F, 0.5F, 0}};
  floor.reference = {{{0, 0, 0, 1, 1, 0}}, {0, 2}, FrontCorners{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}};
  stage.emitters = {light};
  stage.receivers = {floor};
  EXPECT_EQ(outcome_of(stage, parse_list_setup("arithmetic=certified")).blocked,
            std::vector<std::uint8_t>{1});
  EXPECT_EQ(outcome_of(stage, parse_list_setup("arithmetic=certified,adjacency=0.02")).blocked,
            std::vector<std::uint8_t>{0});
}

TEST(RadiosityCaster, RaysAgreeWithTheExactOnesButForRounding) {
  Random random(3);
  const Stage stage(random, office(), 10, 6);
  const Outcome outcome = outcome_of(stage, {});
  const exact::Hierarchy hierarchy(stage.scene);
  std::size_t ray = 0, wrong = 0, blocked = 0;
  for (const Patch& emitter : stage.emitters) {
    for (const Patch& receiver : stage.receivers) {
      if (!sees(emitter, receiver) || !sees(receiver, emitter)) continue;
      for (const FloatPoint& p : receiver.points) {
        for (const FloatPoint& q : emitter.points) {
          const bool truth =
              hierarchy.shadow({wide(p), wide(q), receiver.reference.own.first}).answer != scene::Shadow::lit;
          wrong += truth != (outcome.blocked[ray++] != 0);
          blocked += truth;
        }
      }
    }
  }
  EXPECT_EQ(ray, outcome.blocked.size());
  EXPECT_GT(blocked, ray / 10);
  EXPECT_LT(blocked, ray);
  EXPECT_LE(wrong, ray / 1000);
}

TEST(RadiosityCaster, EveryOptionDoesWhatItSays) {
  Random random(4);
  const Stage stage(random, office(), kSanitized ? 20 : 60, 16);
  const auto run = [&](const std::string& text) { return outcome_of(stage, parse_list_setup(text)); };
  const auto tests = [](const Outcome& o) { return o.cast.boxes + o.cast.objects; };
  const Outcome standard = run(""), keep = run("strategy=keep-closed"), always = run("strategy=always-open"),
                overlap = run("strategy=overlap-open");
  // Kept closed costs least to make and most to cast at; always open has primitives alone.
  EXPECT_LT(keep.cull.volumes, standard.cull.volumes);
  EXPECT_LT(standard.cull.volumes, overlap.cull.volumes);
  EXPECT_LT(overlap.cull.volumes, always.cull.volumes);
  EXPECT_LT(keep.cull.items, always.cull.items);
  EXPECT_LT(overlap.cull.items, always.cull.items);
  EXPECT_LT(standard.cull.items, overlap.cull.items);
  EXPECT_LT(tests(standard), tests(keep));
  EXPECT_LT(tests(keep), tests(run("min-rays=4294967295")));
  EXPECT_EQ(run("open-from-rays=1000").cull, keep.cull);
  EXPECT_EQ(run("open-from-rays=64").cull, standard.cull);  // all pairs have 64 rays
  EXPECT_EQ(run("ratio=1").cull, overlap.cull);
  EXPECT_GT(run("ratio=0.8").cull.items, run("ratio=0.2").cull.items);
  EXPECT_LT(run("discard-single=off").cull.volumes, standard.cull.volumes);
  // What encloses a reference box, if not opened, is hit by every ray.
  EXPECT_GT(tests(run("enclosure=off")), 2 * tests(standard));
  // Without the emitter's list every shaft starts from the root and asks again what encloses the emitter.
  const Outcome no_list = run("emitter-list=off");
  EXPECT_GT(no_list.cull.volumes, standard.cull.volumes);
  EXPECT_GT(no_list.cull.enclosures, standard.cull.enclosures);
  EXPECT_EQ(no_list.cull.emitter_volumes, 0u);
  EXPECT_GT(run("behind-emitter=off,min-rays=4294967295").cast.boxes, run("min-rays=4294967295").cast.boxes);
  EXPECT_LT(run("back-faces=on").cull.volumes, standard.cull.volumes);
  EXPECT_GT(run("back-faces=on").cull.back_faces, 0u);
  EXPECT_GT(standard.cull.marks, 0u);
  EXPECT_EQ(run("mailbox=off").cull.marks, 0u);
  EXPECT_GT(run("mailbox=off").cast.boxes, standard.cast.boxes);
  EXPECT_EQ(run("shadow-cache=off").cast.rays, standard.blocked.size());
  EXPECT_EQ(run("shadow-cache=off").cast.cache_tests, 0u);
  EXPECT_EQ(standard.cast.rays + standard.cast.cache_hits, standard.blocked.size());
  EXPECT_GT(standard.cast.cache_hits, 0u);
  EXPECT_GT(run("wait-for-miss=off").cull.lists, standard.cull.lists);
  EXPECT_EQ(run("min-rays=64").cull, standard.cull);
  EXPECT_EQ(run("min-rays=65").cull.lists, 0u);
  EXPECT_LT(run("adjacency=0.05").cull.items, standard.cull.items);
  const Outcome clumps = run("clump=16"), nested = run("clump=16,nested=on");  // four points each
  EXPECT_GT(clumps.cull.lists, standard.cull.lists);
  EXPECT_LT(tests(clumps), tests(standard));
  EXPECT_EQ(nested.cull.lists, clumps.cull.lists + standard.cull.lists);
  EXPECT_LT(nested.cull.volumes, clumps.cull.volumes);
  EXPECT_EQ(run("clump=64").cull, standard.cull);
  const Outcome shared = run("super-least=32,super-most=400");
  EXPECT_LT(shared.cull.lists, standard.cull.lists);
  EXPECT_GT(shared.cull.lists, 0u);
  EXPECT_LT(tests(shared), tests(run("min-rays=4294967295")));
  EXPECT_LT(tests(shared), tests(run("super-least=32,super-most=32")));  // fewer share, the others have none
  for (const char* sorting : {"sorting=solid-angle", "sorting=nearest", "sorting=hits"}) {
    EXPECT_EQ(run(std::string(sorting) + ",shadow-cache=off").cull.items, run("shadow-cache=off").cull.items);
    EXPECT_NE(tests(run(sorting)), tests(standard)) << sorting;
  }
  EXPECT_LT(run("sort-planes=on").cull.planes, standard.cull.planes);
  EXPECT_EQ(run("sort-planes=on").cull.items, standard.cull.items);
  EXPECT_LT(run("weak-planes=0.2").cull.planes, standard.cull.planes);
  EXPECT_GE(run("weak-planes=0.2").cull.items, standard.cull.items);
  EXPECT_LT(run("strategy=always-open,patch-planes=on").cull.items, always.cull.items);
  EXPECT_GE(run("strategy=always-open,arithmetic=certified").cull.items, always.cull.items);
  EXPECT_NE(run("tree=sah").cull, standard.cull);
  EXPECT_NE(run("seed=2").cull, standard.cull);
  EXPECT_GT(tests(run("volumes=spheres")), tests(standard));
  EXPECT_EQ(run("").cull, standard.cull);
}

/// What receive() casts once more, and the lists that it shows.
TEST(RadiosityCaster, TimesWhatTheCacheDidNotAnswer) {
  Random random(5);
  const Stage stage(random, office(), kSanitized ? 10 : 30, 16);
  const ItemTree tree(stage.scene, stage.polygons);
  for (const char* const text : {"", "clump=16,nested=on", "wait-for-miss=off,clump=16", "min-rays=65"}) {
    RadiosityCaster caster(tree, stage.scene, parse_list_setup(text).options, stage.convex);
    std::uint64_t shown = 0, rays = 0, missed = 0, lists = 0;
    for (const Patch& emitter : stage.emitters) {
      caster.begin_emitter(emitter.reference);
      for (const Patch& receiver : stage.receivers) {
        if (!sees(emitter, receiver) || !sees(receiver, emitter)) continue;
        caster.show_lists([&](const fast::CandidateList& list, const Reference& from, const Reference& to) {
          ++shown;
          EXPECT_EQ(from.box, emitter.reference.box);
          EXPECT_EQ(fast::box_around(receiver.reference.box, to.box), receiver.reference.box);
          EXPECT_NE(list.parent, nullptr);
        });
        const fast::PairPoints points{receiver.points, emitter.points};
        std::vector<RayAnswer> answers(points.rays());
        const auto casts = [&](fast::CastRays which) {
          const std::uint64_t lists_before = caster.cull_counters().lists;
          const fast::CastCounters before = caster.cast_counters();
          caster.receive(receiver.reference, points, answers, which);
          const fast::CastCounters after = caster.cast_counters();
          return std::array{caster.cull_counters().lists - lists_before, after.rays - before.rays,
                            after.cache_tests - before.cache_tests};
        };
        const auto first = casts(fast::CastRays::all);
        caster.show_lists({});
        const std::vector<RayAnswer> found = answers;
        const auto cached =
            static_cast<std::uint64_t>(std::count(found.begin(), found.end(), RayAnswer::cached));
        EXPECT_EQ(first[1], answers.size() - cached);
        EXPECT_EQ(casts(fast::CastRays::uncached), (std::array{first[0], first[1], std::uint64_t{0}}))
            << text;
        EXPECT_EQ(casts(fast::CastRays::none), (std::array{first[0], std::uint64_t{0}, std::uint64_t{0}}))
            << text;
        EXPECT_EQ(answers, found);
        lists += first[0], rays += answers.size(), missed += first[1];
      }
    }
    EXPECT_EQ(shown, lists);
    EXPECT_EQ(lists > 0, std::string(text) != "min-rays=65");
    EXPECT_TRUE(0 < missed && missed < rays);
  }
}

TEST(ListOptionsText, ReadsBackWhatItWrites) {
  EXPECT_EQ(parse_list_setup(""), ListSetup());
  EXPECT_EQ(fuzz::text_of({}), "");
  EXPECT_EQ(fuzz::text_of(parse_list_setup("strategy=ratio-open,ratio=0.4,enclosure=on")), "");
  for (const char* text : kSetups) {
    const ListSetup setup = parse_list_setup(text);
    EXPECT_NE(setup, ListSetup()) << text;
    EXPECT_EQ(parse_list_setup(fuzz::text_of(setup)), setup) << text;
  }
  EXPECT_EQ(fuzz::text_of(parse_list_setup("seed=2,mailbox=off,strategy=keep-closed")),
            "strategy=keep-closed,mailbox=off,seed=2");
  ListSetup setup =
      parse_list_setup("ratio=0.30000001,adjacency=1e-3,weak-planes=0.5,seed=7,arithmetic=certified");
  EXPECT_EQ(setup.options.ratio, 0.3F);
  EXPECT_EQ(setup.options.adjacency, 0.001F);
  EXPECT_EQ(parse_list_setup(fuzz::text_of(setup)), setup);
  EXPECT_NE(fuzz::known_list_options().find("strategy=keep-closed|always-open|overlap-open|ratio-open"),
            std::string::npos);
}

TEST(ListOptionsText, RefusesInOneLineWhatItDoesNotKnow) {
  const auto complaint = [](const char* text) -> std::string {
    try {
      (void)parse_list_setup(text);
    } catch (const fuzz::UsageError& error) {
      return error.what();
    }
    return "";
  };
  for (const char* text : {"ratios=0.4",
                           "ratio",
                           "ratio=",
                           "ratio=1.1",
                           "ratio=-0.1",
                           "ratio=nan",
                           "ratio=0.4x",
                           "adjacency=0.5",
                           "strategy=open",
                           "enclosure=yes",
                           "clump=-1",
                           "clump=1.5",
                           "clump=4294967296",
                           "ratio=0.4,ratio=0.4",
                           "super-least=5",
                           "super-least=5,super-most=4",
                           ",",
                           "ratio=0.4,",
                           "=",
                           "seed=x",
                           "weak-planes=0.6"}) {
    const std::string what = complaint(text);
    EXPECT_EQ(what.rfind("list options: expected ", 0), 0u) << text << ": " << what;
    EXPECT_EQ(what.find('\n'), std::string::npos);
    EXPECT_NE(what.find("found \""), std::string::npos) << text;
  }
  EXPECT_NE(complaint("foo=1").find("strategy, ratio,"), std::string::npos);
  EXPECT_NE(complaint("sorting=big").find("none|solid-angle|nearest|hits"), std::string::npos);
}

}  // namespace
}  // namespace gnomon::tests
