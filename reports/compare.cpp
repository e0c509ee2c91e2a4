// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fuzz/method.h"
#include "fuzz/question_words.h"
#include "fuzz/scene_measurement.h"
#include "reports/json_node.h"
#include "reports/result_reader.h"
#include "scene/input_error.h"

namespace gnomon::reports {

namespace {

std::string key_of(const ResultRow& row) {
  return row.question + " " + row.method + " " + row.distribution + " " + row.scalar;
}

ResultFile read_fuzz_result(const std::filesystem::path& path) {
  ResultFile file = read_result_file(path);
  if (file.kind != "fuzz") {
    throw scene::InputError(
        path.string(), 0,
        "expected a result of gnomon fuzz (or two of gnomon measure), found one of kind \"" + file.kind +
            "\"");
  }
  return file;
}

std::string seeds_text(const ResultFile& file) {
  std::string text;
  for (const std::uint64_t seed : file.seeds) text += (text.empty() ? "" : ", ") + std::to_string(seed);
  return text.empty() ? "none" : text;
}

std::string shard_of(const ResultFile& file) {
  return file.shard.empty() ? "1/1" : file.shard;
}

/// How many of the cases are exactly what: equal for equal cases.
std::map<std::string, std::uint64_t> cases_of(const ResultRow& row) {
  std::map<std::string, std::uint64_t> cases = row.touching;  // by boundary
  for (auto& [name, count] : row.touching) {
    cases.erase(name);
    cases["touching " + name] = count;
  }
  cases["trials"] = row.trials;
  const fuzz::QuestionWords* const words = fuzz::find_question(row.question);
  const bool pairs = words != nullptr && words->about_pairs;
  if (row.waste_rate.of) cases[pairs ? "cases that can be wasted" : "outside"] = *row.waste_rate.of;
  if (row.unsound_rate.of) {
    cases[pairs ? "cases that can be unsound" : "not outside"] = *row.unsound_rate.of;
  }
  if (const auto faces = row.faces.find("true"); faces != row.faces.end())
    cases["true faces"] = faces->second;
  if (row.false_inside_rate && row.false_inside_rate->of) cases["not inside"] = *row.false_inside_rate->of;
  return cases;
}

std::uint64_t strength_of(const std::string& promise) {
  for (const fuzz::Promise known : {fuzz::Promise::never_unsound, fuzz::Promise::always_agrees}) {
    if (promise == name_of(known)) return static_cast<std::uint64_t>(known);
  }
  return 0;
}

class Comparer {
 public:
  Comparer(const ResultRow& before, const ResultRow& after, std::vector<ErrorChange>& changes)
      : before_(&before), after_(&after), changes_(&changes) {
    // What the tier or the promise says; a method that gave up its promise is held to the old one.
    keeps_word_ = before.promise != "none" && before.tier != "trivial";
  }

  void compare() {
    const std::uint64_t old_strength = strength_of(before_->promise),
                        new_strength = strength_of(after_->promise);
    if (old_strength != new_strength) {
      changes_->push_back({key_of(*after_), "promise", old_strength, new_strength,
                           new_strength < old_strength ? Change::worse : Change::better,
                           before_->promise + " -> " + after_->promise});
    }
    say("promise_broken", before_->promise_broken, after_->promise_broken, true);
    say("unsound", before_->unsound, after_->unsound, true);
    say("false_culls", before_->false_culls, after_->false_culls, true);
    say("false_insides", before_->false_insides, after_->false_insides, true);
    for (const auto& [name, count] : before_->faces) {
      const auto now = after_->faces.find(name);
      if (now == after_->faces.end() || name == "true") continue;
      say(("faces_" + name).c_str(), count, now->second,
          name == "missing" || (name == "excess" && keeps_word_));
    }
    say("unsound_touching", before_->unsound_touching, after_->unsound_touching, true);
    say("threshold_exceeded", before_->threshold_exceeded, after_->threshold_exceeded, true);
    say("waste", before_->waste, after_->waste, keeps_word_);
    say("undecided", before_->undecided, after_->undecided, keeps_word_);
    say("rejected", before_->rejected, after_->rejected, keeps_word_);
    say_other("rounding", before_->rounding, after_->rounding);
    say_other("model", before_->model, after_->model);
    say_other("rounding_and_model", before_->rounding_and_model, after_->rounding_and_model);
  }

 private:
  void add(const char* field, std::uint64_t before, std::uint64_t after, Change change) {
    if (before != after) changes_->push_back({key_of(*after_), field, before, after, change});
  }
  void say(const char* field, std::uint64_t before, std::uint64_t after, bool counts) {
    add(field, before, after, after < before ? Change::better : counts ? Change::worse : Change::other);
  }
  void say_other(const char* field, std::uint64_t before, std::uint64_t after) {
    add(field, before, after, Change::other);
  }

