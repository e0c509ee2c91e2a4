// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/verb_measure.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "fast/fp_environment.h"
#include "fuzz/list_options_text.h"
#include "fuzz/measure_scene.h"
#include "reports/list_figures.h"
#include "reports/measure_text.h"
#include "reports/peers/peers.h"
#include "reports/progress_line.h"
#include "reports/scene_source.h"
#include "reports/whole_number.h"
#include "scene/atomic_file.h"

namespace gnomon::reports {
namespace {

constexpr int kBroken = 1;
/// What is measured where no scene is named and radiosity alone is asked: the paper's office in both its
/// meshings.
constexpr const char* kRadiosityScenes[] = {"office", "office-fine"};
/// Where no scene is named else: a room, balls, a fractal, a park; minutes in all.
constexpr const char* kDefaultScenes[] = {"living-room", "sphereflake:3", "tetra:5", "gazebo"};

struct MeasureArguments {
  std::vector<std::string> scenes, lights, methods, workloads, variants;
  std::vector<std::size_t> rays;    // a pair, of radiosity
  std::vector<std::string> shafts;  // further rows of candidate lists
  std::optional<std::size_t> checked_lists;
  std::string json;
  std::size_t queries = fuzz::WorkloadOptions{}.queries;
  std::uint64_t seed = fuzz::WorkloadOptions{}.seed;
  unsigned rounds = fuzz::MeasureOptions{}.rounds;
};

/// What is asked of one variant: `hard` and `hard-rays` are asked of all variants by default, the others of
/// the scene as given.
struct VariantRun {
  const fuzz::SceneVariant* variant;
  std::vector<std::string> workloads;
};

/// Leaves each word where it first stands: a result has each row once.
void drop_repeats(std::vector<std::string>& words) {
  std::vector<std::string> first;
  for (std::string& word : words) {
    if (std::find(first.begin(), first.end(), word) == first.end()) first.push_back(std::move(word));
  }
  words = std::move(first);
}

bool names_radiosity(const MeasureArguments& arguments) {
  return std::find(arguments.workloads.begin(), arguments.workloads.end(), "radiosity") !=
         arguments.workloads.end();
}

/// Throws unless it is a square number, as workloads of radiosity ask.
std::string radiosity_of(std::size_t rays) {
  const std::string name = "radiosity@" + std::to_string(rays);
  static_cast<void>(fuzz::pair_rays_of(name));
  return name;
}

std::vector<VariantRun> variant_runs(const MeasureArguments& arguments) {
  std::vector<std::string> workloads;
  for (const std::string& name : arguments.workloads) {
    static_cast<void>(fuzz::workload_kind(name));
    if (name != "radiosity") {
      workloads.push_back(name);
    } else {
      for (const std::size_t rays : arguments.rays) workloads.push_back(radiosity_of(rays));
    }
  }
  drop_repeats(workloads);
  if (workloads.empty()) {
    for (const auto& kinds : {fuzz::workload_kinds(), fuzz::ray_workload_kinds()}) {
      for (const fuzz::WorkloadKind& kind : kinds) workloads.emplace_back(kind.name);
    }
  }
  std::vector<VariantRun> runs;
  for (const std::string& name : arguments.variants) runs.push_back({&fuzz::scene_variant(name), workloads});
  if (!runs.empty()) return runs;
  std::vector<std::string> hard;
  for (const std::string& name : workloads) {
    if (name.starts_with("hard")) hard.push_back(name);
  }
  for (const fuzz::SceneVariant& variant : fuzz::scene_variants()) {
    if (variant.name == "given") {
      runs.push_back({&variant, workloads});
    } else if (!hard.empty()) {
      runs.push_back({&variant, hard});
    }
  }
  return runs;
}

/// The command as it can be typed again: where results go is left out.
std::string command_of(const MeasureArguments& arguments) {
  std::string text = "gnomon measure";
  for (const std::string& scene : arguments.scenes) text += " " + scene;
  for (const std::string& light : arguments.lights) text += " --light " + light;
  for (const std::string& method : arguments.methods) text += " --method " + method;
  for (const std::string& workload : arguments.workloads) text += " --workload " + workload;
  for (const std::string& shaft : arguments.shafts) text += " --shaft " + shaft;
  if (arguments.checked_lists) text += " --checked-lists " + std::to_string(*arguments.checked_lists);
  if (names_radiosity(arguments)) {
    for (const std::size_t rays : arguments.rays) text += " --rays " + std::to_string(rays);
  }
  for (const std::string& variant : arguments.variants) text += " --variant " + variant;
  text += " --queries " + std::to_string(arguments.queries) + " --seed " + std::to_string(arguments.seed);
  return text + " --rounds " + std::to_string(arguments.rounds);
}

int run_measure(MeasureArguments arguments) {
  const bool radiosity = names_radiosity(arguments);
  if (arguments.scenes.empty() && radiosity && arguments.workloads.size() == 1) {
    arguments.scenes.assign(std::begin(kRadiosityScenes), std::end(kRadiosityScenes));
  }
  if (arguments.scenes.empty()) arguments.scenes.assign(std::begin(kDefaultScenes), std::end(kDefaultScenes));
  for (const auto& [given, option] : {std::pair{!arguments.rays.empty(), "--rays"},
                                      {!arguments.shafts.empty(), "--shaft"},
                                      {arguments.checked_lists.has_value(), "--checked-lists"}}) {
    if (given && !radiosity) {
      throw std::runtime_error(std::string(option) + ": expected --workload radiosity beside it, found none");
    }
  }
  if ((!arguments.shafts.empty() || arguments.checked_lists) && !arguments.variants.empty() &&
      std::find(arguments.variants.begin(), arguments.variants.end(), "given") == arguments.variants.end()) {
    throw std::runtime_error(std::string(arguments.shafts.empty() ? "--checked-lists" : "--shaft") +
                             ": expected the variant given, whose lists are made, found " +
                             arguments.variants.front());
  }
  if (arguments.rays.empty()) arguments.rays = {16, 64, 400};
  for (auto* const words : {&arguments.scenes, &arguments.workloads, &arguments.variants}) {
    drop_repeats(*words);
  }
  fuzz::MeasureOptions options;
  options.methods = choose_measured_methods(arguments.methods);
  options.chosen = !arguments.methods.empty();
  options.rounds = arguments.rounds;
  options.workload = {arguments.queries, arguments.seed};
  options.checked_lists = arguments.checked_lists.value_or(options.checked_lists);
  std::vector<fuzz::ListSpec> shafts;
  drop_repeats(arguments.shafts);
  for (const std::string& text : arguments.shafts) {
    shafts.push_back({text, fuzz::ListStart::lists, fuzz::parse_list_setup(text)});
  }
  const std::vector<VariantRun> runs = variant_runs(arguments);
  for (const std::string& light : arguments.lights) options.lights.push_back(parse_light(light));
  if (!arguments.json.empty()) scene::require_writable(arguments.json);
  if (!fast::witness_fp_environment().is_strict()) {
    throw std::runtime_error(
        "the floating-point environment is not IEEE round-to-nearest with denormals: no result would hold");
  }
  std::vector<NamedScene> scenes;
  for (const std::string& word : arguments.scenes) scenes.push_back(load_scene(word));

  fuzz::Measurement measurement;
  {
    ProgressLine line;
    const double parts = static_cast<double>(scenes.size() * runs.size());
    double done = 0;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      for (const VariantRun& run : runs) {
        options.workloads = run.workloads;
        options.lists.reset();
        if (radiosity && run.variant->name == "given") options.lists = shafts;
        fuzz::measure_scene(
            scenes[i].name, scenes[i].scene, *run.variant, options, measurement,
            [&](double share, const std::string& where) { line.show((done + share) / parts, where); });
        ++done;
      }
      if (!arguments.json.empty()) {
        scene::write_whole_file(
            arguments.json,
            measure_json(measurement, {command_of(arguments), arguments.seed, arguments.lights,
                                       arguments.rounds, i + 1 == scenes.size()}));
      }
    }
  }
  std::vector<ListFigures> lists;
  for (const fuzz::ListRow& row : measurement.lists) lists.push_back(figures_of(row));
  std::cout << lists_text(lists) << measure_text(measurement);
  const auto say_broken = [](const auto& row) {
    if (!row.promise_broken()) return;
    std::cerr << "gnomon: " << row.method->name << " on " << row.scene << " (" << row.variant << ") "
              << row.workload << " broke its promise (" << name_of(row.method->promise) << ")\n";
  };
  for (const fuzz::ShadowRow& row : measurement.rows) say_broken(row);
  for (const fuzz::FirstHitRow& row : measurement.hit_rows) say_broken(row);
  return measurement.promise_broken() ? kBroken : 0;
}

}  // namespace

