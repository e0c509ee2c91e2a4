// SPDX-License-Identifier: GPL-3.0-or-later
// Case generators: one for each distribution, scalar and kind of case.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/random.h"
#include "scene/scalar.h"
#include "scene/shaft_case.h"

namespace gnomon::fuzz {

/// Makes the cases of one distribution. Immutable after construction, so that threads may share it.
template <class Case>
class Generator {
 public:
  Generator() = default;
  Generator(const Generator&) = delete;
  Generator& operator=(const Generator&) = delete;
  virtual ~Generator() = default;
  /// A valid case; every number is one of the generator's scalar.
  [[nodiscard]] virtual Case make(CaseRandom& random) const = 0;
};

/// The least shares of truths that a distribution states for shaft-box; measured shares are in every report
/// and a test holds them against these.
struct TruthMix {
  double outside, overlap, inside;
};

/// One row of the table of distributions. `NAME` or `NAME:ARG` on the command line; with `@K`, each shaft is
/// asked about K boxes or balls, so that trials are no longer independent (intervals take them as if).
struct Distribution {
  std::string_view name;
  std::string_view argument;     ///< what ARG is, empty when there is none
  std::string_view description;  ///< one line
  TruthMix least_mix;            ///< of shaft-box
  TruthMix least_mix_sphere;     ///< of shaft-sphere
  bool in_every_domain;  ///< false: methods may reject its cases or waste without bound (over-, underflow)
  bool needs_argument;
  bool shares_shafts = true;  ///< false: a and b depend on t, so that `@K` makes no sense
};

/// All distributions, in the order of reports.
[[nodiscard]] const std::vector<Distribution>& distributions();

/// A distribution with its argument, as the command line names it.
struct DistributionChoice {
  const Distribution* distribution;
  std::string argument;
  std::uint64_t per_shaft = 1;  ///< so many consecutive trials share their shaft: `@K`

  /// "name", "name:argument", each with "@K" where shafts are shared; of a file argument the name without
  /// folders, so that results do not depend on where a file lies.
  [[nodiscard]] std::string label() const;
};

/// Bad usage: what was asked for does not exist. The message is one line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Parses "NAME", "NAME:ARG", "NAME@K" or "NAME:ARG@K". Throws UsageError naming the known ones.
[[nodiscard]] DistributionChoice parse_distribution(const std::string& text);

/// Throws UsageError for a bad argument, scene::InputError for a bad mesh file.
template <class Case>
[[nodiscard]] std::unique_ptr<Generator<Case>> make_generator(const DistributionChoice& choice,
                                                              scene::Scalar scalar);

}  // namespace gnomon::fuzz
