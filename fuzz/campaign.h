// SPDX-License-Identifier: GPL-3.0-or-later
// The trial loop: cases, references, methods, verdicts.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/generator.h"
#include "fuzz/method.h"
#include "fuzz/plugin_host.h"
#include "fuzz/row_result.h"

namespace gnomon::fuzz {

struct CampaignOptions {
  std::uint64_t seed = 1;
  std::uint64_t trials = 100000;  ///< of each row
  std::optional<double>
      seconds;        ///< instead of trials: for all rows together; each row gets a block at least
  unsigned jobs = 1;  ///< threads; results do not depend on it
  unsigned shard = 1, shards = 1;          ///< this run takes the shard-th of `shards` parts of the trials
  std::optional<scene::Scalar> scalar;     ///< of the cases; without it every method gets cases of its own
  std::vector<std::string> methods;        ///< empty: all; batch rows only where shafts are shared
  std::vector<std::string> distributions;  ///< empty: all that need no argument
  unsigned witnesses_per_row = 1;          ///< how many disagreements of each fault are shrunk; 0: none
  const Plugins* plugins = nullptr;        ///< whose methods are rows, too
};

/// How far a campaign is: shares of 1, for a progress line.
struct Progress {
  double done = 0;
  std::string where;
};
using OnProgress = std::function<void(const Progress&)>;
/// What is known when another distribution is done: rows so far, whole.
using OnBatch = std::function<void(const CampaignResult&)>;

/// Runs a campaign. Throws UsageError for methods or distributions that do not exist, scene::InputError for
/// mesh files that can't be read. `on_progress` is called from one thread, a few times a second; `on_batch`
/// after each distribution and scalar. A method that fails is left out from there on, and said in `failures`.
template <class Q>
[[nodiscard]] CampaignResult run_campaign(const CampaignOptions& options, const OnProgress& on_progress = {},
                                          const OnBatch& on_batch = {});

/// The methods of Q by name, all when `names` is empty. Throws UsageError naming the known ones.
template <class Q>
[[nodiscard]] std::vector<const Method<Q>*> choose_methods(const std::vector<std::string>& names,
                                                           const Plugins* plugins = nullptr);

}  // namespace gnomon::fuzz
