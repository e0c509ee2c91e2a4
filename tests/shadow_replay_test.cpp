// SPDX-License-Identifier: GPL-3.0-or-later
// Replays of `shadow`: verdicts, domains, promises, and the inputs behind public reports.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "exact/hierarchy.h"
#include "fuzz/replay.h"
#include "reports/peers/peers.h"
#include "scene/input_error.h"
#include "scene/scalar.h"
#include "scene/shadow_case.h"
#include "tests/shadow_by_definition.h"

namespace gnomon::tests {
namespace {

using fuzz::Answer;
using fuzz::ReplayLine;
using fuzz::ReplayResult;
using fuzz::SceneMethod;

const std::string kNamed = std::string(GNOMON_SOURCE_DIR) + "/tests/corpus/shadow_named.txt";
// Through the middle of a triangle.
const std::string kThrough = "shadow 1 1 -1  1 1 1  -1 1  tri 0 0 0 4 0 0 0 4 0";

std::vector<scene::CorpusLine> corpus_of(const std::string& text) {
  std::istringstream in(text);
  return scene::read_corpus(in, "f");
}

ReplayResult replay_all(const std::vector<scene::CorpusLine>& corpus,
                        const std::vector<std::string>& methods = {}) {
  return fuzz::replay(corpus, methods, {nullptr, reports::all_scene_methods()});
}

std::map<std::string, std::string> verdicts_of(const std::string& text) {
  std::map<std::string, std::string> verdicts;
  for (const ReplayLine& line : replay_all(corpus_of(text)).lines) verdicts[line.method] = line.verdict;
  return verdicts;
}

/// Gives one answer always.
template <Answer kAlways>
class Parrot : public fuzz::SceneCaster {
 public:
  void shadows(std::span<const scene::ShadowQuery> /*queries*/, std::span<Answer> answers) const override {
    std::fill(answers.begin(), answers.end(), kAlways);
  }
  void first_hits(std::span<const scene::RayQuery> /*rays*/, std::span<std::uint32_t> faces) const override {
    std::fill(faces.begin(), faces.end(), scene::kNoFace);
  }
  [[nodiscard]] std::size_t bytes() const override { return 0; }
};

template <Answer kAlways>
ReplayLine parrot_on(const std::string& text, fuzz::Promise promise) {
  const SceneMethod method{"parrot", "naive", promise, "", "", false, true, [](const scene::Scene&) {
                             return std::unique_ptr<fuzz::SceneCaster>(std::make_unique<Parrot<kAlways>>());
                           }};
  const ReplayResult result = fuzz::replay(corpus_of(text), {}, {nullptr, {&method, 1}});
  EXPECT_EQ(result.lines.size(), 1u);
  EXPECT_EQ(result.promise_broken(), result.lines.at(0).promise_broken);
  return result.lines.at(0);
}

constexpr Answer kLit = static_cast<Answer>(scene::Shadow::lit);
constexpr Answer kFacing = static_cast<Answer>(scene::Shadow::facing);

TEST(ShadowReplay, AsksEveryRowAndTellsWhoIsWrong) {
  const ReplayResult result = replay_all(corpus_of("\n" + kThrough + " -> shadowed\n" + kThrough));
  EXPECT_EQ(result.cases, 2u);
  EXPECT_EQ(result.stated, 1u);
  EXPECT_TRUE(result.wrong_answers.empty());
  ASSERT_EQ(result.lines.size(), 2 * reports::all_scene_methods().size());
  for (std::size_t i = 0; i < result.lines.size(); ++i) {
    const ReplayLine& line = result.lines[i];
    EXPECT_EQ(line.where, i < result.lines.size() / 2 ? "f:2" : "f:3");
    EXPECT_EQ(line.method, reports::all_scene_methods()[i % reports::all_scene_methods().size()].name);
    EXPECT_EQ(line.question, "shadow");
    EXPECT_EQ(line.reference, "shadowed");
    EXPECT_EQ(line.verdict, "agree") << line.method;
  }
  const ReplayLine wrong = parrot_on<kLit>(kThrough, fuzz::Promise::none);
  EXPECT_EQ(wrong.answer, "lit");
  EXPECT_EQ(wrong.verdict, "unsound");
  EXPECT_EQ(parrot_on<kFacing>(kThrough, fuzz::Promise::none).verdict, "unsound");
}

TEST(ShadowReplay, EnforcesPromises) {
  using fuzz::Promise;
  EXPECT_FALSE(parrot_on<kLit>(kThrough, Promise::none).promise_broken);
  EXPECT_TRUE(parrot_on<kLit>(kThrough, Promise::never_unsound).promise_broken);
  EXPECT_TRUE(parrot_on<kLit>(kThrough, Promise::always_agrees).promise_broken);
  EXPECT_EQ(parrot_on<fuzz::kUndecided>(kThrough, Promise::never_unsound).verdict, "undecided");
  EXPECT_FALSE(parrot_on<fuzz::kUndecided>(kThrough, Promise::never_unsound).promise_broken);
  EXPECT_TRUE(parrot_on<fuzz::kUndecided>(kThrough, Promise::always_agrees).promise_broken);
  const std::string doubles = "shadow 0.1 1 -1  0.1 1 1  -1 0";
  EXPECT_EQ(parrot_on<kFacing>(doubles, Promise::always_agrees).verdict, "rejected");
  EXPECT_FALSE(parrot_on<kFacing>(doubles, Promise::always_agrees).promise_broken);
}

TEST(ShadowReplay, MethodsOfFloatsRejectWhatIsNone) {
  const std::string faces = "  tri 0 0 0 4 0 0 0 4 0  ";
  for (const std::string& text :
       {"shadow 0.1 1 -1  1 1 1  -1 1" + faces, "shadow 1 1 -1  1 1 0.1  -1 1" + faces,
        "shadow 1 1 -1  1 1 1  -1 2" + faces + "tri 0 0 0.1 1 0 0 0 1 0",
        "shadow 1 1 -1  1 1 1  -1 2" + faces + "ball 9 9 9 0.1",
        "shadow 1 1 -1  1 1 1  -1 2" + faces + "ball 0x1p+40 9 9.1 1",
        "shadow 1 1 -1  1 1 1  -1 2" + faces + "ball 0x1.8p+127 0 0 0x1.8p+127",  // a float, its reach none
        "shadow 1 1 -1  1 1 0x1p+128  -1 1" + faces}) {
    for (const auto& [method, verdict] : verdicts_of(text)) {
      EXPECT_EQ(verdict, method == "reference" ? "agree" : "rejected") << method << " on " << text;
    }
  }
  for (const auto& [method, verdict] : verdicts_of("shadow 1 1 -1  1 1 1  -1 2" + faces + "ball 9 9 9 1")) {
    EXPECT_EQ(verdict, method.starts_with("cgal") ? "rejected" : "agree") << method;
  }
}

TEST(ShadowReplay, NamesWrongAnswersAndBadLines) {
  const ReplayResult result =
      replay_all(corpus_of(kThrough + " -> lit\nshaft-box 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 3 1 1 -> inside\n"),
                 {"reference", "exact"});
  EXPECT_EQ(result.cases, 2u);
  ASSERT_EQ(result.wrong_answers.size(), 1u);
  EXPECT_EQ(result.wrong_answers[0].where, "f:1");
  EXPECT_EQ(result.wrong_answers[0].stated, "lit");
  EXPECT_EQ(result.wrong_answers[0].reference, "shadowed");
  ASSERT_EQ(result.lines.size(), 2u);
  EXPECT_EQ(result.lines[0].method, "reference");
  EXPECT_EQ(result.lines[1].method, "exact");
  for (const std::string& bad : {std::string("shadow 1 2 3"), kThrough + " 5", kThrough + " -> inside"}) {
    EXPECT_THROW((void)replay_all(corpus_of(bad)), scene::InputError) << bad;
  }
  EXPECT_THROW((void)replay_all(corpus_of(kThrough), {"no-such"}), std::runtime_error);
}

/// Errors of methods that promise none depend on versions and processors: they are printed, not demanded. Our
/// own naive rows are the same everywhere.
TEST(ShadowReplay, NamedInputsAreHardAndDecided) {
  const std::vector<scene::CorpusLine> corpus = scene::read_corpus(kNamed);
  EXPECT_GE(corpus.size(), 25u);
  const ReplayResult result = replay_all(corpus);
  EXPECT_EQ(result.stated, corpus.size());
  EXPECT_TRUE(result.wrong_answers.empty());
  EXPECT_FALSE(result.promise_broken());
  std::map<std::string, int> unsound;
  for (const ReplayLine& line : result.lines) {
    EXPECT_NE(line.verdict, "rejected") << line.where << " " << line.method;
    unsound[line.method] += line.verdict == "unsound" ? 1 : 0;
  }
  for (const auto& [method, count] : unsound) std::printf("%-19s wrong on %d\n", method.c_str(), count);
  EXPECT_EQ(unsound.at("bvh-certified-f32") + unsound.at("bvh-exact") + unsound.at("reference"), 0);
  EXPECT_GE(unsound.at("brute-naive-f32"), 10);
  EXPECT_GE(unsound.at("bvh-naive-f32"), 10);
}

TEST(ShadowReplay, TwoMoreReferencesAgreeOnThem) {
  std::map<scene::Shadow, int> answers;
  int touching = 0;
  for (const scene::CorpusLine& line : scene::read_corpus(kNamed)) {
    const scene::ShadowCase c = scene::read_shadow_case(line);
    const exact::ShadowTruth truth = shadow_by_definition(c.scene, c.query);
    EXPECT_EQ(scene::stated_shadow(line), truth.answer) << line.line;
    EXPECT_EQ(exact::shadow_by_all_faces(c.scene, c.query), truth) << line.line;
    EXPECT_EQ(exact::Hierarchy(c.scene).shadow(c.query), truth) << line.line;
    ++answers[truth.answer];
    touching += truth.touching;
    for (std::size_t k = 0; k < 3; ++k) {  // no method of rays has to round the direction
      const Rational3 along = rational(c.query.light) - rational(c.query.point);
      EXPECT_TRUE(scene::is_float(along[k].get_d()) && mpq_class(along[k].get_d()) == along[k]) << line.line;
    }
  }
  EXPECT_EQ(touching, 1);
  EXPECT_GE(answers[scene::Shadow::lit], 10);
  EXPECT_GE(answers[scene::Shadow::shadowed], 10);
}

}  // namespace
}  // namespace gnomon::tests
