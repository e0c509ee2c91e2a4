// SPDX-License-Identifier: GPL-3.0-or-later
// Measured scenes in the report.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/html_measure.h"
#include "reports/html_radiosity.h"
#include "scene/input_error.h"
#include "tests/cli_run.h"
#include "tests/shadow_scenes.h"

namespace gnomon::tests {
namespace {

using nlohmann::json;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

std::string section_of(const std::filesystem::path& folder) {
  return reports::measure_section(reports::read_measure_files(folder));
}

/// A folder with the result file of a small measurement.
struct MeasuredFolder : Folder {
  MeasuredFolder() {
    write("s.nff", kBallsNff);
    const Outcome run =
        run_gnomon({"measure",    "s.nff",     "--queries",  "300",           "--rounds",   "1",
                    "--workload", "hard",      "--workload", "surface",       "--workload", "hard-rays",
                    "--variant",  "given",     "--method",   "bvh-naive-f32", "--method",   "bvh-exact",
                    "--method",   "reference", "--json",     "m.json"},
                   path());
    EXPECT_EQ(run.status, 0) << run.err;
  }
};

TEST(MeasuredScenes, HaveASectionWithPlotsTableAndPicture) {
  const MeasuredFolder folder;
  const std::string without = section_of(folder.path());
  EXPECT_EQ(count(without, "<h3>s.nff"), 1u);
  EXPECT_EQ(count(without, "<h4>"), 3u);  // a workload each
  EXPECT_EQ(count(without, "<svg"), 6u);  // two directions of error each
  EXPECT_EQ(count(without, "<tr><th scope=\"row\">"), 9u);
  EXPECT_EQ(count(without, ">False lit</th>"), 2u);
  EXPECT_EQ(count(without, ">Wrong face</th>"), 1u);
  EXPECT_EQ(count(without, "<img"), 0u);
  ASSERT_EQ(run_gnomon({"render", "s.nff", "--method", "reference", "--size", "4x3", "-o", "s.nff.png"},
                       folder.path())
                .status,
            0);
  const std::string with = section_of(folder.path());
  EXPECT_EQ(count(with, "<img"), 1u);
  EXPECT_EQ(count(with, "data:image/png;base64,iVBORw0KGgo"), 1u);  // the signature of PNG
  folder.write("s.nff.png", "no picture");
  EXPECT_EQ(section_of(folder.path()), without);

  const Outcome report = run_gnomon({"report", ".", "-o", "r.html"}, folder.path());
  ASSERT_EQ(report.status, 0) << report.err;
  const std::string page = contents_of(folder / "r.html");
  EXPECT_EQ(count(page, "<section id=\"scenes\">"), 1u);
  EXPECT_EQ(count(page, "<section id=\"other\">"), 0u);
}

TEST(MeasuredScenes, OfBadFilesAreRefusedWithThePlace) {
  const MeasuredFolder folder;
  const json good = json::parse(contents_of(folder / "m.json"));
  const std::pair<const char*, json> changes[] = {
      {"/rows/0/unsound", 301},
      {"/rows/1/false_lit_rate/hits", 1000000},
      {"/rows/1/method", 7},
      {"/rows/2/touching", nullptr},
      {"/rows/3/question", "voxel-label"},
      {"/rows/6/question", "shadow"},
      {"/rows/6/wrong_face_rate/hits", 1000000},
      {"/rows/6/touching/face", 1000000},
      {"/measured/ns_per_query/0/ns/median", -1},
      {"/measured/set_ups/1/seconds", -1},
  };
  for (const auto& [where, value] : changes) {
    json bad = good;
    bad[json::json_pointer(where)] = value;
    folder.write("m.json", bad.dump());
    EXPECT_THROW((void)section_of(folder.path()), scene::InputError) << where;
  }
  folder.write("m.json", good.dump());
  EXPECT_NO_THROW((void)section_of(folder.path()));
}

TEST(MeasuredScenes, AreSummedUpByTierAtTheTopOfThePage) {
  const MeasuredFolder folder;
  json result = json::parse(contents_of(folder / "m.json"));
  const auto verdict = [&] {
    folder.write("m.json", result.dump());
    return reports::measure_verdict(reports::read_measure_files(folder.path()));
  };
  std::string text = verdict();
  EXPECT_EQ(count(text, "Every promise held on scenes.</b> 6 rows"), 1u) << text;
  // Two workloads of shadow and one of first-hit; the reference judges and is not counted.
  EXPECT_EQ(count(text, "Exact methods</b> (<code>bvh-exact</code>): 0 wrong of 600 queries; 95 %: 0 to "),
            1u)
      << text;
  EXPECT_EQ(count(text, "Exact methods</b> (<code>bvh-exact</code>): 0 wrong of 300 queries; 95 %: 0 to "),
            1u)
      << text;
  EXPECT_EQ(count(text, "Naive methods</b>"), 2u) << text;
  EXPECT_EQ(count(text, "<code>reference</code>"), 0u) << text;
  for (json& row : result["rows"]) {
    if (row["method"] != "bvh-exact" || row["question"] != "first-hit") continue;
    row["unsound"] = 2;
    row["promise_broken"] = true;
  }
  text = verdict();
  EXPECT_EQ(count(text, "A promise was broken on a scene"), 1u) << text;
  EXPECT_EQ(count(text, "<code>bvh-exact</code>): 2 wrong of 300 queries"), 1u) << text;
  EXPECT_EQ(reports::measure_verdict({}), "");
}

TEST(MeasuredScenes, AreTextAndNothingElse) {
  const MeasuredFolder folder;
  json named = json::parse(contents_of(folder / "m.json"));
  for (json& row : named["rows"]) row["scene"] = "<script>alert(1)</script>";
  folder.write("m.json", named.dump());
  for (json& row : named["rows"]) row["promise_broken"] = true;
  folder.write("m.json", named.dump());
  EXPECT_EQ(count(section_of(folder.path()), "<script>"), 0u);
  EXPECT_EQ(count(reports::measure_verdict(reports::read_measure_files(folder.path())), "<script>"), 0u);
}

TEST(MeasuredRadiosity, HasOneTableOfBatchesForAllFilesThatKeepsTheirPlacesApart) {
  const auto row_of = [](const char* method, double ns) {
    reports::MeasureRow row;
    row.scene = "office", row.variant = "given", row.workload = "radiosity@16";
    row.method = method, row.image = reports::TimeSpread{ns, ns, ns};
    return row;
  };
  const std::vector<reports::MeasureFile> files{{"a.json", {row_of("embree", 100), row_of("mine", 25)}, {}},
                                                {"b.json", {row_of("embree", 10), row_of("mine", 10)}, {}}};
  const std::string html = reports::radiosity_section(files);
  EXPECT_EQ(count(html, "<h3>Batches of rays</h3>"), 1u);
  EXPECT_EQ(count(html,
                  "mine</th><td class=\"num\">0.50</td><td class=\"num\">0.25</td>"
                  "<td class=\"num\">1.00</td><td class=\"num\">2</td>"),
            1u)
      << html;
}

TEST(MeasuredRadiosity, TellsNoSpeedUpOfRowsThatWereNotAskedAtTheHighRate) {
  reports::ListRate rate;
  rate.rays = 100, rate.shadowed = 50, rate.uncached = 60, rate.boxes = 600;
  rate.ray = fuzz::Spread{20, 10, 30};
  const std::vector<reports::ListRate> low{rate}, both{rate, rate};
  const auto figures = [&](const std::vector<reports::ListRate>& cache,
                           const std::vector<reports::ListRate>& base) {
    const std::vector<reports::ListFigures> rows{{"office", "table1", "baseline", "", base},
                                                 {"office", "table1", "ratio open 0.4", "", both},
                                                 {"office", "text", "shadow cache alone", "", cache}};
    std::string all;
    for (const reports::TextFigure& figure : reports::text_figures(rows, "office")) all += figure.what + "\n";
    return all;
  };
  EXPECT_EQ(count(figures(both, both), "speed-up"), 2u);
  EXPECT_EQ(count(figures(low, both), "total speed-up"), 0u);
  EXPECT_EQ(count(figures(low, both), "speed-up"), 1u);
  EXPECT_EQ(count(figures(low, low), "speed-up"), 0u);
}

}  // namespace
}  // namespace gnomon::tests
