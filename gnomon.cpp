// SPDX-License-Identifier: GPL-3.0-or-later
// The command line: one executable, `gnomon VERB`. Exit status: 0 ran and every promise held; 1 a promise was
// broken, a stated answer is wrong or a comparison regressed; 2 bad usage or bad input, said in one line on
// standard error.
#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>
#include <optional>
#include <thread>

#include "fast/fp_environment.h"
#include "fuzz/campaign.h"
#include "fuzz/pair_campaign.h"
#include "fuzz/replay.h"
#include "fuzz/shaft_questions.h"
#include "fuzz/volume_questions.h"
#include "reports/campaign_files.h"
#include "reports/campaign_text.h"
#include "reports/environment.h"
#include "reports/explain.h"
#include "reports/html_report.h"
#include "reports/peers/peers.h"
#include "reports/progress_line.h"
#include "reports/replay_json.h"
#include "reports/verb_claims.h"
#include "reports/verb_measure.h"
#include "reports/verb_render.h"
#include "reports/verb_scene.h"
#include "reports/verbs_results.h"
#include "reports/whole_number.h"
#include "scene/atomic_file.h"
#include "scene/input_error.h"

namespace {

using namespace gnomon;

constexpr int kBroken = 1, kBadInput = 2;

/// --plugin LIB.so and --plugin-timeout, which several verbs take.
struct PluginArguments {
  std::vector<std::string> libraries;
  double seconds = 10;  // a thousand times what a batch of 1024 cases takes at 10 us each
  fuzz::Plugins loaded;

  void add_to(CLI::App* verb) {
    verb->add_option("--plugin", libraries, "a shared library with methods of its own (repeatable)")
        ->allow_extra_args(false);
    verb->add_option("--plugin-timeout", seconds, "seconds that a plug-in may take for 1024 cases")
        ->check(CLI::Range(0.001, 86400.0))
        ->capture_default_str();
  }
  const fuzz::Plugins* load() {
    for (const std::string& library : libraries) loaded.load(library, seconds);
    return &loaded;
  }
};

struct FuzzArguments {
  std::string question, scalar, time, shard, out, json;
  fuzz::CampaignOptions options;
  PluginArguments plugins;
};

/// "60s", "5m", "2h", or seconds.
double seconds_of(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const std::string unit(stop, end);
  const double factor = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
  if (error != std::errc{} || factor == 0 || !(value > 0) || !(value * factor < 1e9)) {
    throw fuzz::UsageError("--time: expected a duration such as 60s, 5m or 2h, found \"" + text + "\"");
  }
  return value * factor;
}

void parse_shard(const std::string& text, fuzz::CampaignOptions& options) {
  unsigned shard = 0, shards = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard);
  const bool slash = first.ec == std::errc{} && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, shards) : first;
  if (!slash || second.ec != std::errc{} || second.ptr != end || shard < 1 || shard > shards) {
    throw fuzz::UsageError("--shard: expected I/N with 1 <= I <= N, found \"" + text + "\"");
  }
  options.shard = shard;
  options.shards = shards;
}

/// The command as it can be typed again: what does not change results (jobs, output places) is left out.
std::string command_of(const FuzzArguments& arguments) {
  const fuzz::CampaignOptions& options = arguments.options;
  std::string text = "gnomon fuzz " + arguments.question;
  for (const std::string& library : arguments.plugins.libraries) text += " --plugin " + library;
  for (const std::string& name : options.methods) text += " --method " + name;
  for (const std::string& name : options.distributions) text += " --distribution " + name;
  if (!arguments.scalar.empty()) text += " --scalar " + arguments.scalar;
  text += options.seconds ? " --time " + arguments.time : " --trials " + std::to_string(options.trials);
  text += " --seed " + std::to_string(options.seed);
  if (options.witnesses_per_row != 1) text += " --witnesses " + std::to_string(options.witnesses_per_row);
  if (options.shards > 1) text += " --shard " + arguments.shard;
  return text;
}

