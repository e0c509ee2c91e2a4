// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/measure_rows.h"

#include <algorithm>
#include <string>

#include "reports/json_node.h"
#include "reports/list_json.h"

namespace gnomon::reports {
namespace {

Share share(const Node& node) {
  const Node hits = node.at("hits"), of = node.at("of");
  if (hits.count() > of.count()) hits.fail("a count of at most `of`");
  return share_of(hits.count(), of.count());
}

/// A count of queries, which can't be more than there are.
std::uint64_t count_of(const Node& node, const char* key, std::uint64_t queries) {
  const Node count = node.at(key);
  if (count.count() > queries) count.fail("a count of at most " + std::to_string(queries));
  return count.count();
}

MeasureRow row(const Node& node) {
  MeasureRow r;
  const Node question = node.at("question");
  r.question = question.text();
  const bool shadow = r.question == "shadow";
  if (!shadow && r.question != "first-hit") question.fail("\"shadow\" or \"first-hit\"");
  r.scene = node.at("scene").text();
  r.variant = node.at("variant").text();
  r.workload = node.at("workload").text();
  r.method = node.at("method").text();
  r.tier = node.at("tier").text();
  r.promise = node.at("promise").text();
  r.faces = node.at("faces").count();
  r.queries = node.at("queries").count();
  if (shadow) {
    r.false_lit = share(node.at("false_lit_rate"));
    r.false_shadowed = share(node.at("false_shadowed_rate"));
    r.wrong_reason = count_of(node, "wrong_reason", r.queries);
  } else {
    r.wrong_face = share(node.at("wrong_face_rate"));
    r.false_miss = share(node.at("false_miss_rate"));
    r.false_hit = share(node.at("false_hit_rate"));
  }
  for (const auto& [truth, answers] : node.at("matrix").fields()) {
    for (const auto& [answer, count] : answers.fields()) r.truths[truth] += count.count();
    r.touching[truth] = count_of(node.at("touching"), truth.c_str(), r.queries);
  }
  r.unsound = count_of(node, "unsound", r.queries);
  r.unsound_touching = count_of(node.at("touching"), "unsound", r.unsound);
  r.undecided = count_of(node, "undecided", r.queries);
  r.rejected = count_of(node, "rejected", r.queries);
  r.changed_by_order = count_of(node, "changed_by_order", r.queries);
  r.promise_broken = node.at("promise_broken").flag();
  if (node.has("tests_per_query")) {
    const Node tests = node.at("tests_per_query");
    r.boxes = tests.at("boxes").number();
    r.face_tests = tests.at("faces").number();
    r.exact = tests.at("exact").number();
  }
  if (node.has("pairs")) {
    const Node pairs = node.at("pairs");
    const std::uint64_t n = pairs.at("pairs").count();
    r.pairs = PairShares{n, count_of(pairs, "all", n), count_of(pairs, "none", n),
                         pairs.at("faces_per_pair").number()};
  }
  return r;
}

TimeSpread spread(const Node& ns) {
  const TimeSpread s{ns.at("median").number(), ns.at("low25").number(), ns.at("high75").number()};
  if (!(0 <= s.low25 && s.low25 <= s.median && s.median <= s.high75)) {
    ns.fail("0 <= low25 <= median <= high75");
  }
  return s;
}

}  // namespace

std::vector<MeasureRow> read_measure_rows(const Node& top) {
  std::vector<MeasureRow> rows;
  for (const Node& node : top.at("rows").list()) rows.push_back(row(node));
  if (!top.has("measured")) return rows;
  const Node measured = top.at("measured");
  // Read once each: there are as many as rows, or twice as many.
  const auto those_of = [](const Node& node) {
    return [scene = node.at("scene").text(), variant = node.at("variant").text(),
            method = node.at("method").text()](const MeasureRow& r) {
      return r.method == method && r.variant == variant && r.scene == scene;
    };
  };
  for (const Node& time : measured.at("ns_per_query").list()) {
    const TimeSpread ns = spread(time.at("ns"));
    const auto is_of = those_of(time);
    const std::string question = time.at("question").text(), workload = time.at("workload").text();
    const Node order = time.at("order");
    std::optional<TimeSpread> MeasureRow::*const which = order.text() == "image"      ? &MeasureRow::image
                                                         : order.text() == "shuffled" ? &MeasureRow::shuffled
                                                         : order.text() == "listed"   ? &MeasureRow::listed
                                                                                      : nullptr;
    if (which == nullptr) order.fail("\"image\", \"shuffled\" or \"listed\"");
    for (MeasureRow& r : rows) {
      if (!is_of(r) || r.workload != workload || r.question != question) continue;
      r.*which = ns;
    }
  }
  for (const Node& set_up : measured.at("set_ups").list()) {
    const Node seconds = set_up.at("seconds");
    if (seconds.number() < 0) seconds.fail("a time, 0 or more");
    const std::uint64_t bytes = set_up.at("bytes").count();
    const auto is_of = those_of(set_up);
    for (MeasureRow& r : rows) {
      if (!is_of(r)) continue;
      r.set_up_seconds = seconds.number();
      r.bytes = bytes;
    }
  }
  return rows;
}

std::vector<MeasureFile> read_measure_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json" && !entry.is_directory()) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<MeasureFile> files;
  for (const std::filesystem::path& path : paths) {
    const Json json = read_json(path);
    const Node top(json, path);
    if (kind_of_result(top) == "measure") files.push_back({path, read_measure_rows(top), read_lists(top)});
  }
  return files;
}

}  // namespace gnomon::reports
