// SPDX-License-Identifier: GPL-3.0-or-later
// Bad usage and bad input: exit status 2, one line on standard error that says where and what, and nothing
// written.
#include <gtest/gtest.h>

#include "tests/cli_run.h"

namespace gnomon::tests {
namespace {

const std::string kBox = "shaft-box 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 3 1 1";

struct BadCall {
  std::vector<std::string> arguments;
  std::string said;  ///< a part of the complaint
};

/// Runs in a folder of its own that holds a few files.
class BadInput : public testing::Test {
 protected:
  BadInput() {
    folder_.write("good.txt", kBox + " -> inside\n");
    folder_.write("nan.txt", "# a comment\nshaft-box 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 3 nan 1\n");
    folder_.write("infinite.txt", "shaft-box 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 3 1 1e999\n");
    folder_.write("order.txt", kBox + "\n\nshaft-box 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 1 1 1\n");
    folder_.write("radius.txt", "shaft-sphere 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0 -1\n");
    folder_.write("few.txt", "shaft-sphere 0 0 0 1 1 1 4 0 0 5 1 1 2 0 0\n");
    folder_.write("many.txt", kBox + " 7\n");
    folder_.write("question.txt", "shaft-bocks 1 2 3\n");
    folder_.write("answer.txt", kBox + " -> in\n");
    folder_.write("arrow.txt", kBox + " ->\n");
    folder_.write("escape.txt", "shaft-box \033[31mred\n");
    folder_.write("empty.txt", "# nothing\n");
    folder_.write("two.txt", kBox + "\n" + kBox + "\n");
    folder_.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n");
    folder_.write("flat.off", "OFF\n0 0 0\n");
    folder_.write("file", "not a folder");
    folder_.write("not.json", "{");
    std::filesystem::create_directory(folder_ / "folder");
    std::filesystem::create_directory(folder_ / "rubbish");
    folder_.write("rubbish/r.json", "{\"schema\": 1,\n");
  }

  void expect_refused(const BadCall& call) const {
    std::string shown;
    for (const std::string& word : call.arguments) shown += " " + word;
    const std::set<std::string> before = folder_.entries();
    const Outcome run = run_gnomon(call.arguments, folder_.path());
    EXPECT_EQ(run.status, 2) << shown << "\n" << run.err;
    EXPECT_EQ(run.out, "") << shown;
    EXPECT_EQ(lines_of(run.err).size(), 1u) << shown << "\n" << run.err;
    EXPECT_EQ(run.err.rfind("gnomon: ", 0), 0u) << shown << "\n" << run.err;
    EXPECT_NE(run.err.find(call.said), std::string::npos) << shown << "\n"
                                                          << run.err << "expected " << call.said;
    for (const char c : run.err.substr(0, run.err.size() - 1)) ASSERT_TRUE(c >= 0x20 && c < 0x7f) << shown;
    EXPECT_EQ(folder_.entries(), before) << shown;
  }

