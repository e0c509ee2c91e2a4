// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "reports/environment.h"
#include "reports/json_node.h"
#include "reports/merge_rows.h"
#include "reports/result_reader.h"
#include "reports/shard_set.h"
#include "scene/input_error.h"

namespace gnomon::reports {

namespace {

/// One file, checked.
struct Part {
  std::filesystem::path path;
  Json json;
  std::string tool;
  std::vector<std::uint64_t> seeds;
  std::vector<std::string> commands;  ///< one a seed, without --shard
  ShardSet shards;

  [[nodiscard]] Node top() const { return {json, path}; }
  [[noreturn]] void fail(const std::string& message) const {
    throw scene::InputError(path.string(), 0, message);
  }
};

std::string major_version(const std::string& tool) {
  return tool.substr(0, tool.find('.'));
}

Part read_part(const std::filesystem::path& path) {
  Part part{path, read_json(path), {}, {}, {}, {}};
  const Node top = part.top();
  if (const std::string kind = kind_of_result(top); kind != "fuzz") {
    part.fail("expected a result of gnomon fuzz, found one of kind \"" + kind + "\"");
  }
  part.seeds = read_result_file(path).seeds;  // checks the rest too
  if (part.seeds.empty() || !std::is_sorted(part.seeds.begin(), part.seeds.end())) {
    part.fail("expected a seed, or rising seeds");
  }
  part.tool = top.at("tool").text();
  if (major_version(part.tool) != major_version(version())) {
    part.fail("expected a result of " + major_version(version()) + ".*, found one of \"" + part.tool + "\"");
  }
  const std::string shard = top.has("shard") ? top.at("shard").text() : "1/1";
  if (!ShardSet::parse(shard, part.shards)) top.at("shard").fail("shards such as \"2/3\" or \"1-2,4/5\"");
  if (top.has("commands")) {
    for (const Node& command : top.at("commands").list()) part.commands.push_back(command.text());
  } else {
    std::string command = top.at("command").text();
    if (const std::string option = " --shard " + shard; command.ends_with(option)) {
      command.resize(command.size() - option.size());
    }
    part.commands.push_back(command);
  }
  if (part.commands.size() != part.seeds.size()) part.fail("expected as many commands as seeds");
  std::set<std::string> keys;
  for (const Node& row : top.at("rows").list()) {
    check_row(row);
    if (!keys.insert(row_key(row)).second) part.fail("expected each row once, found twice: " + row_key(row));
  }
  if (top.has("witnesses_per_row")) (void)top.at("witnesses_per_row").count();
  if (keys.empty()) part.fail("expected at least one row, found none");
  return part;
}

/// The shards of one seed put together: which are there.
struct Run {
  std::uint64_t seed;
  std::string command;
  ShardSet shards;
  const Part* first;
};

/// Sorted parts come with the shards of a seed next to each other.
std::vector<Run> runs_of(const std::vector<Part>& parts) {
  std::vector<Run> runs;
  for (const Part& part : parts) {
    for (std::size_t i = 0; i < part.seeds.size(); ++i) {
      const std::uint64_t seed = part.seeds[i];
      const auto known =
          std::find_if(runs.begin(), runs.end(), [&](const Run& run) { return run.seed == seed; });
      if (known == runs.end()) {
        runs.push_back({seed, part.commands[i], part.shards, &part});
        continue;
      }
      const std::string other = known->first->path.string();
      if (known->command != part.commands[i]) {
        part.fail(fmt::format("expected a shard of the command of {} ({}) for seed {}, found \"{}\"", other,
                              known->command, seed, part.commands[i]));
      }
      if (known->shards.of() != part.shards.of()) {
        part.fail(fmt::format("expected one of {} shards as {} is, found shard {}", known->shards.of(), other,
                              part.shards.text()));
      }
      if (known->shards.overlaps(part.shards)) {
        part.fail(fmt::format(
            "expected cases that no other file has, found shard {} of seed {} again: {} is there already",
            part.shards.text(), seed, known->shards.text()));
      }
      known->shards.add(part.shards);
    }
  }
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.seed < b.seed; });
  for (const Run& run : runs) {
    if (runs.size() > 1 && !run.shards.whole()) {
      run.first->fail(
          fmt::format("expected all {} shards of seed {} to merge it with other seeds, missing: {}",
                      run.shards.of(), run.seed, run.shards.missing()));
    }
  }
  return runs;
}

/// Once several seeds meet, a trial's number alone does not name it.
void name_seed(Part& part) {
  if (part.seeds.size() > 1) return;
  for (Json& row : part.json["rows"]) {
    const auto gap = row.find("worst_gap");
    if (gap != row.end() && !gap->is_null()) (*gap)["seed"] = part.seeds.front();
  }
  if (!part.json.contains("witnesses")) return;
  for (Json& witness : part.json["witnesses"]) witness["seed"] = part.seeds.front();
}

