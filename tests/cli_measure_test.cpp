// SPDX-License-Identifier: GPL-3.0-or-later
// gnomon measure: its table, its result file, and what it refuses.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli_run.h"
#include "tests/shadow_scenes.h"

namespace gnomon::tests {
namespace {

using nlohmann::json;

const std::vector<std::string> kCall{
    "measure",    "s.nff",     "--queries",  "600",           "--rounds",  "2",
    "--workload", "surface",   "--workload", "hard",          "--variant", "given",
    "--method",   "bvh-exact", "--method",   "bvh-naive-f32", "--json",    "r/m.json"};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CommandLineMeasure, WritesAllFieldsOfTheContract) {
  const Folder folder;
  folder.write("s.nff", kBallsNff);
  const Outcome run = run_gnomon(kCall, folder.path());
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* said : {"bvh-naive-f32", "surface", "hard", "rounded to floats", "not independent"}) {
    EXPECT_TRUE(has(run.out, said)) << said << "\n" << run.out;
  }
  EXPECT_FALSE(has(run.out, "\r"));
  const json result = json::parse(contents_of(folder / "r/m.json"));
  EXPECT_EQ(result.at("schema"), 1);
  EXPECT_EQ(result.at("kind"), "measure");
  EXPECT_TRUE(has(result.at("command"), "gnomon measure s.nff --method bvh-exact"));
  EXPECT_FALSE(has(result.at("command"), "json"));
  ASSERT_EQ(result.at("rows").size(), 4u);
  std::uint64_t wrong_on_hard = 0;
  for (const json& row : result.at("rows")) {
    EXPECT_EQ(row.at("question"), "shadow");
    EXPECT_EQ(row.at("scene"), "s.nff");
    EXPECT_EQ(row.at("variant"), "given");
    EXPECT_EQ(row.at("faces"), 69);
    const auto count = [&row](const char* key) { return row.at(key).get<std::uint64_t>(); };
    std::uint64_t sum = 0, wrong = 0;
    for (const auto& [truth, cells] : row.at("matrix").items()) {
      for (const auto& [answer, n] : cells.items()) {
        sum += n.get<std::uint64_t>();
        const bool definite = answer != "undecided" && answer != "rejected";
        wrong += definite && answer != truth ? n.get<std::uint64_t>() : 0;
      }
    }
    EXPECT_EQ(sum, count("queries"));
    EXPECT_EQ(wrong, count("unsound"));
    EXPECT_EQ(wrong, count("false_lit") + count("false_shadowed") + count("wrong_reason"));
    EXPECT_EQ(count("undecided") + count("rejected"), 0u);
    EXPECT_LE(row.at("touching").at("unsound").get<std::uint64_t>(), wrong);
    EXPECT_EQ(row.at("unsound_rate").at("hits"), wrong);
    EXPECT_GT(row.at("tests_per_query").at("boxes").get<double>(), 0);
    EXPECT_GT(row.at("tests_per_query").at("faces").get<double>(), 0);
    EXPECT_FALSE(row.at("promise_broken").get<bool>());
    if (row.at("method") == "bvh-exact") {
      EXPECT_EQ(wrong, 0u);
      EXPECT_EQ(row.at("promise"), "always agrees");
    } else if (row.at("workload") == "hard") {
      wrong_on_hard += wrong;
    }
  }
  EXPECT_GT(wrong_on_hard, 10u);
  const json& measured = result.at("measured");
  EXPECT_TRUE(measured.at("environment").is_object());
  EXPECT_EQ(measured.at("rounds"), 2);
  ASSERT_EQ(measured.at("set_ups").size(), 2u);
  for (const json& set_up : measured.at("set_ups")) {
    EXPECT_GT(set_up.at("seconds").get<double>(), 0);
    EXPECT_GT(set_up.at("bytes").get<std::uint64_t>(), 69u);
  }
  ASSERT_EQ(measured.at("ns_per_query").size(), 8u);  // two orders a row
  for (const json& time : measured.at("ns_per_query")) {
    const json& ns = time.at("ns");
    EXPECT_GT(ns.at("low25").get<double>(), 0);
    EXPECT_LE(ns.at("low25").get<double>(), ns.at("median").get<double>());
    EXPECT_LE(ns.at("median").get<double>(), ns.at("high75").get<double>());
  }
}

