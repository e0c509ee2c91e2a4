// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/pair_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/convexity.h"
#include "exact/hierarchy.h"
#include "exact/shadow.h"
#include "exact/shaft_candidates.h"
#include "fuzz/radiosity.h"
#include "scene/builtin.h"
#include "scene/single.h"
#include "tests/batch_cases.h"
#include "tests/pair_batches.h"

namespace gnomon::tests {

using fast::PairCaster;
using fast::PairResult;
using fast::PairScratch;
using scene::PairVisibility;

namespace {

/// What happened in many cases: guards against tests that never test.
struct Tally {
  long rays = 0, shadowed = 0, undecided = 0, naive_wrong = 0, pairs = 0, all = 0, none = 0, listed = 0;
};

/// The truth by the definition, face by face; also that no face that blocks is missing in the list.
Answers truth_of(const scene::Scene& scene, const BatchCase& c, const std::vector<std::uint32_t>& list) {
  std::vector<bool> listed(scene.face_count());
  for (const std::uint32_t face : list) {
    EXPECT_FALSE(listed[face]) << "twice in the list";
    listed[face] = true;
  }
  Answers truth(c.rays(), ShadowAnswer::lit);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
      if (c.own_from.contains(face) || c.own_to.contains(face)) continue;
      if (!exact::blocks(scene, face, c.query(i))) continue;
      truth[i] = ShadowAnswer::shadowed;
      EXPECT_TRUE(listed[face]) << "face " << face << " blocks ray " << i << " and is not in the list";
    }
  }
  return truth;
}

void check_result(const PairResult& result, const scene::Scene& scene, const BatchCase& c,
                  const Answers& truth) {
  if (result.visibility == PairVisibility::all) {
    EXPECT_EQ(std::count(truth.begin(), truth.end(), ShadowAnswer::lit), static_cast<long>(truth.size()));
  } else if (result.visibility == PairVisibility::none) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ASSERT_TRUE(exact::blocks(scene, result.blocker, c.query(i))) << "ray " << i;
    }
  }
}

void check_case(const scene::Scene& scene, const PairCaster& caster, PairScratch& scratch, const BatchCase& c,
                Tally& tally) {
  std::vector<std::uint32_t> list;
  caster.candidates(caster.prepare(c.from, c.own_from), caster.prepare(c.to, c.own_to), list);
  const Answers truth = truth_of(scene, c, list);
  Answers first_naive, first_certified;
  PairResult first_result;
  for_each_target([&](const std::string& target) {
    const bool is_first = first_naive.empty();
    Answers naive(c.rays(), ShadowAnswer{77}), certified = naive, exact = naive;
    (void)caster.shadows_naive(c.batch(), scratch, naive);
    check_result(caster.shadows_certified(c.batch(), scratch, certified), scene, c, truth);
    const PairResult result = caster.shadows_exact(kExactFaces, c.batch(), scratch, exact);
    check_result(result, scene, c, truth);
    ASSERT_EQ(exact, truth) << target;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (certified[i] == ShadowAnswer::undecided) continue;
      ASSERT_EQ(certified[i], truth[i]) << target << " " << i;
    }
    if (is_first) {
      first_naive = naive;
      first_certified = certified;
      ++tally.pairs;
      tally.all += result.visibility == PairVisibility::all;
      tally.none += result.visibility == PairVisibility::none;
      tally.listed += static_cast<long>(list.size());
      for (std::size_t i = 0; i < truth.size(); ++i) {
        ++tally.rays;
        tally.shadowed += truth[i] == ShadowAnswer::shadowed;
        tally.undecided += certified[i] == ShadowAnswer::undecided;
        tally.naive_wrong += naive[i] != truth[i];
      }
    }
    ASSERT_EQ(naive, first_naive) << target;
    ASSERT_EQ(certified, first_certified) << target;
    // The same from prepared patches and without a memory of blockers, which decides what is noticed.
    PairScratch fresh;
    const PairResult alone = caster.shadows_certified(caster.prepare(c.from, c.own_from),
                                                      caster.prepare(c.to, c.own_to), fresh, certified);
    if (is_first) first_result = alone;
    ASSERT_EQ(alone.visibility, first_result.visibility) << target;
    ASSERT_EQ(alone.blocker, first_result.blocker) << target;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (certified[i] == ShadowAnswer::undecided) continue;
      ASSERT_EQ(certified[i], truth[i]) << target << " " << i;
    }
  });
}

}  // namespace

