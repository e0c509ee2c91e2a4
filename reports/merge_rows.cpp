// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/merge_rows.h"

#include <gmpxx.h>

#include <algorithm>
#include <map>
#include <set>

#include "fuzz/question_words.h"
#include "fuzz/statistics.h"

namespace gnomon::reports {

namespace {

std::uint64_t added(std::uint64_t sum, const Node& more) {
  std::uint64_t result = 0;
  if (__builtin_add_overflow(sum, more.count(), &result)) more.fail("a count that does not overflow the sum");
  return result;
}

/// Counts add, at any depth; all else must be equal.
void add_value(Json& sum, const Node& more) {
  if (sum.is_number_unsigned()) {
    sum = added(sum.get<std::uint64_t>(), more);
  } else if (sum.is_object() && more.json().is_object() && sum.size() == more.json().size()) {
    for (auto& [key, value] : sum.items()) add_value(value, more.at(key.c_str()));
  } else if (sum != more.json()) {
    more.fail("the same as in the other files (" + sum.dump() + ")");
  }
}

void add_rate(Json& sum, const Node& more) {
  const std::uint64_t hits = added(sum["hits"].get<std::uint64_t>(), more.at("hits"));
  const std::uint64_t of = added(sum["of"].get<std::uint64_t>(), more.at("of"));
  const fuzz::Rate rate = fuzz::rate_of(hits, of);
  sum["value"] = rate.value;
  sum["low95"] = rate.low95;
  sum["high95"] = rate.high95;
  sum["hits"] = hits;
  sum["of"] = of;
}

/// |p/q| of a gap.
mpq_class size_of(const Node& gap) {
  const Node text = gap.at("rational");
  mpq_class value;
  if (value.set_str(text.text(), 10) != 0 || value.get_den() == 0) text.fail("a rational p/q");
  value.canonicalize();
  return abs(value);
}

TrialPlace place_of(const Node& node, const char* trial) {
  return {node.has("seed") ? node.at("seed").count() : 0, node.at(trial).count()};
}

void keep_larger_gap(Json& kept, const Node& other) {
  if (other.json().is_null()) return;
  if (!kept.is_null()) {
    const Node known(kept, "the files before", "worst_gap");
    const int order = cmp(size_of(other), size_of(known));
    if (order < 0 || (order == 0 && place_of(other, "trial") > place_of(known, "trial"))) return;
  }
  kept = other.json();
}

/// Faults in the order of one run's witnesses; unknown ones last.
std::size_t fault_order(const std::string& question, const std::string& verdict) {
  const fuzz::QuestionWords* const words = fuzz::find_question(question);
  std::size_t fault = words != nullptr ? 0 : fuzz::kFaults;
  while (fault < fuzz::kFaults && words->fault_names[fault] != verdict) ++fault;
  return fault;
}

/// What was measured in different places, as a list of the different values.
void add_words(Json& words, const std::string& more) {
  const std::string separator = "; ";
  std::set<std::string> all;
  for (std::string rest : {words.get<std::string>(), more}) {
    for (std::size_t cut = 0; (cut = rest.find(separator)) != std::string::npos;
         rest.erase(0, cut + separator.size())) {
      all.insert(rest.substr(0, cut));
    }
    all.insert(rest);
  }
  std::string joined;
  for (const std::string& word : all) joined += (joined.empty() ? "" : separator) + word;
  words = joined;
}

using Trials = std::map<std::string, double>;  ///< by row

Trials trials_of(const Node& top) {
  Trials trials;
  for (const Node& row : top.at("rows").list())
    trials[row_key(row)] = static_cast<double>(row.at("trials").count());
  return trials;
}

/// The mean of each number of `timings`, weighted by trials.
void add_timings(Json& sum, Trials& weights, const Node& timings, const Trials& trials) {
  for (const Node& timing : timings.list()) {
    const std::string key = row_key(timing);
    const auto row = trials.find(key);
    if (row == trials.end()) timing.fail("the timing of a row");
    const auto known = std::find_if(sum.begin(), sum.end(), [&](const Json& other) {
      return row_key(Node(other, "the files before", "ns_per_case")) == key;
    });
    if (known == sum.end()) {
      sum.push_back(timing.json());
      weights[key] = row->second;
      continue;
    }
    double& weight = weights[key];
    const double total = weight + row->second;
    for (auto& [name, value] : known->items()) {
      if (!value.is_number() || total == 0) continue;
      value = (value.get<double>() * weight + timing.at(name.c_str()).number() * row->second) / total;
    }
    weight = total;
  }
}

}  // namespace

std::string row_key(const Node& node) {
  return node.at("question").text() + " " + node.at("method").text() + " " + node.at("distribution").text() +
         " " + node.at("scalar").text();
}

void check_row(const Node& row) {
  for (const auto& [key, value] : row.fields()) {
    if (!key.ends_with("_rate")) continue;
    if (value.at("hits").count() > value.at("of").count()) value.fail("at most as many hits as cases");
  }
  (void)row.at("promise_broken").flag();
  if (row.has("worst_gap")) {
    const Node gap = row.at("worst_gap");
    (void)size_of(gap);
    (void)place_of(gap, "trial");
  }
}

void add_row(Json& sum, const Node& more) {
  for (auto& [key, value] : sum.items()) {
    const Node other = more.at(key.c_str());
    if (key == "witnesses") continue;
    if (key == "worst_gap") {
      keep_larger_gap(value, other);
    } else if (key == "promise_broken") {
      value = value.get<bool>() || other.flag();
    } else if (key.ends_with("_rate")) {
      add_rate(value, other);
    } else {
      add_value(value, other);
    }
  }
  if (sum.size() != more.json().size()) more.fail("a row with the fields of the other files' rows");
}

void keep_witnesses(Json& result, std::vector<Node> all, std::uint64_t keep) {
  std::map<std::string, std::size_t> row_of;
  for (std::size_t i = 0; i < result["rows"].size(); ++i) {
    Json& row = result["rows"][i];
    row_of[row_key(Node(row, "the files before", "rows"))] = i;
    row["witnesses"] = Json::array();
  }
  // By row and fault, in which order one run lists them.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Node>> groups;
  for (const Node& witness : all) {
    const auto row = row_of.find(row_key(witness));
    if (row == row_of.end()) witness.fail("a witness of a row");
    groups[{row->second, fault_order(witness.at("question").text(), witness.at("verdict").text())}].push_back(
        witness);
  }
  result["witnesses"] = Json::array();
  for (auto& [where, group] : groups) {
    std::sort(group.begin(), group.end(),
              [](const Node& a, const Node& b) { return place_of(a, "index") < place_of(b, "index"); });
    for (std::size_t i = 0; i < group.size() && i < keep; ++i) {
      result["rows"][where.first]["witnesses"].push_back(group[i].at("name").text());
      result["witnesses"].push_back(group[i].json());
    }
  }
}

Json merged_measurements(const std::vector<Node>& files) {
  Json result = Json::object();
  Trials weights;
  for (const Node& file : files) {
    if (!file.has("measured")) continue;
    for (const auto& [key, value] : file.at("measured").fields()) {
      if (key == "ns_per_case") {
        if (!result.contains(key)) result[key] = Json::array();
        add_timings(result[key], weights, value, trials_of(file));
      } else if (!result.contains(key)) {
        result[key] = value.json();
      } else if (key == "environment") {
        for (const auto& [name, text] : value.fields()) {
          if (!result[key].contains(name)) result[key][name] = text.text();
          add_words(result[key][name], text.text());
        }
      } else if (result[key].is_number()) {
        result[key] = result[key].get<double>() + value.number();
      }
    }
  }
  return result;
}

}  // namespace gnomon::reports
