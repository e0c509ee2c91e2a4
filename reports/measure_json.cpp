// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>

#include "fuzz/statistics.h"
#include "reports/environment.h"
#include "reports/list_json.h"
#include "reports/measure_text.h"

namespace gnomon::reports {
namespace {

using Json = nlohmann::ordered_json;
using fuzz::FirstHitRow;
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

template <class Row>
Json tests_json(const Row& row) {
  if (!row.tests) return nullptr;
  const double n = static_cast<double>(row.queries());
  return {{"boxes", static_cast<double>(row.tests->boxes) / n},
          {"faces", static_cast<double>(row.tests->faces) / n},
          {"exact", static_cast<double>(row.tests->exact) / n}};
}

Json pairs_json(const fuzz::PairTotals& totals) {
  const double n = static_cast<double>(std::max<std::uint64_t>(totals.pairs, 1));
  return {{"pairs", totals.pairs},
          {"all", totals.all},
          {"none", totals.none},
          {"faces_per_pair", static_cast<double>(totals.faces) / n}};
}

/// The fields that rows of both questions begin with.
template <class Row>
Json head_json(const char* question, const Row& row) {
  Json json;
  json["question"] = question;
  json["scene"] = row.scene;
  json["faces"] = row.faces;
  json["workload"] = row.workload;
  json["variant"] = row.variant;
  json["method"] = row.method->name;
  json["tier"] = row.method->tier;
  json["promise"] = name_of(row.method->promise);
  json["queries"] = row.queries();
  return json;
}

Json row_json(const ShadowRow& row) {
  const ShadowRow::Matrix& m = row.matrix;
  Json json = head_json("shadow", row);
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
  if (row.pairs) json["pairs"] = pairs_json(*row.pairs);
  json["promise_broken"] = row.promise_broken();
  return json;
}

Json hit_matrix_json(const FirstHitRow::Matrix& matrix) {
  Json json = Json::object();
  for (std::size_t truth = 0; truth < fuzz::kHitTruths.size(); ++truth) {
    Json cells = Json::object();
    for (std::size_t answer = 0; answer < fuzz::kHitAnswers.size(); ++answer) {
      cells[std::string(fuzz::kHitAnswers[answer])] = matrix[truth][answer];
    }
    json[std::string(fuzz::kHitTruths[truth])] = cells;
  }
  return json;
}

Json hit_row_json(const FirstHitRow& row) {
  const FirstHitRow::Matrix &m = row.matrix, &touching = row.touching;
  Json json = head_json("first-hit", row);
  json["matrix"] = hit_matrix_json(m);
  json["touching"] = {{"none", FirstHitRow::truths(touching, 0)},
                      {"face", FirstHitRow::truths(touching, 1)},
                      {"unsound", FirstHitRow::unsound(touching)},
                      {"wrong_face", FirstHitRow::wrong_face(touching)},
                      {"false_miss", FirstHitRow::false_miss(touching)},
                      {"false_hit", FirstHitRow::false_hit(touching)},
                      {"undecided", FirstHitRow::column(touching, FirstHitRow::undecided)}};
  json["ties"] = row.ties;
  json["waste"] = 0;  // as for shadow
  json["unsound"] = FirstHitRow::unsound(m);
  json["wrong_face"] = FirstHitRow::wrong_face(m);
  json["false_miss"] = FirstHitRow::false_miss(m);
  json["false_hit"] = FirstHitRow::false_hit(m);
  json["undecided"] = FirstHitRow::column(m, FirstHitRow::undecided);
  json["rejected"] = FirstHitRow::column(m, FirstHitRow::rejected);
  json["changed_by_order"] = row.changed_by_order;
  json["unsound_rate"] = rate_json(FirstHitRow::unsound(m), row.queries());
  json["wrong_face_rate"] = rate_json(FirstHitRow::wrong_face(m), FirstHitRow::truths(m, 1));
  json["false_miss_rate"] = rate_json(FirstHitRow::false_miss(m), FirstHitRow::truths(m, 1));
  json["false_hit_rate"] = rate_json(FirstHitRow::false_hit(m), FirstHitRow::truths(m, 0));
  json["tests_per_query"] = tests_json(row);
  json["promise_broken"] = row.promise_broken();
  return json;
}

template <class Row>
Json time_json(const char* question, const Row& row, const char* order, const fuzz::Spread& ns) {
  return {{"question", question},
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
  json["seed"] = command.seed;
  json["lights"] = command.lights;
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
    times.push_back(time_json("shadow", row, "image", measurement.times[i].image));
    times.push_back(time_json("shadow", row, "shuffled", measurement.times[i].shuffled));
    if (measurement.times[i].listed) {
      times.push_back(time_json("shadow", row, "listed", *measurement.times[i].listed));
    }
  }
  for (std::size_t i = 0; i < measurement.hit_rows.size(); ++i) {
    const FirstHitRow& row = measurement.hit_rows[i];
    json["rows"].push_back(hit_row_json(row));
    times.push_back(time_json("first-hit", row, "image", measurement.hit_times[i].image));
    times.push_back(time_json("first-hit", row, "shuffled", measurement.hit_times[i].shuffled));
  }
  for (const fuzz::SetUp& set_up : measurement.set_ups) {
    set_ups.push_back({{"scene", set_up.scene},
                       {"variant", set_up.variant},
                       {"method", set_up.method->name},
                       {"seconds", set_up.seconds},
                       {"bytes", set_up.bytes}});
  }
  std::vector<ListFigures> lists;
  for (const fuzz::ListRow& row : measurement.lists) lists.push_back(figures_of(row));
  if (!lists.empty()) json["lists"] = lists_json(lists);
  Json where = Json::object();
  for (const auto& [name, value] : environment()) where[name] = value;
  json["measured"] = {
      {"environment", where}, {"rounds", command.rounds}, {"set_ups", set_ups}, {"ns_per_query", times}};
  if (!lists.empty()) json["measured"]["lists"] = list_times_json(lists);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gnomon::reports
