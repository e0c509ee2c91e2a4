// SPDX-License-Identifier: GPL-3.0-or-later
// Campaigns of shaft-candidates and patch-pair: what is drawn, counted, judged and shrunk.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "fuzz/pair_campaign.h"
#include "fuzz/pair_source.h"
#include "fuzz/pair_witness.h"
#include "fuzz/replay.h"
#include "fuzz/witness.h"
#include "reports/campaign_text.h"
#include "reports/result_json.h"
#include "scene/scalar.h"
#include "scene/scene_builder.h"

namespace gnomon::fuzz {
namespace {

using scene::Patch;
using scene::PatchPair;

// Rows that lie on purpose.

/// The true list without its last face where it has two or more.
class ForgetfulFinder final : public CandidateFinder {
 public:
  explicit ForgetfulFinder(const scene::Scene& scene) : candidates_(scene) {}
  void faces(const BoxPair& pair, std::vector<std::uint32_t>& out) const override {
    candidates_.faces(scene::converted<double>(pair.a), scene::converted<double>(pair.b), out);
    if (out.size() > 1) out.pop_back();
  }

 private:
  exact::ShaftCandidates candidates_;
};

/// Lists a face twice, or one that is not there.
class StutteringFinder final : public CandidateFinder {
 public:
  explicit StutteringFinder(const scene::Scene& scene) : faces_(scene.face_count()) {}
  void faces(const BoxPair& /*pair*/, std::vector<std::uint32_t>& out) const override {
    out.assign(2, faces_ > 3 ? 1 : static_cast<std::uint32_t>(faces_));
  }

 private:
  std::size_t faces_;
};

/// Takes a face that could block for one that hides: a usual mistake.
class HastyJudge final : public PairJudge {
 public:
  explicit HastyJudge(const scene::Scene& scene) : pairs_(scene) {}
  [[nodiscard]] Answer visibility(const PatchPair& pair) const override {
    const scene::PairVisibility truth = pairs_.visibility(pair);
    return static_cast<Answer>(truth == scene::PairVisibility::part ? scene::PairVisibility::none : truth);
  }