void add_rows(Json& rows, const Part& part) {
  const std::vector<Node> more = part.top().at("rows").list();
  for (Json& row : rows) {
    const std::string key = row_key(Node(row, part.path));
    const auto same =
        std::find_if(more.begin(), more.end(), [&](const Node& other) { return row_key(other) == key; });
    if (same == more.end()) part.fail("expected the rows of the other files, found no row " + key);
    add_row(row, *same);
  }
  if (more.size() != rows.size()) {
    part.fail(fmt::format("expected the {} rows of the other files, found {}", rows.size(), more.size()));
  }
}

/// The top of the result, in the order of fields of an unsharded run.
Json header_of(const std::vector<Part>& parts, const std::vector<Run>& runs) {
  std::set<std::string> tools;
  std::string tool, command;
  std::vector<std::string> commands;
  std::vector<std::uint64_t> seeds;
  for (const Part& part : parts) tools.insert(part.tool);
  for (const std::string& name : tools) tool += (tool.empty() ? "" : "; ") + name;
  for (const Run& run : runs) {
    command += (command.empty() ? "" : " && ") + run.command;
    commands.push_back(run.command);
    seeds.push_back(run.seed);
  }
  const bool several = runs.size() > 1;
  Json result;
  for (const auto& [key, value] : parts.front().json.items()) {
    if (key == "tool") {
      result[key] = tool;
    } else if (key == "command") {
      result[key] = command;
      if (several) result["commands"] = commands;
    } else if (key == "seed" && several) {
      result["seeds"] = seeds;
    } else if (key == "shard") {
      result[key] = runs.front().shards.text();
    } else if (key != "commands") {
      result[key] = value;
    }
  }
  if (several) result["seeds"] = seeds;
  return result;
}

/// Fields at the top that this version does not know can't be added.
void check_same_settings(const Part& first, const Part& part) {
  const std::set<std::string> merged = {"tool",  "command", "commands",  "seed",    "seeds",
                                        "shard", "rows",    "witnesses", "measured"};
  for (const auto* const side : {&first, &part}) {
    for (const auto& [key, value] : side->json.items()) {
      if (merged.contains(key)) continue;
      const Node mine = part.top().at(key.c_str()), other = first.top().at(key.c_str());
      if (mine.json() != other.json()) mine.fail("the same as in " + first.path.string());
    }
  }
}

}  // namespace

MergedResult merge_results(const std::vector<std::filesystem::path>& files) {
  std::vector<Part> parts;
  for (const std::filesystem::path& file : files) parts.push_back(read_part(file));
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::pair(a.seeds.front(), a.shards.first()) < std::pair(b.seeds.front(), b.shards.first());
  });
  const std::vector<Run> runs = runs_of(parts);
  if (runs.size() > 1) std::for_each(parts.begin(), parts.end(), name_seed);

  Json result = header_of(parts, runs);
  std::vector<Node> witnesses, tops;
  for (const Part& part : parts) {
    const Node top = part.top();
    if (&part != &parts.front()) {
      check_same_settings(parts.front(), part);
      add_rows(result["rows"], part);
    }
    if (top.has("witnesses")) {
      for (const Node& witness : top.at("witnesses").list()) witnesses.push_back(witness);
    }
    tops.push_back(top);
  }
  const std::uint64_t keep =
      result.contains("witnesses_per_row") ? result["witnesses_per_row"].get<std::uint64_t>() : 1;
  keep_witnesses(result, witnesses, keep);
  if (result.contains("measured")) result["measured"] = merged_measurements(tops);

  MergedResult merged;
  std::uint64_t trials = 0;
  for (const Json& row : result["rows"]) {
    trials += row["trials"].get<std::uint64_t>();
    if (!row["promise_broken"].get<bool>()) continue;
    merged.broken.push_back(fmt::format("{} on {} {} broke its promise ({})",
                                        row["method"].get<std::string>(),
                                        row["distribution"].get<std::string>(),
                                        row["scalar"].get<std::string>(), row["promise"].get<std::string>()));
  }
  merged.json = result.dump(1) + "\n";
  merged.summary =
      fmt::format("{} file{}, {} seed{}: {} rows, {} trials", parts.size(), parts.size() == 1 ? "" : "s",
                  runs.size(), runs.size() == 1 ? "" : "s", result["rows"].size(), trials);
  if (!runs.front().shards.whole()) {
    merged.summary +=
        fmt::format("; missing of {} shards: {}", runs.front().shards.of(), runs.front().shards.missing());
  }
  return merged;
}

}  // namespace gnomon::reports
