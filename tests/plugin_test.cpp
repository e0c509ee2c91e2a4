// SPDX-License-Identifier: GPL-3.0-or-later
// Plug-ins as rows: the plug-in of the README in its own words, the examples next to our rows, promises,
// replays, and the same results for any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "fuzz/campaign.h"
#include "fuzz/shaft_questions.h"
#include "reports/result_json.h"
#include "tests/cli_run.h"

namespace gnomon::tests {
namespace {

using nlohmann::ordered_json;

std::string example(const std::string& name) {
  return std::string(GNOMON_EXAMPLE_PLUGINS) + "/" + name + ".so";
}

bool has_example(const std::string& name) {
  return std::filesystem::exists(example(name));
}

/// The fenced blocks of the README in one language, in order.
std::vector<std::string> blocks(const std::string& language) {
  const std::string text = contents_of(std::string(GNOMON_SOURCE_DIR) + "/fuzz/plugin/README.md");
  const std::string open = "```" + language + "\n";
  std::vector<std::string> found;
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
    const std::size_t from = at + open.size();
    found.push_back(text.substr(from, text.find("```", from) - from));
  }
  return found;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// A line of the README, as it would be typed in the folder of a built source tree.
Outcome run_line(const std::string& line, const Folder& folder) {
  std::string command =
      replaced(line, "-I fuzz/plugin", std::string("-I ") + GNOMON_SOURCE_DIR + "/fuzz/plugin");
  command = replaced(command, "build/release/gnomon", GNOMON_BINARY);
  if (command.starts_with("cc ")) command = GNOMON_C_COMPILER + command.substr(2);
  const std::string out = folder / "out", err = folder / "err";
  command = "cd " + folder.path().string() + " && " + command + " >" + out + " 2>" + err;
  const int state = std::system(command.c_str());
  return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, contents_of(out), contents_of(err)};
}

TEST(PluginReadme, ItsPluginIsFoundOutAsItSays) {
  ASSERT_EQ(blocks("c").size(), 1u);
  ASSERT_EQ(blocks("sh").size(), 1u);
  const std::vector<std::string> commands = lines_of(blocks("sh")[0]);
  ASSERT_EQ(commands.size(), 4u);
  EXPECT_LE(lines_of(blocks("c")[0]).size(), 35u);
  const Folder folder;
  folder.write("mine.c", blocks("c")[0]);

  const Outcome compiled = run_line(commands[0], folder);
  ASSERT_EQ(compiled.status, 0) << compiled.err;
  EXPECT_EQ(compiled.err, "");
  const Outcome listed = run_line(commands[1], folder);
  EXPECT_EQ(listed.status, 0) << listed.err;
  EXPECT_NE(listed.out.find("mine:planes"), std::string::npos);
  const Outcome fuzzed = run_line(commands[2], folder);
  EXPECT_EQ(fuzzed.status, 1) << fuzzed.err;
  for (const std::string& line : lines_of(blocks("text").at(0)))
    EXPECT_NE(fuzzed.err.find(line + "\n"), std::string::npos) << line << "\nnot in\n" << fuzzed.err;
  const Outcome explained = run_line(commands[3], folder);
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_TRUE(std::regex_search(explained.out, std::regex("mine:planes +outside +unsound"))) << explained.out;
  EXPECT_NE(explained.out.find("overlap; it touches"), std::string::npos) << explained.out;

  const Outcome replayed = run_line(
      "build/release/gnomon replay --plugin mine.so --method mine:planes results/witnesses/*", folder);
  EXPECT_EQ(replayed.status, 1) << replayed.err;
  EXPECT_NE(replayed.out.find("mine:planes outside overlap unsound"), std::string::npos) << replayed.out;
  EXPECT_EQ(replayed.err.find("0 with a stated"), std::string::npos);
}

ordered_json row_of(const ordered_json& results, const std::string& method, const std::string& scalar) {
  for (const ordered_json& row : results["rows"]) {
    if (row["method"] == method && row["scalar"] == scalar) return row;
  }
  ADD_FAILURE() << "no row " << method;
  return {};
}

template <class Q>
ordered_json campaign(const fuzz::Plugins& plugins, unsigned jobs, std::uint64_t trials,
                      std::vector<std::string> distributions, std::vector<std::string> methods = {}) {
  fuzz::CampaignOptions options;
  options.methods = std::move(methods);
  options.plugins = &plugins;
  options.jobs = jobs;
  options.trials = trials;
  options.distributions = std::move(distributions);
  ordered_json json = ordered_json::parse(reports::result_json(fuzz::run_campaign<Q>(options)));
  json.erase("measured");
  return json;
}

TEST(PluginExamples, AgreeWithOurRowsOfTheSameArithmetic) {
  fuzz::Plugins plugins;
  plugins.load(example("planes"), 10);
  const ordered_json results = campaign<fuzz::ShaftBoxQuestion>(plugins, 2, 20000, {"integer-grid"});
  for (const auto& [ours, theirs] :
       {std::pair("naive-f32", "planes:as-formed"), std::pair("normalised-f32", "planes:normalised")}) {
    const ordered_json row = row_of(results, theirs, "f32");
    EXPECT_EQ(row["matrix"], row_of(results, ours, "f32")["matrix"]) << theirs;
    EXPECT_EQ(row["tier"], "plug-in");
    EXPECT_EQ(row["rounding"], 0);
    EXPECT_EQ(row["model"], 0);
  }
  EXPECT_GT(row_of(results, "planes:normalised", "f32")["false_culls"], 100);
  EXPECT_EQ(row_of(results, "planes:as-formed", "f32")["unsound"], 0);
}

TEST(PluginExamples, IntervalKeepsItsPromiseEverywhereAndCulls) {
  fuzz::Plugins plugins;
  plugins.load(example("interval"), 10);
  for (const ordered_json& results :
       {campaign<fuzz::ShaftBoxQuestion>(plugins, 2, 6000, {}, {"interval:halving"}),
        campaign<fuzz::ShaftBallQuestion>(plugins, 2, 6000, {}, {"interval:halving"})}) {
    std::size_t rows = 0;
    for (const ordered_json& row : results["rows"]) {
      if (row["method"] != "interval:halving") continue;
      ++rows;
      EXPECT_EQ(row["unsound"], 0) << row["distribution"];
      EXPECT_EQ(row["promise_broken"], false);
      if (row["distribution"] == "uniform") {
        EXPECT_GT(row["matrix"]["outside"]["outside"], 1500);
      }
    }
    EXPECT_GE(rows, 10u);
    EXPECT_FALSE(results.contains("failures"));
  }
}

TEST(PluginExamples, FloatGjkCullsWhatTouches) {
  if (!has_example("gjk")) GTEST_SKIP() << "libccd-dev is not installed";
  fuzz::Plugins plugins;
  plugins.load(example("gjk"), 10);
  const ordered_json results =
      campaign<fuzz::ShaftBoxQuestion>(plugins, 2, 10000, {"integer-grid", "uniform"});
  EXPECT_GT(row_of(results, "gjk:ccd", "f64")["false_culls"], 50);
  const ordered_json uniform = campaign<fuzz::ShaftBoxQuestion>(plugins, 2, 10000, {"uniform"});
  EXPECT_EQ(row_of(uniform, "gjk:ccd", "f64")["false_culls"], 0);
}

TEST(Plugin, TheSameForAnyNumberOfJobs) {
  fuzz::Plugins plugins;
  plugins.load(example("planes"), 10);
  plugins.load(example("interval"), 10);
  const std::vector<std::string> where{"near-touch", "integer-grid"};
  const std::string one = campaign<fuzz::ShaftBoxQuestion>(plugins, 1, 5000, where).dump();
  EXPECT_EQ(campaign<fuzz::ShaftBoxQuestion>(plugins, 2, 5000, where).dump(), one);
  EXPECT_EQ(campaign<fuzz::ShaftBoxQuestion>(plugins, 5, 5000, where).dump(), one);
}

TEST(Plugin, LeavesOurRowsAsTheyAre) {
  fuzz::Plugins plugins;
  const ordered_json without = campaign<fuzz::ShaftBoxQuestion>(plugins, 2, 3000, {"degenerate"});
  plugins.load(example("planes"), 10);
  ordered_json with = campaign<fuzz::ShaftBoxQuestion>(plugins, 2, 3000, {"degenerate"});
  for (const char* const key : {"rows", "witnesses"}) {
    ordered_json& all = with[key];
    for (std::size_t i = all.size(); i-- > 0;) {
      if (all[i]["method"].get<std::string>().starts_with("planes:")) all.erase(i);
    }
  }
  EXPECT_EQ(with.dump(), without.dump());
}

TEST(Plugin, IsNamedInTheCommandAndTheList) {
  const Folder folder;
  const Outcome fuzzed =
      run_gnomon({"fuzz", "shaft-box", "--plugin", example("planes"), "--method", "planes:as-formed",
                  "--distribution", "uniform", "--trials", "1000", "--out", folder / "out"});
  EXPECT_EQ(fuzzed.status, 0) << fuzzed.err;
  const ordered_json json = ordered_json::parse(contents_of(folder / "out/shaft-box-1.json"));
  EXPECT_NE(json["command"].get<std::string>().find(" --plugin " + example("planes")), std::string::npos);
  EXPECT_FALSE(json.contains("complete"));
  ASSERT_EQ(json["rows"].size(), 1u);
  const Outcome listed = run_gnomon({"list", "--json", "--plugin", example("interval")});
  EXPECT_EQ(listed.status, 0) << listed.err;
  EXPECT_NE(listed.out.find("\"interval:halving\""), std::string::npos);
  const Outcome unknown =
      run_gnomon({"fuzz", "shaft-box", "--plugin", example("planes"), "--method", "planes:none"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("planes:normalised"), std::string::npos) << unknown.err;
  for (const char* const question : {"shaft-slabs", "shaft-ellipsoid", "patch-pair"}) {
    const Outcome other = run_gnomon({"fuzz", question, "--plugin", example("planes"), "--trials", "10"});
    EXPECT_EQ(other.status, 2) << question;
    EXPECT_EQ(other.err,
              "gnomon: --plugin: " + std::string(question) + " is no question that plug-ins answer\n");
  }
  const Outcome twice = run_gnomon({"list", "--plugin", example("planes"), "--plugin", example("planes")});
  EXPECT_EQ(twice.status, 2);
  EXPECT_EQ(lines_of(twice.err).size(), 1u) << twice.err;
}

}  // namespace
}  // namespace gnomon::tests
