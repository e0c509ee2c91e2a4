// SPDX-License-Identifier: GPL-3.0-or-later
// The command line's contract: exit status, result files, replays, pages. Bad input is in
// cli_errors_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "fuzz/generator.h"
#include "fuzz/pair_source.h"
#include "scene/corpus.h"
#include "tests/cli_run.h"
#include "tests/report_xml_check.h"

namespace gnomon::tests {
namespace {

using nlohmann::json;

const std::string kCorpus = std::string(GNOMON_SOURCE_DIR) + "/tests/corpus/shaft.txt";

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The verbs that `gnomon --help` names.
std::vector<std::string> verbs() {
  std::vector<std::string> names;
  bool listed = false;
  for (const std::string& line : lines_of(run_gnomon({"--help"}).out)) {
    if (listed && line.size() > 2 && line.rfind("  ", 0) == 0 && line[2] != ' ') {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    } else {
      listed = line.rfind("Subcommands:", 0) == 0 || (listed && line.rfind("  ", 0) == 0);
    }
  }
  return names;
}

TEST(CommandLine, HelpShowsAnExampleOfEveryVerb) {
  const Outcome top = run_gnomon({"--help"});
  EXPECT_EQ(top.status, 0);
  EXPECT_TRUE(has(top.out, "Examples:"));
  EXPECT_TRUE(has(top.out, "Exit status:"));
  const std::vector<std::string> names = verbs();
  for (const std::string verb :
       {"list", "fuzz", "replay", "explain", "report", "claims", "scene", "measure", "render"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), verb), names.end()) << verb;
  }
  for (const std::string& verb : names) {
    const Outcome help = run_gnomon({verb, "--help"});
    EXPECT_EQ(help.status, 0) << verb;
    EXPECT_TRUE(has(help.out, "Example")) << verb << " has no example";
    EXPECT_TRUE(has(help.out, "gnomon " + verb)) << verb;
    EXPECT_EQ(help.err, "") << verb;
  }
  const Outcome version = run_gnomon({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.rfind("gnomon ", 0), 0u);
}

// An example that names what does not exist teaches nothing.
TEST(CommandLine, ExamplesOfHelpNameWhatThereIs) {
  std::set<std::string> methods;
  const json listed = json::parse(run_gnomon({"list", "--json"}).out);
  for (const json& question : listed.at("questions")) {
    for (const json& method : question.at("methods")) methods.insert(method.at("name"));
  }
  std::size_t named = 0;
  std::vector<std::string> all = verbs();
  for (const std::string& verb : all) {
    for (const std::string& line : lines_of(run_gnomon({verb, "--help"}).out)) {
      std::istringstream words(line);
      std::string option, value;
      if (!(words >> option) || option != "gnomon") continue;
      while (words >> option) {
        if (option == "--method" && words >> value) {
          EXPECT_TRUE(methods.contains(value)) << line;
        } else if (option == "--distribution" && words >> value) {
          if (has(line, "shaft-candidates") || has(line, "patch-pair")) {
            EXPECT_NO_THROW((void)fuzz::parse_pair_distribution(value)) << line;
          } else {
            EXPECT_NO_THROW((void)fuzz::parse_distribution(value)) << line;
          }
        } else {
          continue;
        }
        ++named;
      }
    }
  }
  EXPECT_GE(named, 4u);
}

TEST(CommandLine, ListSaysWhatThereIs) {
  const Outcome text = run_gnomon({"list"}), machine = run_gnomon({"list", "--json"});
  ASSERT_EQ(text.status, 0);
  ASSERT_EQ(machine.status, 0);
  const json all = json::parse(machine.out);
  std::map<std::string, std::size_t> methods;
  for (const json& question : all.at("questions")) {
    const std::map<std::string, json> answers{{"shaft-box", {"outside", "overlap", "inside"}},
                                              {"shaft-sphere", {"outside", "overlap", "inside"}},
                                              {"shaft-slabs", {"outside", "overlap", "inside"}},
                                              {"shaft-oriented-box", {"outside", "overlap", "inside"}},
                                              {"shaft-ellipsoid", {"outside", "overlap", "inside"}},
                                              {"shaft-candidates", {"same", "more", "missing"}},
                                              {"patch-pair", {"all", "none", "part"}},
                                              {"shadow", {"lit", "shadowed", "facing"}},
                                              {"first-hit", {"none", "face"}}};
    EXPECT_EQ(question.at("answers"), answers.at(question.at("id")));
    for (const json& method : question.at("methods")) {
      ++methods[question.at("id")];
      EXPECT_TRUE(has(text.out, method.at("name"))) << method;
      EXPECT_TRUE(has(text.out, method.at("promise"))) << method;
      EXPECT_FALSE(method.at("scalars").empty()) << method;
      EXPECT_FALSE(method.at("domain").get<std::string>().empty()) << method;
    }
  }
  EXPECT_GE(methods["shaft-box"], 10u);
  EXPECT_GE(methods["shaft-sphere"], 9u);
  EXPECT_GE(methods["shaft-candidates"], 13u);
  EXPECT_GE(methods["shadow"], 7u);
  EXPECT_EQ(methods["first-hit"], methods["shadow"]);
  EXPECT_GE(all.at("distributions").size(), 11u);
  for (const json& distribution : all.at("distributions")) {
    EXPECT_TRUE(has(text.out, distribution.at("name"))) << distribution;
  }
  EXPECT_TRUE(has(text.out, "Not built in: "));
}

const std::vector<std::string> kFuzz{"fuzz",    "shaft-box", "--distribution", "near-touch", "--distribution",
                                     "uniform", "--trials",  "4000",           "--seed",     "5"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(CommandLine, FuzzWritesAllFieldsOfTheContract) {
  const Folder folder;
  const Outcome run = run_gnomon(with(kFuzz, {"--jobs", "1", "--json", folder / "r.json"}));
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");  // no progress and no messages: this is no terminal
  EXPECT_TRUE(has(run.out, "naive-f32"));
  EXPECT_FALSE(has(run.out, "\033"));
  EXPECT_FALSE(has(run.out, "\r"));
  const json result = json::parse(contents_of(folder / "r.json"));
  EXPECT_EQ(result.at("schema"), 1);
  EXPECT_EQ(result.at("seed"), 5);
  EXPECT_TRUE(has(result.at("command"), "gnomon fuzz shaft-box"));
  EXPECT_TRUE(has(result.at("command"), "--seed 5"));
  EXPECT_FALSE(has(result.at("command"), "jobs"));
  EXPECT_TRUE(result.at("measured").at("environment").is_object());
  EXPECT_EQ(result.at("measured").at("ns_per_case").size(), result.at("rows").size());
  std::size_t forms = 0;  // a row for each form of each method that is not for batches, and each distribution
  const json listed = json::parse(run_gnomon({"list", "--json"}).out);
  for (const json& method : listed.at("questions")[0].at("methods")) {
    if (!method.at("in_batches")) forms += method.at("scalars").size();
  }
  EXPECT_EQ(result.at("rows").size(), 2 * forms);
  for (const json& row : result.at("rows")) {
    EXPECT_EQ(row.at("question"), "shaft-box");
    for (const char* key : {"method", "promise", "distribution", "scalar"})
      EXPECT_TRUE(row.at(key).is_string()) << key;
    EXPECT_EQ(row.at("trials"), 4000);
    std::uint64_t sum = 0, wrong = 0;
    for (const char* truth : {"outside", "overlap", "inside"}) {
      for (const char* answer : {"outside", "overlap", "inside"}) {
        const std::uint64_t count = row.at("matrix").at(truth).at(answer);
        sum += count;
        wrong += std::string(truth) == answer ? 0 : count;
      }
    }
    const auto count = [&row](const char* key) { return row.at(key).get<std::uint64_t>(); };
    EXPECT_EQ(sum + count("undecided") + count("rejected"), 4000u);
    EXPECT_EQ(count("waste") + count("unsound"), wrong);
    EXPECT_LE(count("rounding") + count("model"), wrong + count("rounding_and_model"));
    for (const char* key : {"outside", "inside"})
      EXPECT_TRUE(row.at("touching").at(key).is_number_unsigned());
    for (const char* rate : {"waste_rate", "unsound_rate"}) {
      const double value = row.at(rate).at("value");
      EXPECT_LE(row.at(rate).at("low95").get<double>(), value);
      EXPECT_GE(row.at(rate).at("high95").get<double>(), value);
    }
    EXPECT_EQ(row.at("worst_gap").is_null(), wrong == 0);
    if (wrong > 0) {
      EXPECT_TRUE(row.at("worst_gap").at("rational").is_string());
      EXPECT_TRUE(row.at("worst_gap").at("approx").is_number());
      EXPECT_TRUE(row.at("worst_gap").at("ulps").is_number());
    }
    EXPECT_TRUE(row.at("witnesses").is_array());
    const bool silent = wrong == 0 || row.at("method") == "trivial";
    EXPECT_EQ(row.at("witnesses").empty(), silent) << row.at("method");
  }
}

/// The file as text up to "measured", which is written last.
std::string before_measured(const std::string& file) {
  const std::string text = contents_of(file);
  const std::size_t end = text.find("\"measured\"");
  EXPECT_NE(end, std::string::npos);
  return text.substr(0, end);
}

TEST(CommandLine, FuzzGivesTheSameBytesForAnyNumberOfJobs) {
  const Folder folder;
  std::string first;
  for (const char* jobs : {"1", "2", "5"}) {
    ASSERT_EQ(run_gnomon(with(kFuzz, {"--jobs", jobs, "--json", folder / jobs})).status, 0);
    const std::string text = before_measured(folder / jobs);
    if (first.empty()) first = text;
    EXPECT_EQ(text, first) << jobs;
  }
}

TEST(CommandLine, FuzzShardsAndTimesAreWritten) {
  const Folder folder;
  for (const char* shard : {"1/2", "2/2"}) {
    const Outcome run = run_gnomon({"fuzz", "shaft-sphere", "--trials", "2000", "--method", "exact",
                                    "--shard", shard, "--out", folder.path()});
    EXPECT_EQ(run.status, 0) << run.err;
  }
  EXPECT_EQ(folder.entries(),
            (std::set<std::string>{"shaft-sphere-1-1of2.json", "shaft-sphere-1-2of2.json"}));
  const json part = json::parse(contents_of(folder / "shaft-sphere-1-2of2.json"));
  EXPECT_EQ(part.at("shard"), "2/2");
  EXPECT_EQ(part.at("rows")[0].at("trials"), 976);  // blocks of 1024 go to the shards in turn
  EXPECT_EQ(run_gnomon({"fuzz", "shaft-box", "--time", "0.2s", "--method", "trivial"}).status, 0);
}

TEST(CommandLine, OutHoldsResultAndWitnessesThatReplay) {
  const Folder folder;
  for (const std::string question : {"shaft-box", "shaft-sphere"}) {
    const Outcome run = run_gnomon({"fuzz", question, "--trials", "3000", "--distribution", "near-touch",
                                    "--distribution", "offset:1e5", "--out", folder / question});
    ASSERT_EQ(run.status, 0) << run.err;
    const json result = json::parse(contents_of(folder / (question + "/" + question + "-1.json")));
    std::set<std::string> named;
    for (const json& witness : result.at("witnesses")) {
      named.insert(witness.at("name"));
      const std::string file = folder / (question + "/witnesses/" + witness.at("name").get<std::string>());
      EXPECT_TRUE(has(contents_of(file), witness.at("case").get<std::string>()));
      const Outcome replay = run_gnomon({"replay", file, "--method", witness.at("method")});
      EXPECT_EQ(replay.status, 0) << replay.err;
      const std::size_t line = lines_of(contents_of(file)).size();  // the case is the last line
      const bool lies = witness.at("verdict") == "false cull" || witness.at("verdict") == "false inside";
      EXPECT_EQ(replay.out,
                file + ":" + std::to_string(line) + " " + witness.at("method").get<std::string>() + " " +
                    witness.at("answer").get<std::string>() + " " +
                    witness.at("reference").get<std::string>() + (lies ? " unsound\n" : " waste\n"));
    }
    EXPECT_GT(named.size(), 5u);
    std::set<std::string> in_rows, on_disk;
    for (const json& row : result.at("rows"))
      in_rows.insert(row.at("witnesses").begin(), row.at("witnesses").end());
    for (const auto& entry : std::filesystem::directory_iterator(folder / (question + "/witnesses")))
      on_disk.insert(entry.path().filename());
    EXPECT_EQ(in_rows, named);
    EXPECT_EQ(on_disk, named);
  }
}

TEST(CommandLine, TheCorpusAgreesWithItsStatedAnswers) {
  const Folder folder;
  const Outcome run = run_gnomon({"replay", kCorpus, "--json", folder / "r.json"});
  EXPECT_EQ(run.status, 0) << run.err;
  const json result = json::parse(contents_of(folder / "r.json"));
  EXPECT_EQ(result.at("schema"), 1);
  EXPECT_TRUE(result.at("wrong_answers").empty()) << result.at("wrong_answers");
  EXPECT_GE(result.at("cases"), 60);
  EXPECT_EQ(result.at("stated"), result.at("cases"));
  const std::vector<std::string> lines = lines_of(run.out);
  ASSERT_EQ(lines.size(), result.at("lines").size());
  std::map<std::string, int> verdicts, truths;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const json& line = result.at("lines")[i];
    const auto text = [&line](const char* key) { return line.at(key).get<std::string>(); };
    EXPECT_EQ(lines[i], text("where") + " " + text("method") + " " + text("answer") + " " +
                            text("reference") + " " + text("verdict"));
    EXPECT_EQ(text("where").rfind(kCorpus + ":", 0), 0u);
    if (text("method") == "exact") {
      EXPECT_EQ(text("verdict"), "agree") << lines[i];
      ++truths[text("question") + " " + text("reference")];
    }
    ++verdicts[text("method") + " " + text("verdict")];
  }
  // The corpus is worth its name: every truth often, and lies of every method that can lie.
  for (const std::string question : {"shaft-box", "shaft-sphere"}) {
    for (const std::string truth : {"outside", "overlap", "inside"})
      EXPECT_GE(truths[question + " " + truth], 5) << truth;
  }
  for (const std::string method : {"naive-f32", "naive-f64", "normalised-f32", "printed-f32", "slab-f32"}) {
    EXPECT_GT(verdicts[method + " unsound"], 0) << method;
  }
  EXPECT_EQ(
      verdicts["certified-f32 unsound"] + verdicts["certified-f64 unsound"] + verdicts["trivial unsound"], 0);
}

TEST(CommandLine, AWrongStatedAnswerIsNamed) {
  const Folder folder;
  const std::string file =
      folder.write("c.txt",
                   "# two cases\nshaft-box 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 3 1 1 -> inside\n"
                   "shaft-box 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 3 1 1 -> outside # wrong\n");
  const Outcome run = run_gnomon({"replay", file, "--method", "exact"});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(has(run.err, file + ":3: states outside, exactly it is inside\n")) << run.err;
  EXPECT_FALSE(has(run.err, ":2:")) << run.err;
  EXPECT_EQ(run.out, file + ":2 exact inside inside agree\n" + file + ":3 exact inside inside agree\n");
}

TEST(CommandLine, ReplayRejectsDoublesForFloatMethodsAloud) {
  const Folder folder;
  const std::string file = folder.write("c.txt", "shaft-box 0.1 0 0 1 1 1 4 0 0 5 1 1 2 0 0 3 1 1\n");
  const Outcome run = run_gnomon({"replay", file, "--method", "naive-f32", "--method", "naive-f64"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out,
            file + ":1 naive-f32 rejected inside rejected\n" + file + ":1 naive-f64 inside inside agree\n");
}

TEST(CommandLine, ExplainShowsNumbersGapAndPicture) {
  const Folder folder;
  const std::string box =
      folder.write("b.txt", "shaft-box 0 0 0 1 1 1 4 0 0 5 1 1 1.5 1.1 0.25 2 2 0.5 -> outside\n");
  const Outcome run = run_gnomon({"explain", box, "--svg", folder / "b.svg"});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* part :
       {"b.txt:1: shaft-box", "1.5", "0x1.8p+0", "1.1", "outside", "gap", "ulps", "naive-f64", "rejected"}) {
    EXPECT_TRUE(has(run.out, part)) << part << "\n" << run.out;
  }
  for (const char mark : {'A', 'B', 'T', '.', '|'}) EXPECT_TRUE(has(run.out, std::string(1, mark))) << mark;
  EXPECT_EQ(xml_fault(contents_of(folder / "b.svg")), "");
  EXPECT_TRUE(has(contents_of(folder / "b.svg"), "<svg"));

  const std::string ball =
      folder.write("s.txt", "shaft-sphere 0 0 0 1 1 1 4 0 0 5 1 1 2 3 0.5 2 # touches y = 1\n");
  const Outcome sphere = run_gnomon({"explain", ball, "--svg", folder / "s.svg"});
  ASSERT_EQ(sphere.status, 0) << sphere.err;
  for (const char* part : {"overlap", "touches", "gap", "radius 2", "squared length"}) {
    EXPECT_TRUE(has(sphere.out, part)) << part << "\n" << sphere.out;
  }
  EXPECT_EQ(xml_fault(contents_of(folder / "s.svg")), "");
}

// The whole corpus, huge and denormal cases too: words and pictures of anything.
TEST(CommandLine, ExplainManagesTheWholeCorpus) {
  const Outcome run = run_gnomon({"explain", kCorpus});
  EXPECT_EQ(run.status, 0) << run.err;
  std::size_t pictures = 0;
  for (const std::string& line : lines_of(run.out)) pictures += line.rfind("seen along", 0) == 0;
  EXPECT_EQ(pictures, scene::read_corpus(kCorpus).size());
  EXPECT_FALSE(has(run.out, "nan"));
}

TEST(CommandLine, ReportIsOnePage) {
  const Folder folder;
  ASSERT_EQ(run_gnomon(with(kFuzz, {"--out", folder / "results"})).status, 0);
  const Outcome run = run_gnomon({"report", "results", "-o", "page.html"}, folder.path());
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string page = contents_of(folder / "page.html");
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0) == 0 || page.rfind("<!doctype html>", 0) == 0, true);
  EXPECT_TRUE(has(page, "near-touch"));
  EXPECT_FALSE(has(page, "src=\"http"));
  std::size_t pages = 0;
  for (const std::string& name : folder.entries()) pages += name.ends_with(".html");
  EXPECT_EQ(pages, 1u);
}

}  // namespace
}  // namespace gnomon::tests
