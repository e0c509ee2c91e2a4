// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/hierarchy.h"

#include <gtest/gtest.h>

#include <limits>

#include "exact/first_hit.h"
#include "exact/hierarchy.h"
#include "exact/shadow.h"
#include "tests/batch_cases.h"
#include "tests/fast_hierarchy_truth.h"
#include "tests/hard_scenes.h"

namespace gnomon::tests {

using fast::Hierarchy;
using fast::ShadowAnswer;
using Tier = fast::Hierarchy::Tier;

namespace {

const fast::ExactFaces kExactFaces{exact::blocks, exact::faces_away, exact::meets, exact::compare_hits};

ShadowAnswer answer_of(scene::Shadow shadow) {
  return static_cast<ShadowAnswer>(shadow);
}
static_assert(static_cast<int>(ShadowAnswer::facing) == static_cast<int>(scene::Shadow::facing));

std::string text_of(HardKind kind, std::uint64_t seed, const scene::ShadowQuery& q) {
  char text[300];
  std::snprintf(text, sizeof text, "%s %d: %a %a %a -> %a %a %a own %d", name_of(kind).c_str(),
                static_cast<int>(seed), q.point[0], q.point[1], q.point[2], q.light[0], q.light[1],
                q.light[2], static_cast<int>(q.own));
  return text;
}

/// How often each tier was right, wrong or undecided.
struct Tally {
  int trials = 0, naive_wrong = 0, undecided = 0;
  int truths[3] = {0, 0, 0};
};

std::vector<ShadowAnswer> all_shadows(const Hierarchy& hierarchy, Tier tier,
                                      const std::vector<scene::ShadowQuery>& queries) {
  std::vector<ShadowAnswer> answers(queries.size(), ShadowAnswer{77});
  hierarchy.shadows(tier, queries, answers);
  return answers;
}

void check_shadows(HardKind kind, std::uint64_t seed, const scene::Scene& scene,
                   const std::vector<scene::ShadowQuery>& queries, const std::vector<ShadowAnswer>& truth,
                   Tally& tally) {
  const Hierarchy hierarchy(scene);
  ASSERT_TRUE(hierarchy.in_domain());
  std::vector<ShadowAnswer> first_naive, first_certified;
  for_each_target([&](const std::string& target) {
    EXPECT_EQ(fast::hierarchy_instruction_set(), target);
    const auto naive = all_shadows(hierarchy, Tier::naive, queries),
               certified = all_shadows(hierarchy, Tier::certified, queries);
    std::vector<ShadowAnswer> exact(queries.size(), ShadowAnswer{77});
    hierarchy.shadows_exact(kExactFaces, queries, exact);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ASSERT_EQ(exact[i], truth[i]) << target << " " << text_of(kind, seed, queries[i]);
      if (certified[i] != ShadowAnswer::undecided) {
        ASSERT_EQ(certified[i], truth[i]) << target << " " << text_of(kind, seed, queries[i]);
      }
    }
    if (first_naive.empty()) {
      first_naive = naive;
      first_certified = certified;
      for (std::size_t i = 0; i < queries.size(); ++i) {
        ++tally.trials;
        ++tally.truths[static_cast<std::size_t>(truth[i])];
        tally.naive_wrong += naive[i] != truth[i];
        tally.undecided += certified[i] == ShadowAnswer::undecided;
      }
    }
    ASSERT_EQ(naive, first_naive) << target;
    ASSERT_EQ(certified, first_certified) << target;
  });
}

}  // namespace

TEST(FastHierarchy, ShadowsAreThoseOfTheDefinition) {
  Tally tally;
  for (const HardKind kind : kHardKinds) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, 20, 2);
      const auto queries = hard_queries(kind, scene, seed, affordable(40));
      std::vector<ShadowAnswer> truth;
      for (const auto& query : queries) truth.push_back(answer_of(true_shadow(scene, query)));
      check_shadows(kind, seed, scene, queries, truth, tally);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(tally.naive_wrong, tally.trials / 100);
  EXPECT_GT(tally.undecided, tally.trials / 100);
}

TEST(FastHierarchy, ShadowsAreThoseOfExactPredicates) {
  for (const HardKind kind : kHardKinds) {
    Tally tally;
    for (std::uint64_t seed = 10; seed < 14; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, seed % 2 == 0 ? 60 : 10, seed % 2 == 0 ? 9 : 2);
      const auto queries = hard_queries(kind, scene, seed, affordable(300));
      std::vector<ShadowAnswer> truth;
      for (const auto& query : queries) {
        truth.push_back(answer_of(exact::shadow_by_all_faces(scene, query).answer));
      }
      check_shadows(kind, seed, scene, queries, truth, tally);
      if (HasFatalFailure()) return;
    }
    RecordProperty(name_of(kind) + " naive wrong", tally.naive_wrong);
    RecordProperty(name_of(kind) + " undecided", tally.undecided);
    std::printf("%-10s of %d: naive wrong %d, certified undecided %d; lit %d, shadowed %d, facing %d\n",
                name_of(kind).c_str(), tally.trials, tally.naive_wrong, tally.undecided, tally.truths[0],
                tally.truths[1], tally.truths[2]);
    EXPECT_LT(tally.undecided, tally.trials * 4 / 5) << name_of(kind);
    for (const int truths : tally.truths) EXPECT_GT(truths, 0) << name_of(kind);
  }
}