 private:
  exact::PatchPairs pairs_;
};

class UndecidedJudge final : public PairJudge {
 public:
  [[nodiscard]] Answer visibility(const PatchPair& /*pair*/) const override { return kUndecided; }
};

class NonsenseJudge final : public PairJudge {
 public:
  [[nodiscard]] Answer visibility(const PatchPair& /*pair*/) const override { return 77; }
};

template <class Made, class Maker>
std::unique_ptr<Maker> make(const scene::Scene& scene) {
  if constexpr (std::is_constructible_v<Made, const scene::Scene&>) {
    return std::make_unique<Made>(scene);
  } else {
    return std::make_unique<Made>();
  }
}

constexpr CandidateMethod kForgetful{"forgetful", "certified", Promise::never_unsound,
                                     "",          "",          make<ForgetfulFinder, CandidateFinder>};
constexpr CandidateMethod kStuttering{"stuttering", "naive", Promise::none,
                                      "",           "",      make<StutteringFinder, CandidateFinder>};
constexpr PairMethod kHasty{"hasty", "exact", Promise::always_agrees, "", "", make<HastyJudge, PairJudge>};
constexpr PairMethod kUnsure{"unsure", "certified", Promise::never_unsound,
                             "",       "",          make<UndecidedJudge, PairJudge>};
constexpr PairMethod kNonsense{"nonsense", "naive", Promise::none, "", "", make<NonsenseJudge, PairJudge>};

CampaignOptions options(std::uint64_t trials, std::vector<std::string> distributions = {}) {
  CampaignOptions options;
  options.trials = trials;
  options.distributions = std::move(distributions);
  return options;
}

std::string counts(CampaignResult result) {
  return nlohmann::json::parse(reports::result_json(result)).at("rows").dump() +
         nlohmann::json::parse(reports::result_json(result)).at("witnesses").dump();
}

bool is_float_scene(const scene::Scene& scene) {
  for (const auto& p : scene.points) {
    if (!std::all_of(p.begin(), p.end(), scene::is_float)) return false;
  }
  for (const auto& ball : scene.balls) {
    if (!scene::is_float(ball.radius) ||
        !std::all_of(ball.centre.begin(), ball.centre.end(), scene::is_float))
      return false;
  }
  return true;
}

bool is_good(const BoxPair& pair, const scene::Scene& /*scene*/) {
  return is_valid(pair.a) && is_valid(pair.b);
}

bool is_good(const PatchPair& pair, const scene::Scene& scene) {
  for (const Patch* patch : {&pair.a, &pair.b}) {
    for (const auto& corner : patch->corners) {
      if (!std::all_of(corner.begin(), corner.end(), scene::is_float)) return false;
    }
    if (patch->face != scene::kNoFace && patch->face >= scene.triangles.size()) return false;
  }
  return true;
}

template <class Q>
void check_cases() {
  for (const PairDistribution& distribution : pair_distributions()) {
    if (distribution.needs_argument) continue;
    const auto source = make_pair_source<typename Q::Query>({&distribution, ""});
    std::size_t with_balls = 0, kinds = 0;
    for (std::uint64_t trial = 0; trial < 400; ++trial) {
      PairCase<typename Q::Query> c, again;
      source->make({1, 7, trial}, c);
      source->make({1, 7, trial}, again);
      EXPECT_EQ(c.scene, again.scene);
      EXPECT_EQ(c.query, again.query);
      source->make({2, 7, trial}, again);
      kinds += c.query == again.query ? 0 : 1;
      ASSERT_TRUE(is_valid(c.scene)) << distribution.name << " " << trial;
      EXPECT_TRUE(is_float_scene(c.scene)) << distribution.name << " " << trial;
      EXPECT_TRUE(is_good(c.query, c.scene)) << distribution.name << " " << trial;
      with_balls += c.scene.balls.empty() ? 0 : 1;
    }
    EXPECT_GT(kinds, 300u) << distribution.name << ": another seed gives other cases";
    if (distribution.name == "coplanar") continue;
    EXPECT_GT(with_balls, 40u) << distribution.name;
  }
}

TEST(PairCampaign, CasesAreValidFloatsAndFunctionsOfTheirNumbers) {
  check_cases<CandidateQuestion>();
  check_cases<PatchQuestion>();
}

template <class Q>
void check_mix(std::array<double, kTruths> PairDistribution::*least) {
  CampaignOptions some = options(3000);
  some.methods = {"trivial", "reference"};
  const CampaignResult result = run_pair_campaign<Q>(some);
  ASSERT_EQ(result.rows.size(), 2 * (pair_distributions().size() - 1));
  EXPECT_FALSE(result.promise_broken());
  for (const RowResult& row : result.rows) {
    const std::string where = row.question + " " + row.method + " " + row.distribution;
    EXPECT_EQ(row.trials, 3000u) << where;
    EXPECT_TRUE(row.method == "trivial" || row.count(Verdict::agree) == row.trials) << where;
    EXPECT_EQ(row.count(Verdict::unsound), 0u) << where;
    const PairDistribution& distribution = *parse_pair_distribution(row.distribution).distribution;
    for (std::size_t truth = 0; truth < row.words().truth_count(); ++truth) {
      EXPECT_GE(static_cast<double>(row.truths(truth)) / 3000, (distribution.*least)[truth])
          << where << " " << row.words().truths[truth];
      EXPECT_GT((distribution.*least)[truth], 0) << where;
    }
  }
}

TEST(PairCampaign, EveryDistributionHasTheMixThatItStates) {
  check_mix<CandidateQuestion>(&PairDistribution::least_candidates);
  check_mix<PatchQuestion>(&PairDistribution::least_pairs);
}

template <class Q>
void check_shards(const std::vector<std::string>& distributions) {
  CampaignOptions whole = options(1000, distributions);
  const CampaignResult one = run_pair_campaign<Q>(whole);
  whole.jobs = 3;
  EXPECT_EQ(counts(one), counts(run_pair_campaign<Q>(whole)));
  std::vector<CampaignResult> parts;
  for (unsigned shard = 1; shard <= 3; ++shard) {
    CampaignOptions part = options(1000, distributions);
    part.shard = shard;
    part.shards = 3;
    parts.push_back(run_pair_campaign<Q>(part));
  }
  for (std::size_t r = 0; r < one.rows.size(); ++r) {
    RowResult sum = parts[0].rows[r];
    for (const CampaignResult& part : {parts[1], parts[2]}) {
      sum.trials += part.rows[r].trials;
      sum.faces.add(part.rows[r].faces);
      for (std::size_t truth = 0; truth < kTruths; ++truth) {
        for (std::size_t k = 0; k < kColumns; ++k) sum.matrix[truth][k] += part.rows[r].matrix[truth][k];
      }
    }
    EXPECT_EQ(sum.trials, one.rows[r].trials);
    EXPECT_EQ(sum.matrix, one.rows[r].matrix);
    EXPECT_EQ(sum.faces, one.rows[r].faces);
  }
}

TEST(PairCampaign, ThreadsAndShardsChangeNothing) {
  check_shards<CandidateQuestion>({"degenerate", "scene:gears:1"});
  check_shards<PatchQuestion>({"near-touch", "scene:gears:1"});
}

TEST(PairCampaign, VerdictsOfListsAndOfPairs) {
  const QuestionWords& lists = words_of(CandidateQuestion::id);
  FaceMarks marks;
  const auto judged = [&](const std::vector<std::uint32_t>& truth, const std::vector<std::uint32_t>& listed) {
    scene::SceneBuilder builder;
    for (int k = 0; k < 5; ++k) builder.add_ball({{1.0 * k, 0, 0}, 0.25});
    return CandidateQuestion::judge(builder.finish(), truth, listed, marks);
  };
  const PairJudgement same = judged({0, 3}, {3, 0});
  EXPECT_EQ(lists.judge(same.truth, same.answer), Verdict::agree);
  const PairJudgement more = judged({0, 3}, {3, 0, 4, 1});
  EXPECT_EQ(lists.judge(more.truth, more.answer), Verdict::waste);
  EXPECT_EQ(more.faces, (FaceSums{2, 4, 0, 2}));
  const PairJudgement both = judged({0, 3, 2}, {3, 4});
  EXPECT_EQ(lists.judge(both.truth, both.answer), Verdict::unsound);
  EXPECT_EQ(both.faces, (FaceSums{3, 2, 2, 1}));
  EXPECT_EQ(judged({}, {}).truth, 0u);
  EXPECT_EQ(lists.judge(0, judged({}, {}).answer), Verdict::agree);
  EXPECT_EQ(lists.judge(0, judged({}, {2}).answer), Verdict::waste);
  EXPECT_THROW((void)judged({1}, {1, 1}), std::runtime_error);
  EXPECT_THROW((void)judged({1}, {5}), std::runtime_error);

  const QuestionWords& pairs = words_of(PatchQuestion::id);
  for (std::size_t truth = 0; truth < 3; ++truth) {
    for (Answer answer = 0; answer < 3; ++answer) {
      const Verdict expected = answer == truth ? Verdict::agree
                               : answer == 2   ? Verdict::waste
                                               : Verdict::unsound;
      EXPECT_EQ(pairs.judge(truth, answer), expected) << truth << " " << int(answer);
    }
    EXPECT_EQ(pairs.judge(truth, kUndecided), Verdict::undecided);
    EXPECT_EQ(pairs.judge(truth, kRejected), Verdict::rejected);
  }
}

template <class Q>
RowResult only_row(const typename Q::Method& method, const CampaignOptions& options) {
  const CampaignResult result = run_pair_campaign<Q>(options, {}, {}, std::span(&method, 1));
  EXPECT_TRUE(result.failures.empty());
  EXPECT_EQ(result.rows.size(), 1u);
  return result.rows.at(0);
}

std::size_t words_in(const std::string& text) {
  std::istringstream in(text);
  std::size_t count = 0;
  for (std::string word; in >> word;) ++count;
  return count;
}

TEST(PairCampaign, AFaceThatIsForgottenIsCaughtAndShrunkToTwoFaces) {
  for (const char* const distribution : {"uniform", "coplanar", "scene:gears:1"}) {
    const RowResult row = only_row<CandidateQuestion>(kForgetful, options(300, {distribution}));
    EXPECT_TRUE(row.promise_broken()) << distribution;
    EXPECT_EQ(row.count(Verdict::unsound), row.faces.missing) << distribution;
    EXPECT_GT(row.faces.missing, 50u);
    EXPECT_EQ(row.faces.excess, 0u);
    ASSERT_EQ(row.witnesses.size(), 1u) << distribution;
    const Witness& witness = row.witnesses[0];
    EXPECT_EQ(witness.verdict, "missing face");
    EXPECT_EQ(witness.answer, "{0}");
    EXPECT_EQ(witness.reference, "{0 1}");
    EXPECT_TRUE(witness.case_text.ends_with("-> {0 1}")) << witness.case_text;
    EXPECT_LE(words_in(witness.case_text), 1u + 12 + 1 + 2 * 10 + 3) << "two faces are enough";
    EXPECT_LT(witness.case_text.size(), 300u) << "of simple numbers: " << witness.case_text;
  }
}

TEST(PairCampaign, AnAnswerTooManyIsCaughtAndShrunkToOneFace) {
  for (const char* const distribution : {"uniform", "scene:gears:1"}) {
    const RowResult row = only_row<PatchQuestion>(kHasty, options(300, {distribution}));
    EXPECT_TRUE(row.promise_broken()) << distribution;
    EXPECT_GT(row.count_fault(1), 50u);
    EXPECT_EQ(row.count(Verdict::unsound), row.count_fault(1));
    ASSERT_EQ(row.witnesses.size(), 1u) << distribution;
    const Witness& witness = row.witnesses[0];
    EXPECT_EQ(witness.verdict, "false none");
    EXPECT_EQ(witness.answer, "none");
    EXPECT_TRUE(witness.case_text.ends_with("-> part")) << witness.case_text;
    EXPECT_LE(words_in(witness.case_text), 1u + 20 + 1 + 10 + 2) << witness.case_text;
  }
}

TEST(PairCampaign, WitnessesOfTheRegistrysRowsReplay) {
  CampaignOptions some = options(1000, {"near-touch"});
  some.methods = {"list-spheres-naive-f32"};
  const CampaignResult result = run_pair_campaign<CandidateQuestion>(some);
  ASSERT_EQ(result.rows.size(), 1u);
  EXPECT_FALSE(result.promise_broken()) << "it promises nothing";
  ASSERT_EQ(result.rows[0].witnesses.size(), 2u) << "one of each fault";
  EXPECT_EQ(result.rows[0].witnesses[0].verdict, "missing face");
  EXPECT_EQ(result.rows[0].witnesses[1].verdict, "excess face");
  for (const Witness& witness : result.rows[0].witnesses) {
    std::istringstream file(witness_text(witness));
    const ReplayResult replayed = replay(scene::read_corpus(file, "witness"), some.methods);
    EXPECT_TRUE(replayed.wrong_answers.empty());
    ASSERT_EQ(replayed.lines.size(), 1u);
    EXPECT_EQ(replayed.lines[0].answer, witness.answer);
    EXPECT_EQ(replayed.lines[0].reference, witness.reference);
    EXPECT_EQ(replayed.lines[0].verdict, witness.verdict == "missing face" ? "unsound" : "waste");
  }
}

TEST(PairCampaign, NoAnswerBreaksAPromiseInTheDomainAlone) {
  const RowResult in_domain = only_row<PatchQuestion>(kUnsure, options(64, {"uniform"}));
  EXPECT_EQ(in_domain.count(Verdict::undecided), 64u);
  EXPECT_TRUE(in_domain.promise_broken());
  EXPECT_FALSE(only_row<PatchQuestion>(kUnsure, options(64, {"huge"})).promise_broken());
}

TEST(PairCampaign, NonsenseIsAFailureAndRetiresTheRow) {
  const CandidateMethod finders[] = {kStuttering, candidate_methods()[0]};
  const CampaignResult lists =
      run_pair_campaign<CandidateQuestion>(options(200, {"uniform", "thin"}), {}, {}, finders);
  ASSERT_EQ(lists.failures.size(), 1u);
  EXPECT_NE(lists.failures[0].line.find("stuttering listed face"), std::string::npos)
      << lists.failures[0].line;
  ASSERT_EQ(lists.failures[0].cases.size(), 1u);
  EXPECT_TRUE(lists.failures[0].cases[0].starts_with("shaft-candidates "));
  EXPECT_EQ(lists.rows.size(), 2u) << "the other row goes on";

  const PairMethod judges[] = {kNonsense};
  const CampaignResult pairs =
      run_pair_campaign<PatchQuestion>(options(200, {"uniform", "thin"}), {}, {}, judges);
  ASSERT_EQ(pairs.failures.size(), 1u);
  EXPECT_NE(pairs.failures[0].line.find("nonsense answered number 77"), std::string::npos);
  EXPECT_TRUE(pairs.rows.empty());
}

TEST(PairCampaign, SceneQueriesAreAdjacentNestedAndFarAndUseTheLights) {
  const auto boxes = make_pair_source<BoxPair>(parse_pair_distribution("scene:office"));
  const auto patches = make_pair_source<PatchPair>(parse_pair_distribution("scene:office"));
  const scene::Scene& scene = *patches->scene_of_all();
  std::size_t shared = 0, lights = 0, parts = 0, equal = 0, nested = 0, points = 0;
  for (std::uint64_t trial = 0; trial < 2000; ++trial) {
    PairCase<BoxPair> box;
    PairCase<PatchPair> patch;
    boxes->make({1, 1, trial}, box);
    patches->make({1, 1, trial}, patch);
    const auto& [a, b] = box.query;
    bool within = true;
    for (int axis = 0; axis < 3; ++axis) within &= a.lo(axis) <= b.lo(axis) && b.hi(axis) <= a.hi(axis);
    nested += within ? 1 : 0;
    equal += a == b ? 1 : 0;
    points += a.lo(0) == a.hi(0) && a.lo(1) == a.hi(1) && a.lo(2) == a.hi(2) ? 1 : 0;
    lights += patch.query.a.face == scene::kNoFace ? 1 : 0;
    ASSERT_TRUE(is_good(patch.query, scene));
    const auto corner = [&](const Patch& p, std::size_t k) { return scene.corner(p.face, k); };
    const std::uint32_t face = patch.query.b.face;
    parts += patch.query.b.corners[0] != corner(patch.query.b, 0) ? 1 : 0;
    if (patch.query.a.face == scene::kNoFace || patch.query.a.face == face) continue;
    std::set<std::array<double, 3>> corners;
    for (std::size_t k = 0; k < 3; ++k) corners.insert({corner(patch.query.a, k), corner(patch.query.b, k)});
    shared += corners.size() < 6 ? 1 : 0;
  }
  EXPECT_GT(shared, 200u);
  EXPECT_GT(lights, 200u);
  EXPECT_GT(parts, 500u);
  EXPECT_GT(nested, 100u);
  EXPECT_GT(equal, 5u);
  EXPECT_GT(points, 50u);
}

TEST(PairCampaign, TimeEndsACampaignAndNoRowIsLeftWithoutTrials) {
  CampaignOptions short_one = options(1, {"uniform", "thin"});
  short_one.seconds = 0.01;
  const CampaignResult result = run_pair_campaign<PatchQuestion>(short_one);
  for (const RowResult& row : result.rows) EXPECT_GE(row.trials, 64u);
}

}  // namespace
}  // namespace gnomon::fuzz
