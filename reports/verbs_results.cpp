// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/verbs_results.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>

#include "reports/compare.h"
#include "reports/merge.h"
#include "scene/atomic_file.h"

namespace gnomon::reports {

namespace {

constexpr int kRegressed = 1, kBroken = 1;

struct CompareArguments {
  std::string before, after, json;
  CompareOptions options;
};

int run_compare(const CompareArguments& arguments) {
  const CompareOptions& options = arguments.options;
  if (!std::isfinite(options.tolerance) || options.tolerance < 0) {
    throw std::runtime_error("--tolerance: expected a number of at least 0, such as 0.05");
  }
  if (options.speed_limit && !(std::isfinite(*options.speed_limit) && *options.speed_limit > 0)) {
    throw std::runtime_error("--speed-limit: expected a ratio above 0, such as 1.2");
  }
  const Comparison comparison = compare_results(arguments.before, arguments.after, options);
  if (!arguments.json.empty()) scene::write_whole_file(arguments.json, comparison_json(comparison, options));
  std::cout << comparison_text(comparison, options);
  return comparison.regressed() ? kRegressed : 0;
}

int run_merge(const std::vector<std::string>& files, const std::string& out) {
  const MergedResult merged = merge_results({files.begin(), files.end()});
  scene::write_whole_file(out, merged.json);
  std::cerr << merged.summary << "\n";
  for (const std::string& row : merged.broken) std::cerr << "gnomon: " << row << "\n";
  return merged.broken.empty() ? 0 : kBroken;
}

}  // namespace

void add_result_verbs(CLI::App& app, std::function<int()>& run) {
  CLI::App* const compare =
      app.add_subcommand("compare", "Two results of one workload: errors first, then speed");
  const auto arguments = std::make_shared<CompareArguments>();
  compare->add_option("old", arguments->before, "result file of gnomon fuzz or gnomon measure")->required();
  compare->add_option("new", arguments->after, "one of the same seed, shard and cases, or scenes and queries")
      ->required();
  compare
      ->add_option("--tolerance", arguments->options.tolerance, "times per case this close are called equal")
      ->capture_default_str();
  compare->add_option(
      "--speed-limit", arguments->options.speed_limit,
      "a row that takes more than this many times its old time fails; without it speed never fails");
  compare->add_option("--json", arguments->json, "the comparison for scripts");
  compare->footer(
      "Exit status: 1 when a promise is newly broken, unsound answers are more, or a certified or exact row "
      "wastes,\n"
      "leaves open or rejects more, or the same command no longer gives a row. Cases are the same, so every\n"
      "change of a count is a change of the method. Of gnomon measure: more wrong answers of any row, and "
      "times\n"
      "beyond the quartiles of both results as well as the tolerance.\n"
      "Examples:\n"
      "  gnomon compare before/shaft-box-1.json after/shaft-box-1.json\n"
      "  gnomon compare old.json new.json --speed-limit 1.2 --json comparison.json");
  compare->final_callback([&run, arguments] { run = [arguments] { return run_compare(*arguments); }; });

  struct MergeArguments {
    std::vector<std::string> files;
    std::string out;
  };
  CLI::App* const merge =
      app.add_subcommand("merge", "The result files of shards, or of several seeds, as one");
  const auto merged = std::make_shared<MergeArguments>();
  merge
      ->add_option("files", merged->files,
                   "result files of gnomon fuzz: shards of one command, or several seeds")
      ->required();
  merge->add_option("-o,--out", merged->out, "the merged result file")->required();
  merge->footer(
      "All shards give, outside \"measured\", the bytes of the run that was not sharded. Exit status: 1 when "
      "a promise is\n"
      "broken in the merged result.\n"
      "Results of gnomon measure are refused: they have nothing to add up. `gnomon report` shows all that "
      "lie "
      "in a folder.\n"
      "Examples:\n"
      "  gnomon merge results/shaft-box-1-*of3.json -o shaft-box-1.json\n"
      "  gnomon merge seed1.json seed2.json -o both.json");
  merge->final_callback([&run, merged] { run = [merged] { return run_merge(merged->files, merged->out); }; });
}

}  // namespace gnomon::reports