  Folder folder_;
};

TEST_F(BadInput, VerbsAndOptions) {
  for (const BadCall& call : std::vector<BadCall>{
           {{}, "subcommand is required"},
           {{"fuss"}, "expected a verb, found \"fuss\""},
           {{"list", "--jsn"}, "--jsn"},
           {{"list", "all"}, "all"},
           {{"fuzz"}, "question is required"},
           {{"fuzz", "shaft-box", "--method"}, "--method"},
           {{"replay"}, "files is required"},
           {{"explain"}, "witness is required"},
           {{"report"}, "folder is required"},
       }) {
    expect_refused(call);
  }
}

TEST_F(BadInput, OptionsOfFuzz) {
  const auto with = [](std::vector<std::string> more) {
    std::vector<std::string> all{"fuzz", "shaft-box", "--out", "results", "--json", "r.json"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const auto number = [](const std::string& found) { return ", found \"" + found + "\""; };
  std::vector<BadCall> calls{
      {{"fuzz", "shaft-cube"},
       "expected a question (shaft-box, shaft-sphere, shaft-slabs, shaft-oriented-box, shaft-ellipsoid, "
       "shaft-candidates, patch-pair), found \"shaft-cube\""},
      {with({"--method", "naif"}), "expected one of trivial, "},
      {{"fuzz", "shaft-sphere", "--method", "normalised-f32"}, "found \"normalised-f32\""},
      {with({"--distribution", "unifrom"}), "expected one of uniform, "},
      {with({"--distribution", "uniform:3"}), "takes no argument"},
      {with({"--distribution", "offset:zero"}), "found \"zero\""},
      {with({"--distribution", "mesh"}), "expected mesh:ARG"},
      {with({"--distribution", "mesh:none.off"}), "none.off"},
      {with({"--distribution", "mesh:bad.off"}), "bad.off:5: expected "},
      {with({"--distribution", "mesh:flat.off"}), "flat.off"},
      {with({"--distribution", "mesh:good.txt"}), "good.txt"},
      {with({"--time", ""}), "--time: expected a value"},
      {with({"--method", ""}), "--method: expected a value"},
      {with({"--scalar", ""}), "--scalar: expected a value"},
      {{"fuzz", ""}, "question: expected a value"},
      {{"fuzz", "shaft-box", "--out", ""}, "--out: expected a value"},
      {with({"--scalar", "f16"}), "expected f32 or f64, found \"f16\""},
      {with({"--trials", "many"}), number("many")},
      {with({"--trials", "0"}), number("0")},
      {with({"--trials", "-5"}), number("-5")},
      {with({"--trials", "1.5"}), number("1.5")},
      {with({"--trials", "18446744073709551615"}), number("18446744073709551615")},
      {with({"--trials", "99999999999999999999"}), number("99999999999999999999")},
      {with({"--seed", "-1"}), number("-1")},
      {with({"--seed", "x"}), number("x")},
      {with({"--jobs", "0"}), number("0")},
      {with({"--jobs", "-1"}), number("-1")},
      {with({"--jobs", "100000"}), number("100000")},
      {with({"--witnesses", "-1"}), number("-1")},
  };
  for (const char* shard :
       {"", "1", "0/2", "3/2", "1/0", "a/b", "1/2/3", "-1/2", "1/", "/2", " 1/2", "1/99999999999"}) {
    calls.push_back({with({"--shard", shard}),
                     *shard == '\0' ? "--shard: expected a value" : "expected I/N with 1 <= I <= N, found "});
  }
  for (const char* time : {"0", "-1s", "5x", "s", "1e99h", "nan", "inf", "5 s", "1h30m"}) {
    calls.push_back({with({"--time", time}), "expected a duration such as 60s, 5m or 2h, found "});
  }
  for (const BadCall& call : calls) expect_refused(call);
}

TEST_F(BadInput, PlacesThatCantBeWritten) {
  // More trials than a lifetime holds: the places are tried before the work.
  const std::vector<std::string> fuzz{"fuzz",     "shaft-box", "--trials",       "1000000000000000",
                                      "--method", "exact",     "--distribution", "uniform"};
  for (const auto& [option, place] : std::vector<std::pair<std::string, std::string>>{
           {"--json", "file/r.json"}, {"--json", "folder"}, {"--out", "file"}, {"--out", "file/below"}}) {
    std::vector<std::string> all = fuzz;
    all.insert(all.end(), {option, place});
    expect_refused({all, "can't be written"});
  }
  expect_refused({{"replay", "good.txt", "--json", "file/r.json"}, "can't be written"});
}

TEST_F(BadInput, CorporaNameFileLineAndWhatWasExpected) {
  for (const std::string verb : {"replay", "explain"}) {
    for (const BadCall& call : std::vector<BadCall>{
             {{verb, "none.txt"}, "none.txt: expected a text corpus, found no file"},
             {{verb, "folder"}, "folder: expected a text corpus, found a folder"},
             {{verb, "empty.txt"}, "empty.txt: expected at least one case, found none"},
             {{verb, "nan.txt"}, "nan.txt:2: expected a number, found 'nan'"},
             {{verb, "infinite.txt"},
              "infinite.txt:1: expected a number within the range of a double, found '1e999'"},
             {{verb, "order.txt"}, "order.txt:3: expected a box T with finite lo <= hi"},
             {{verb, "radius.txt"}, "radius.txt:1: expected a ball with finite centre and radius >= 0"},
             {{verb, "few.txt"}, "few.txt:1: expected 16 numbers for shaft-sphere, found 15"},
             {{verb, "many.txt"}, "many.txt:1: expected 18 numbers for shaft-box, found 19"},
             {{verb, "question.txt"},
              "question.txt:1: expected a question (shaft-box, shaft-sphere, shaft-slabs, "
              "shaft-oriented-box, shaft-ellipsoid, shadow, shaft-candidates, patch-pair)"},
             {{verb, "answer.txt"}, "answer.txt:1: expected outside, overlap or inside"},
             {{verb, "arrow.txt"}, "arrow.txt:1: expected an answer after \"->\""},
             {{verb, "escape.txt"}, "escape.txt:1: expected "},
         }) {
      expect_refused(call);
    }
  }
  expect_refused({{"replay", "good.txt", "nan.txt"}, "nan.txt:2:"});
  expect_refused({{"replay", "good.txt", "--method", "no-such"}, "found \"no-such\""});
  expect_refused({{"explain", "two.txt", "--svg", "x.svg"}, "expected one case for --svg, found 2"});
}

TEST_F(BadInput, ReportsNeedResults) {
  expect_refused({{"report", "none"}, "none: expected a folder of result files"});
  expect_refused({{"report", "file"}, "file: expected a folder of result files"});
  expect_refused({{"report", "folder"}, "folder: expected at least one *.json result file"});
  expect_refused({{"report", "rubbish"}, "r.json:2: expected JSON"});
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  folder_.write("rubbish/r.json", "{\"schema\": " + deep + "}");
  expect_refused({{"report", "rubbish"}, "r.json: expected JSON of at most 64 levels"});
}

}  // namespace
}  // namespace gnomon::tests
