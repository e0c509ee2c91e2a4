// SPDX-License-Identifier: GPL-3.0-or-later
// Text lines of shaft-candidates and patch-pair: reading, writing, complaints, a corpus with stated answers,
// replays and explanations.
#include "scene/pair_case.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "exact/blocked_range.h"
#include "exact/patch_pair.h"
#include "exact/shaft_candidates.h"
#include "fuzz/replay.h"
#include "reports/explain.h"
#include "scene/input_error.h"
#include "tests/pair_by_definition.h"
#include "tests/pair_trials.h"

namespace gnomon::tests {
namespace {

using scene::CandidatesCase;
using scene::CorpusLine;
using scene::PairCase;
using scene::PairVisibility;
using Faces = std::vector<std::uint32_t>;

const std::string kCorpus = std::string(GNOMON_SOURCE_DIR) + "/tests/corpus/pairs.txt";
const std::string kBoxes = "shaft-candidates 0 0 0 1 1 1  0 0 4 1 1 5 ";
const std::string kPatches = "patch-pair 0 0 0 4 0 0 0 4 0 -1  0 0 4 0 4 4 4 0 4 ";
const std::string kTri = " tri 0 0 2 4 0 2 0 4 2", kFarBall = " ball 50 0 0 1";

CorpusLine line_of(const std::string& text) {
  std::istringstream in("\n" + text + "\n");
  return scene::read_corpus(in, "f").at(0);
}

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(fuzz::replay({line_of(text)}, {}));
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(PairCase, ReadsFacesInAnyOrder) {
  const CorpusLine line = line_of(kBoxes + "3" + kFarBall + kTri + " ball 0 0 0 0 -> { 2 1 }");
  const CandidatesCase c = scene::read_candidates_case(line);
  EXPECT_EQ(c.a, (scene::Box<double>{{0, 0, 0, 1, 1, 1}}));
  EXPECT_EQ(c.b, (scene::Box<double>{{0, 0, 4, 1, 1, 5}}));
  EXPECT_EQ(c.number, (Faces{1, 0, 2}));
  EXPECT_EQ(scene::stated_candidates(line, c), (Faces{0, 2}));
  EXPECT_EQ(scene::candidates_text(Faces{1, 0}, c.number), "{0 1}");
  EXPECT_EQ(scene::candidates_text({}, c.number), "{}");
  const PairCase pair = scene::read_pair_case(line_of(kPatches + "1 2" + kFarBall + kTri));
  EXPECT_EQ(pair.pair.a.face, scene::kNoFace);
  EXPECT_EQ(pair.pair.b.face, 0u);
  EXPECT_EQ(pair.pair.b.corners[1], (std::array<double, 3>{0, 4, 4}));
  EXPECT_FALSE(scene::stated_visibility(line_of(kPatches + "-1 0")));
  EXPECT_EQ(scene::stated_visibility(line_of(kPatches + "-1 0 -> none")), PairVisibility::none);
}

TEST(PairCase, WhatIsWrittenReadsBack) {
  for (const Finish finish :
       {Finish::grid, Finish::turned, Finish::stretched, Finish::huge, Finish::denormal}) {
    PairTrials trials(7, finish);
    for (int i = 0; i < 50; ++i) {
      const PairTrial trial = trials.next(i % 5);
      Faces number;
      for (std::uint32_t face = 0; face < trial.scene.face_count(); ++face) number.push_back(face);
      const CandidatesCase c{trial.scene, trial.a, trial.b, number};
      const CorpusLine line = line_of(corpus_text(c, scene::candidates_text(number, number)));
      EXPECT_EQ(scene::read_candidates_case(line), c);
      EXPECT_EQ(scene::stated_candidates(line, c), number);
      const PairCase pair{trial.scene, trial.pair, number};
      EXPECT_EQ(scene::read_pair_case(line_of(corpus_text(pair, "part"))), pair);
      EXPECT_EQ(corpus_text(pair, "").find("->"), std::string::npos);
    }
  }
}

TEST(PairCase, ComplainsInOneLine) {
  const std::pair<std::string, std::string> kCases[] = {
      {"shaft-candidates 0 0 0 1 1", "six numbers for box A, found the end of the line"},
      {"shaft-candidates 0 0 0 1 1 1 0 x", "six numbers for box B, found 'x'"},
      {"shaft-candidates 0 0 0 1 1 1 0 1e999", "a number within the range of a double, found '1e999'"},
      {"shaft-candidates 0 2 0 1 1 1 0 0 0 1 1 1 0", "a box A with lo <= hi, found 0x1p+1 > 0x1p+0"},
      {kBoxes, "how many faces there are, found the end of the line"},
      {kBoxes + "1 cone", "\"tri\" or \"ball\" for face 0, found 'cone'"},
      {kBoxes + "1 ball 0 0 0 -1", "a radius that is not negative, found -0x1p+0"},
      {kBoxes + "1 ball 0 0 0 1 5", "the end of the line after the last face, found '5'"},
      {kBoxes + "1" + kTri + " -> 0", "faces below 1 as {0 2 5} after \"->\", none twice, found '0'"},
      {kBoxes + "1" + kTri + " -> {1}", "faces below 1 as {0 2 5} after \"->\", none twice, found '{1}'"},
      {kBoxes + "1" + kTri + " -> {0 0}", "faces below 1 as {0 2 5} after \"->\", none twice, found '{0 0}'"},
      {kBoxes + "1" + kTri + " -> {-1}", "faces below 1 as {0 2 5} after \"->\", none twice, found '{-1}'"},
      {kBoxes + "1" + kTri + " -> {0", "a \"}\" after \"{\", found the end of the line"},
      {kBoxes + "1" + kTri + " -> {0} {0}", "one answer after \"->\", found '{0}' after it"},
      {"patch-pair 0 0 0 1 0 0 0 1", "nine numbers for patch a, found the end of the line"},
      {"patch-pair 0 0 0 4 0 0 0 4 0 x", "the number of patch a's face, or -1, found 'x'"},
      {kPatches + "-2 0", "the number of patch b's face, or -1, found '-2'"},
      {kPatches + "1 1" + kTri, "the number of a patch's face below 1, found 1"},
      {kPatches + "-1 0 -> lit", "all, none or part after \"->\", found 'lit'"},
  };
  for (const auto& [text, what] : kCases) EXPECT_EQ(complaint(text), "f:2: expected " + what) << text;
}

TEST(PairCase, TheCorpusStatesExactAnswers) {
  std::set<PairVisibility> seen;
  std::size_t listed = 0, culled = 0;
  for (const CorpusLine& line : scene::read_corpus(kCorpus)) {
    const std::string where = line.file + ":" + std::to_string(line.line);
    if (line.question == "patch-pair") {
      const PairCase c = scene::read_pair_case(line);
      const PairVisibility truth = exact::patch_pair_by_all_faces(c.scene, c.pair);
      EXPECT_EQ(scene::stated_visibility(line), truth) << where;
      EXPECT_EQ(exact::PatchPairs(c.scene).visibility(c.pair), truth) << where;
      EXPECT_EQ(pair_by_definition(c.scene, c.pair), truth) << where;
      seen.insert(truth);
      continue;
    }
    const CandidatesCase c = scene::read_candidates_case(line);
    const Faces truth = exact::shaft_candidates_by_all_faces(c.scene, c.a, c.b);
    EXPECT_EQ(scene::stated_candidates(line, c), truth) << where;
    for (std::uint32_t face = 0; face < c.scene.face_count(); ++face) {
      const bool meets = std::binary_search(truth.begin(), truth.end(), face);
      EXPECT_EQ(meets_shaft_by_definition(c.scene, face, c.a, c.b), meets) << where << " face " << face;
    }
    listed += truth.size();
    culled += c.scene.face_count() - truth.size();
  }
  EXPECT_EQ(seen.size(), 3u);
  EXPECT_GE(listed, 15u);
  EXPECT_GE(culled, 10u);
}

/// Verdicts of the trivial rows, which no other row may be worse than.
std::string trivial_verdict(const std::string& text) {
  const fuzz::ReplayResult result = fuzz::replay({line_of(text)}, {"trivial"});
  for (const fuzz::ReplayLine& line : result.lines) {
    if (line.question != "shaft-box") return line.answer + " " + line.reference + " " + line.verdict;
  }
  return "";
}

TEST(PairCase, ReplaysJudgeTheMethods) {
  EXPECT_EQ(trivial_verdict(kBoxes + "2" + kFarBall + kTri), "{0 1} {1} waste");
  EXPECT_EQ(trivial_verdict(kBoxes + "1 tri 0 0 2 1 0 2 0 1 2"), "{0} {0} agree");
  EXPECT_EQ(trivial_verdict(kBoxes + "1 ball 0.1 0 0 0"), "rejected {0} rejected");
  EXPECT_EQ(trivial_verdict(kPatches + "-1 1" + kFarBall), "part all waste");
  EXPECT_EQ(trivial_verdict(kPatches + "-1 1 tri 0 0 2 3 0 2 0 3 2"), "part part agree");
  EXPECT_EQ(trivial_verdict(kPatches + "-1 1 ball 0.1 0 0 0"), "rejected all rejected");
  const fuzz::ReplayResult wrong = fuzz::replay(
      {line_of(kPatches + "-1 1" + kTri + " -> all"), line_of(kBoxes + "1" + kTri + " -> {}")}, {});
  EXPECT_EQ(wrong.stated, 2u);
  ASSERT_EQ(wrong.wrong_answers.size(), 2u);
  EXPECT_EQ(wrong.wrong_answers[0].reference, "none");
  EXPECT_EQ(wrong.wrong_answers[1].stated, "{}");
  EXPECT_EQ(wrong.wrong_answers[1].reference, "{0}");
  EXPECT_FALSE(wrong.promise_broken());
}

TEST(PairCase, ExplanationsNameFacesAndRanges) {
  const std::string boxes = reports::explain(line_of(kBoxes + "3" + kFarBall + kTri + " ball 4 4 2 5"));
  for (const char* part :
       {"Exactly: 2 of 3 faces meet the shaft: {1 2}", "ball 0 has no point in common",
        "triangle 1 meets the shaft: the box (1-s)A + sB at s from 1/4 to 1/2", "ball 2 meets the shaft\n",
        "squared distance to the shaft less squared radius: -7", "trivial"}) {
    EXPECT_NE(boxes.find(part), std::string::npos) << part << "\n" << boxes;
  }
  const std::string pair = reports::explain(line_of(kPatches + "1 3" + kFarBall + kTri + kTri));
  for (const char* part : {"patch b (face 1)", "ball 0 meets no open segment", "triangle 1 is a patch's own",
                           "triangle 2 blocks at s = 1/2 (about 0.5) alone: it meets 9 of the nine",
                           "it hides each patch", "seen from a: in front; seen from b: in front", ": none"}) {
    EXPECT_NE(pair.find(part), std::string::npos) << part << "\n" << pair;
  }
  EXPECT_THROW(static_cast<void>(reports::explain_svg(line_of(kBoxes + "1" + kTri))), scene::InputError);
}

/// The ends of a range are met, and what lies beyond is not: a face is moved by asking for points.
TEST(PairCase, RangesAreWhereFacesAre) {
  const CandidatesCase c = scene::read_candidates_case(line_of(kBoxes + "1 tri 0 0 2 0 0 3 1 1 2.5"));
  const auto range = exact::blocked_range(c.scene, 0, c.a, c.b);
  ASSERT_TRUE(range);
  EXPECT_EQ(range->least, mpq_class(1, 4));     // z = 4s + 1 reaches 2
  EXPECT_EQ(range->greatest, mpq_class(3, 4));  // z = 4s reaches 3
  EXPECT_FALSE(exact::blocked_range(c.scene, 0, c.a, c.a));
  const PairCase pair = scene::read_pair_case(line_of(kPatches + "-1 1 tri 1 1 1 1 1 3 1 1 5"));
  const auto between = exact::blocked_range(pair.scene, 0, pair.pair);
  ASSERT_TRUE(between);
  EXPECT_EQ(between->least, mpq_class(1, 4));
  EXPECT_EQ(between->greatest, 1);
}

}  // namespace
}  // namespace gnomon::tests
