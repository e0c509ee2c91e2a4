// SPDX-License-Identifier: GPL-3.0-or-later
// Comparing: every kind of regression is found, nothing else fails, other workloads are refused.
#include "reports/compare.h"

#include <algorithm>

#include "scene/input_error.h"
#include "tests/result_files.h"

namespace gnomon::reports {
namespace {

namespace fs = std::filesystem;
using Edit = std::function<void(OrderedJson&)>;

class Compare : public ResultFiles {
 protected:
  Compare() {
    old_ = write("old.json", result_of(few_hard_trials()));
    json_ = json_of(old_);
  }

  /// The row of a method on near-touch f32.
  static OrderedJson& row(OrderedJson& json, const std::string& method) {
    for (OrderedJson& row : json["rows"]) {
      if (row["method"] == method && row["distribution"] == "near-touch" && row["scalar"] == "f32")
        return row;
    }
    throw std::runtime_error("no row of " + method);
  }

  [[nodiscard]] Comparison compared(const Edit& edit, const CompareOptions& options = {}) const {
    return compare_results(old_, changed("new.json", json_, edit), options);
  }
  [[nodiscard]] Comparison with(const std::string& method, const std::string& field, const OrderedJson& value,
                                const CompareOptions& options = {}) const {
    return compared([&](OrderedJson& json) { row(json, method)[field] = value; }, options);
  }
  /// Adds `more` to one count.
  [[nodiscard]] Comparison more(const std::string& method, const std::string& field,
                                std::int64_t more) const {
    return compared([&](OrderedJson& json) {
      OrderedJson& value = row(json, method)[field];
      value = static_cast<std::uint64_t>(value.get<std::int64_t>() + more);
    });
  }
  [[nodiscard]] std::string refusal(const Edit& edit) const {
    try {
      (void)compared(edit);
    } catch (const scene::InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path("new.json").string() + ":", 0), 0u) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "expected a refusal";
    return "";
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  static void times(OrderedJson& json, double factor) {
    for (OrderedJson& timing : json["measured"]["ns_per_case"])
      timing["ns"] = timing["ns"].get<double>() * factor;
  }