fuzz::CampaignResult run_question(const FuzzArguments& arguments, const fuzz::OnProgress& on_progress,
                                  const fuzz::OnBatch& on_batch) {
  if (arguments.question == fuzz::ShaftBoxQuestion::id) {
    return fuzz::run_campaign<fuzz::ShaftBoxQuestion>(arguments.options, on_progress, on_batch);
  }
  if (arguments.question == fuzz::ShaftBallQuestion::id) {
    return fuzz::run_campaign<fuzz::ShaftBallQuestion>(arguments.options, on_progress, on_batch);
  }
  if (arguments.question == fuzz::CandidateQuestion::id) {
    return fuzz::run_pair_campaign<fuzz::CandidateQuestion>(arguments.options, on_progress, on_batch);
  }
  if (arguments.question == fuzz::PatchQuestion::id) {
    return fuzz::run_pair_campaign<fuzz::PatchQuestion>(arguments.options, on_progress, on_batch);
  }
  std::optional<fuzz::CampaignResult> of_volume;
  fuzz::for_volume_question(arguments.question, [&](auto question) {
    if (!arguments.plugins.libraries.empty()) {
      throw fuzz::UsageError("--plugin: " + arguments.question + " is no question that plug-ins answer");
    }
    of_volume = fuzz::run_campaign<decltype(question)>(arguments.options, on_progress, on_batch);
  });
  if (of_volume) return *std::move(of_volume);
  throw fuzz::UsageError(
      "fuzz: expected a question (shaft-box, shaft-sphere, shaft-slabs, shaft-oriented-box, shaft-ellipsoid, "
      "shaft-candidates, patch-pair), found \"" +
      arguments.question + "\"");
}

int run_fuzz(FuzzArguments& arguments) {
  fuzz::CampaignOptions& options = arguments.options;
  if (!arguments.time.empty()) options.seconds = seconds_of(arguments.time);
  if (!arguments.shard.empty()) parse_shard(arguments.shard, options);
  if (!arguments.scalar.empty()) {
    if (arguments.scalar != "f32" && arguments.scalar != "f64") {
      throw fuzz::UsageError("--scalar: expected f32 or f64, found \"" + arguments.scalar + "\"");
    }
    options.scalar = arguments.scalar == "f32" ? scene::Scalar::f32 : scene::Scalar::f64;
  }
  if (options.trials < 1 || options.jobs < 1)
    throw fuzz::UsageError("--trials and --jobs: expected at least 1, found 0");
  if (!fast::witness_fp_environment().is_strict()) {
    throw fuzz::UsageError(
        "the floating-point environment is not IEEE round-to-nearest with denormals: no result would hold");
  }
  options.plugins = arguments.plugins.load();
  reports::CampaignFiles files(arguments.out, arguments.json);
  fuzz::CampaignResult result;
  {
    reports::ProgressLine line;
    const auto keep = [&](fuzz::CampaignResult so_far) {
      so_far.command = command_of(arguments);
      files.write(so_far, arguments.question);
    };
    result = run_question(
        arguments, [&line](const fuzz::Progress& progress) { line.show(progress.done, progress.where); },
        keep);
    result.command = command_of(arguments);
    files.write(result, arguments.question);
    files.write_failures(result, arguments.question);
  }
  std::cout << reports::campaign_text(result);
  for (const fuzz::RowResult& row : result.rows) {
    if (!row.promise_broken()) continue;
    std::cerr << "gnomon: " << row.method << " on " << row.distribution << " " << row.scalar
              << " broke its promise (" << row.promise << ")\n";
    for (const fuzz::Witness& witness : row.witnesses) std::cerr << "  " << witness.case_text << "\n";
  }
  for (const fuzz::Failure& failure : result.failures) {
    std::cerr << "gnomon: " << failure.line << " (" << failure.distribution << " " << failure.scalar << ")\n";
  }
  if (!result.failures.empty()) return kBadInput;
  return result.promise_broken() ? kBroken : 0;
}

int run_replay(const std::vector<std::string>& files, const std::vector<std::string>& methods,
               const std::string& json, PluginArguments& plugins) {
  std::vector<scene::CorpusLine> corpus;
  for (const std::string& file : files) {
    std::vector<scene::CorpusLine> lines = scene::read_corpus(file);
    corpus.insert(corpus.end(), std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end()));
  }
  const fuzz::ReplayResult result =
      fuzz::replay(corpus, methods, {plugins.load(), reports::all_scene_methods()});
  if (!json.empty()) scene::write_whole_file(json, reports::replay_json(result));
  for (const fuzz::ReplayLine& line : result.lines) {
    std::cout << line.where << " " << line.method << " " << line.answer << " " << line.reference << " "
              << line.verdict << "\n";
  }
  for (const fuzz::WrongAnswer& wrong : result.wrong_answers) {
    std::cerr << wrong.where << ": states " << wrong.stated << ", exactly it is " << wrong.reference << "\n";
  }
  std::cerr << result.cases << " cases, " << result.stated << " with a stated answer, "
            << result.wrong_answers.size() << " of them wrong\n";
  for (const std::string& failure : result.failures) std::cerr << "gnomon: " << failure << "\n";
  if (!result.failures.empty()) return kBadInput;
  return result.promise_broken() || !result.wrong_answers.empty() ? kBroken : 0;
}

