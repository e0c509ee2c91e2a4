// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/campaign_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fuzz/generator.h"
#include "fuzz/shaft_questions.h"
#include "fuzz/statistics.h"
#include "fuzz/volume_questions.h"
#include "reports/environment.h"
#include "reports/pair_methods_text.h"
#include "reports/scene_methods_text.h"
#include "scene/builtin.h"

namespace gnomon::reports {

namespace {

using fuzz::Fault;
using fuzz::RowResult;
using fuzz::Verdict;

/// A rate for people: "0.31 %", or for no hits the bound, "<3.7e-06".
std::string rate_text(std::uint64_t hits, std::uint64_t of) {
  if (of == 0) return "-";
  const fuzz::Rate rate = fuzz::rate_of(hits, of);
  if (hits == 0) return fmt::format("<{:.1e}", rate.high95);
  return fmt::format("{:.1e}", rate.value);
}

std::string shaft_header(const RowResult& row) {
  const double n = static_cast<double>(std::max<std::uint64_t>(row.trials, 1));
  const auto share = [n](std::uint64_t count) { return 100 * static_cast<double>(count) / n; };
  return fmt::format(
      "\n{} {} {}: {} trials, exactly {:.1f} % outside, {:.1f} % overlap, {:.1f} % inside; touching {:.1f} % "
      "outside, "
      "{:.1f} % inside\n  {:<20}{:>12}{:>12}{:>10}{:>12}{:>10}{:>10}{:>10}{:>9}{:>9}\n",
      row.question, row.distribution, row.scalar, row.trials, share(row.truths(0)), share(row.truths(1)),
      share(row.truths(2)), share(row.touching_outside), share(row.touching_inside), "method", "false culls",
      "false ins.", "waste", "cull rate", "waste rt.", "rounding", "model", "worst", "ns/case");
}

std::string shaft_row(const RowResult& row) {
  const std::uint64_t outside = row.truths(0), meeting = row.truths(1) + row.truths(2);
  // What is rounding and what model is told by a method's exact twin, and a plug-in has none that is known.
  const auto source = [&row](std::uint64_t count) {
    return row.tier == "plug-in" ? std::string("-") : std::to_string(count);
  };
  std::string text =
      fmt::format("  {:<20}{:>12}{:>12}{:>10}{:>12}{:>10}{:>10}{:>10}{:>9}{:>9.1f}", row.method,
                  row.count(Fault::false_cull), row.count(Fault::false_inside), row.count(Verdict::waste),
                  rate_text(row.count(Fault::false_cull), meeting),
                  rate_text(row.matrix[0][1] + row.matrix[0][2], outside), source(row.rounding),
                  source(row.model + row.rounding_and_model),
                  row.worst ? fmt::format("{:.1e}", std::abs(row.worst->length)) : "", row.ns_per_case);
  return text;
}

/// What the cases are exactly.
std::string pair_header(const RowResult& row) {
  const fuzz::QuestionWords& words = row.words();
  const double n = static_cast<double>(std::max<std::uint64_t>(row.trials, 1));
  std::string text =
      fmt::format("\n{} {} {}: {} trials, exactly", row.question, row.distribution, row.scalar, row.trials);
  for (std::size_t truth = 0; truth < words.truth_count(); ++truth) {
    text += fmt::format("{} {:.1f} % {}", truth == 0 ? "" : ",",
                        100 * static_cast<double>(row.truths(truth)) / n, words.truths[truth]);
  }
  if (words.lists_faces) {
    text += fmt::format("; {:.1f} faces a list", static_cast<double>(row.faces.in_truth) / n);
  }
  if (!row.independent) text += "; queries of one scene, not independent as the intervals take them";
  text += fmt::format("\n  {:<32}", "method");
  if (words.lists_faces) {
    text += fmt::format("{:>10}{:>10}{:>12}{:>10}{:>12}{:>13}{:>13}", "missing", "more", "miss. rate",
                        "more rt.", "faces", "faces miss.", "faces exc.");
  } else {
    text += fmt::format("{:>11}{:>12}{:>12}{:>12}{:>12}{:>10}", "false all", "false none", "unsound rt.",
                        "missed all", "missed none", "waste rt.");
  }
  return text + fmt::format("{:>11}\n", "ns/case");
}

std::string pair_row(const RowResult& row) {
  const fuzz::PairChances chances = fuzz::chances_of(row);
  const std::uint64_t unsound = row.count(Verdict::unsound), waste = row.count(Verdict::waste);
  std::string text = fmt::format("  {:<32}", row.method);
  if (row.words().lists_faces) {
    const double n = static_cast<double>(std::max<std::uint64_t>(row.trials, 1));
    text += fmt::format("{:>10}{:>10}{:>12}{:>10}{:>12.1f}{:>13}{:>13}", unsound, waste,
                        rate_text(unsound, chances.unsound), rate_text(waste, chances.waste),
                        static_cast<double>(row.faces.listed) / n, row.faces.missing, row.faces.excess);
  } else {
    text += fmt::format("{:>11}{:>12}{:>12}{:>12}{:>12}{:>10}", row.count_fault(0), row.count_fault(1),
                        rate_text(unsound, chances.unsound), row.count_fault(3), row.count_fault(2),
                        rate_text(waste, chances.waste));
  }
  return text + fmt::format("{:>11.1f}", row.ns_per_case);
}

std::string header_text(const RowResult& row) {
  return row.words().about_pairs ? pair_header(row) : shaft_header(row);
}

std::string row_text(const RowResult& row) {
  std::string text = row.words().about_pairs ? pair_row(row) : shaft_row(row);
  if (row.count(Verdict::undecided) > 0) text += fmt::format("  {} undecided", row.count(Verdict::undecided));
  if (row.count(Verdict::rejected) > 0) text += fmt::format("  {} rejected", row.count(Verdict::rejected));
  if (row.promise_broken()) text += fmt::format("  PROMISE BROKEN ({})", row.promise);
  return text + "\n";
}

template <class Q>
std::string methods_text(const fuzz::Plugins* plugins) {
  std::string text = fmt::format("{}\n", Q::id);
  for (const fuzz::Method<Q>* row : fuzz::all_methods<Q>(plugins)) {
    const fuzz::Method<Q>& method = *row;
    const char* const scalars = method.run_f32 == nullptr   ? "f64"
                                : method.run_f64 == nullptr ? "f32"
                                                            : "f32 f64";
    text += fmt::format("  {:<19} {:<11}{:<9}{:<16}{}\n", method.name, method.tier, scalars,
                        name_of(method.promise), method.summary);
  }
  return text;
}

template <class Q>
nlohmann::ordered_json methods_json(const fuzz::Plugins* plugins) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const fuzz::Method<Q>* row : fuzz::all_methods<Q>(plugins)) {
    const fuzz::Method<Q>& method = *row;
    nlohmann::ordered_json scalars = nlohmann::ordered_json::array();
    if (method.run_f32 != nullptr) scalars.push_back("f32");
    if (method.run_f64 != nullptr) scalars.push_back("f64");
    all.push_back({{"name", method.name},
                   {"tier", method.tier},
                   {"promise", name_of(method.promise)},
                   {"scalars", scalars},
                   {"domain", method.domain},
                   {"in_batches", method.in_batches},
                   {"summary", method.summary}});
  }
  return {{"id", Q::id}, {"answers", Q::answers}, {"methods", all}};
}

