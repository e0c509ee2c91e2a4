// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of questions about pairs in a scene, and the distributions that they are drawn from.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/pair_method.h"
#include "fuzz/verdict.h"

namespace gnomon::fuzz {

/// A pair and the scene it is asked about.
template <class Query>
struct PairCase {
  scene::Scene scene;
  Query query;
};

/// Names the random numbers of a trial.
struct TrialId {
  std::uint64_t seed = 0;
  std::uint32_t stream = 0;
  std::uint64_t trial = 0;
};

/// Makes the cases of one distribution, each a pure function of its TrialId; all numbers are floats.
/// Immutable after construction, so that threads may share it.
template <class Query>
class PairSource {
 public:
  PairSource() = default;
  PairSource(const PairSource&) = delete;
  PairSource& operator=(const PairSource&) = delete;
  virtual ~PairSource() = default;

  /// The scene of all trials; null when each has a scene of its own.
  [[nodiscard]] virtual const scene::Scene* scene_of_all() const { return nullptr; }
  /// Replaces the case; leaves its scene alone where all trials share one.
  virtual void make(const TrialId& id, PairCase<Query>& c) const = 0;
};

/// One row of the table. `NAME` or `NAME:ARG` on the command line.
struct PairDistribution {
  std::string_view name;
  std::string_view argument;     ///< what ARG is, empty when there is none
  std::string_view description;  ///< one line
  /// The least shares of truths, in the order of the question's words; a test holds them against measured
  /// ones. Of a scene they are whatever the scene has.
  std::array<double, kTruths> least_candidates, least_pairs;
  bool in_every_domain = true;  ///< false: methods may reject its cases
  bool needs_argument = false;
};

/// All of them, in the order of reports.
[[nodiscard]] const std::vector<PairDistribution>& pair_distributions();

/// A distribution with its argument, as the command line names it.
struct PairChoice {
  const PairDistribution* distribution;
  std::string argument;

  /// "name" or "name:argument"; of a file the name without folders.
  [[nodiscard]] std::string label() const;
  /// All trials ask about one scene, so that they are not independent.
  [[nodiscard]] bool shares_scene() const;
};

/// Parses "NAME" or "NAME:ARG". Throws UsageError naming the known ones.
[[nodiscard]] PairChoice parse_pair_distribution(const std::string& text);

/// Throws UsageError for a bad argument, and scene::InputError for a scene that can't be read or made, has
/// fewer than two faces (patch-pair: two triangles), or does not round to finite floats. Query is BoxPair or
/// scene::PatchPair.
template <class Query>
[[nodiscard]] std::unique_ptr<PairSource<Query>> make_pair_source(const PairChoice& choice);

}  // namespace gnomon::fuzz
