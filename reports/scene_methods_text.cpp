// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/scene_methods_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fuzz/first_hit_row.h"
#include "fuzz/scene_variant.h"
#include "fuzz/workload.h"
#include "reports/peers/peers.h"

namespace gnomon::reports {

std::string scene_methods_text() {
  std::string text = "shadow (gnomon measure, gnomon render) and first-hit (gnomon measure)\n";
  for (const fuzz::SceneMethod& method : all_scene_methods()) {
    text += fmt::format("  {:<19} {:<11}{:<9}{:<16}{}\n", method.name, method.tier, "f32",
                        name_of(method.promise), method.summary);
  }
  text += "\nshadow, workloads of radiosity alone (gnomon measure)\n";
  for (const fuzz::SceneMethod& method : all_radiosity_methods()) {
    text += fmt::format("  {:<22} {:<11}{:<9}{:<16}{}\n", method.name, method.tier, "f32",
                        name_of(method.promise), method.summary);
  }
  text += "\nWorkloads of shadow:\n\n";
  for (const fuzz::WorkloadKind& kind : fuzz::workload_kinds()) {
    text += fmt::format("  {:<16}{}\n", kind.name, kind.description);
  }
  text += "\nWorkloads of first-hit:\n\n";
  for (const fuzz::WorkloadKind& kind : fuzz::ray_workload_kinds()) {
    text += fmt::format("  {:<16}{}\n", kind.name, kind.description);
  }
  text += "\nVariants of scenes:\n\n";
  for (const fuzz::SceneVariant& variant : fuzz::scene_variants()) {
    text += fmt::format("  {:<16}{}\n", variant.name, variant.description);
  }
  return text;
}

namespace {

nlohmann::ordered_json methods_json(std::span<const fuzz::SceneMethod> rows) {
  auto methods = nlohmann::ordered_json::array();
  for (const fuzz::SceneMethod& method : rows) {
    methods.push_back({{"name", method.name},
                       {"tier", method.tier},
                       {"promise", name_of(method.promise)},
                       {"scalars", {"f32"}},
                       {"domain", method.domain},
                       {"in_batches", method.by_pairs},
                       {"balls", method.has_balls},
                       {"summary", method.summary}});
  }
  return methods;
}

nlohmann::ordered_json scene_question_json(const char* id, std::span<const std::string_view> answers,
                                           std::span<const fuzz::WorkloadKind> kinds) {
  using Json = nlohmann::ordered_json;
  Json workloads = Json::array(), variants = Json::array();
  for (const fuzz::WorkloadKind& kind : kinds) {
    workloads.push_back({{"name", kind.name}, {"description", kind.description}});
  }
  for (const fuzz::SceneVariant& variant : fuzz::scene_variants()) {
    variants.push_back({{"name", variant.name}, {"description", variant.description}});
  }
  return {{"id", id},
          {"answers", answers},
          {"methods", methods_json(all_scene_methods())},
          {"workloads", workloads},
          {"variants", variants}};
}

}  // namespace

nlohmann::ordered_json shadow_question_json() {
  auto json = scene_question_json("shadow", fuzz::kShadowAnswers, fuzz::workload_kinds());
  json["radiosity_methods"] = methods_json(all_radiosity_methods());
  return json;
}

nlohmann::ordered_json first_hit_question_json() {
  return scene_question_json("first-hit", fuzz::kHitTruths, fuzz::ray_workload_kinds());
}

std::vector<std::string> not_built_in() {
  std::vector<std::string> missing;
  if (!has_embree()) missing.emplace_back("Embree");
  missing.insert(missing.end(), {"EGL", "MPI"});
  return missing;
}

}  // namespace gnomon::reports