TEST(PairVisibility, HardScenesAreAnsweredAsTheDefinitionSays) {
  Tally total;
  for (const HardKind kind : kHardKinds) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, seed % 2 == 0 ? 10 : 50, seed % 3 == 0 ? 6 : 0);
      const PairCaster caster(scene);
      ASSERT_TRUE(caster.in_domain());
      PairScratch scratch;
      Random random(seed * 977 + static_cast<std::uint64_t>(kind));
      for (int i = affordable(12); i > 0; --i) {
        SCOPED_TRACE(name_of(kind) + " " + std::to_string(seed) + " " + std::to_string(i));
        check_case(scene, caster, scratch, hard_case(kind, scene, random), tally);
        if (HasFailure()) return;
      }
    }
    std::printf(
        "%-10s of %ld rays: shadowed %ld, undecided %ld, naive wrong %ld; of %ld pairs: all %ld, none %ld\n",
        name_of(kind).c_str(), tally.rays, tally.shadowed, tally.undecided, tally.naive_wrong, tally.pairs,
        tally.all, tally.none);
    EXPECT_LT(tally.undecided, tally.rays * 9 / 10) << name_of(kind);
    EXPECT_GT(tally.shadowed, 0) << name_of(kind);
    EXPECT_LT(tally.shadowed, tally.rays) << name_of(kind);
    total.naive_wrong += tally.naive_wrong;
    total.all += tally.all;
    total.none += tally.none;
  }
  EXPECT_GT(total.naive_wrong, 0);
  if (kSanitized) return;  // too few cases for each kind of pair to be among them
  EXPECT_GT(total.all, 0);
  EXPECT_GT(total.none, 0);
}

TEST(PairVisibility, RadiosityRaysAreThoseOfTheExactHierarchy) {
  Tally tally;
  std::uint64_t faces_with = 0, faces_without = 0;
  for (const char* name : {"office", "classroom:2", "gears", "city:4"}) {
    const scene::Scene scene = scene::rounded_to_floats(scene::find_builtin(name)->make()).scene;
    std::vector<std::uint8_t> convex;
    for (const scene::Object& object : scene.objects) convex.push_back(exact::is_convex(scene, object));
    const PairCaster caster(scene, convex), careful(scene);
    const exact::Hierarchy reference(scene);
    PairScratch scratch;
    for (const std::size_t rays : {16, 64, 400}) {
      const auto most = static_cast<std::size_t>(affordable(4000));
      for (const fuzz::RadiosityPair& pair : fuzz::record_pairs(scene, {rays, most, 7})) {
        BatchCase c{{}, {}, pair.from.own, pair.to.own};
        for (const auto& p : pair.from.points) c.from.push_back(fuzz::to_floats(p));
        for (const auto& p : pair.to.points) c.to.push_back(fuzz::to_floats(p));
        Answers exact(c.rays()), certified = exact, unflagged = exact;
        fast::PairCounters with, without;
        const PairResult result = caster.shadows_exact(kExactFaces, c.batch(), scratch, exact, &with);
        (void)caster.shadows_certified(c.batch(), scratch, certified);
        PairScratch fresh;
        (void)careful.shadows_exact(kExactFaces, c.batch(), fresh, unflagged, &without);
        faces_with += with.faces;
        faces_without += without.faces;
        ++tally.pairs;
        tally.all += result.visibility == PairVisibility::all;
        tally.none += result.visibility == PairVisibility::none;
        for (std::size_t i = 0; i < exact.size(); ++i) {
          const auto truth = static_cast<ShadowAnswer>(reference.shadow(pair.query(i)).answer);
          ASSERT_EQ(exact[i], truth) << name;
          ASSERT_EQ(unflagged[i], truth) << name;
          ASSERT_TRUE(certified[i] == truth || certified[i] == ShadowAnswer::undecided) << name;
          ++tally.rays;
          tally.shadowed += truth == ShadowAnswer::shadowed;
          tally.undecided += certified[i] == ShadowAnswer::undecided;
        }
      }
    }
  }
  std::printf(
      "of %ld rays: shadowed %ld, undecided %ld; of %ld pairs: all %ld, none %ld; faces %d, without flags "
      "%d\n",
      tally.rays, tally.shadowed, tally.undecided, tally.pairs, tally.all, tally.none,
      static_cast<int>(faces_with), static_cast<int>(faces_without));
  EXPECT_GT(tally.pairs, 100);
  EXPECT_LT(tally.undecided, tally.rays / 200);
  EXPECT_GT(tally.all, tally.pairs / 20);
  EXPECT_GT(tally.none, tally.pairs / 50);
  EXPECT_LE(faces_with, faces_without);
}

