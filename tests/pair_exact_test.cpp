// SPDX-License-Identifier: GPL-3.0-or-later
// exact/shaft_candidates.h and exact/patch_pair.h against the definitions in rationals.
#include <gtest/gtest.h>

#include "exact/patch_pair.h"
#include "exact/polygons.h"
#include "exact/shadow.h"
#include "exact/shaft_candidates.h"
#include "scene/find_scene.h"
#include "tests/pair_by_definition.h"
#include "tests/pair_trials.h"

namespace gnomon::tests {
namespace {

using scene::PairVisibility;

struct Share {
  Finish finish;
  int trials;
};
const std::vector<Share> kShares{{Finish::grid, 400},
                                 {Finish::turned, 100},
                                 {Finish::stretched, 150},
                                 {Finish::huge, 60},
                                 {Finish::denormal, 60}};

int scale() {
  return std::max(1, reference_cases(1000) / 1000);
}

/// Calls `check` with trials of every kind, of so many faces.
template <class Check>
void try_all(std::uint64_t seed, int faces, const Check& check) {
  for (const Share& share : kShares) {
    PairTrials trials(seed + static_cast<std::uint64_t>(share.finish), share.finish);
    for (int i = 0; i < affordable(share.trials * scale()) && !testing::Test::HasFailure(); ++i) {
      check(trials.next(faces));
    }
  }
}

TEST(PairExact, ShaftCandidatesAreTheFacesThatMeetTheHull) {
  int met = 0, apart = 0;
  exact::CandidateCounters counters;
  try_all(100, 5, [&](const PairTrial& trial) {
    std::vector<std::uint32_t> expected, found;
    for (std::uint32_t face = 0; face < trial.scene.face_count(); ++face) {
      const bool meets = meets_shaft_by_definition(trial.scene, face, trial.a, trial.b);
      EXPECT_EQ(exact::meets_shaft(trial.scene, face, trial.a, trial.b), meets) << face << "\n"
                                                                                << text_of(trial);
      if (meets) expected.push_back(face);
      ++(meets ? met : apart);
    }
    const exact::ShaftCandidates candidates(trial.scene);
    candidates.faces(trial.a, trial.b, found, counters);
    EXPECT_EQ(found, expected) << text_of(trial);
    EXPECT_EQ(exact::shaft_candidates_by_all_faces(trial.scene, trial.a, trial.b), expected);
  });
  RecordProperty("met", met);
  RecordProperty("apart", apart);
  RecordProperty("exact_faces", static_cast<int>(counters.exact_faces));
  EXPECT_GE(apart, affordable(300));
  EXPECT_GE(met, affordable(300));
  // Touching by a hair, or far beyond the range of intervals.
  EXPECT_GE(counters.exact_faces, static_cast<std::uint64_t>(affordable(100)));
}

TEST(PairExact, FacesBlockWhatTheyMeet) {
  std::array<int, 3> seen{};
  exact::PatchPairCounters counters;
  try_all(200, 5, [&](const PairTrial& trial) {
    for (std::uint32_t face = 0; face < trial.scene.face_count(); ++face) {
      const Between between = face_between(trial.scene, face, trial.pair);
      EXPECT_EQ(exact::can_block(trial.scene, face, trial.pair), between == Between::within)
          << face << "\n"
          << text_of(trial);
      ++seen[static_cast<std::size_t>(between)];
    }
    const exact::PatchPairs pairs(trial.scene);
    static_cast<void>(pairs.visibility(trial.pair, counters));
  });
  RecordProperty("apart", seen[0]);
  RecordProperty("at_patches", seen[1]);
  RecordProperty("within", seen[2]);
  RecordProperty("exact_faces", static_cast<int>(counters.exact_faces));
  for (const int count : seen) EXPECT_GE(count, affordable(200));
  EXPECT_GE(counters.exact_faces, static_cast<std::uint64_t>(affordable(100)));
}

/// Radii that are the distance to the hull but for a rounding, and those next to them.
TEST(PairExact, BallsNextToTheHull) {
  std::array<int, 3> seen{};
  for (const Finish finish : {Finish::grid, Finish::turned}) {
    PairTrials trials(250 + static_cast<std::uint64_t>(finish), finish);
    for (int i = 0; i < affordable(100 * scale()) && !HasFailure(); ++i) {
      PairTrial trial = trials.next(1);
      scene::Ball<double> ball{
          trial.scene.points.empty() ? trial.scene.balls[0].centre : trial.scene.points[0], 0};
      Points seen_from_centre;
      for (const Rational3& p : corners_of(trial.pair)) {
        seen_from_centre.push_back(p - rational(ball.centre));
      }
      const Rational3 nearest = nearest_to_origin(seen_from_centre);
      const double distance = std::sqrt(mpq_class(scalar_product(nearest, nearest)).get_d());
      for (const double radius :
           {std::nextafter(distance, 0.0), distance, std::nextafter(distance, HUGE_VAL)}) {
        ball.radius = radius;
        trial.scene = {};
        trial.scene.balls.push_back(ball);
        const Between between = face_between(trial.scene, 0, trial.pair);
        EXPECT_EQ(exact::can_block(trial.scene, 0, trial.pair), between == Between::within) << text_of(trial);
        ++seen[static_cast<std::size_t>(between)];
      }
    }
  }
  for (const int count : seen) EXPECT_GE(count, affordable(24));
}

TEST(PairExact, PatchesSeeWhatTheDefinitionSays) {
  std::array<int, 3> seen{};
  int hiding = 0;
  try_all(300, 3, [&](const PairTrial& trial) {
    const PairVisibility expected = pair_by_definition(trial.scene, trial.pair);
    for (std::uint32_t face = 0; face < trial.scene.face_count(); ++face) {
      const bool hides = hides_by_definition(trial.scene, face, trial.pair);
      EXPECT_EQ(exact::hides(trial.scene, face, trial.pair), hides) << face << "\n" << text_of(trial);
      hiding += hides;
    }
    EXPECT_EQ(exact::patch_pair_by_all_faces(trial.scene, trial.pair), expected) << text_of(trial);
    EXPECT_EQ(exact::PatchPairs(trial.scene).visibility(trial.pair), expected) << text_of(trial);
    ++seen[static_cast<std::size_t>(expected)];
    // Exchanged patches see the same.
    const scene::PatchPair back{trial.pair.b, trial.pair.a};
    EXPECT_EQ(exact::PatchPairs(trial.scene).visibility(back), expected) << text_of(trial);
  });
  RecordProperty("all", seen[0]);
  RecordProperty("none", seen[1]);
  RecordProperty("part", seen[2]);
  RecordProperty("hiding_faces", hiding);
  for (const int count : seen) EXPECT_GE(count, affordable(15));
}

scene::Box<double> box_of(const scene::Scene& scene, const scene::FaceRun& run) {
  scene::Box<double> box{{HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (std::uint32_t face = run.first; face < run.first + run.count; ++face) {
    for (std::size_t i = 0; i < 9; ++i) {
      const double x = scene.corner(face, i / 3)[i % 3];
      box.c[i % 3] = std::min(box.c[i % 3], x);
      box.c[i % 3 + 3] = std::max(box.c[i % 3 + 3], x);
    }
  }
  return box;
}

/// Scenes of many leaves: hierarchies leave out no face, wherever the boxes are, and rays bear out what is
/// said of pairs.
TEST(PairExact, HierarchiesAgreeOnScenesOfManyFaces) {
  std::array<int, 3> seen{};
  std::size_t listed = 0;
  for (const char* name : {"office:1", "tetra:3", "city:1"}) {
    const scene::Scene scene = scene::find_scene(name).loaded.scene;
    const auto faces = static_cast<int>(scene.triangles.size());
    const std::vector<scene::FaceRun> runs = exact::polygons_of(scene);
    const exact::ShaftCandidates candidates(scene);
    const exact::PatchPairs pairs(scene);
    Random random(static_cast<std::uint64_t>(faces));
    std::vector<std::uint32_t> found;
    const auto any = [&](int count, int near, int step) {
      return near < 0 ? random.below(count) : std::min(count - 1, near + random.below(step));
    };
    for (int i = 0; i < affordable(60); ++i) {
      const int run = any(static_cast<int>(runs.size()), -1, 0);
      const int other = any(static_cast<int>(runs.size()), random.chance(50) ? run : -1, 8);
      scene::Box<double> a = box_of(scene, runs[static_cast<std::size_t>(run)]),
                         b = box_of(scene, runs[static_cast<std::size_t>(other)]);
      if (i % 10 == 0) b = {{-0x1p+900, 0, 0, -0x1p+900, 1, 0x1p+900}};  // beyond all floats of the hierarchy
      if (i % 10 == 1) a = {{9e9, 9e9, 9e9, 9e9, 9e9, 9e9}};
      candidates.faces(a, b, found);
      EXPECT_EQ(found, exact::shaft_candidates_by_all_faces(scene, a, b)) << name << ' ' << i;
      listed += found.size();

      scene::PatchPair pair;
      pair.a.face = static_cast<std::uint32_t>(any(faces, -1, 0));
      pair.b.face =
          static_cast<std::uint32_t>(any(faces, random.chance(50) ? static_cast<int>(pair.a.face) : -1, 12));
      for (scene::Patch* patch : {&pair.a, &pair.b}) {
        const double share = std::ldexp(1.0, -random.below(8));  // a small part of the face sees more
        for (std::size_t k = 0; k < 3; ++k) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const double from = scene.corner(patch->face, 0)[axis];
            patch->corners[k][axis] = from + (scene.corner(patch->face, k)[axis] - from) * share;
          }
        }
      }
      const PairVisibility visibility = pairs.visibility(pair);
      EXPECT_EQ(visibility, exact::patch_pair_by_all_faces(scene, pair)) << name << ' ' << i;
      ++seen[static_cast<std::size_t>(visibility)];
      if (visibility == PairVisibility::part || pair.a.face == pair.b.face) continue;
      for (const auto& p : pair.a.corners) {
        for (const auto& q : pair.b.corners) {
          bool blocked = false;
          for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
            const bool own = face == pair.a.face || face == pair.b.face;
            blocked = blocked || (!own && exact::blocks(scene, face, scene::ShadowQuery{p, q}));
          }
          EXPECT_EQ(blocked, visibility == PairVisibility::none) << name << ' ' << i;
        }
      }
    }
  }
  for (const int count : seen) EXPECT_GE(count, affordable(6));
  EXPECT_GE(listed, static_cast<std::size_t>(affordable(2000)));
}

}  // namespace
}  // namespace gnomon::tests
