// SPDX-License-Identifier: GPL-3.0-or-later
// Rows pooled: what the report says of a method on one distribution or on all of them.
#pragma once

#include <span>

#include "reports/result_set.h"

namespace gnomon::reports {

/// k errors of n chances with the 95 % interval of the rate. n == 0: nothing was asked, the rate means
/// nothing.
struct Share {
  std::uint64_t k = 0, n = 0;
  Rate rate;
};

/// k of n with the two-sided Clopper-Pearson 95 % interval: [0, 1] for n = 0. Throws std::domain_error for k
/// > n.
[[nodiscard]] Share share_of(std::uint64_t k, std::uint64_t n);

/// A method's counts over one or more rows of the same question, method and scalar.
struct Summary {
  std::string question, method, promise, tier, scalar;
  std::string label;         ///< the method, with the scalar when group() found the method with several
  std::string distribution;  ///< empty when rows of several distributions are pooled
  std::uint64_t trials = 0, unsound = 0, waste = 0, undecided = 0, rejected = 0;
  std::uint64_t rounding = 0, model = 0, rounding_and_model = 0;
  Matrix matrix;
  Share culls;    ///< said "outside" of what is not outside; for other questions: every unsound answer
  Share insides;  ///< said "inside" of what is not inside; n = 0 for questions without that answer
  Share wasted;   ///< kept though exactly outside; for other questions: every wasteful answer
  bool about_pairs = false;      ///< of a scene: no exact twin is known, and no boundary is touched
  std::uint64_t wasteful = 0;    ///< of a question about pairs: cases where waste is possible
  std::uint64_t deceivable = 0;  ///< and those where unsound answers are
  bool promise_broken = false;
  /// True when an unsound answer was seen.
  [[nodiscard]] bool lies() const { return culls.k > 0 || insides.k > 0 || unsound > 0; }

  std::optional<double> ns, reference_ns;  ///< medians over the rows that were timed
};

/// One row as a summary; its rates are the file's own.
[[nodiscard]] Summary summarise(const ResultRow& row);

/// Several rows (at least one) as one; rates are counted anew from the matrices.
[[nodiscard]] Summary pool(std::span<const ResultRow* const> rows);

/// The rows of all files grouped as `key` orders them: by question, then tier (trivial, naive, certified,
/// exact, others), then method and scalar. `by_distribution` keeps distributions apart, too.
enum class Grouping { kMethod, kMethodAndDistribution };
[[nodiscard]] std::vector<Summary> group(std::span<const ResultFile> files, Grouping grouping);

/// Answers in the order in which people think of them: outside, overlap, inside, then others by name.
[[nodiscard]] std::vector<std::string> answers_of(const Matrix& matrix);

}  // namespace gnomon::reports