int run_explain(const std::string& file, const std::string& svg, PluginArguments& plugins) {
  const std::vector<scene::CorpusLine> corpus = scene::read_corpus(file);
  if (!svg.empty() && corpus.size() != 1) {
    throw scene::InputError(file, 0, "expected one case for --svg, found " + std::to_string(corpus.size()));
  }
  const fuzz::Plugins* const loaded = plugins.load();
  std::string text;  // whole or not at all: a later line may be bad
  for (const scene::CorpusLine& line : corpus) text += reports::explain(line, loaded) + "\n";
  if (!svg.empty()) scene::write_whole_file(svg, reports::explain_svg(corpus.front()));
  std::cout << text;
  return 0;
}

int run_list(bool json, PluginArguments& plugins) {
  const fuzz::Plugins* const loaded = plugins.load();
  std::cout << (json ? reports::list_json(loaded) : reports::list_text(loaded));
  return 0;
}

int run_report(const std::string& folder, const std::string& out) {
  reports::write_html_report(folder, out);
  std::cerr << "wrote " << out << "\n";
  return 0;
}

/// Says of an empty word, as an unset variable in a script makes it, what is missing: it is no absent option.
void refuse_empty_words(CLI::App& app) {
  const CLI::Validator not_empty(
      [](const std::string& text) { return text.empty() ? "expected a value, found \"\"" : std::string(); },
      "");
  for (CLI::App* verb : app.get_subcommands({})) {
    for (CLI::Option* option : verb->get_options()) {
      if (option->get_expected_max() > 0) option->check(not_empty);
    }
  }
}

/// The first word, when it is neither an option nor a verb.
std::optional<std::string> unknown_verb(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return std::nullopt;
  const std::string word = argv[1];
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_name() == word) return std::nullopt;
  }
  return word;
}

