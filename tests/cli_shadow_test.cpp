// SPDX-License-Identifier: GPL-3.0-or-later
// `gnomon replay` and `gnomon explain` of cases of `shadow`.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/segment_contact.h"
#include "scene/corpus.h"
#include "scene/shadow_case.h"
#include "tests/cli_run.h"

namespace gnomon::tests {
namespace {

const std::string kShadow = std::string(GNOMON_SOURCE_DIR) + "/tests/corpus/shadow.txt";
const std::string kNamed = std::string(GNOMON_SOURCE_DIR) + "/tests/corpus/shadow_named.txt";
const std::string kThrough = "shadow 1 1 -1  1 1 1  -1 1  tri 0 0 0 4 0 0 0 4 0";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

scene::ShadowCase case_of(const std::string& text) {
  std::istringstream in(text);
  return scene::read_shadow_case(scene::read_corpus(in, "f").at(0));
}

TEST(ShadowCommands, ReplayMixesQuestions) {
  const Folder folder;
  const std::string file = folder.write(
      "m.txt", kThrough + " -> shadowed\nshaft-box 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 3 1 1 -> inside\n\n" +
                   "shadow 0.1 1 1  1 1 2  -1 1  tri 0 0 0 4 0 0 0 4 0 -> lit\n");
  const Outcome run =
      run_gnomon({"replay", file, "--method", "bvh-exact", "--method", "exact", "--json", folder / "r.json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, file + ":1 bvh-exact shadowed shadowed agree\n" + file +
                         ":2 exact inside inside agree\n" + file + ":4 bvh-exact rejected lit rejected\n");
  EXPECT_EQ(run.err, "3 cases, 3 with a stated answer, 0 of them wrong\n");
  const nlohmann::json result = nlohmann::json::parse(contents_of(folder / "r.json"));
  EXPECT_EQ(result.at("cases"), 3);
  ASSERT_EQ(result.at("lines").size(), 3u);
  EXPECT_EQ(result.at("lines")[2].at("question"), "shadow");
  EXPECT_EQ(result.at("lines")[2].at("verdict"), "rejected");
}

TEST(ShadowCommands, ReplayTellsStatedAnswersThatAreWrong) {
  const Folder folder;
  const std::string file = folder.write("w.txt", kThrough + " -> lit\n");
  const Outcome run = run_gnomon({"replay", file, "--method", "reference"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, file + ":1 reference shadowed shadowed agree\n");
  EXPECT_TRUE(has(run.err, file + ":1: states lit, exactly it is shadowed\n")) << run.err;
}

TEST(ShadowCommands, ReplayOfTheCorporaKeepsPromises) {
  const Outcome run = run_gnomon({"replay", kShadow, kNamed});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, " rejected\n")) << "no case of doubles";
  EXPECT_TRUE(has(run.out, " unsound\n")) << "no case is hard";
}

TEST(ShadowCommands, BadLinesAreNamed) {
  const Folder folder;
  const std::string file = folder.write("b.txt", kThrough + "\nshadow 1 2 3\n");
  for (const std::string verb : {"replay", "explain"}) {
    const Outcome run = run_gnomon({verb, file});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err,
              "gnomon: " + file + ":2: expected three numbers for the light, found the end of the line\n");
  }
  const std::string good = folder.write("g.txt", kThrough);
  const Outcome svg = run_gnomon({"explain", good, "--svg", folder / "g.svg"});
  EXPECT_EQ(svg.status, 2);
  EXPECT_EQ(svg.err, "gnomon: " + good + ":1: expected a shaft case for a picture, found \"shadow\"\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "g.svg"));
}

TEST(ShadowCommands, ExplainTellsWhatBlocksWhereAndHow) {
  const Folder folder;
  const auto explained = [&](const std::string& text) {
    const Outcome run = run_gnomon({"explain", folder.write("e.txt", text)});
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out;
  };
  const std::string inside = explained("shadow 1 1 -1  1 1 2  -1 1  tri 0 0 0 4 0 0 0 4 0\n");
  for (const char* part :
       {"e.txt:1: shadow (all numbers are floats)", "shadowed", "triangle 0 blocks: met inside", "t = 1/3\n",
        "(1, 1, 0)", "0x1p+2", "bvh-exact", "agree"}) {
    EXPECT_TRUE(has(inside, part)) << part << "\n" << inside;
  }
  EXPECT_FALSE(has(inside, "touches"));
  const std::string edge = "tri 0 0 0 4 0 0 0 4 0", other = " tri 4 4 0 0 4 0 4 0 0";
  const std::string unsealed = explained("shadow 2 2 -1  2 2 1  -1 1 " + edge);
  EXPECT_TRUE(has(unsealed, "met on an edge, which is not sealed") && has(unsealed, "it touches"))
      << unsealed;
  const std::string sealed = explained("shadow 2 2 -1  2 2 1  -1 2 " + edge + other);
  EXPECT_TRUE(has(sealed, "met on an edge, which is sealed") && !has(sealed, "touches")) << sealed;
  EXPECT_TRUE(has(explained("shadow 0 0 -1  0 0 1  -1 1 " + edge), "met on a vertex, which is not sealed"));
  EXPECT_TRUE(has(explained("shadow -1 1 0  9 1 0  -1 1 " + edge), "within its plane"));
  EXPECT_TRUE(has(explained("shadow 1 1 0  1 1 5  -1 1 " + edge), "holds an end of the segment"));
  const std::string own = explained("shadow 1 1 0  1 1 5.1  0 1 " + edge);
  EXPECT_TRUE(has(own, "own face") && has(own, "no face has a point") && has(own, "double precision")) << own;
  const std::string tangent = explained("shadow -3 -4 0  3 4 0  -1 1  ball -4 3 0 5");
  EXPECT_TRUE(has(tangent, "tangent") && has(tangent, "t = 1/2") && has(tangent, "radius: 0\n")) << tangent;
  EXPECT_TRUE(has(explained("shadow 0 0 1  0 0 0.5  0 1  ball 0 0 0 1"), "its own, blocks"));
}

// Huge and denormal numbers too.
TEST(ShadowCommands, ExplainManagesTheCorpora) {
  for (const std::string& corpus : {kShadow, kNamed}) {
    const Outcome run = run_gnomon({"explain", corpus});
    EXPECT_EQ(run.status, 0) << run.err;
    std::size_t exact = 0;
    for (const std::string& line : lines_of(run.out)) exact += line.starts_with("Exactly: ");
    EXPECT_EQ(exact, scene::read_corpus(corpus).size());
    EXPECT_FALSE(has(run.out, "nan"));
  }
}

TEST(SegmentContact, IsRational) {
  const scene::ShadowCase c = case_of("shadow 1 1 -1  2 3 6  -1 1  tri 0 0 0 4 0 0 0 4 0");
  EXPECT_EQ(reports::plane_parameter(c.scene, 0, c.query), mpq_class(1, 7));
  const scene::ShadowCase within = case_of("shadow 1 1 2  2 3 2  -1 1  tri 0 0 0 4 0 0 0 4 0");
  EXPECT_EQ(reports::plane_parameter(within.scene, 0, within.query), std::nullopt);
  const scene::ShadowCase ball = case_of("shadow 0 0 0  3 0 0  -1 1  ball 1 2 0 1");
  const reports::NearestToCentre nearest = reports::nearest_to_centre(ball.scene.balls[0], ball.query);
  EXPECT_EQ(nearest.parameter, mpq_class(1, 3));
  EXPECT_EQ(nearest.squared_gap, 3);
  EXPECT_EQ(reports::nearest_to_centre({{9, 0, 0}, 1}, ball.query).parameter, 1);
  EXPECT_EQ(reports::nearest_to_centre({{-9, 0, 0}, 1}, ball.query).squared_gap, 80);
  EXPECT_EQ(reports::nearest_to_centre({{1, 1, 1}, 1}, {{0, 0, 0}, {0, 0, 0}, 0}).squared_gap, 2);
}

}  // namespace
}  // namespace gnomon::tests
