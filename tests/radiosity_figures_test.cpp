// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of radiosity: figures written and read back, ratios, the report's part, the command line.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/html_radiosity.h"
#include "reports/json_node.h"
#include "reports/list_json.h"
#include "reports/radiosity_ratio.h"
#include "scene/input_error.h"
#include "tests/cli_run.h"
#include "tests/shadow_scenes.h"

namespace gnomon::reports {
namespace {

using tests::Folder;
using tests::Outcome;
using tests::run_gnomon;

/// Two rows of Table 1 as if measured on the paper's standard office.
std::vector<ListFigures> two_rows() {
  ListRate rate;
  rate.pairs = 10, rate.rays = 1000, rate.shadowed = 540, rate.uncached = 500;
  rate.boxes = 20000, rate.objects = 2300;
  rate.ray = fuzz::Spread{787, 700, 800};
  ListFigures base{"office", "table1", "baseline", "", {rate, rate}};
  rate.shafts = 50, rate.items = 400, rate.cull_tests = 1234, rate.comparisons = 3021, rate.planes = 845,
  rate.checked = 7, rate.lacking = 1;
  rate.boxes = 14000, rate.objects = 200;
  rate.ray = fuzz::Spread{642.5, 600, 700};
  rate.list = fuzz::Spread{1000, 900, 1100};
  ListFigures closed{"office", "table1", "keep closed", "strategy=keep-closed", {rate, rate}};
  closed.rates[1].ray = fuzz::Spread{900, 800, 1000};  // slower than the baseline
  closed.rates[1].false_lit = 3;
  return {base, closed};
}

std::vector<ListFigures> read_back(const nlohmann::ordered_json& json) {
  const Json plain = Json::parse(json.dump());
  return read_lists(Node(plain, "f.json", "the top"));
}

TEST(ListFigures, AreReadBackAsTheyWereWritten) {
  const std::vector<ListFigures> rows = two_rows();
  nlohmann::ordered_json json{{"lists", lists_json(rows)}, {"measured", {{"lists", list_times_json(rows)}}}};
  const std::vector<ListFigures> read = read_back(json);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(lists_json(read), lists_json(rows));
  EXPECT_EQ(list_times_json(read), list_times_json(rows));
  EXPECT_EQ(lists_text(read), lists_text(rows));
  for (const char* const name : {"uncached", "cache_hits", "false_lit"}) {
    nlohmann::ordered_json more = json;
    more["lists"][0]["low"][name] = 1001;  // more than rays
    EXPECT_THROW((void)read_back(more), scene::InputError) << name;
  }
  json["lists"].push_back(json["lists"][0]);
  EXPECT_THROW((void)read_back(json), scene::InputError);
}

TEST(ListFigures, StandBesideThePrintedOnes) {
  const std::vector<ListFigures> rows = two_rows();
  const std::array<Table1Cell, 3> cells = table1_cells(rows, rows[1]);
  EXPECT_DOUBLE_EQ(cells[0].value, 28.4);
  EXPECT_EQ(cells[0].printed, 28.4);
  EXPECT_EQ(cells[0].direction, "same");
  EXPECT_DOUBLE_EQ(*cells[1].printed_ratio, 642.0 / 787);
  EXPECT_EQ(cells[1].direction, "same");
  EXPECT_EQ(cells[2].direction, "opposite");
  // 1000 ns a list over ten rays leave 542.5 of casting, which saves 244.5.
  EXPECT_NEAR(*break_even(rows[0], rows[1], 0), 1000 / 244.5, 1e-9);
  std::vector<ListFigures> elsewhere = rows;
  for (ListFigures& row : elsewhere) row.scene = "classroom";
  EXPECT_EQ(table1_cells(elsewhere, elsewhere[1])[0].printed, std::nullopt);
  const std::string html = radiosity_section(std::vector<MeasureFile>{{"f.json", {}, rows}});
  for (const char* const said : {"keep closed", "28.4 <small>0.64</small>", "642 <small>0.82</small>",
                                 "<b class=\"warn\">opposite</b>", "<td class=\"num bad\">3</td>"}) {
    EXPECT_NE(html.find(said), std::string::npos) << said;
  }
  EXPECT_EQ(radiosity_section({}), "");
}

TEST(RadiosityRatios, AreToTheQuickestRowThatAsksRayByRay) {
  const RadiosityTime times[] = {
      {"a", "embree", 100}, {"a", "embree-high", 80}, {"a", "mine", 20}, {"a", "embree-packet8", 1},
      {"b", "embree", 50},  {"b", "mine", 50},        {"c", "mine", 7}};
  const std::vector<RadiosityRatio> ratios = ratios_to_embree(times);
  ASSERT_EQ(ratios.size(), 4u);
  EXPECT_EQ(ratios[2].method, "mine");
  EXPECT_EQ(ratios[2].places, 2u);
  EXPECT_NEAR(ratios[2].mean, 0.5, 1e-12);
  EXPECT_EQ(ratios[2].least, 0.25);
  EXPECT_EQ(ratios[2].most, 1);
}

TEST(CommandLineRadiosity, MeasuresTellsWritesAndCompares) {
  const Folder folder;
  folder.write("s.nff", tests::kTrianglesNff);
  const Outcome run =
      run_gnomon({"measure",  "s.nff",       "--workload", "radiosity", "--rays",   "4",
                  "--rays",   "16",          "--queries",  "200",       "--rounds", "1",
                  "--method", "shaft-exact", "--method",   "bvh-exact", "--shaft",  "strategy=keep-closed",
                  "--json",   "m.json",      "--variant",  "given"},
                 folder.path());
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* const said : {"candidate lists on s.nff", "ratio open 0.8", "radiosity@16", "shaft-exact",
                                 "strategy=keep-closed", "faces each"}) {
    EXPECT_NE(run.out.find(said), std::string::npos) << said;
  }
  auto json = nlohmann::json::parse(tests::contents_of(folder / "m.json"));
  EXPECT_EQ(json.at("rows").size(), 4u);
  std::size_t by_pairs = 0;
  for (const auto& row : json.at("rows")) {
    EXPECT_EQ(row.at("unsound"), 0);
    by_pairs += row.contains("pairs") ? 1 : 0;
  }
  EXPECT_EQ(by_pairs, 2u);
  EXPECT_GT(json.at("lists").size(), 30u);
  folder.write("n.json", json.dump());
  EXPECT_EQ(run_gnomon({"compare", "m.json", "n.json"}, folder.path()).status, 0);
  json["lists"][1]["low"]["false_lit"] = 1;
  folder.write("n.json", json.dump());
  const Outcome worse = run_gnomon({"compare", "m.json", "n.json"}, folder.path());
  EXPECT_EQ(worse.status, 1);
  EXPECT_NE(worse.out.find("lists s.nff table1 keep closed low"), std::string::npos) << worse.out;
}

TEST(CommandLineRadiosity, HoldsAsManyListsAgainstTheExactOnesAsItIsAsked) {
  const Folder folder;
  const auto checked_of = [&](const std::string& asked) {
    const Outcome run = run_gnomon(
        {"measure", "tetra:2", "--workload", "radiosity", "--rays", "4", "--queries", "50", "--rounds", "1",
         "--method", "bvh-exact", "--variant", "given", "--checked-lists", asked, "--json", "m.json"},
        folder.path());
    EXPECT_EQ(run.status, 0) << run.err;
    // The second row: the first is the baseline, which makes no lists.
    const auto json = nlohmann::json::parse(tests::contents_of(folder / "m.json"));
    const nlohmann::json& low = json.at("lists").at(1).at("low");
    EXPECT_GT(low.at("shafts"), 20);
    return std::pair(low.at("checked").get<int>(), low.at("shafts").get<int>());
  };
  const auto [few, lists] = checked_of("2");
  EXPECT_GT(few, 0);
  EXPECT_LE(few, 2);
  EXPECT_EQ(checked_of("1000000000"), std::pair(lists, lists));
}

TEST(CommandLineRadiosity, RefusesWhatItDoesNotKnow) {
  for (const std::vector<std::string>& bad :
       {std::vector<std::string>{"--workload", "radiosity", "--rays", "5"},
        {"--rays", "4"},
        {"--workload", "radiosity@5"},
        {"--shaft", "ratio=0.5"},
        {"--checked-lists", "7"},
        {"--workload", "radiosity", "--checked-lists", "0"},
        {"--workload", "radiosity", "--shaft", "ratio=2"},
        {"--workload", "radiosity", "--shaft", "ratio=0.5", "--variant", "moved"},
        {"--workload", "radiosity", "--shaft", "colour=on"}}) {
    std::vector<std::string> words{"measure", "office"};
    words.insert(words.end(), bad.begin(), bad.end());
    const Outcome run = run_gnomon(words);
    EXPECT_EQ(run.status, 2) << bad.back();
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find("expected"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace gnomon::reports