TEST(CommandLineMeasure, AsksFirstHitToo) {
  const Folder folder;
  folder.write("s.nff", kBallsNff);
  const Outcome run =
      run_gnomon({"measure",    "s.nff",     "--queries",  "2000",          "--rounds",  "1",
                  "--workload", "hard-rays", "--workload", "primary-rays",  "--variant", "given",
                  "--method",   "bvh-exact", "--method",   "bvh-naive-f32", "--method",  "bvh-certified-f32",
                  "--method",   "reference", "--json",     "m.json"},
                 folder.path());
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, "first-hit, 69 faces, 2000 rays, exactly ")) << run.out;
  const json result = json::parse(contents_of(folder / "m.json"));
  ASSERT_EQ(result.at("rows").size(), 8u);
  std::uint64_t wrong_on_hard = 0;
  for (const json& row : result.at("rows")) {
    const auto count = [&row](const char* key) { return row.at(key).get<std::uint64_t>(); };
    EXPECT_EQ(row.at("question"), "first-hit");
    EXPECT_EQ(row.at("faces"), 69);
    const json& none = row.at("matrix").at("none");
    const json& face = row.at("matrix").at("face");
    std::uint64_t sum = 0;
    for (const json* cells : {&none, &face}) {
      for (const json& n : *cells) sum += n.get<std::uint64_t>();
    }
    EXPECT_EQ(sum, count("queries"));
    EXPECT_EQ(none.at("right"), 0);
    EXPECT_EQ(face.at("wrong"), count("wrong_face"));
    EXPECT_EQ(face.at("none"), count("false_miss"));
    EXPECT_EQ(none.at("wrong"), count("false_hit"));
    EXPECT_EQ(count("unsound"), count("wrong_face") + count("false_miss") + count("false_hit"));
    EXPECT_EQ(row.at("unsound_rate").at("hits"), count("unsound"));
    EXPECT_EQ(row.at("false_hit_rate").at("of").get<std::uint64_t>() +
                  row.at("wrong_face_rate").at("of").get<std::uint64_t>(),
              count("queries"));
    EXPECT_LE(row.at("touching").at("unsound").get<std::uint64_t>(), count("unsound"));
    EXPECT_GT(row.at("tests_per_query").at("boxes").get<double>(), 0);
    EXPECT_EQ(count("rejected"), 0u);
    EXPECT_FALSE(row.at("promise_broken").get<bool>());
    const std::string method = row.at("method");
    EXPECT_TRUE(method == "bvh-naive-f32" || count("unsound") == 0) << method;
    EXPECT_TRUE(method == "bvh-certified-f32" || count("undecided") == 0) << method;
    if (row.at("workload") == "hard-rays") {
      EXPECT_GT(count("ties"), 100u);  // edges and vertices, met exactly
      if (method == "bvh-naive-f32") wrong_on_hard += count("unsound");
      EXPECT_EQ(method == "bvh-certified-f32", count("undecided") > 0) << method;
    }
  }
  EXPECT_GT(wrong_on_hard, 10u);
  EXPECT_EQ(result.at("measured").at("ns_per_query").size(), 16u);
  for (const json& time : result.at("measured").at("ns_per_query"))
    EXPECT_EQ(time.at("question"), "first-hit");
}

TEST(CommandLineMeasure, GivesTheSameRowsEachTime) {
  const Folder folder;
  folder.write("s.nff", kTrianglesNff);
  const auto rows = [&folder](const std::string& file) {
    const Outcome run =
        run_gnomon({"measure", "s.nff", "--queries", "400", "--rounds", "1", "--json", file}, folder.path());
    EXPECT_EQ(run.status, 0) << run.err;
    json result = json::parse(contents_of(folder / file));
    EXPECT_EQ(result.erase("measured"), 1u);
    return result.dump();
  };
  const std::string first = rows("a.json");
  EXPECT_EQ(first, rows("b.json"));
  // All methods, hard in all variants, the others in one.
  for (const char* said : {"cgal-epick", "reference", "primary", "light-rays", "primary-rays", "hard-rays",
                           "scaled-down", "moved"}) {
    EXPECT_TRUE(has(first, said)) << said;
  }
}

