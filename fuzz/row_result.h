// SPDX-License-Identifier: GPL-3.0-or-later
// What a campaign finds out about one method on one distribution.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/gap.h"
#include "fuzz/face_sums.h"
#include "fuzz/question_words.h"
#include "fuzz/verdict.h"

namespace gnomon::fuzz {

/// The largest disagreement of a row.
struct WorstGap {
  exact::Gap value;
  double length = 0;  ///< as a length
  double ulps = 0;    ///< the length over one ulp of the case's largest coordinate, in the row's scalar
  std::uint64_t trial = 0;
};

/// A disagreement, shrunk.
struct Witness {
  std::string name;  ///< file name
  std::string question, method, distribution, scalar;
  std::string verdict;  ///< name of the fault
  std::string answer, reference;
  std::string case_text;      ///< corpus line of the shrunk case with the reference's answer
  std::string original_text;  ///< corpus line as generated
  std::uint64_t trial = 0, seed = 0;
  bool has_gap = true;  ///< false: the question has none
  exact::Gap gap;
  double gap_length = 0, gap_ulps = 0;
};

/// Counts are sums over trials, so results of shards add up.
struct RowResult {
  std::string question, method, promise, tier, distribution, scalar;
  std::uint64_t trials = 0;
  std::array<std::array<std::uint64_t, kColumns>, kTruths> matrix{};
  std::uint64_t touching_outside = 0, touching_inside = 0;
  std::uint64_t unsound_touching = 0;  ///< unsound verdicts on cases that touch a boundary
  std::uint64_t rounding = 0, model = 0, rounding_and_model = 0;
  std::uint64_t threshold_checked = 0, threshold_exceeded = 0;
  FaceSums faces;           ///< of shaft-candidates
  bool independent = true;  ///< false: all trials ask about one scene
  bool in_domain = true;    ///< the distribution lies in every method's stated domain
  std::optional<WorstGap> worst;
  std::vector<Witness> witnesses;
  double ns_per_case = 0, reference_ns_per_case = 0;

  /// Those of the row's question; a row without one is about a shaft.
  [[nodiscard]] const QuestionWords& words() const;
  [[nodiscard]] std::uint64_t truths(std::size_t truth) const;
  [[nodiscard]] std::uint64_t count(Verdict verdict) const;
  [[nodiscard]] std::uint64_t count(Fault fault) const;
  /// Of a fault by its number in the question's words.
  [[nodiscard]] std::uint64_t count_fault(std::size_t fault) const;
  /// True when the row shows that the method's promise does not hold.
  [[nodiscard]] bool promise_broken() const;
};

/// Of a question about pairs: how many cases could be wasteful, how many unsound.
struct PairChances {
  std::uint64_t waste = 0, unsound = 0;
};
/// Cases whose truth has an answer that would be so.
[[nodiscard]] PairChances chances_of(const RowResult& row);

/// A method that gave no answers: a plug-in's that crashed, hung or answered nonsense. It is asked no more.
struct Failure {
  std::string method, distribution, scalar;
  std::string line;                ///< method, what happened, on which case
  std::vector<std::string> cases;  ///< corpus lines: the one case to blame, or a batch
};

/// One campaign: everything that a result file says, timings apart.
struct CampaignResult {
  std::string command;
  std::uint64_t seed = 0;
  unsigned shard = 1, shards = 1;
  unsigned witnesses_per_row = 1;  ///< how many of each fault were asked for
  std::vector<RowResult> rows;
  std::vector<Failure> failures;
  bool complete = true;      ///< false while distributions are left to do
  std::uint64_t trials = 0;  ///< over all rows
  double seconds = 0;        ///< wall time of the trials, shrinking left out
  double core_seconds = 0;   ///< processor time of the trials, over all threads

  [[nodiscard]] bool promise_broken() const;
};

}  // namespace gnomon::fuzz