nlohmann::ordered_json mix_json(const fuzz::TruthMix& mix) {
  return {{"outside", mix.outside}, {"overlap", mix.overlap}, {"inside", mix.inside}};
}

}  // namespace

std::string campaign_text(const fuzz::CampaignResult& result) {
  std::string text;
  std::string last;
  for (const RowResult& row : result.rows) {
    const std::string key = row.distribution + row.scalar;
    if (key != last) text += header_text(row);
    last = key;
    text += row_text(row);
  }
  text += fmt::format(
      "\n{} trials in {:.1f} s ({:.1f} s of processor time): {:.2f} M exactly verified trials a second and "
      "core\n",
      result.trials, result.seconds, result.core_seconds,
      static_cast<double>(result.trials) / std::max(result.core_seconds, 1e-9) * 1e-6);
  return text;
}

std::string list_text(const fuzz::Plugins* plugins) {
  std::string text = "Questions and methods (name, tier, scalars, promise, what it is):\n\n";
  text +=
      methods_text<fuzz::ShaftBoxQuestion>(plugins) + "\n" + methods_text<fuzz::ShaftBallQuestion>(plugins) +
      "\n" + methods_text<fuzz::ShaftSlabsQuestion>(plugins) + "\n" +
      methods_text<fuzz::ShaftOrientedBoxQuestion>(plugins) + "\n" +
      methods_text<fuzz::ShaftEllipsoidQuestion>(plugins) + "\n" + pair_methods_text() + scene_methods_text();
  text +=
      "\nDistributions (NAME or NAME:ARG, @K for K cases a shaft; at least these shares "
      "outside/overlap/inside, of "
      "boxes and of balls):\n\n";
  for (const fuzz::Distribution& distribution : fuzz::distributions()) {
    const fuzz::TruthMix& box = distribution.least_mix;
    const fuzz::TruthMix& ball = distribution.least_mix_sphere;
    text += fmt::format("  {:<16}{}\n  {:<16}{:g}/{:g}/{:g} %, {:g}/{:g}/{:g} %{}\n", distribution.name,
                        distribution.description, "", 100 * box.outside, 100 * box.overlap, 100 * box.inside,
                        100 * ball.outside, 100 * ball.overlap, 100 * ball.inside,
                        distribution.argument.empty() ? "" : fmt::format("; ARG: {}", distribution.argument));
  }
  text += pair_distributions_text();
  text += "\nScene files (gnomon scene): .nff, .off, .obj, .ply, .stl\n";
  text +=
      "\nBuilt-in scenes (NAME or NAME:SIZE; faces at the size that NAME alone has, what SIZE counts):\n\n";
  for (const scene::BuiltinScene& scene : scene::builtin_scenes()) {
    text += fmt::format("  {:<16}{}\n  {:<16}{} faces at size {}, at most {}: {}\n  {:<16}stands for: {}\n",
                        scene.name, scene.summary, "", scene.faces(scene.default_size), scene.default_size,
                        scene.largest_size, scene.size_means, "", scene.stands_for);
  }
  text += fmt::format("\nNot built in: {}\n", fmt::join(not_built_in(), ", "));
  return text;
}

