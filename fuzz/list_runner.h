// SPDX-License-Identifier: GPL-3.0-or-later
// Casts the rays of radiosity's steps by candidate lists. Internal to fuzz/list_*.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fast/radiosity_caster.h"
#include "fuzz/list_statistics.h"
#include "fuzz/radiosity_steps.h"

namespace gnomon::fuzz {

using FloatPoint = std::array<float, 3>;

/// A pair of a step in floats.
struct ListPair {
  fast::Reference receiver, tight;  ///< by the whole patch, and by the pair's points alone
  std::vector<FloatPoint> from, to;
  const std::vector<bool>* hidden = nullptr;  ///< the truth of each ray

  [[nodiscard]] fast::PairPoints points() const { return {from, to}; }
};

struct ListStep {
  fast::Reference emitter, tight;  ///< tight: of the samples
  std::vector<ListPair> pairs;
};

/// The steps made ready; they must outlive the result.
[[nodiscard]] std::vector<ListStep> list_steps_of(const std::vector<RadiosityStep>& steps);

/// Casts the rays of steps in one way, by fast::RadiosityCaster.
class ListRunner {
 public:
  /// `convex` as in ListBuilder. Keeps references to the tree and the scene.
  ListRunner(const scene::Scene& scene, const fast::ItemTree& tree, const ListSpec& spec,
             std::span<const std::uint8_t> convex);

  /// Casts all rays with the shadow cache, counts, and keeps which rays the cache answered.
  [[nodiscard]] ListCounts count(std::span<const ListStep> steps, const fast::OnList& on_list);

  /// What count() found uncached once more, without the cache and without counting answers: processor time in
  /// nanoseconds. Without `cast` the lists are made and no ray is cast.
  [[nodiscard]] double time(std::span<const ListStep> steps, bool cast);

 private:
  void begin(const ListStep& step);
  [[nodiscard]] const fast::Reference& receiver_of(const ListPair& pair) const {
    return tight_boxes_ ? pair.tight : pair.receiver;
  }

  const bool tight_boxes_, shares_lists_;
  fast::RadiosityCaster caster_;
  std::vector<fast::ReceiverSamples> receivers_;
  std::vector<fast::RayAnswer> answers_;  // of all rays of all steps, in order
};

}  // namespace gnomon::fuzz
