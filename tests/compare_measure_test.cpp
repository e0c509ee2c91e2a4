// SPDX-License-Identifier: GPL-3.0-or-later
// Comparing results of gnomon measure: every kind of regression is found, other workloads are refused.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "reports/compare.h"
#include "scene/input_error.h"
#include "tests/cli_run.h"
#include "tests/shadow_scenes.h"

namespace gnomon::tests {
namespace {

using nlohmann::json;
using reports::Change;
using reports::Comparison;
using Edit = std::function<void(json&)>;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class CompareMeasure : public testing::Test {
 protected:
  CompareMeasure() {
    folder_.write("s.nff", kBallsNff);
    const Outcome run =
        run_gnomon({"measure",   "s.nff",      "--queries", "300",           "--rounds",
                    "1",         "--workload", "hard-rays", "--workload",    "surface",
                    "--variant", "given",      "--method",  "bvh-naive-f32", "--method",
                    "bvh-exact", "--method",   "reference", "--method",      "bvh-certified-f32",
                    "--json",    "old.json"},
                   folder_.path());
    EXPECT_EQ(run.status, 0) << run.err;
    json_ = json::parse(contents_of(folder_ / "old.json"));
    // Times are set by hand: nothing here depends on the machine.
    for (json& time : json_["measured"]["ns_per_query"]) time["ns"] = spread(100, 98, 102);
    folder_.write("old.json", json_.dump());
  }

  static json spread(double median, double low, double high) {
    return {{"median", median}, {"low25", low}, {"high75", high}};
  }
  static json& row(json& result, const std::string& question, const std::string& method) {
    for (json& row : result["rows"]) {
      if (row["question"] == question && row["method"] == method) return row;
    }
    throw std::runtime_error("no row of " + method);
  }
  Comparison compared(const Edit& edit, const reports::CompareOptions& options = {}) const {
    json changed = json_;
    edit(changed);
    folder_.write("new.json", changed.dump());
    return reports::compare_results(folder_ / "old.json", folder_ / "new.json", options);
  }
  Comparison with(const char* question, const char* method, const char* field, int more) const {
    return compared([&](json& result) {
      json& value = row(result, question, method)[json::json_pointer(field)];
      value = value.get<int>() + more;
    });
  }
  std::string refusal(const Edit& edit) const {
    try {
      (void)compared(edit);
    } catch (const scene::InputError& error) {
      EXPECT_TRUE(has(error.what(), "new.json: expected ")) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "expected a refusal";
    return "";
  }

  Folder folder_;
  json json_;
};

TEST_F(CompareMeasure, SeesNothingInTheSameResult) {
  const Comparison same = compared([](json&) {});
  EXPECT_FALSE(same.regressed());
  EXPECT_TRUE(same.errors.empty() && same.only_old.empty() && same.only_new.empty());
  EXPECT_EQ(same.rows, 8u);
  ASSERT_EQ(same.speeds.size(), 16u);  // two orders
  for (const reports::SpeedChange& speed : same.speeds) EXPECT_TRUE(speed.ratio == 1 && speed.within_noise);
  EXPECT_EQ(same.reference_ratio, 1.0);
}

TEST_F(CompareMeasure, CallsEveryMoreOfWrongAnswersWorse) {
  const std::pair<const char*, std::vector<const char*>> fields[] = {
      {"shadow", {"/unsound", "/false_lit_rate/hits", "/false_shadowed_rate/hits", "/wrong_reason"}},
      {"first-hit", {"/unsound", "/wrong_face_rate/hits", "/false_miss_rate/hits", "/false_hit_rate/hits"}}};
  for (const auto& [question, names] : fields) {
    for (const char* const method : {"bvh-naive-f32", "bvh-exact", "bvh-certified-f32"}) {
      for (const char* const field : names) {
        const Comparison more = with(question, method, field, 1);
        EXPECT_TRUE(more.regressed()) << question << method << field;
        ASSERT_EQ(more.errors.size(), 1u) << question << method << field;
        EXPECT_EQ(more.errors[0].change, Change::worse);
        EXPECT_TRUE(has(more.errors[0].row, method) && has(more.errors[0].row, question))
            << more.errors[0].row;
      }
    }
  }
  ASSERT_GT(row(json_, "first-hit", "bvh-naive-f32").at("unsound").get<int>(),
            row(json_, "first-hit", "bvh-naive-f32").at("touching").at("unsound").get<int>());
  const Comparison fewer = with("first-hit", "bvh-naive-f32", "/unsound", -1);
  EXPECT_FALSE(fewer.regressed());
  EXPECT_EQ(fewer.errors.at(0).change, Change::better);
}

TEST_F(CompareMeasure, HoldsRowsThatPromiseToWhatTheyLeaveOpen) {
  for (const char* const field : {"/undecided", "/rejected", "/changed_by_order"}) {
    EXPECT_TRUE(with("first-hit", "bvh-certified-f32", field, 1).regressed()) << field;
    EXPECT_TRUE(with("shadow", "bvh-exact", field, 1).regressed()) << field;
    EXPECT_FALSE(with("shadow", "bvh-naive-f32", field, 1).regressed()) << field;
  }
}

TEST_F(CompareMeasure, SeesPromisesBrokenAndGivenUpAndRowsThatVanished) {
  const auto set = [&](const char* field, const json& value) {
    return compared([&](json& result) { row(result, "first-hit", "bvh-exact")[field] = value; });
  };
  EXPECT_TRUE(set("promise_broken", true).regressed());
  EXPECT_TRUE(set("promise", "never unsound").regressed());
  EXPECT_TRUE(set("promise", "none").regressed());
  const Comparison lost = compared([](json& result) { result["rows"].erase(2); });
  EXPECT_TRUE(lost.regressed());
  EXPECT_EQ(lost.only_old.size(), 1u);
  const Comparison left_out = compared([](json& result) {
    result["rows"].erase(2);
    result["command"] = "gnomon measure s.nff --method bvh-exact";
  });
  EXPECT_FALSE(left_out.regressed());
  EXPECT_EQ(left_out.only_old.size(), 1u);
}

TEST_F(CompareMeasure, TakesTimesForOtherOnlyBeyondTheSpreadOfBoth) {
  const auto timed = [&](double median, double low, double high, std::optional<double> limit = {}) {
    reports::CompareOptions options;
    options.speed_limit = limit;
    return compared(
        [&](json& result) { result["measured"]["ns_per_query"][0]["ns"] = spread(median, low, high); },
        options);
  };
  const auto noise = [&](double median, double low, double high) {
    const Comparison comparison = timed(median, low, high);
    EXPECT_FALSE(comparison.regressed());
    std::size_t beyond = 0;
    for (const reports::SpeedChange& speed : comparison.speeds) beyond += speed.within_noise ? 0 : 1;
    return beyond == 0;
  };
  EXPECT_TRUE(noise(120, 101, 130));  // quartiles overlap
  EXPECT_TRUE(noise(104, 103, 105));  // apart, but within the tolerance
  EXPECT_FALSE(noise(120, 103, 130));
  EXPECT_FALSE(noise(80, 75, 97));
  EXPECT_TRUE(noise(80, 75, 99));
  EXPECT_TRUE(timed(150, 140, 160, 1.2).regressed());
  EXPECT_FALSE(timed(150, 101, 160, 1.2).regressed());  // above the limit, but within the spread
  EXPECT_FALSE(timed(150, 140, 160, 1.6).regressed());
  const std::string text = reports::comparison_text(timed(150, 140, 160), {});
  EXPECT_TRUE(has(text, "100 [98, 102] -> 150 [140, 160] ns per query, x 1.500")) << text;
}

TEST_F(CompareMeasure, RefusesOtherWorkloads) {
  EXPECT_TRUE(has(refusal([](json& j) { j["seed"] = 2; }), "(seed 1), found seed 2"));
  EXPECT_TRUE(has(refusal([](json& j) { j["lights"] = {"1,2,3"}; }), "found lights: 1,2,3"));
  EXPECT_TRUE(has(refusal([](json& j) { j["rows"][0]["faces"] = 70; }), "(69 faces in"));
  EXPECT_TRUE(has(refusal([](json& j) { j["rows"][0]["queries"] = 301; }), "(300 queries in"));
  EXPECT_TRUE(has(refusal([](json& j) {
                    json& n = j["rows"][0]["matrix"]["lit"]["lit"];
                    n = n.get<int>() - 1;
                  }),
                  "exactly in"));
  EXPECT_TRUE(has(refusal([](json& j) {
                    json& n = j["rows"][0]["touching"]["lit"];
                    n = n.get<int>() + 1;
                  }),
                  "touching in"));
  EXPECT_TRUE(has(refusal([](json& j) {
                    for (json& row : j["rows"]) row["scene"] = "other.nff";
                  }),
                  "no row that is in both"));
  EXPECT_TRUE(has(refusal([](json& j) { j["rows"].push_back(j["rows"][0]); }), "found twice"));
  EXPECT_TRUE(has(refusal([](json& j) { j["kind"] = "fuzz"; }), "expected a result of gnomon measure"));
}

TEST_F(CompareMeasure, CommandLine) {
  EXPECT_EQ(run_gnomon({"compare", "old.json", "old.json"}, folder_.path()).status, 0);
  (void)with("first-hit", "bvh-naive-f32", "/unsound", 1);
  const Outcome worse = run_gnomon({"compare", "old.json", "new.json", "--json", "c.json"}, folder_.path());
  EXPECT_EQ(worse.status, 1);
  EXPECT_TRUE(has(worse.out, "Errors: 1 count worse")) << worse.out;
  const json comparison = json::parse(contents_of(folder_ / "c.json"));
  EXPECT_EQ(comparison.at("regressed"), true);
  EXPECT_EQ(comparison.at("speeds").at(0).at("old_quartiles"), (json{98.0, 102.0}));
  // Nothing of these adds up.
  const Outcome merged = run_gnomon({"merge", "old.json", "new.json", "-o", "m.json"}, folder_.path());
  EXPECT_EQ(merged.status, 2);
  EXPECT_EQ(lines_of(merged.err).size(), 1u) << merged.err;
  EXPECT_TRUE(has(merged.err, "old.json: expected a result of gnomon fuzz, found one of kind \"measure\""));
  EXPECT_FALSE(folder_.entries().contains("m.json"));
}

}  // namespace
}  // namespace gnomon::tests
