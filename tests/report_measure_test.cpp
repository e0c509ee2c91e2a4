// SPDX-License-Identifier: GPL-3.0-or-later
// Measured scenes in the report.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/html_measure.h"
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

/// A folder with the result file of a small measurement.
struct MeasuredFolder : Folder {
  MeasuredFolder() {
    write("s.nff", kBallsNff);
    const Outcome run = run_gnomon(
        {"measure",  "s.nff",      "--queries", "300",       "--rounds", "1",        "--workload",
         "hard",     "--workload", "surface",   "--variant", "given",    "--method", "bvh-naive-f32",
         "--method", "bvh-exact",  "--method",  "reference", "--json",   "m.json"},
        path());
    EXPECT_EQ(run.status, 0) << run.err;
  }
};

TEST(MeasuredScenes, HaveASectionWithPlotsTableAndPicture) {
  const MeasuredFolder folder;
  const std::string without = reports::measure_section(folder.path());
  EXPECT_EQ(count(without, "<h3>s.nff"), 1u);
  EXPECT_EQ(count(without, "<h4>"), 2u);  // a workload each
  EXPECT_EQ(count(without, "<svg"), 4u);  // two directions of error each
  EXPECT_EQ(count(without, "<tr><th scope=\"row\">"), 6u);
  EXPECT_EQ(count(without, "<img"), 0u);
  ASSERT_EQ(run_gnomon({"render", "s.nff", "--method", "reference", "--size", "4x3", "-o", "s.nff.png"},
                       folder.path())
                .status,
            0);
  const std::string with = reports::measure_section(folder.path());
  EXPECT_EQ(count(with, "<img"), 1u);
  EXPECT_EQ(count(with, "data:image/png;base64,iVBORw0KGgo"), 1u);  // the signature of PNG
  folder.write("s.nff.png", "no picture");
  EXPECT_EQ(reports::measure_section(folder.path()), without);

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
      {"/measured/ns_per_query/0/ns/median", -1},
      {"/measured/set_ups/1/seconds", -1},
  };
  for (const auto& [where, value] : changes) {
    json bad = good;
    bad[json::json_pointer(where)] = value;
    folder.write("m.json", bad.dump());
    EXPECT_THROW((void)reports::measure_section(folder.path()), scene::InputError) << where;
  }
  folder.write("m.json", good.dump());
  EXPECT_NO_THROW((void)reports::measure_section(folder.path()));
}

TEST(MeasuredScenes, AreTextAndNothingElse) {
  const MeasuredFolder folder;
  json named = json::parse(contents_of(folder / "m.json"));
  for (json& row : named["rows"]) row["scene"] = "<script>alert(1)</script>";
  folder.write("m.json", named.dump());
  EXPECT_EQ(count(reports::measure_section(folder.path()), "<script>"), 0u);
}

}  // namespace
}  // namespace gnomon::tests
