// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/compare.h"
#include "reports/environment.h"

namespace gnomon::reports {

namespace {

const char* name_of(Change change) {
  switch (change) {
    case Change::worse:
      return "worse";
    case Change::better:
      return "better";
    case Change::other:
      return "changed";
  }
  return "?";
}

std::string error_text(const ErrorChange& error) {
  if (error.field == "promise_broken") {
    return fmt::format("  {:<8}{}: promise {}\n", name_of(error.change), error.row,
                       error.after != 0 ? "newly BROKEN" : "holds again");
  }
  if (!error.words.empty()) {
    return fmt::format("  {:<8}{}: {} {}\n", name_of(error.change), error.row, error.field, error.words);
  }
  const double difference = static_cast<double>(error.after) - static_cast<double>(error.before);
  return fmt::format("  {:<8}{}: {} {} -> {} ({:+.0f})\n", name_of(error.change), error.row, error.field,
                     error.before, error.after, difference);
}

std::string spread_text(const std::optional<TimeSpread>& spread) {
  return spread ? fmt::format(" [{:.4g}, {:.4g}]", spread->low25, spread->high75) : "";
}

std::string speed_text(const SpeedChange& speed, const std::string& unit) {
  const char* const word = speed.above_limit    ? "TOO SLOW"
                           : speed.within_noise ? "equal"
                           : speed.ratio > 1    ? "slower"
                                                : "faster";
  return fmt::format("  {:<9}{}: {:.4g}{} -> {:.4g}{} ns per {}, x {:.3f}\n", word, speed.row, speed.before,
                     spread_text(speed.before_spread), speed.after, spread_text(speed.after_spread), unit,
                     speed.ratio);
}

double geometric_mean(const std::vector<SpeedChange>& speeds) {
  double sum = 0;
  for (const SpeedChange& speed : speeds) sum += std::log(speed.ratio);
  return std::exp(sum / static_cast<double>(speeds.size()));
}

std::string speeds_text(const Comparison& comparison, const CompareOptions& options) {
  const std::vector<SpeedChange>& speeds = comparison.speeds;
  if (speeds.empty()) return "\nSpeed: not measured in both\n";
  const auto noise =
      std::count_if(speeds.begin(), speeds.end(), [](const SpeedChange& s) { return s.within_noise; });
  std::string text =
      fmt::format("\nSpeed (new / old time per {}): x {:.3f} on average over {} rows; {} within {:g} %{}\n",
                  comparison.unit, geometric_mean(speeds), speeds.size(), noise, 100 * options.tolerance,
                  speeds.front().before_spread ? " or the quartiles of both" : "");
  for (const SpeedChange& speed : speeds) {
    if (!speed.within_noise || speed.above_limit) text += speed_text(speed, comparison.unit);
  }
  if (comparison.reference_ratio) {
    text += fmt::format(
        "  the exact reference itself: x {:.3f} (median); what it gained, the machine may have gained\n",
        *comparison.reference_ratio);
  }
  for (const auto& [name, values] : comparison.environment)
    text += fmt::format("  not measured alike: {}: {}\n", name, values);
  return text;
}

std::string list_text(const char* where, const std::vector<std::string>& rows) {
  std::string text;
  for (const std::string& row : rows) text += fmt::format("  only in {}: {}\n", where, row);
  return text;
}

}  // namespace

std::string comparison_text(const Comparison& comparison, const CompareOptions& options) {
  std::string text =
      fmt::format("{} -> {}: {} rows in both\n\n", comparison.old_name, comparison.new_name, comparison.rows);
  if (comparison.errors.empty()) {
    text += "Errors: none more, none fewer\n";
  } else {
    const auto worse = std::count_if(comparison.errors.begin(), comparison.errors.end(),
                                     [](const ErrorChange& e) { return e.change == Change::worse; });
    text += fmt::format("Errors: {} count{} worse, of {} that changed\n", worse, worse == 1 ? "" : "s",
                        comparison.errors.size());
    for (const ErrorChange& error : comparison.errors) text += error_text(error);
  }
  if (!comparison.only_old.empty() || !comparison.only_new.empty()) {
    text +=
        "\nNot compared:\n" + list_text("old", comparison.only_old) + list_text("new", comparison.only_new);
    if (comparison.same_command && !comparison.only_old.empty()) {
      text += fmt::format("  lost: the same command gave {} more row{}\n", comparison.only_old.size(),
                          comparison.only_old.size() == 1 ? "" : "s");
    }
  }
  text += speeds_text(comparison, options);
  text += comparison.regressed() ? "\nREGRESSED\n" : "\nNo regression\n";
  return text;
}

std::string comparison_json(const Comparison& comparison, const CompareOptions& options) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["schema"] = 1;
  json["kind"] = "compare";
  json["tool"] = version();
  json["old"] = comparison.old_name;
  json["new"] = comparison.new_name;
  json["command"] = comparison.command;
  json["regressed"] = comparison.regressed();
  json["tolerance"] = options.tolerance;
  json["speed_limit"] = options.speed_limit ? Json(*options.speed_limit) : Json(nullptr);
  json["compared_rows"] = comparison.rows;
  json["errors"] = Json::array();
  for (const ErrorChange& error : comparison.errors) {
    json["errors"].push_back({{"row", error.row},
                              {"field", error.field},
                              {"old", error.before},
                              {"new", error.after},
                              {"change", name_of(error.change)}});
    if (!error.words.empty()) json["errors"].back()["words"] = error.words;
  }
  json["speeds"] = Json::array();
  for (const SpeedChange& speed : comparison.speeds) {
    json["speeds"].push_back({{"row", speed.row},
                              {"old_ns", speed.before},
                              {"new_ns", speed.after},
                              {"ratio", speed.ratio},
                              {"within_noise", speed.within_noise},
                              {"above_limit", speed.above_limit}});
    const auto quartiles = [](const TimeSpread& spread) { return Json{spread.low25, spread.high75}; };
    if (speed.before_spread) json["speeds"].back()["old_quartiles"] = quartiles(*speed.before_spread);
    if (speed.after_spread) json["speeds"].back()["new_quartiles"] = quartiles(*speed.after_spread);
  }
  json["reference_ratio"] = comparison.reference_ratio ? Json(*comparison.reference_ratio) : Json(nullptr);
  json["only_old"] = comparison.only_old;
  json["only_new"] = comparison.only_new;
  json["same_command"] = comparison.same_command;
  json["environment"] = Json::object();
  for (const auto& [name, values] : comparison.environment) json["environment"][name] = values;
  return json.dump(1) + "\n";
}

}  // namespace gnomon::reports
