// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_source.h"

#include <filesystem>
#include <stdexcept>

#include "fuzz/generator.h"
#include "fuzz/pair_drafts.h"
#include "fuzz/scene_pairs.h"
#include "scene/find_scene.h"
#include "scene/input_error.h"
#include "scene/single.h"

namespace gnomon::fuzz {

namespace {

constexpr std::string_view kScene = "scene", kCoplanar = "coplanar";

template <class Query>
constexpr bool kAsksPatches = std::is_same_v<Query, scene::PatchPair>;

template <class Query>
class SceneSource final : public PairSource<Query> {
 public:
  explicit SceneSource(scene::Scene scene) : scene_(std::move(scene)), pairs_(scene_) {}

  [[nodiscard]] const scene::Scene* scene_of_all() const override { return &scene_; }
  void make(const TrialId& id, PairCase<Query>& c) const override {
    CaseRandom random(id.seed, id.stream, id.trial);
    if constexpr (kAsksPatches<Query>) {
      c.query = pairs_.patches(random);
    } else {
      c.query = pairs_.boxes(random);
    }
  }

 private:
  scene::Scene scene_;
  ScenePairs pairs_;
};

template <class Query>
std::unique_ptr<PairSource<Query>> make_scene_source(const std::string& word) {
  const scene::Scene given = scene::find_scene(word).loaded.scene;
  const auto refuse = [&](const std::string& line) { throw scene::InputError(word, 0, line); };
  const std::size_t triangles = given.triangles.size(), faces = given.face_count();
  if (kAsksPatches<Query> && triangles < 2)
    refuse("expected a scene with two triangles to pick patches from, found " + std::to_string(triangles));
  if (faces < 2) refuse("expected a scene with two faces, found " + std::to_string(faces));
  try {
    return std::make_unique<SceneSource<Query>>(scene::rounded_to_floats(given).scene);
  } catch (const std::runtime_error& error) {
    refuse(error.what());
    throw;
  }
}

}  // namespace

const std::vector<PairDistribution>& pair_distributions() {
  static const std::vector<PairDistribution> all{
      {"uniform", "", "small scenes about a shaft in the unit cube", {0.1, 0.3}, {0.1, 0.05, 0.1}},
      {"offset",
       "the distance, 1 to 1e30",
       "uniform, 16 times as large, moved 1e3, 1e5 or 1e7 away on each axis",
       {0.1, 0.3},
       {0.1, 0.05, 0.1}},
      {"integer-grid",
       "the number of grid lines, 2 to 1048576",
       "all coordinates are small integers: ties everywhere",
       {0.1, 0.3},
       {0.1, 0.02, 0.1}},
      {"near-touch",
       "",
       "faces within 4 ulps of the shaft's planes, or of planes through corners of both patches",
       {0.1, 0.3},
       {0.1, 0.05, 0.1}},
      {"degenerate",
       "",
       "flat boxes, points, shared coordinates; collinear triangles, balls of radius 0",
       {0.1, 0.3},
       {0.1, 0.01, 0.1}},
      {"thin", "", "sides from 2^-20 to 1 in one scene", {0.04, 0.3}, {0.1, 0.05, 0.1}},
      {"coplanar",
       "",
       "terraces with walls under a ceiling: coplanar neighbours, exactly or but for rounding",
       {0.02, 0.3},
       {0.05, 0.05, 0.1}},
      {"mixed-magnitude",
       "",
       "coordinates of sizes 2^-30 to 2^30 side by side",
       {0.05, 0.3},
       {0.1, 0.05, 0.1}},
      {"denormal", "", "multiples of the smallest denormal", {0.1, 0.3}, {0.1, 0.05, 0.1}, false},
      {"huge", "", "coordinates up to the largest finite float", {0.05, 0.3}, {0.1, 0.05, 0.1}, false},
      {kScene,
       "a built-in scene, NAME or NAME:SIZE, or a scene file",
       "boxes and patches of one scene: far, near, adjacent, nested, coplanar, parts of polygon lights",
       {0, 0},
       {0, 0, 0},
       true,
       true},
  };
  return all;
}

bool PairChoice::shares_scene() const {
  return distribution->name == kScene;
}

std::string PairChoice::label() const {
  std::string text(distribution->name);
  if (argument.empty()) return text;
  return text + ":" + (shares_scene() ? std::filesystem::path(argument).filename().string() : argument);
}

PairChoice parse_pair_distribution(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string argument = colon == std::string::npos ? "" : text.substr(colon + 1);
  std::string known;
  for (const PairDistribution& distribution : pair_distributions()) {
    known += (known.empty() ? "" : ", ") + std::string(distribution.name);
    if (distribution.name != name) continue;
    if (distribution.argument.empty() && colon != std::string::npos) {
      throw UsageError("--distribution " + name + ": takes no argument, found \"" + argument + "\"");
    }
    if (argument.empty() && (distribution.needs_argument || colon != std::string::npos)) {
      throw UsageError("--distribution " + name + ": expected " + name + ":ARG, " +
                       std::string(distribution.argument));
    }
    return {&distribution, argument};
  }
  throw UsageError("--distribution: expected one of " + known + ", found \"" + name + "\"");
}

template <class Query>
std::unique_ptr<PairSource<Query>> make_pair_source(const PairChoice& choice) {
  const std::string name(choice.distribution->name);
  if (choice.shares_scene()) return make_scene_source<Query>(choice.argument);
  const std::string style = choice.argument.empty() ? name : name + ":" + choice.argument;
  if constexpr (kAsksPatches<Query>) {
    return name == kCoplanar ? make_coplanar_patches() : make_patch_drafts(ShaftStyle::of(style));
  } else {
    return name == kCoplanar ? make_coplanar_candidates() : make_candidate_drafts(ShaftStyle::of(style));
  }
}

template std::unique_ptr<PairSource<BoxPair>> make_pair_source(const PairChoice&);
template std::unique_ptr<PairSource<scene::PatchPair>> make_pair_source(const PairChoice&);

}  // namespace gnomon::fuzz