TEST(FastHierarchy, LargerScenesAgreeWithTheExactHierarchy) {
  int undecided = 0, decided = 0;
  for (const HardKind kind : {HardKind::mesh, HardKind::far_mesh, HardKind::soup}) {
    const scene::Scene scene = hard_scene(kind, 30, affordable(2400), 40);
    const Hierarchy hierarchy(scene);
    const exact::Hierarchy reference(scene);
    for (const auto& query : hard_queries(kind, scene, 30, affordable(400))) {
      const ShadowAnswer truth = answer_of(reference.shadow(query).answer);
      ASSERT_EQ(hierarchy.shadow_exact(kExactFaces, query), truth) << text_of(kind, 30, query);
      const ShadowAnswer certified = hierarchy.shadow(Tier::certified, query);
      ++(certified == ShadowAnswer::undecided ? undecided : decided);
      ASSERT_TRUE(certified == truth || certified == ShadowAnswer::undecided) << text_of(kind, 30, query);
      const scene::RayQuery ray = ray_of(query);
      if (ray.direction == Point3{}) continue;
      const std::vector<std::uint32_t> faces = reference.first_hit(ray).faces;
      const std::uint32_t first = faces.empty() ? scene::kNoFace : faces.front();
      ASSERT_EQ(hierarchy.first_hit_exact(kExactFaces, ray), first) << text_of(kind, 30, query);
      const std::uint32_t certain = hierarchy.first_hit(Tier::certified, ray);
      ASSERT_TRUE(certain == first || certain == fast::kUndecidedFace) << text_of(kind, 30, query);
    }
  }
  EXPECT_GT(undecided, 0);
  EXPECT_GT(decided, undecided);
}

TEST(FastHierarchy, FirstHitsAreThoseOfTheDefinitionAndOfExactPredicates) {
  int naive_wrong = 0, undecided = 0, trials = 0, ties = 0;
  for (const HardKind kind : kHardKinds) {
    for (std::uint64_t seed = 20; seed < 24; ++seed) {
      const bool by_definition = seed == 20;
      const scene::Scene scene = hard_scene(kind, seed, by_definition ? 20 : 60, by_definition ? 0 : 4);
      const Hierarchy hierarchy(scene);
      std::vector<scene::RayQuery> rays;
      std::vector<std::vector<std::uint32_t>> truth;
      for (const auto& query : hard_queries(kind, scene, seed, affordable(by_definition ? 40 : 200))) {
        rays.push_back(ray_of(query));
        if (rays.back().direction == Point3{}) {
          rays.pop_back();
          continue;
        }
        truth.push_back(by_definition ? true_first_triangles(scene, rays.back())
                                      : exact::first_hit_by_all_faces(scene, rays.back()).faces);
        ties += truth.back().size() > 1;
      }
      std::vector<std::uint32_t> first_certified, first_naive;
      for_each_target([&](const std::string& target) {
        std::vector<std::uint32_t> naive(rays.size()), certified(rays.size()), exact(rays.size());
        hierarchy.first_hits(Tier::naive, rays, naive);
        hierarchy.first_hits(Tier::certified, rays, certified);
        hierarchy.first_hits_exact(kExactFaces, rays, exact);
        for (std::size_t i = 0; i < rays.size(); ++i) {
          const std::uint32_t right = truth[i].empty() ? scene::kNoFace : truth[i].front();
          const std::string text =
              target + " " + text_of(kind, seed, {rays[i].origin, rays[i].direction, rays[i].own});
          ASSERT_EQ(exact[i], right) << text;
          if (certified[i] != fast::kUndecidedFace) {
            ASSERT_EQ(certified[i], right) << text;
            ASSERT_LE(truth[i].size(), 1u) << text;
          }
          if (!first_naive.empty()) continue;
          ++trials;
          undecided += certified[i] == fast::kUndecidedFace;
          naive_wrong +=
              naive[i] != right && std::find(truth[i].begin(), truth[i].end(), naive[i]) == truth[i].end();
        }
        if (first_naive.empty()) {
          first_naive = naive;
          first_certified = certified;
        }
        ASSERT_EQ(naive, first_naive) << target;
        ASSERT_EQ(certified, first_certified) << target;
      });
      if (HasFatalFailure()) return;
    }
  }
  std::printf("first hits of %d: naive wrong %d, certified undecided %d, ties %d\n", trials, naive_wrong,
              undecided, ties);
  EXPECT_GT(naive_wrong, trials / 100);
  EXPECT_GT(ties, trials / 100);
  EXPECT_LT(undecided, trials * 3 / 4);
}

}  // namespace gnomon::tests
