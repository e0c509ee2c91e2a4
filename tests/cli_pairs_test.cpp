// SPDX-License-Identifier: GPL-3.0-or-later
// shaft-candidates and patch-pair from the command line: result files, merging, comparing, the report, and
// what is refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli_run.h"

namespace gnomon::tests {
namespace {

using Json = nlohmann::json;

Json said(const std::filesystem::path& file) {
  Json json = Json::parse(contents_of(file));
  json.erase("measured");
  json.erase("shard");
  json.erase("command");
  return json;
}

class CliPairs : public testing::TestWithParam<const char*> {
 protected:
  Outcome fuzz(std::vector<std::string> more) const {
    more.insert(more.begin(), {"fuzz", GetParam(), "--trials", "600", "--distribution", "degenerate",
                               "--distribution", "scene:gears:1"});
    return run_gnomon(more, folder_.path());
  }
  Folder folder_;
};

TEST_P(CliPairs, ShardsMergeToTheWholeAndTheWholeComparesWithItself) {
  ASSERT_EQ(fuzz({"--json", "whole.json", "--jobs", "1"}).status, 0);
  ASSERT_EQ(fuzz({"--json", "again.json", "--jobs", "3"}).status, 0);
  EXPECT_EQ(said(folder_ / "whole.json"), said(folder_ / "again.json"));
  ASSERT_EQ(fuzz({"--json", "a.json", "--shard", "1/2"}).status, 0);
  ASSERT_EQ(fuzz({"--json", "b.json", "--shard", "2/2"}).status, 0);
  EXPECT_NE(said(folder_ / "a.json").at("rows"), said(folder_ / "b.json").at("rows"));
  const Outcome merge = run_gnomon({"merge", "b.json", "a.json", "-o", "merged.json"}, folder_.path());
  ASSERT_EQ(merge.status, 0) << merge.err;
  EXPECT_EQ(said(folder_ / "merged.json"), said(folder_ / "whole.json"));
  const Outcome same = run_gnomon({"compare", "whole.json", "merged.json"}, folder_.path());
  EXPECT_EQ(same.status, 0) << same.out << same.err;
  EXPECT_NE(same.out.find("No regression"), std::string::npos) << same.out;
}

TEST_P(CliPairs, RowsAddUpAndSayWhatTheyCount) {
  ASSERT_EQ(fuzz({"--json", "r.json"}).status, 0);
  const Json rows = said(folder_ / "r.json").at("rows");
  const bool lists = std::string(GetParam()) == "shaft-candidates";
  for (const Json& row : rows) {
    EXPECT_EQ(row.at("trials"), 600);
    EXPECT_EQ(row.at("independent"), row.at("distribution") != "scene:gears:1");
    EXPECT_EQ(row.at("scalar"), "f32");
    EXPECT_FALSE(row.at("promise_broken").get<bool>());
    std::uint64_t sum = row.at("undecided").get<std::uint64_t>() + row.at("rejected").get<std::uint64_t>();
    for (const auto& [truth, answers] : row.at("matrix").items()) {
      std::uint64_t of = 0;
      for (const auto& [answer, count] : answers.items()) of += count.get<std::uint64_t>();
      sum += of;
      EXPECT_EQ(answers.size(), 3u);
      for (const auto& [answer, count] : answers.items()) {
        const std::string rate = truth + "_as_" + answer + "_rate";
        if (!row.contains(rate)) continue;
        EXPECT_EQ(row.at(rate).at("hits"), count) << rate;
        EXPECT_GE(row.at(rate).at("of").get<std::uint64_t>(), of) << rate;
      }
    }
    EXPECT_EQ(sum, 600u);
    EXPECT_TRUE(row.contains(lists ? "some_as_missing_rate" : "part_as_none_rate"));
    EXPECT_FALSE(row.contains(lists ? "some_as_same_rate" : "part_as_part_rate"));
    EXPECT_EQ(row.contains("faces"), lists);
    if (!lists) continue;
    const Json& faces = row.at("faces");
    EXPECT_EQ(faces.at("true").get<std::int64_t>() + faces.at("excess").get<std::int64_t>(),
              faces.at("listed").get<std::int64_t>() + faces.at("missing").get<std::int64_t>());
  }
}

TEST_P(CliPairs, WorseCountsAreARegressionAndOtherScenesAreNot) {
  ASSERT_EQ(fuzz({"--json", "old.json"}).status, 0);
  Json worse = Json::parse(contents_of(folder_ / "old.json"));
  for (Json& row : worse.at("rows")) {
    if (row.at("method") == "reference") row.at("unsound") = 1;
  }
  folder_.write("worse.json", worse.dump());
  const Outcome regressed = run_gnomon({"compare", "old.json", "worse.json"}, folder_.path());
  EXPECT_EQ(regressed.status, 1);
  EXPECT_NE(regressed.out.find("unsound"), std::string::npos) << regressed.out;
  Json other = Json::parse(contents_of(folder_ / "old.json"));
  other.at("rows")[0].at("waste_rate").at("of") = 1;
  folder_.write("other.json", other.dump());
  EXPECT_EQ(run_gnomon({"compare", "old.json", "other.json"}, folder_.path()).status, 2) << "other cases";
}

TEST_P(CliPairs, TheReportShowsThem) {
  ASSERT_EQ(fuzz({"--out", "results"}).status, 0);
  const Outcome report = run_gnomon({"report", "results", "-o", "page.html"}, folder_.path());
  ASSERT_EQ(report.status, 0) << report.err;
  const std::string page = contents_of(folder_ / "page.html");
  EXPECT_NE(page.find(std::string("<code>") + GetParam() + "</code>"), std::string::npos);
  EXPECT_NE(page.find("Every promise held"), std::string::npos);
  const bool lists = std::string(GetParam()) == "shaft-candidates";
  EXPECT_EQ(page.find("How long the lists are") != std::string::npos, lists);
  EXPECT_NE(page.find(lists ? "exactly some" : "exactly part"), std::string::npos);
  EXPECT_EQ(page.find("exactly outside</th>"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Questions, CliPairs, testing::Values("shaft-candidates", "patch-pair"),
                         [](const auto& param) {
                           return std::string(param.param) == "patch-pair" ? "PatchPair" : "ShaftCandidates";
                         });

TEST(CliPairErrors, SayInOneLineWhatWasExpected) {
  const Folder folder;
  folder.write("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("huge.off", "OFF\n4 2 0\n0 0 0\n1e300 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n");
  folder.write("balls.nff", "b 0 0 0\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\ns 3 0 0 1\n");
  const struct {
    std::vector<std::string> arguments;
    const char* said;
  } calls[] = {
      {{"patch-pair", "--distribution", "nested"}, "--distribution: expected one of uniform"},
      {{"patch-pair", "--distribution", "scene"}, "expected scene:ARG"},
      {{"patch-pair", "--distribution", "scene:nowhere"}, "nowhere"},
      {{"shaft-candidates", "--distribution", "scene:office:0"}, "office"},
      {{"shaft-candidates", "--distribution", "uniform:3"}, "takes no argument"},
      {{"shaft-candidates", "--distribution", "uniform@4"}, "--distribution: expected one of"},
      {{"shaft-candidates", "--distribution", "integer-grid:1"}, "number of grid lines"},
      {{"shaft-candidates", "--distribution", "scene:one.off"},
       "one.off: expected a scene with two faces, found 1"},
      {{"patch-pair", "--distribution", "scene:one.off"}, "expected a scene with two triangles"},
      {{"patch-pair", "--distribution", "scene:balls.nff"}, "expected a scene with two triangles"},
      {{"patch-pair", "--distribution", "scene:huge.off"}, "huge.off"},
      {{"patch-pair", "--method", "naive-f32"}, "--method: expected one of trivial"},
      {{"patch-pair", "--scalar", "f64"}, "--scalar: expected f32 for patch-pair"},
      {{"patch-pairs"}, "expected a question"},
  };
  for (const auto& call : calls) {
    std::vector<std::string> arguments{"fuzz", "--trials", "10"};
    arguments.insert(arguments.end(), call.arguments.begin(), call.arguments.end());
    const Outcome run = run_gnomon(arguments, folder.path());
    EXPECT_EQ(run.status, 2) << call.said << "\n" << run.out;
    EXPECT_EQ(run.out, "") << call.said;
    EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    EXPECT_NE(run.err.find(call.said), std::string::npos) << run.err << "expected " << call.said;
  }
  const Outcome balls = run_gnomon(
      {"fuzz", "shaft-candidates", "--distribution", "scene:balls.nff", "--trials", "100"}, folder.path());
  EXPECT_EQ(balls.status, 0) << balls.err;
  EXPECT_NE(balls.out.find("scene:balls.nff"), std::string::npos);
}

TEST(CliPairErrors, ListNamesThem) {
  const std::string text = run_gnomon({"list"}).out;
  for (const char* const word : {"\nshaft-candidates\n", "\npatch-pair\n", "\n  coplanar ", "\n  scene "}) {
    EXPECT_NE(text.find(word), std::string::npos) << word;
  }
  const Json json = Json::parse(run_gnomon({"list", "--json"}).out);
  std::set<std::string> ids;
  for (const Json& question : json.at("questions")) ids.insert(question.at("id"));
  EXPECT_TRUE(ids.contains("shaft-candidates") && ids.contains("patch-pair"));
  EXPECT_EQ(json.at("pair_distributions").size(), 11u);
  EXPECT_GT(json.at("pair_distributions")[0].at("least_mix_pairs").at("none"), 0);
}

}  // namespace
}  // namespace gnomon::tests
