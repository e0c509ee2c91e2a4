// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/result_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "fuzz/question_words.h"
#include "reports/json_node.h"
#include "scene/input_error.h"

namespace gnomon::reports {
namespace {

std::string optional_text(const Node& node, const char* key) {
  return node.has(key) ? node.at(key).text() : "";
}

std::uint64_t optional_count(const Node& node, const char* key) {
  return node.has(key) ? node.at(key).count() : 0;
}

std::map<std::string, std::uint64_t> counts(const Node& node) {
  std::map<std::string, std::uint64_t> result;
  for (const auto& [key, value] : node.fields()) result[key] = value.count();
  return result;
}

Rate rate(const Node& node) {
  Rate r{node.at("value").number(), node.at("low95").number(), node.at("high95").number(), {}};
  if (node.has("of")) r.of = node.at("of").count();
  // A last digit may differ between the value and an interval end that were rounded apart.
  constexpr double kSlack = 1e-9;
  if (r.low95 < 0 || r.high95 > 1 + kSlack || r.low95 > r.value + kSlack || r.value > r.high95 + kSlack) {
    node.fail("0 <= low95 <= value <= high95 <= 1");
  }
  return r;
}

std::optional<GapText> gap(const Node& node, const char* key) {
  if (!node.has(key)) return std::nullopt;
  const Node g = node.at(key);
  const auto rounded = [&](const char* field) {
    return g.has(field) ? std::optional(g.at(field).number()) : std::nullopt;
  };
  return GapText{g.at("rational").text(), rounded("approx"), rounded("ulps")};
}

ResultRow row(const Node& node) {
  ResultRow r;
  r.question = node.at("question").text();
  r.method = node.at("method").text();
  r.promise = node.at("promise").text();
  r.tier = optional_text(node, "tier");
  r.distribution = node.at("distribution").text();
  r.scalar = node.at("scalar").text();
  r.trials = node.at("trials").count();
  // Questions about pairs have no exact twin and no touching cases, and rows of theirs don't tell.
  const fuzz::QuestionWords* const words = fuzz::find_question(r.question);
  r.knows_twin = words == nullptr || !words->about_pairs;
  if (r.knows_twin) r.touching = counts(node.at("touching"));
  std::uint64_t total = 0;
  for (const auto& [truth, answers] : node.at("matrix").fields()) {
    r.matrix[truth] = counts(answers);
    for (const auto& [answer, n] : r.matrix[truth]) total += n;
  }
  if (total > r.trials)
    node.at("matrix").fail(fmt::format("counts that sum to at most trials ({})", r.trials));
  r.waste = node.at("waste").count();
  r.unsound = node.at("unsound").count();
  r.false_culls = optional_count(node, "false_culls");
  r.false_insides = optional_count(node, "false_insides");
  r.unsound_touching = optional_count(node, "unsound_touching");
  r.undecided = node.at("undecided").count();
  r.rejected = node.at("rejected").count();
  if (r.knows_twin) {
    r.rounding = node.at("rounding").count();
    r.model = node.at("model").count();
    r.rounding_and_model = node.at("rounding_and_model").count();
  }
  if (r.rounding > r.trials || r.model > r.trials || r.rounding_and_model > r.trials ||
      r.rounding + r.model + r.rounding_and_model > r.trials) {
    node.fail("rounding, model and rounding_and_model that sum to at most trials");
  }
  r.waste_rate = rate(node.at("waste_rate"));
  r.unsound_rate = rate(node.at("unsound_rate"));
  if (node.has("false_inside_rate")) r.false_inside_rate = rate(node.at("false_inside_rate"));
  if (node.has("independent")) r.independent = node.at("independent").flag();
  if (node.has("faces")) r.faces = counts(node.at("faces"));
  r.worst_gap = gap(node, "worst_gap");
  r.promise_broken = node.has("promise_broken") && node.at("promise_broken").flag();
  r.threshold_exceeded = optional_count(node, "threshold_exceeded");
  return r;
}

ResultWitness witness(const Node& node) {
  return {node.at("name").text(),
          node.at("question").text(),
          node.at("method").text(),
          optional_text(node, "distribution"),
          optional_text(node, "scalar"),
          node.at("verdict").text(),
          node.at("answer").text(),
          node.at("reference").text(),
          node.at("case").text(),
          optional_text(node, "as_generated"),
          gap(node, "gap")};
}

void read_measured(const Node& measured, ResultFile& file) {
  if (measured.has("environment")) {
    for (const auto& [key, value] : measured.at("environment").fields()) {
      file.environment.emplace_back(key, value.json().is_string() ? value.text() : value.json().dump());
    }
  }
  if (file.kind != "fuzz" || !measured.has("ns_per_case")) return;
  for (const Node& timing : measured.at("ns_per_case").list()) {
    const std::string question = timing.at("question").text(), method = timing.at("method").text();
    const std::string distribution = timing.at("distribution").text(), scalar = timing.at("scalar").text();
    const Node ns = timing.at("ns");
    if (ns.number() < 0) ns.fail("a time, 0 or more");
    for (ResultRow& r : file.rows) {
      if (r.question != question || r.method != method || r.distribution != distribution ||
          r.scalar != scalar) {
        continue;
      }
      r.ns = ns.number();
      if (timing.has("reference_ns")) r.reference_ns = timing.at("reference_ns").number();
    }
  }
}

/// The plain fields of a row of a kind without a page section of its own.
std::vector<std::pair<std::string, std::string>> plain_fields(const Node& node) {
  std::vector<std::pair<std::string, std::string>> cells;
  for (const auto& [key, value] : node.fields()) {
    const Json& json = value.json();
    if (json.is_string()) cells.emplace_back(key, json.get<std::string>());
    if (json.is_number() || json.is_boolean()) cells.emplace_back(key, json.dump());
  }
  return cells;
}

std::vector<std::uint64_t> seeds_of(const Node& top) {
  if (top.has("seed")) return {top.at("seed").count()};
  std::vector<std::uint64_t> seeds;
  if (!top.has("seeds")) return seeds;
  for (const Node& seed : top.at("seeds").list()) seeds.push_back(seed.count());
  return seeds;
}

}  // namespace

ResultFile read_result_file(const std::filesystem::path& path) {
  const Json json = read_json(path);
  const Node top(json, path);
  ResultFile file;
  file.name = path.filename().string();
  file.kind = kind_of_result(top);
  file.tool = optional_text(top, "tool");
  file.command = top.at("command").text();
  file.shard = optional_text(top, "shard");
  file.seeds = seeds_of(top);
  if (file.seeds.size() == 1) file.seed = file.seeds.front();
  for (const Node& node : top.at("rows").list()) {
    if (file.kind == "fuzz") {
      file.rows.push_back(row(node));
    } else if (file.kind != "measure") {  // which has a section of its own (html_measure.h)
      file.table.push_back(plain_fields(node));
    }
  }
  if (file.kind == "fuzz" && top.has("witnesses")) {
    for (const Node& node : top.at("witnesses").list()) file.witnesses.push_back(witness(node));
  }
  if (top.has("measured")) read_measured(top.at("measured"), file);
  return file;
}

std::vector<ResultFile> read_result_folder(const std::filesystem::path& dir) {
  std::error_code error;
  std::vector<std::filesystem::path> paths;
  for (std::filesystem::directory_iterator it(dir, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".json" && !it->is_directory()) paths.push_back(it->path());
  }
  if (error)
    throw scene::InputError(dir.string(), 0, "expected a folder of result files, " + error.message());
  if (paths.empty())
    throw scene::InputError(dir.string(), 0, "expected at least one *.json result file, found none");
  std::sort(paths.begin(), paths.end());

  std::vector<ResultFile> files;
  for (const auto& path : paths) {
    ResultFile file = read_result_file(path);
    for (const ResultFile& other : files) {
      if (other.kind == file.kind && other.command == file.command && other.seed == file.seed &&
          other.shard == file.shard) {
        throw scene::InputError(
            path.string(), 0,
            fmt::format("expected another run, found the same command and seed as in {}: its "
                        "cases would count twice",
                        other.name));
      }
    }
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace gnomon::reports