  fs::path old_;
  OrderedJson json_;
};

TEST_F(Compare, SeesNothingInTheSameResult) {
  const Comparison same = compared([](OrderedJson&) {});
  EXPECT_FALSE(same.regressed());
  EXPECT_TRUE(same.errors.empty());
  EXPECT_EQ(same.rows, json_["rows"].size());
  ASSERT_EQ(same.speeds.size(), same.rows);
  for (const SpeedChange& speed : same.speeds) EXPECT_TRUE(speed.ratio == 1 && speed.within_noise);
  EXPECT_EQ(same.reference_ratio, 1.0);
  EXPECT_TRUE(same.environment.empty() && same.only_old.empty() && same.only_new.empty());
}

TEST_F(Compare, CallsEveryMoreOfUnsoundWorse) {
  ASSERT_GT(row(json_, "naive-f32")["unsound"].get<int>(), 0);
  for (const char* const method : {"naive-f32", "certified-f32", "exact"}) {
    for (const char* const field :
         {"unsound", "false_culls", "false_insides", "unsound_touching", "threshold_exceeded"}) {
      const Comparison comparison = more(method, field, 1);
      ASSERT_EQ(comparison.errors.size(), 1u) << method << " " << field;
      EXPECT_TRUE(comparison.regressed()) << method << " " << field;
      EXPECT_EQ(comparison.errors[0].row, std::string("shaft-box ") + method + " near-touch f32");
      EXPECT_EQ(comparison.errors[0].field, field);
      EXPECT_EQ(comparison.errors[0].after, comparison.errors[0].before + 1);
    }
  }
  const Comparison fewer = more("naive-f32", "unsound", -1);
  EXPECT_FALSE(fewer.regressed());
  ASSERT_EQ(fewer.errors.size(), 1u);
  EXPECT_EQ(fewer.errors[0].change, Change::better);
}

TEST_F(Compare, HoldsCertifiedAndExactRowsToTheirWasteToo) {
  for (const char* const field : {"waste", "undecided", "rejected"}) {
    EXPECT_TRUE(more("certified-f32", field, 1).regressed()) << field;
    EXPECT_TRUE(more("exact", field, 1).regressed()) << field;
    const Comparison naive = more("naive-f32", field, 1);
    EXPECT_FALSE(naive.regressed()) << field;
    ASSERT_EQ(naive.errors.size(), 1u) << field;
    EXPECT_EQ(naive.errors[0].change, Change::other);
  }
  EXPECT_EQ(more("certified-f32", "waste", -1).errors.at(0).change, Change::better);
  const Comparison rounding = more("naive-f32", "rounding", -1);
  EXPECT_FALSE(rounding.regressed());
  EXPECT_EQ(rounding.errors.at(0).change, Change::other);
}

TEST_F(Compare, SeesPromisesBrokenKeptAndGivenUp) {
  const Comparison broken = with("certified-f32", "promise_broken", true);
  EXPECT_TRUE(broken.regressed());
  EXPECT_TRUE(has(comparison_text(broken, {}), "promise newly BROKEN"));
  const Comparison given_up = with("exact", "promise", "never unsound");
  EXPECT_TRUE(given_up.regressed());
  EXPECT_TRUE(has(comparison_text(given_up, {}), "promise always agrees -> never unsound"));
  EXPECT_TRUE(with("certified-f32", "promise", "none").regressed());
  const Comparison gained = with("naive-f32", "promise", "never unsound");
  EXPECT_FALSE(gained.regressed());
  EXPECT_EQ(gained.errors.at(0).change, Change::better);
  // Broken before and whole now.
  const fs::path worse =
      changed("worse.json", json_, [](OrderedJson& j) { row(j, "exact")["promise_broken"] = true; });
  const Comparison repaired = compare_results(worse, old_, {});
  EXPECT_FALSE(repaired.regressed());
  EXPECT_TRUE(has(comparison_text(repaired, {}), "promise holds again"));
}

TEST_F(Compare, PutsWhatGotWorseFirstAndErrorsBeforeSpeed) {
  const Comparison mixed = compared([](OrderedJson& json) {
    row(json, "naive-f32")["unsound"] = 0;
    row(json, "naive-f32")["rounding"] = 0;
    row(json, "exact")["waste"] = 3;
    times(json, 2);
  });
  ASSERT_EQ(mixed.errors.size(), 3u);
  EXPECT_EQ(mixed.errors[0].change, Change::worse);
  EXPECT_EQ(mixed.errors[1].change, Change::better);
  EXPECT_EQ(mixed.errors[2].change, Change::other);
  const std::string text = comparison_text(mixed, {});
  EXPECT_LT(text.find("Errors: 1 count worse, of 3 that changed"), text.find("Speed")) << text;
  EXPECT_TRUE(has(text, "exact near-touch f32: waste 0 -> 3 (+3)")) << text;
  EXPECT_TRUE(has(text, "x 2.000 on average")) << text;
  EXPECT_TRUE(has(text, "\nREGRESSED\n")) << text;
}

TEST_F(Compare, FailsOnSpeedOnlyWhenAsked) {
  const Comparison slower = compared([](OrderedJson& json) { times(json, 1.5); });
  EXPECT_FALSE(slower.regressed());
  EXPECT_FALSE(slower.speeds.at(0).within_noise);
  CompareOptions options;
  options.speed_limit = 1.4;
  EXPECT_TRUE(compared([](OrderedJson& json) { times(json, 1.5); }, options).regressed());
  EXPECT_FALSE(compared([](OrderedJson& json) { times(json, 1.3); }, options).regressed());
  EXPECT_FALSE(compared([](OrderedJson& json) { times(json, 1 / 1.5); }, options).regressed());
  // The tolerance, from both sides and both directions.
  const auto within = [&](double factor, double tolerance) {
    CompareOptions noise;
    noise.tolerance = tolerance;
    return compared([&](OrderedJson& json) { times(json, factor); }, noise).speeds.at(0).within_noise;
  };
  EXPECT_TRUE(within(1.04, 0.05) && within(0.96, 0.05) && within(1.09, 0.1));
  EXPECT_FALSE(within(1.06, 0.05) || within(0.94, 0.05) || within(1.11, 0.1));
  // Without times there is nothing to compare, and nothing fails.
  const Comparison untimed = compared([](OrderedJson& json) { json.erase("measured"); }, options);
  EXPECT_TRUE(untimed.speeds.empty());
  EXPECT_FALSE(untimed.regressed());
  EXPECT_TRUE(has(comparison_text(untimed, {}), "not measured in both"));
}

TEST_F(Compare, SaysWhatItCouldNotCompare) {
  const Comparison fewer = compared([](OrderedJson& json) {
    json["rows"].erase(0);
    row(json, "exact")["method"] = "exact-2";
    json["measured"]["environment"]["cpu"] = "another one";
    json["command"] = json["command"].get<std::string>() + " --method exact-2";
  });
  EXPECT_FALSE(fewer.regressed());
  EXPECT_EQ(fewer.only_old.size(), 2u);
  EXPECT_EQ(fewer.only_new, std::vector<std::string>{"shaft-box exact-2 near-touch f32"});
  ASSERT_EQ(fewer.environment.size(), 1u);
  const std::string text = comparison_text(fewer, {});
  EXPECT_TRUE(has(text, "only in new: shaft-box exact-2 near-touch f32")) << text;
  EXPECT_TRUE(has(text, "only in old: shaft-box exact near-touch f32")) << text;
  EXPECT_TRUE(has(text, "not measured alike: cpu: ")) << text;
}

TEST_F(Compare, CallsARowThatTheSameCommandLostWorse) {
  const Comparison lost = compared([](OrderedJson& json) { json["rows"].erase(0); });
  EXPECT_TRUE(lost.errors.empty());
  EXPECT_EQ(lost.only_old.size(), 1u);
  EXPECT_TRUE(lost.regressed());
  EXPECT_TRUE(has(comparison_text(lost, {}), "lost: the same command gave 1 more row\n"));
  // More rows than before are none the worse.
  const Comparison more = compared([](OrderedJson& json) {
    OrderedJson added = json["rows"][0];
    added["method"] = "added";
    json["rows"].push_back(added);
  });
  EXPECT_TRUE(more.same_command);
  EXPECT_FALSE(more.regressed());
}

TEST_F(Compare, RefusesOtherWorkloads) {
  EXPECT_TRUE(has(refusal([](OrderedJson& j) { j["seed"] = 2; }), "(seed 1), found seed 2"));
  EXPECT_TRUE(has(refusal([](OrderedJson& j) {
                    j["seeds"] = {1, 2};
                    j.erase("seed");
                  }),
                  "(seed 1), found seed 1, 2"));
  EXPECT_TRUE(has(refusal([](OrderedJson& j) { j["shard"] = "1/2"; }), "(shard 1/1), found shard 1/2"));
  EXPECT_TRUE(has(refusal([](OrderedJson& j) { row(j, "exact")["trials"] = 7001; }), "(7000 trials in"));
  EXPECT_TRUE(has(refusal([](OrderedJson& j) {
                    for (OrderedJson& row : j["rows"])
                      row["distribution"] = "uniform-" + row["distribution"].get<std::string>();
                  }),
                  "no row that is in both"));
  // The same seed and trials, but other cases: their exact answers tell.
  for (const char* const rate : {"waste_rate", "unsound_rate", "false_inside_rate"}) {
    EXPECT_TRUE(has(refusal([&](OrderedJson& j) {
                      OrderedJson& of = row(j, "exact")[rate]["of"];
                      of = of.get<std::uint64_t>() + 1;
                    }),
                    "expected the cases of the old result"))
        << rate;
  }
  EXPECT_TRUE(
      has(refusal([](OrderedJson& j) { row(j, "exact")["touching"]["inside"] = 6999; }), "touching inside"));
  EXPECT_TRUE(has(refusal([](OrderedJson& j) { j["rows"].push_back(j["rows"][0]); }), "found twice"));
  EXPECT_TRUE(has(refusal([](OrderedJson& j) { j["kind"] = "replay"; }), "kind \"replay\""));
  EXPECT_TRUE(has(refusal([](OrderedJson& j) { j.erase("schema"); }), "\"schema\""));
}

TEST_F(Compare, CommandLine) {
  const std::string old_name = old_.string(), new_name = path("new.json").string();
  (void)compared([](OrderedJson& json) {
    row(json, "naive-f32")["unsound"] = row(json, "naive-f32")["unsound"].get<int>() + 2;
    times(json, 1.5);
  });
  const Outcome worse = gnomon("compare " + old_name + " " + new_name + " --json " + path("c.json").string());
  EXPECT_EQ(worse.status, 1);
  EXPECT_EQ(worse.error, "");
  EXPECT_TRUE(has(worse.out, "Errors: 1 count worse")) << worse.out;
  const OrderedJson json = json_of(path("c.json"));
  EXPECT_EQ(json["kind"], "compare");
  EXPECT_EQ(json["regressed"], true);
  ASSERT_EQ(json["errors"].size(), 1u);
  EXPECT_EQ(json["errors"][0]["change"], "worse");
  EXPECT_EQ(json["errors"][0]["new"].get<int>(), json["errors"][0]["old"].get<int>() + 2);
  EXPECT_EQ(json["speeds"].size(), json_["rows"].size());

  EXPECT_EQ(gnomon("compare " + new_name + " " + old_name).status, 0);  // the other way round it got better
  EXPECT_EQ(gnomon("compare " + new_name + " " + old_name + " --speed-limit 0.5").status, 1);
  EXPECT_EQ(gnomon("compare " + new_name + " " + old_name + " --speed-limit 0.7").status, 0);

  write("cut.json", read(old_).substr(0, 4000));
  write("foreign.json", "{}");
  write("empty.json", "");
  const auto one_line = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = gnomon("compare " + arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_TRUE(has(outcome.error, words)) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  };
  for (const bool first : {true, false}) {
    const auto pair = [&](const std::string& name) {
      return first ? path(name).string() + " " + old_name : old_name + " " + path(name).string();
    };
    one_line(pair("cut.json"), "cut.json:");
    one_line(pair("foreign.json"), "foreign.json: expected field \"schema\"");
    one_line(pair("empty.json"), "found an empty one");
    one_line(pair(""), "found a folder");
    one_line(pair("absent.json"), "can't open it");
  }
  one_line(old_name, "new");
  one_line(old_name + " " + new_name + " --tolerance -1", "--tolerance");
  one_line(old_name + " " + new_name + " --tolerance nan", "--tolerance");
  one_line(old_name + " " + new_name + " --speed-limit 0", "--speed-limit");
  one_line(old_name + " " + new_name + " --json " + (old_ / "x.json").string(), "can't be written");
}

}  // namespace
}  // namespace gnomon::reports
