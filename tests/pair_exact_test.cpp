// SPDX-License-Identifier: GPL-3.0-or-later
// exact/shaft_candidates.h and exact/patch_pair.h against the definitions in rationals.
#include <gtest/gtest.h>

#include "exact/hierarchy.h"
#include "exact/patch_pair.h"
#include "exact/shaft_candidates.h"
#include "tests/pair_by_definition.h"
#include "tests/pair_trials.h"

namespace gnomon::tests {
namespace {

using scene::PairVisibility;

struct Share {
  Finish finish;
  int trials;
};
const std::vector<Share> kShares{
    {Finish::grid, 400}, {Finish::turned, 150}, {Finish::huge, 60}, {Finish::denormal, 60}};

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

}  // namespace
}  // namespace gnomon::tests
