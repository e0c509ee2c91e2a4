// SPDX-License-Identifier: GPL-3.0-or-later
// One thread's counts of one row, and how they are put together.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "fuzz/row_result.h"

namespace gnomon::fuzz {

/// The lowest few trial numbers offered: which ones they are does not depend on the order of the offers.
class LowestTrials {
 public:
  void offer(std::uint64_t trial, std::size_t keep) {
    if (trials_.size() == keep && (keep == 0 || trial >= trials_.back())) return;
    trials_.insert(std::upper_bound(trials_.begin(), trials_.end(), trial), trial);
    if (trials_.size() > keep) trials_.pop_back();
  }
  [[nodiscard]] const std::vector<std::uint64_t>& trials() const { return trials_; }

 private:
  std::vector<std::uint64_t> trials_;
};

/// The largest |gap| offered; ties go to the lower trial.
class LargestGap {
 public:
  /// False when a gap of at most `bound` in size can not be the largest, so that it need not be computed.
  [[nodiscard]] bool may_exceed(double bound) const { return !known_ || bound >= approximate_; }
  void offer(const exact::Gap& gap, std::uint64_t trial);

  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] const exact::Gap& gap() const { return gap_; }
  [[nodiscard]] std::uint64_t trial() const { return trial_; }

 private:
  exact::Gap gap_;
  double approximate_ = 0;  ///< |gap| rounded down
  std::uint64_t trial_ = 0;
  bool known_ = false;
};

struct Tally {
  std::uint64_t trials = 0;
  std::array<std::array<std::uint64_t, kColumns>, kTruths> matrix{};
  std::uint64_t touching_outside = 0, touching_inside = 0, unsound_touching = 0;
  std::uint64_t rounding = 0, model = 0, rounding_and_model = 0;
  std::uint64_t threshold_checked = 0, threshold_exceeded = 0;
  std::array<LowestTrials, kFaults> faults;
  LargestGap largest;
  FaceSums faces;
  double ns = 0;

  void add(const Tally& other, std::size_t keep);
};

}  // namespace gnomon::fuzz
