// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "fuzz/statistics.h"
#include "reports/environment.h"
#include "reports/measure_text.h"

namespace gnomon::reports {
namespace {

using Json = nlohmann::ordered_json;
using fuzz::ShadowRow;

Json rate_json(std::uint64_t hits, std::uint64_t of) {
  const fuzz::Rate rate = fuzz::rate_of(hits, of);
  return {{"value", rate.value}, {"low95", rate.low95}, {"high95", rate.high95}, {"hits", hits}, {"of", of}};
}

Json matrix_json(const ShadowRow::Matrix& matrix) {
  Json json = Json::object();
  for (std::size_t truth = 0; truth < fuzz::kTruths; ++truth) {
    Json cells = Json::object();
    for (std::size_t answer = 0; answer < fuzz::kTruths; ++answer) {
      cells[std::string(fuzz::kShadowAnswers[answer])] = matrix[truth][answer];
    }
    cells["undecided"] = matrix[truth][fuzz::kUndecided];
    cells["rejected"] = matrix[truth][fuzz::kRejected];
    json[std::string(fuzz::kShadowAnswers[truth])] = cells;
  }
  return json;
}

Json touching_json(const ShadowRow& row) {
  const ShadowRow::Matrix& m = row.touching;
  Json json = Json::object();
  for (std::size_t truth = 0; truth < fuzz::kTruths; ++truth) {
    json[std::string(fuzz::kShadowAnswers[truth])] = ShadowRow::truths(m, truth);
  }
  json["unsound"] = ShadowRow::unsound(m);
  json["false_lit"] = ShadowRow::false_lit(m);
  json["false_shadowed"] = ShadowRow::false_shadowed(m);
  json["wrong_reason"] = ShadowRow::wrong_reason(m);
  json["undecided"] = ShadowRow::column(m, fuzz::kUndecided);
  return json;
}

Json tests_json(const ShadowRow& row) {
  if (!row.tests) return nullptr;
  const double n = static_cast<double>(row.queries());
  return {{"boxes", static_cast<double>(row.tests->boxes) / n},
          {"faces", static_cast<double>(row.tests->faces) / n},
          {"exact", static_cast<double>(row.tests->exact) / n}};
}

Json row_json(const ShadowRow& row) {
  const ShadowRow::Matrix& m = row.matrix;
  Json json;
  json["question"] = "shadow";
  json["scene"] = row.scene;
  json["faces"] = row.faces;
  json["workload"] = row.workload;
  json["variant"] = row.variant;
  json["method"] = row.method->name;
  json["tier"] = row.method->tier;
  json["promise"] = name_of(row.method->promise);
  json["queries"] = row.queries();
  json["matrix"] = matrix_json(m);
  json["touching"] = touching_json(row);
  json["waste"] = 0;  // the question has none: each wrong answer is a wrong image
  json["unsound"] = ShadowRow::unsound(m);
  json["false_lit"] = ShadowRow::false_lit(m);
  json["false_shadowed"] = ShadowRow::false_shadowed(m);
  json["wrong_reason"] = ShadowRow::wrong_reason(m);
  json["undecided"] = ShadowRow::column(m, fuzz::kUndecided);
  json["rejected"] = ShadowRow::column(m, fuzz::kRejected);
  json["changed_by_order"] = row.changed_by_order;
  json["unsound_rate"] = rate_json(ShadowRow::unsound(m), row.queries());
  json["false_lit_rate"] = rate_json(ShadowRow::false_lit(m), row.dark());
  json["false_shadowed_rate"] = rate_json(ShadowRow::false_shadowed(m), ShadowRow::truths(m, 0));
  json["tests_per_query"] = tests_json(row);
  json["promise_broken"] = row.promise_broken();
  return json;
}

Json time_json(const ShadowRow& row, const char* order, const fuzz::Spread& ns) {
  return {{"question", "shadow"},
          {"scene", row.scene},
          {"workload", row.workload},
          {"variant", row.variant},
          {"method", row.method->name},
          {"order", order},
          {"ns", {{"median", ns.median}, {"low25", ns.low25}, {"high75", ns.high75}}}};
}

}  // namespace

std::string measure_json(const fuzz::Measurement& measurement, const MeasureCommand& command) {
  Json json;
  json["schema"] = 1;
  json["kind"] = "measure";
  json["tool"] = version();
  json["command"] = command.text;
  if (!command.complete) json["complete"] = false;
  json["note"] =
      "queries of a scene are not independent: the 95 % intervals (Clopper-Pearson) take them as if they "
      "were";
  json["notes"] = measurement.notes;
  json["rows"] = Json::array();
  Json times = Json::array(), set_ups = Json::array();
  for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
    const ShadowRow& row = measurement.rows[i];
    json["rows"].push_back(row_json(row));
    times.push_back(time_json(row, "image", measurement.times[i].image));
    times.push_back(time_json(row, "shuffled", measurement.times[i].shuffled));
  }
  for (const fuzz::SetUp& set_up : measurement.set_ups) {
    set_ups.push_back({{"scene", set_up.scene},
                       {"variant", set_up.variant},
                       {"method", set_up.method->name},
                       {"seconds", set_up.seconds},
                       {"bytes", set_up.bytes}});
  }
  Json where = Json::object();
  for (const auto& [name, value] : environment()) where[name] = value;
  json["measured"] = {
      {"environment", where}, {"rounds", command.rounds}, {"set_ups", set_ups}, {"ns_per_query", times}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gnomon::reports