TEST(PairVisibility, ShaftFacesAreThoseThatMeetTheShaftOrNear) {
  std::size_t listed = 0, met = 0, dropped = 0;
  for (const HardKind kind : kHardKinds) {
    for (std::uint64_t seed = 50; seed < 54; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, 40, 8);
      const PairCaster caster(scene);
      Random random(seed * 31 + static_cast<std::uint64_t>(kind));
      HardPoints points(kind, random);
      for (int i = affordable(40); i > 0; --i) {
        scene::Box<float> box[2];
        for (auto& b : box) {
          const Point3 p = points.point(), q = random.chance(40) ? p : points.point();
          for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            b.lo(k) = static_cast<float>(std::min(p[axis], q[axis]));
            b.hi(k) = static_cast<float>(std::max(p[axis], q[axis]));
          }
        }
        const std::vector<std::uint32_t> truth = exact::shaft_candidates_by_all_faces(
            scene, scene::converted<double>(box[0]), scene::converted<double>(box[1]));
        std::vector<std::uint32_t> first;
        for_each_target([&](const std::string& target) {
          std::vector<std::uint32_t> faces;
          caster.shaft_faces(box[0], box[1], faces);
          std::sort(faces.begin(), faces.end());
          ASSERT_TRUE(std::includes(faces.begin(), faces.end(), truth.begin(), truth.end()))
              << target << " " << name_of(kind);
          if (first.empty()) first = faces;
          ASSERT_EQ(faces, first) << target;
        });
        if (HasFatalFailure()) return;
        listed += first.size();
        met += truth.size();
        dropped += scene.face_count() - first.size();
      }
    }
  }
  std::printf("shafts: %zu faces listed, %zu met, %zu dropped\n", listed, met, dropped);
  EXPECT_GT(dropped, listed / 4);
  EXPECT_LT(listed, met + met / 4);
}

TEST(PairVisibility, CostsAreCountedAndDoNotDependOnTheInstructionSet) {
  const scene::Scene scene = hard_scene(HardKind::soup, 3, 200, 10);
  const PairCaster caster(scene);
  Random random(5);
  const BatchCase c = hard_case(HardKind::soup, scene, random);
  fast::PairCounters first;
  for_each_target([&](const std::string& target) {
    PairScratch scratch;
    fast::PairCounters counters;
    Answers answers(c.rays());
    (void)caster.shadows_exact(kExactFaces, c.batch(), scratch, answers, &counters);
    EXPECT_EQ(counters.pairs, 1u);
    EXPECT_EQ(counters.rays, c.rays());
    EXPECT_GT(counters.nodes, 0u);
    if (first.pairs == 0) first = counters;
    EXPECT_EQ(counters, first) << target;
  });
}

}  // namespace gnomon::tests