std::string list_json(const fuzz::Plugins* plugins) {
  nlohmann::ordered_json json;
  json["tool"] = version();
  json["questions"] = {methods_json<fuzz::ShaftBoxQuestion>(plugins),
                       methods_json<fuzz::ShaftBallQuestion>(plugins),
                       methods_json<fuzz::ShaftSlabsQuestion>(plugins),
                       methods_json<fuzz::ShaftOrientedBoxQuestion>(plugins),
                       methods_json<fuzz::ShaftEllipsoidQuestion>(plugins),
                       candidate_question_json(),
                       patch_question_json(),
                       shadow_question_json(),
                       first_hit_question_json()};
  json["distributions"] = nlohmann::ordered_json::array();
  for (const fuzz::Distribution& distribution : fuzz::distributions()) {
    json["distributions"].push_back({{"name", distribution.name},
                                     {"argument", distribution.argument},
                                     {"description", distribution.description},
                                     {"in_every_domain", distribution.in_every_domain},
                                     {"shares_shafts", distribution.shares_shafts},
                                     {"least_mix", mix_json(distribution.least_mix)},
                                     {"least_mix_sphere", mix_json(distribution.least_mix_sphere)}});
  }
  json["pair_distributions"] = pair_distributions_json();
  json["scene_files"] = {".nff", ".off", ".obj", ".ply", ".stl"};
  json["scenes"] = nlohmann::ordered_json::array();
  for (const scene::BuiltinScene& scene : scene::builtin_scenes()) {
    json["scenes"].push_back({{"name", scene.name},
                              {"summary", scene.summary},
                              {"stands_for", scene.stands_for},
                              {"size_means", scene.size_means},
                              {"default_size", scene.default_size},
                              {"largest_size", scene.largest_size},
                              {"faces", scene.faces(scene.default_size)}});
  }
  json["not_built_in"] = not_built_in();
  return json.dump(1) + "\n";
}

}  // namespace gnomon::reports