// Two rows of one key could not be compared.
TEST(CommandLineMeasure, AsksWhatIsSaidTwiceOnce) {
  const Folder folder;
  folder.write("s.nff", kBallsNff);
  const Outcome run =
      run_gnomon({"measure",  "s.nff",      "s.nff",    "--queries",  "90",        "--rounds", "1",
                  "--method", "bvh-exact",  "--method", "bvh-exact",  "--variant", "moved",    "--variant",
                  "moved",    "--workload", "surface",  "--workload", "surface",   "--json",   "r.json"},
                 folder.path());
  ASSERT_EQ(run.status, 0) << run.err;
  const json result = json::parse(contents_of(folder / "r.json"));
  EXPECT_EQ(result.at("rows").size(), 1u);
  EXPECT_EQ(result.at("measured").at("set_ups").size(), 1u);
}

TEST(CommandLineMeasure, TakesLightsInsteadOfTheScenesOwn) {
  const Folder folder;
  folder.write("s.nff", "p 3\n-9 -9 0\n9 -9 0\n0 9 0\nl 0 0 -5\n");
  const auto facing = [&folder](std::vector<std::string> lights) {
    std::vector<std::string> words{"measure",   "s.nff",      "--queries", "90",       "--rounds",
                                   "1",         "--workload", "surface",   "--method", "bvh-exact",
                                   "--variant", "given",      "--json",    "r.json"};
    for (const std::string& light : lights) words.insert(words.end(), {"--light", light});
    EXPECT_EQ(run_gnomon(words, folder.path()).status, 0);
    const json result = json::parse(contents_of(folder / "r.json"));
    return result.at("rows").at(0).at("matrix").at("facing").at("facing").get<int>();
  };
  EXPECT_EQ(facing({}), 90);
  EXPECT_EQ(facing({"0,0,5"}), 0);
  EXPECT_EQ(facing({"0,0,5", "0,1,4", "1,0,-3"}), 30);
}

TEST(CommandLineMeasure, RefusesBadInputInOneLineAndWritesNothing) {
  const Folder folder;
  folder.write("s.nff", kBallsNff);
  folder.write("bad.nff", "p 3\n0 0 0\n");
  folder.write("far.off", "OFF\n3 1 0\n0 0 0\n1e40 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("points.off", "OFF\n1 0 0\n0 0 0\n");
  const std::set<std::string> before = folder.entries();
  const std::pair<std::vector<std::string>, std::string> calls[] = {
      {{"sphereflake:99", "s.nff"}, "sphereflake:99"},
      {{"no-such-scene"}, "no-such-scene: expected"},
      {{"none.nff"}, "none.nff: expected"},
      {{"bad.nff"}, "bad.nff:2: expected"},
      {{"far.off"}, "far.off (given): expected a coordinate within the range of floats, found 1e+40"},
      {{"points.off"}, "points.off:2: expected"},
      {{"s.nff", "--method", "bvh"}, "--method: expected a method (brute-naive-f32, "},
      {{"s.nff", "--method", "\x1b[31m"}, "found \"\\x1b[31m\""},
      {{"s.nff", "--workload", "all"}, "--workload: expected a workload (primary, "},
      {{"s.nff", "--variant", "turned"}, "--variant: expected a variant (given, "},
      {{"s.nff", "--light", "1,2"}, "--light: expected X,Y,Z"},
      {{"s.nff", "--light", "1,2,3,4"}, "--light: expected X,Y,Z"},
      {{"s.nff", "--light", "1,2,nan"}, "--light: expected X,Y,Z"},
      {{"s.nff", "--light", "1,2,1e39"}, "--light: expected X,Y,Z"},
      {{"s.nff", "--variant", "scaled-up", "--light", "1,2,1e38"}, "expected a light within the range of"},
      {{"s.nff", "--light", "1, 2,3"}, "--light: expected X,Y,Z"},
      {{"s.nff", "--light", ""}, "--light: expected a value"},
      {{"s.nff", "--queries", "0"}, "--queries: expected a whole number"},
      {{"s.nff", "--queries", "-5"}, "--queries: expected a whole number"},
      {{"s.nff", "--rounds", "0"}, "--rounds: expected a whole number"},
      {{"s.nff", "--json", "s.nff/r.json"}, "can't be written"},
  };
  for (const auto& [more, said] : calls) {
    std::vector<std::string> words{"measure"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = run_gnomon(words, folder.path());
    EXPECT_EQ(run.status, 2) << said;
    EXPECT_EQ(run.out, "") << said;
    EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    EXPECT_TRUE(has(run.err, said)) << run.err << "expected " << said;
    EXPECT_EQ(folder.entries(), before) << said;
  }
}

}  // namespace
}  // namespace gnomon::tests
