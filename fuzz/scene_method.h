// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the registry of questions about whole scenes: `shadow` and `first-hit`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fuzz/method.h"
#include "fuzz/radiosity.h"
#include "scene/ray_query.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::fuzz {

/// The answers of `shadow`, under their numbers as scene::Shadow has them; then kUndecided and kRejected.
inline constexpr std::array<std::string_view, 3> kShadowAnswers{"lit", "shadowed", "facing"};

/// What a method of `first-hit` says when it can't tell; kNoFace says that there is no face.
inline constexpr std::uint32_t kUndecidedFace = 0xffff'fffe;

/// What answers cost, whatever the machine: sums over the queries that were asked.
struct TestCounts {
  std::uint64_t boxes = 0;  ///< boxes of a hierarchy against segments
  std::uint64_t faces = 0;  ///< faces against segments, by the method's first arithmetic
  std::uint64_t exact = 0;  ///< of those: handed to an exact predicate
};

/// What methods that are asked pair by pair find out: sums over the pairs.
struct PairTotals {
  std::uint64_t pairs = 0;
  std::uint64_t all = 0, none = 0;  ///< pairs whose rays were all lit, all blocked, without a test of any ray
  std::uint64_t faces = 0;          ///< on the lists of candidates, of all pairs together
};

/// A method made ready for a scene. Several threads may ask it at once. All numbers of queries are floats,
/// unless the method takes doubles.
class SceneCaster {
 public:
  SceneCaster() = default;
  SceneCaster(const SceneCaster&) = delete;
  SceneCaster& operator=(const SceneCaster&) = delete;
  virtual ~SceneCaster() = default;

  /// Answers each of the queries; as many answers as queries.
  virtual void shadows(std::span<const scene::ShadowQuery> queries, std::span<Answer> answers) const = 0;
  /// A face that each ray meets first, kNoFace or kUndecidedFace.
  virtual void first_hits(std::span<const scene::RayQuery> rays, std::span<std::uint32_t> faces) const = 0;
  /// What the method keeps for the scene, the scene itself not counted.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
  /// The tests that shadows() makes for these queries; nothing when they can't be counted.
  [[nodiscard]] virtual std::optional<TestCounts> count_tests(
      std::span<const scene::ShadowQuery> /*queries*/) const {
    return std::nullopt;
  }
  /// The tests that first_hits() makes for these rays; nothing when they can't be counted.
  [[nodiscard]] virtual std::optional<TestCounts> count_hit_tests(
      std::span<const scene::RayQuery> /*rays*/) const {
    return std::nullopt;
  }
  /// Of methods that are asked pair by pair alone: answers the rays of each pair in their order, all in a
  /// row.
  virtual void pair_shadows(std::span<const RadiosityPair> /*pairs*/, std::span<Answer> /*answers*/) const {}
  /// What it finds out about these pairs; nothing from methods that aren't asked by pairs.
  [[nodiscard]] virtual std::optional<PairTotals> count_pairs(
      std::span<const RadiosityPair> /*pairs*/) const {
    return std::nullopt;
  }
};

/// A method for questions about scenes.
struct SceneMethod {
  std::string_view name;
  std::string_view tier;  ///< naive, certified, exact, reference; peer: another project's
  Promise promise;
  std::string_view domain;
  std::string_view summary;
  /// Looks at every face for every query: left out by default where that takes too long.
  bool every_face = false;
  bool has_balls = true;  ///< answers for scenes with balls
  /// Makes the structure for a scene, which must outlive it and have floats alone (scene/single.h) unless the
  /// method takes doubles. Throws std::runtime_error where it can't.
  std::unique_ptr<SceneCaster> (*make)(const scene::Scene& scene) = nullptr;
  /// Takes scenes and queries whose numbers are doubles, not floats alone.
  bool takes_doubles = false;
  /// Answers workloads of radiosity alone: either it is asked pair by pair, or its answers hold because the
  /// points of these lie on their faces or in front of them.
  bool radiosity_alone = false;
  bool by_pairs = false;  ///< asked by pair_shadows(), not by shadows()
};

/// The rows of this project, in the order of reports.
[[nodiscard]] std::span<const SceneMethod> scene_methods();

/// The further rows for workloads of radiosity.
[[nodiscard]] std::span<const SceneMethod> radiosity_methods();

}  // namespace gnomon::fuzz