void add_measure_verb(CLI::App& app, std::function<int()>& run) {
  CLI::App* const verb =
      app.add_subcommand("measure", "Ask methods about scenes: errors, tests, time, memory");
  const auto arguments = std::make_shared<MeasureArguments>();
  const auto several = [verb](const char* name, std::vector<std::string>& words, const std::string& what) {
    verb->add_option(name, words, what)->allow_extra_args(false);
  };
  verb->add_option("scene", arguments->scenes,
                   "files (.nff, .off, .obj, .ply or .stl) or built-in scenes: NAME or NAME:SIZE; without "
                   "it living-room, sphereflake:3, tetra:5 and gazebo");
  several("--light", arguments->lights, "X,Y,Z: a point light instead of the scene's own (repeatable)");
  several("--method", arguments->methods, "a method of `gnomon list` (repeatable); all without it");
  several("--workload", arguments->workloads, "a workload (repeatable); all without it");
  verb->add_option(
          "--rays", arguments->rays,
          "rays a pair with --workload radiosity, square numbers (repeatable); 16, 64 and 400 without it")
      ->allow_extra_args(false)
      ->check(whole_number(1, 10000));
  several("--shaft", arguments->shafts,
          "NAME=VALUE,...: a further row of candidate lists with --workload radiosity (repeatable)");
  verb->add_option(
          "--checked-lists", arguments->checked_lists,
          "at most so many candidate lists a row and sampling rate are held against the exact candidates, "
          "evenly chosen; 200 without it, all with 1000000000")
      ->check(whole_number(1, 1'000'000'000));
  several("--variant", arguments->variants,
          "given, moved, scaled-up or scaled-down (repeatable); without it hard and hard-rays are asked of "
          "all, the rest of the scene as given");
  // Queries are told apart by 32 bits, and each takes some hundred bytes in all.
  verb->add_option("--queries", arguments->queries, "at most so many a workload")
      ->check(whole_number(1, 100'000'000))
      ->capture_default_str();
  verb->add_option("--rounds", arguments->rounds, "timed rounds, all methods in turn in each")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  verb->add_option("--seed", arguments->seed, "of workloads that are drawn at random")
      ->check(whole_number(0, UINT64_MAX))
      ->capture_default_str();
  verb->add_option("--json", arguments->json, "result file");
  std::string footer =
      "A scene's numbers are rounded to floats first, so that all methods and the truth see the same ones. "
      "One\n"
      "without lights gets two, one without a view gets one, from its extent. Workloads:\n";
  for (const auto& kinds : {fuzz::workload_kinds(), fuzz::ray_workload_kinds()}) {
    for (const fuzz::WorkloadKind& kind : kinds) {
      footer += "  " + std::string(kind.name) + std::string(14 - kind.name.size(), ' ') +
                std::string(kind.description) + "\n";
    }
  }
  footer +=
      "--workload radiosity asks pairs of patches with each of --rays, and holds the paper's candidate "
      "lists\n"
      "against its Table 1 on 20 steps of progressive radiosity, in scenes as given; without scenes on "
      "office\n"
      "and office-fine.\n"
      "Options of --shaft, defaults in brackets:\n";
  std::istringstream known(fuzz::known_list_options());
  for (std::string line; std::getline(known, line);) footer += "  " + line + "\n";
  footer += "Variants:\n";
  for (const fuzz::SceneVariant& variant : fuzz::scene_variants()) {
    footer += "  " + std::string(variant.name) + std::string(14 - variant.name.size(), ' ') +
              std::string(variant.description) + "\n";
  }
  verb->footer(
      footer +
      "Exit status: 1 when a method broke its promise.\n"
      "Examples:\n"
      "  gnomon measure --json default.json\n"
      "  gnomon measure office balls.nff --queries 20000 --json both.json\n"
      "  gnomon measure bunny.off --light 1,2,3 --method bvh-naive-f32 --method bvh-exact\n"
      "  gnomon measure gears.nff --workload hard --variant moved --queries 1000000\n"
      "  gnomon measure --workload radiosity --json radiosity.json\n"
      "  gnomon measure office:4 --workload radiosity --rays 256 --shaft strategy=keep-closed,tree=sah");
  verb->final_callback([&run, arguments] { run = [arguments] { return run_measure(*arguments); }; });
}

}  // namespace gnomon::reports