void add_fuzz(CLI::App& app, FuzzArguments& arguments, std::function<int()>& run) {
  CLI::App* verb = app.add_subcommand("fuzz", "Run a campaign: methods against the exact references");
  verb->add_option(
          "question", arguments.question,
          "shaft-box, shaft-sphere, shaft-slabs, shaft-oriented-box, shaft-ellipsoid, shaft-candidates "
          "or patch-pair")
      ->required();
  verb->add_option("--method", arguments.options.methods,
                   "a method (repeatable); all without it, batch rows only with distributions @K");
  verb->add_option(
      "--distribution", arguments.options.distributions,
      "NAME or NAME:ARG, shafts' with @K for K cases a shaft (repeatable); all that need no argument without "
      "it");
  verb->add_option("--scalar", arguments.scalar, "f32 or f64 cases for all methods; without it each its own");
  verb->add_option("--trials", arguments.options.trials,
                   "trials a row (question, method, distribution, scalar)")
      ->check(reports::whole_number(1, 1000000000000000000))
      ->capture_default_str();
  verb->add_option("--time", arguments.time, "instead of --trials: 60s, 5m, 2h for the whole campaign");
  verb->add_option("--seed", arguments.options.seed, "the same seed gives the same results")
      ->check(reports::whole_number(0, UINT64_MAX))
      ->capture_default_str();
  arguments.options.jobs = std::max(1u, std::thread::hardware_concurrency());
  verb->add_option("--jobs", arguments.options.jobs, "threads; changes no result")
      ->check(reports::whole_number(1, 1024))
      ->capture_default_str();
  verb->add_option("--shard", arguments.shard, "I/N: this run takes the I-th of N parts of the trials");
  verb->add_option("--witnesses", arguments.options.witnesses_per_row,
                   "disagreements of each kind a row that are shrunk")
      ->check(reports::whole_number(0, 1000000))
      ->capture_default_str();
  verb->add_option("--out", arguments.out, "folder for the result file and the witnesses");
  verb->add_option("--json", arguments.json, "result file");
  arguments.plugins.add_to(verb);
  verb->footer(
      "Examples:\n"
      "  gnomon fuzz shaft-box\n"
      "  gnomon fuzz shaft-box --method naive-f32 --distribution near-touch --trials 10000000 --out results\n"
      "  gnomon fuzz shaft-sphere --distribution mesh:bunny.off --time 60s --json bunny.json\n"
      "  gnomon fuzz shaft-box --distribution uniform@64   # 64 boxes a shaft: what the batch rows are for\n"
      "  gnomon fuzz shaft-box --plugin ./mine.so --distribution integer-grid --out results\n"
      "  gnomon fuzz shaft-candidates --distribution scene:office --trials 1000000 --out results\n"
      "  gnomon fuzz patch-pair --distribution coplanar --distribution scene:bunny.off");
  verb->final_callback([&] { run = [&arguments] { return run_fuzz(arguments); }; });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "gnomon: runs fast visibility-culling methods next to exact references and says how often, in which "
      "direction\n"
      "and by how much they lie."};
  app.name("gnomon");
  app.set_version_flag("--version", reports::version());
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 every promise held; 1 a promise was broken, a stated answer is wrong or a comparison\n"
      "regressed; 2 bad usage or input.\n"
      "Examples:\n"
      "  gnomon list\n"
      "  gnomon fuzz shaft-box --trials 1000000 --out results\n"
      "  gnomon explain results/witnesses/shaft-box.naive-f32.false-cull.*.txt\n"
      "  gnomon report results -o report.html\n"
      "  gnomon claims S2\n"
      "  gnomon scene balls.nff\n"
      "  gnomon measure balls.nff --json balls.json\n"
      "  gnomon render balls.nff --method bvh-naive-f32 --errors -o errors.png");

  std::function<int()> run;
  FuzzArguments fuzz_arguments;
  add_fuzz(app, fuzz_arguments, run);

  std::vector<std::string> replay_files, replay_methods;
  std::string replay_json, explain_file, explain_svg, report_folder, report_out = "report.html";
  bool list_as_json = false;
  PluginArguments plugins;  // of the verb that runs

  CLI::App* list =
      app.add_subcommand("list", "Questions, methods with their promises, distributions, built-in scenes");
  list->add_flag("--json", list_as_json, "as JSON");
  plugins.add_to(list);
  list->final_callback([&] { run = [&] { return run_list(list_as_json, plugins); }; });

  CLI::App* replay = app.add_subcommand("replay", "Run text corpora or witness files again");
  replay->add_option("files", replay_files, "text corpora or witness files")->required();
  replay->add_option("--method", replay_methods, "a method (repeatable); all without it")
      ->allow_extra_args(false);
  replay->add_option("--json", replay_json, "result file");
  plugins.add_to(replay);
  replay->footer(
      "Prints FILE:LINE method answer reference verdict for each case and method of its question: "
      "shaft-box,\n"
      "shaft-sphere or shadow, in any mixture.\n"
      "Examples:\n"
      "  gnomon replay tests/corpus/shaft.txt --method exact\n"
      "  gnomon replay tests/corpus/shadow_named.txt --json named.json");
  replay->final_callback(
      [&] { run = [&] { return run_replay(replay_files, replay_methods, replay_json, plugins); }; });

  CLI::App* explain =
      app.add_subcommand("explain", "A case in words, decimals, hex floats, exact gap, and a picture");
  explain->add_option("witness", explain_file, "a witness file or text corpus")->required();
  explain->add_option("--svg", explain_svg, "write the picture as SVG too");
  plugins.add_to(explain);
  explain->footer(
      "Shafts are drawn, shadow cases told in words alone.\n"
      "Examples:\n"
      "  gnomon explain results/witnesses/shaft-box.naive-f32.false-cull.offset.f32.1.123.txt --svg "
      "case.svg\n"
      "  gnomon explain tests/corpus/shadow_named.txt");
  explain->final_callback([&] { run = [&] { return run_explain(explain_file, explain_svg, plugins); }; });

  CLI::App* report = app.add_subcommand("report", "Result files to one self-contained HTML page");
  report->add_option("folder", report_folder, "folder with result files (*.json)")->required();
  report->add_option("-o,--out", report_out, "the page")->capture_default_str();
  report->footer("Example: gnomon report results -o report.html");
  report->final_callback([&] { run = [&] { return run_report(report_folder, report_out); }; });

  reports::add_result_verbs(app, run);
  reports::add_claims_verb(app, run);
  reports::add_scene_verb(app, run);
  reports::add_measure_verb(app, run);
  reports::add_render_verb(app, run);

  refuse_empty_words(app);
  if (const std::optional<std::string> word = unknown_verb(app, argc, argv)) {
    std::cerr << "gnomon: expected a verb, found \"" << *word << "\"; see gnomon --help\n";
    return kBadInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "gnomon: " << error.what() << "; see gnomon --help\n";
    return kBadInput;
  }
  try {
    return run();
  } catch (const std::exception& error) {
    std::cerr << "gnomon: " << error.what() << "\n";
    return kBadInput;
  }
}
