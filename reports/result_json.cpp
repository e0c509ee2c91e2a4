// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/result_json.h"

#include <nlohmann/json.hpp>

#include "fuzz/question_words.h"
#include "fuzz/statistics.h"
#include "reports/environment.h"

namespace gnomon::reports {

namespace {

using Json = nlohmann::ordered_json;
using fuzz::Fault;
using fuzz::RowResult;
using fuzz::Verdict;

Json rate_json(std::uint64_t hits, std::uint64_t trials) {
  const fuzz::Rate rate = fuzz::rate_of(hits, trials);
  return {
      {"value", rate.value}, {"low95", rate.low95}, {"high95", rate.high95}, {"hits", hits}, {"of", trials}};
}

Json matrix_json(const RowResult& row) {
  const fuzz::QuestionWords& words = row.words();
  Json matrix = Json::object();
  for (std::size_t truth = 0; truth < words.truth_count(); ++truth) {
    Json cells = Json::object();
    for (std::size_t answer = 0; answer < fuzz::kTruths; ++answer) {
      cells[std::string(words.answers[answer])] = row.matrix[truth][answer];
    }
    matrix[std::string(words.truths[truth])] = cells;
  }
  return matrix;
}

Json gap_json(const exact::Gap& gap, double length, double ulps) {
  return {{"rational", gap.get_str()}, {"approx", length}, {"ulps", ulps}};
}

/// What rows of all questions begin with.
Json head_json(const RowResult& row) {
  Json json;
  json["question"] = row.question;
  json["method"] = row.method;
  json["tier"] = row.tier;
  json["promise"] = row.promise;
  json["promise_broken"] = row.promise_broken();
  json["distribution"] = row.distribution;
  json["scalar"] = row.scalar;
  json["trials"] = row.trials;
  return json;
}

void add_verdicts(const RowResult& row, Json& json) {
  json["matrix"] = matrix_json(row);
  json["waste"] = row.count(Verdict::waste);
  json["unsound"] = row.count(Verdict::unsound);
  json["undecided"] = row.count(Verdict::undecided);
  json["rejected"] = row.count(Verdict::rejected);
}

Json witness_names(const RowResult& row) {
  Json names = Json::array();
  for (const fuzz::Witness& witness : row.witnesses) names.push_back(witness.name);
  return names;
}

Json shaft_row_json(const RowResult& row) {
  const std::uint64_t outside = row.truths(0), meeting = row.truths(1) + row.truths(2);
  const std::uint64_t kept = row.matrix[0][1] + row.matrix[0][2];
  Json json = head_json(row);
  json["touching"] = {{"outside", row.touching_outside}, {"inside", row.touching_inside}};
  add_verdicts(row, json);
  json["false_culls"] = row.count(Fault::false_cull);
  json["false_insides"] = row.count(Fault::false_inside);
  json["unsound_touching"] = row.unsound_touching;
  json["rounding"] = row.rounding;
  json["model"] = row.model;
  json["rounding_and_model"] = row.rounding_and_model;
  json["threshold_checked"] = row.threshold_checked;
  json["threshold_exceeded"] = row.threshold_exceeded;
  json["waste_rate"] = rate_json(kept, outside);
  json["unsound_rate"] = rate_json(row.count(Fault::false_cull), meeting);
  json["false_inside_rate"] = rate_json(row.count(Fault::false_inside), row.truths(0) + row.truths(1));
  json["worst_gap"] =
      row.worst ? gap_json(row.worst->value, row.worst->length, row.worst->ulps) : Json(nullptr);
  if (row.worst) json["worst_gap"]["trial"] = row.worst->trial;
  json["witnesses"] = witness_names(row);
  return json;
}

/// Each wrong cell of the matrix has a rate over its truth, named "part_as_all_rate". Besides, waste is told
/// over the cases where it is possible, and what is unsound over those where that is.
Json pair_row_json(const RowResult& row) {
  const fuzz::QuestionWords& words = row.words();
  Json json = head_json(row);
  json["independent"] = row.independent;  // false: intervals take queries of one scene as if they were
  add_verdicts(row, json);
  const fuzz::PairChances chances = fuzz::chances_of(row);
  json["waste_rate"] = rate_json(row.count(Verdict::waste), chances.waste);
  json["unsound_rate"] = rate_json(row.count(Verdict::unsound), chances.unsound);
  for (std::size_t truth = 0; truth < words.truth_count(); ++truth) {
    for (std::size_t answer = 0; answer < fuzz::kTruths; ++answer) {
      if (!words.can_be(truth, answer) || words.verdicts[truth][answer] == Verdict::agree) continue;
      const std::string name =
          std::string(words.truths[truth]) + "_as_" + std::string(words.answers[answer]) + "_rate";
      json[name] = rate_json(row.matrix[truth][answer], row.truths(truth));
    }
  }
  if (words.lists_faces) {
    json["faces"] = {{"true", row.faces.in_truth},
                     {"listed", row.faces.listed},
                     {"missing", row.faces.missing},
                     {"excess", row.faces.excess}};
  }
  json["witnesses"] = witness_names(row);
  return json;
}

Json row_json(const RowResult& row) {
  return row.words().about_pairs ? pair_row_json(row) : shaft_row_json(row);
}

Json witness_json(const fuzz::Witness& witness) {
  Json json = {{"name", witness.name},      {"question", witness.question},
               {"method", witness.method},  {"distribution", witness.distribution},
               {"scalar", witness.scalar},  {"verdict", witness.verdict},
               {"answer", witness.answer},  {"reference", witness.reference},
               {"case", witness.case_text}, {"as_generated", witness.original_text}};
  if (witness.has_gap) json["gap"] = gap_json(witness.gap, witness.gap_length, witness.gap_ulps);
  json["index"] = witness.trial;
  return json;
}

Json failures_json(const std::vector<fuzz::Failure>& failures) {
  Json all = Json::array();
  for (const fuzz::Failure& failure : failures) {
    all.push_back({{"method", failure.method},
                   {"distribution", failure.distribution},
                   {"scalar", failure.scalar},
                   {"line", failure.line},
                   {"cases", failure.cases}});
  }
  return all;
}

}  // namespace

std::string result_json(const fuzz::CampaignResult& result) {
  Json json;
  json["schema"] = 1;
  json["kind"] = "fuzz";
  json["tool"] = version();
  json["command"] = result.command;
  json["seed"] = result.seed;
  json["shard"] = std::to_string(result.shard) + "/" + std::to_string(result.shards);
  json["witnesses_per_row"] = result.witnesses_per_row;
  if (!result.complete) json["complete"] = false;
  if (!result.failures.empty()) json["failures"] = failures_json(result.failures);
  json["rows"] = Json::array();
  json["witnesses"] = Json::array();
  Json times = Json::array();
  for (const RowResult& row : result.rows) {
    json["rows"].push_back(row_json(row));
    for (const fuzz::Witness& witness : row.witnesses) json["witnesses"].push_back(witness_json(witness));
    times.push_back({{"question", row.question},
                     {"method", row.method},
                     {"distribution", row.distribution},
                     {"scalar", row.scalar},
                     {"ns", row.ns_per_case},
                     {"reference_ns", row.reference_ns_per_case}});
  }
  Json where = Json::object();
  for (const auto& [name, value] : environment()) where[name] = value;
  json["measured"] = {{"environment", where},
                      {"seconds", result.seconds},
                      {"core_seconds", result.core_seconds},
                      {"ns_per_case", times}};
  return json.dump(1) + "\n";
}

}  // namespace gnomon::reports
