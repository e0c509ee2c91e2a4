// SPDX-License-Identifier: GPL-3.0-or-later
// Casts the rays of radiosity's steps by candidate lists. Internal to fuzz/list_*.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "fast/list_builder.h"
#include "fast/list_caster.h"
#include "fuzz/list_statistics.h"
#include "fuzz/radiosity_steps.h"

namespace gnomon::fuzz {

using FloatPoint = std::array<float, 3>;

/// A pair of a step in floats.
struct ListPair {
  fast::Reference receiver, tight;  ///< by the whole patch, and by the pair's points alone
  std::vector<FloatPoint> from, to;
  const std::vector<bool>* hidden = nullptr;  ///< the truth of each ray
};

struct ListStep {
  fast::Reference emitter, tight;  ///< tight: of the samples
  std::vector<ListPair> pairs;
};

/// The steps made ready; they must outlive the result.
[[nodiscard]] std::vector<ListStep> list_steps_of(const std::vector<RadiosityStep>& steps);

/// Called with each list made, the pair's rays among which it serves, and the two reference items.
using OnList = std::function<void(const fast::CandidateList&, const fast::Reference& emitter,
                                  const fast::Reference& receiver)>;

/// One way to cast the rays of steps.
class ListRunner {
 public:
  /// `convex` as in ListBuilder. Keeps references to all but the spec.
  ListRunner(const scene::Scene& scene, const fast::ItemTree& tree, const ListSpec& spec,
             std::span<const std::uint8_t> convex);

  /// Casts all rays with the shadow cache, counts, and keeps which rays the cache did not answer.
  [[nodiscard]] ListCounts count(std::span<const ListStep> steps, const OnList& on_list);

  /// What count() found uncached once more, without the cache and without counting answers: processor time in
  /// nanoseconds. Without `cast` the lists are made and no ray is cast.
  [[nodiscard]] double time(std::span<const ListStep> steps, bool cast);

 private:
  struct SharedList {
    fast::Reference volume;
    fast::CandidateList list;
  };

  template <class Rays>
  void run(const ListStep& step, Rays& rays);
  template <class Rays>
  void run_pair(const ListStep& step, const ListPair& pair, Rays& rays);
  [[nodiscard]] const fast::CandidateList& list_for(const ListPair& pair, std::size_t first,
                                                    std::size_t last);
  [[nodiscard]] const fast::CandidateList* shared_list(const ListPair& pair);
  void count_points_below(const ListStep& step);
  void report(const fast::CandidateList& list, const fast::Reference& receiver) const;

  const fast::ItemTree& tree_;
  ListSpec spec_;
  fast::ListBuilder builder_;
  fast::ListCaster caster_;
  fast::CandidateList list_, whole_;  // of a group, and of the receiver that it is part of
  const ListPair* whole_of_ = nullptr;
  std::vector<std::uint32_t> points_below_;  // sample points of the step's receivers below each item
  std::unordered_map<std::uint32_t, std::unique_ptr<SharedList>> shared_;
  std::vector<std::uint8_t> uncached_;  // of all rays of all steps, in order
  std::uint64_t blocked_ = 0;           // so that no compiler drops a cast
  const OnList* on_list_ = nullptr;
};

}  // namespace gnomon::fuzz
