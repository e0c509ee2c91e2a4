// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fuzz/method.h"
#include "fuzz/scene_measurement.h"
#include "reports/compare.h"
#include "reports/json_node.h"
#include "reports/list_json.h"
#include "scene/input_error.h"

namespace gnomon::reports {
namespace {

struct MeasureResult {
  std::filesystem::path path;
  std::string command;
  std::uint64_t seed = 0;
  std::string lights;
  std::vector<MeasureRow> rows;
  std::vector<ListFigures> lists;
  std::map<std::string, const MeasureRow*> by_key;
  std::map<std::string, std::string> environment;

  [[noreturn]] void fail(const std::string& message) const {
    throw scene::InputError(path.string(), 0, message);
  }
};

std::string key_of(const MeasureRow& row) {
  return row.question + " " + row.scene + " " + row.variant + " " + row.workload + " " + row.method;
}

void read(const std::filesystem::path& path, MeasureResult& result) {
  result.path = path;
  const Json json = read_json(path);
  const Node top(json, path);
  if (const std::string kind = kind_of_result(top); kind != "measure") {
    result.fail("expected a result of gnomon measure as the old one is, found one of kind \"" + kind + "\"");
  }
  result.command = top.at("command").text();
  result.seed = top.at("seed").count();
  for (const Node& light : top.at("lights").list()) {
    result.lights += (result.lights.empty() ? "" : " ") + light.text();
  }
  result.rows = read_measure_rows(top);
  result.lists = read_lists(top);
  for (const MeasureRow& row : result.rows) {
    if (!result.by_key.emplace(key_of(row), &row).second) {
      result.fail("expected each row once, found twice: " + key_of(row));
    }
  }
  if (!top.has("measured") || !top.at("measured").has("environment")) return;
  for (const auto& [name, value] : top.at("measured").at("environment").fields()) {
    result.environment[name] = value.json().is_string() ? value.text() : value.json().dump();
  }
}

std::string words_of(const std::map<std::string, std::uint64_t>& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
  return text;
}

void check_same_queries(const MeasureResult& after, const MeasureRow& then, const MeasureRow& now) {
  const auto same = [&](const std::string& what, const auto& expected, const auto& found) {
    if (expected == found) return;
    after.fail(fmt::format("expected the workload of the old result ({} {} in {}), found {}", expected, what,
                           key_of(now), found));
  };
  same("faces", then.faces, now.faces);
  same("queries", then.queries, now.queries);
  same("exactly", words_of(then.truths), words_of(now.truths));
  same("touching", words_of(then.touching), words_of(now.touching));
}

std::uint64_t strength_of(const std::string& promise) {
  for (const fuzz::Promise known : {fuzz::Promise::never_unsound, fuzz::Promise::always_agrees}) {
    if (promise == name_of(known)) return static_cast<std::uint64_t>(known);
  }
  return 0;
}

void compare_counts(const MeasureRow& then, const MeasureRow& now, std::vector<ErrorChange>& changes) {
  const std::string key = key_of(now);
  const std::uint64_t before = strength_of(then.promise), after = strength_of(now.promise);
  if (before != after) {
    changes.push_back({key, "promise", before, after, after < before ? Change::worse : Change::better,
                       then.promise + " -> " + now.promise});
  }
  const auto say = [&](const char* field, std::uint64_t old_count, std::uint64_t new_count, Change more) {
    if (old_count == new_count) return;
    changes.push_back({key, field, old_count, new_count, new_count < old_count ? Change::better : more});
  };
  say("promise_broken", then.promise_broken, now.promise_broken, Change::worse);
  say("unsound", then.unsound, now.unsound, Change::worse);
  say("false_lit", then.false_lit.k, now.false_lit.k, Change::worse);
  say("false_shadowed", then.false_shadowed.k, now.false_shadowed.k, Change::worse);
  say("wrong_reason", then.wrong_reason, now.wrong_reason, Change::worse);
  say("wrong_face", then.wrong_face.k, now.wrong_face.k, Change::worse);
  say("false_miss", then.false_miss.k, now.false_miss.k, Change::worse);
  say("false_hit", then.false_hit.k, now.false_hit.k, Change::worse);
  say("unsound_touching", then.unsound_touching, now.unsound_touching, Change::worse);
  // A method that promised nothing may say "undecided" as it likes; one that gave up its promise may not.
  const Change more = then.promise != "none" ? Change::worse : Change::other;
  say("undecided", then.undecided, now.undecided, more);
  say("rejected", then.rejected, now.rejected, more);
  say("changed_by_order", then.changed_by_order, now.changed_by_order, more);
}

void compare_speed(const std::string& key, const char* order, const std::optional<TimeSpread>& then,
                   const std::optional<TimeSpread>& now, const CompareOptions& options,
                   std::vector<SpeedChange>& speeds) {
  if (!then || !now || !(then->median > 0) || !(now->median > 0)) return;
  const double ratio = now->median / then->median;
  const bool overlap = then->low25 <= now->high75 && now->low25 <= then->high75;
  const bool close = ratio >= 1 - options.tolerance && ratio <= 1 + options.tolerance;
  speeds.push_back({key + " " + order, then->median, now->median, ratio, close || overlap,
                    options.speed_limit && ratio > *options.speed_limit && !overlap, then, now});
}

std::optional<TimeSpread> spread_of_times(const std::optional<fuzz::Spread>& ns) {
  if (!ns) return std::nullopt;
  return TimeSpread{ns->median, ns->low25, ns->high75};
}

void compare_lists(const MeasureResult& before, const MeasureResult& after, const CompareOptions& options,
                   Comparison& comparison) {
  for (const ListFigures& now : after.lists) {
    const auto then = std::find_if(before.lists.begin(), before.lists.end(), [&](const ListFigures& row) {
      return row.scene == now.scene && row.table == now.table && row.name == now.name;
    });
    const std::string row_key = "lists " + now.scene + " " + now.table + " " + now.name;
    if (then == before.lists.end() || then->rates.size() != now.rates.size()) {
      comparison.only_new.push_back(row_key);
      continue;
    }
    ++comparison.rows;
    for (std::size_t k = 0; k < now.rates.size(); ++k) {
      const ListRate &old_rate = then->rates[k], &rate = now.rates[k];
      const std::string key = row_key + (k == 0 ? " low" : " high");
      if (old_rate.pairs != rate.pairs || old_rate.rays != rate.rays || old_rate.shadowed != rate.shadowed) {
        after.fail(fmt::format("expected the workload of the old result ({} rays in {}), found {}",
                               old_rate.rays, key, rate.rays));
      }
      const auto say = [&](const char* field, std::uint64_t old_count, std::uint64_t new_count) {
        if (old_count == new_count) return;
        comparison.errors.push_back(
            {key, field, old_count, new_count, new_count < old_count ? Change::better : Change::worse});
      };
      say("false_lit", old_rate.false_lit, rate.false_lit);
      say("false_shadowed", old_rate.false_shadowed, rate.false_shadowed);
      // Of equally many lists; options decide how many there are.
      if (old_rate.checked == rate.checked) say("lacking", old_rate.lacking, rate.lacking);
      compare_speed(key, "ray", spread_of_times(old_rate.ray), spread_of_times(rate.ray), options,
                    comparison.speeds);
    }
  }
  for (const ListFigures& then : before.lists) {
    if (std::none_of(after.lists.begin(), after.lists.end(), [&](const ListFigures& row) {
          return row.scene == then.scene && row.table == then.table && row.name == then.name;
        })) {
      comparison.only_old.push_back("lists " + then.scene + " " + then.table + " " + then.name);
    }
  }
}

}  // namespace

Comparison compare_measurements(const std::filesystem::path& before, const std::filesystem::path& after,
                                const CompareOptions& options) {
  MeasureResult then, now;
  read(before, then);
  read(after, now);
  if (then.seed != now.seed) {
    now.fail(
        fmt::format("expected the workload of the old result (seed {}), found seed {}", then.seed, now.seed));
  }
  if (then.lights != now.lights) {
    const auto words = [](const std::string& lights) { return lights.empty() ? "the scenes' own" : lights; };
    now.fail(fmt::format("expected the workload of the old result (lights: {}), found lights: {}",
                         words(then.lights), words(now.lights)));
  }
  Comparison comparison;
  comparison.old_name = before.string();
  comparison.new_name = after.string();
  comparison.command = now.command;
  comparison.unit = "query";
  comparison.same_command = !now.command.empty() && now.command == then.command;
  std::vector<double> reference_ratios;
  for (const MeasureRow& row : now.rows) {
    const std::string key = key_of(row);
    const auto known = then.by_key.find(key);
    if (known == then.by_key.end()) {
      comparison.only_new.push_back(key);
      continue;
    }
    const MeasureRow& old_row = *known->second;
    check_same_queries(now, old_row, row);
    ++comparison.rows;
    compare_counts(old_row, row, comparison.errors);
    compare_speed(key, "image", old_row.image, row.image, options, comparison.speeds);
    compare_speed(key, "shuffled", old_row.shuffled, row.shuffled, options, comparison.speeds);
    compare_speed(key, "listed", old_row.listed, row.listed, options, comparison.speeds);
    if (row.tier == "reference" && old_row.image && row.image && old_row.image->median > 0) {
      reference_ratios.push_back(row.image->median / old_row.image->median);
    }
  }
  for (const MeasureRow& row : then.rows) {
    if (!now.by_key.contains(key_of(row))) comparison.only_old.push_back(key_of(row));
  }
  compare_lists(then, now, options, comparison);
  if (comparison.rows == 0) now.fail("expected the workload of the old result, found no row that is in both");
  std::stable_sort(comparison.errors.begin(), comparison.errors.end(),
                   [](const ErrorChange& a, const ErrorChange& b) { return a.change < b.change; });
  std::stable_sort(comparison.speeds.begin(), comparison.speeds.end(),
                   [](const SpeedChange& a, const SpeedChange& b) { return a.ratio > b.ratio; });
  if (!reference_ratios.empty()) {
    comparison.reference_ratio = fuzz::spread_of(std::move(reference_ratios)).median;
  }
  for (const auto& [name, value] : now.environment) {
    const auto known = then.environment.find(name);
    if (known == then.environment.end() || known->second == value) continue;
    comparison.environment.emplace_back(name, known->second + " -> " + value);
  }
  return comparison;
}

}  // namespace gnomon::reports