  const ResultRow* before_;
  const ResultRow* after_;
  std::vector<ErrorChange>* changes_;
  bool keeps_word_ = false;
};

void check_same_cases(const std::filesystem::path& path, const ResultRow& before, const ResultRow& after) {
  const auto old_cases = cases_of(before), new_cases = cases_of(after);
  for (const auto& [what, count] : new_cases) {
    const auto known = old_cases.find(what);
    if (known == old_cases.end() || known->second == count) continue;
    throw scene::InputError(path.string(), 0,
                            fmt::format("expected the cases of the old result ({} {} in {}), found {}",
                                        known->second, what, key_of(after), count));
  }
}

void compare_environments(const ResultFile& before, const ResultFile& after, Comparison& comparison) {
  for (const auto& now : after.environment) {
    const std::string& name = now.first;  // clang 14 can't capture structured bindings
    const std::string& value = now.second;
    const auto known = std::find_if(before.environment.begin(), before.environment.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    if (known == before.environment.end() || known->second == value) continue;
    comparison.environment.emplace_back(name, known->second + " -> " + value);
  }
}

void check_same_run(const std::filesystem::path& path, const ResultFile& before, const ResultFile& after) {
  if (before.seeds != after.seeds) {
    throw scene::InputError(path.string(), 0,
                            fmt::format("expected the workload of the old result (seed {}), found seed {}",
                                        seeds_text(before), seeds_text(after)));
  }
  if (shard_of(before) != shard_of(after)) {
    throw scene::InputError(path.string(), 0,
                            fmt::format("expected the workload of the old result (shard {}), found shard {}",
                                        shard_of(before), shard_of(after)));
  }
}

using RowsByKey = std::map<std::string, const ResultRow*>;

RowsByKey rows_of(const std::filesystem::path& path, const ResultFile& file) {
  RowsByKey rows;
  for (const ResultRow& row : file.rows) {
    if (!rows.emplace(key_of(row), &row).second) {
      throw scene::InputError(path.string(), 0, "expected each row once, found twice: " + key_of(row));
    }
  }
  return rows;
}

}  // namespace

bool Comparison::regressed() const {
  return std::any_of(errors.begin(), errors.end(),
                     [](const ErrorChange& e) { return e.change == Change::worse; }) ||
         std::any_of(speeds.begin(), speeds.end(), [](const SpeedChange& s) { return s.above_limit; }) ||
         (same_command && !only_old.empty());
}

Comparison compare_results(const std::filesystem::path& before, const std::filesystem::path& after,
                           const CompareOptions& options) {
  const Json json = read_json(before);
  if (kind_of_result(Node(json, before)) == "measure") return compare_measurements(before, after, options);
  const ResultFile old_file = read_fuzz_result(before), new_file = read_fuzz_result(after);
  check_same_run(after, old_file, new_file);
  const RowsByKey old_rows = rows_of(before, old_file), new_rows = rows_of(after, new_file);

  Comparison comparison;
  comparison.old_name = before.string();
  comparison.new_name = after.string();
  comparison.command = new_file.command;
  comparison.same_command = !new_file.command.empty() && new_file.command == old_file.command;
  std::vector<double> reference_ratios;
  for (const ResultRow& now : new_file.rows) {
    const auto known = old_rows.find(key_of(now));
    if (known == old_rows.end()) {
      comparison.only_new.push_back(key_of(now));
      continue;
    }
    const ResultRow& then = *known->second;
    check_same_cases(after, then, now);
    ++comparison.rows;
    Comparer(then, now, comparison.errors).compare();
    if (then.ns.value_or(0) > 0 && now.ns.value_or(0) > 0) {
      const double ratio = *now.ns / *then.ns;
      comparison.speeds.push_back({key_of(now), *then.ns, *now.ns, ratio,
                                   ratio >= 1 - options.tolerance && ratio <= 1 + options.tolerance,
                                   options.speed_limit && ratio > *options.speed_limit});
    }
    if (then.reference_ns.value_or(0) > 0 && now.reference_ns.value_or(0) > 0) {
      reference_ratios.push_back(*now.reference_ns / *then.reference_ns);
    }
  }
  for (const ResultRow& then : old_file.rows) {
    if (!new_rows.contains(key_of(then))) comparison.only_old.push_back(key_of(then));
  }
  if (comparison.rows == 0) {
    throw scene::InputError(after.string(), 0,
                            "expected the workload of the old result, found no row that is in both");
  }
  std::stable_sort(comparison.errors.begin(), comparison.errors.end(),
                   [](const ErrorChange& a, const ErrorChange& b) { return a.change < b.change; });
  std::stable_sort(comparison.speeds.begin(), comparison.speeds.end(),
                   [](const SpeedChange& a, const SpeedChange& b) { return a.ratio > b.ratio; });
  if (!reference_ratios.empty()) {
    comparison.reference_ratio = fuzz::spread_of(std::move(reference_ratios)).median;
  }
  compare_environments(old_file, new_file, comparison);
  return comparison;
}

}  // namespace gnomon::reports
