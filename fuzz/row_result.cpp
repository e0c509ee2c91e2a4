// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/row_result.h"

#include <algorithm>

#include "fuzz/shaft_questions.h"

namespace gnomon::fuzz {

std::uint64_t RowResult::truths(std::size_t truth) const {
  std::uint64_t sum = 0;
  for (const std::uint64_t n : matrix[truth]) sum += n;
  return sum;
}

std::uint64_t RowResult::count(Verdict verdict) const {
  std::uint64_t sum = 0;
  for (std::size_t truth = 0; truth < kTruths; ++truth) {
    for (std::size_t answer = 0; answer < kColumns; ++answer) {
      if (ShaftAnswers::judge(static_cast<scene::Category>(truth), static_cast<Answer>(answer)) == verdict) {
        sum += matrix[truth][answer];
      }
    }
  }
  return sum;
}

std::uint64_t RowResult::count(Fault fault) const {
  std::uint64_t sum = 0;
  for (std::size_t truth = 0; truth < kTruths; ++truth) {
    for (std::size_t answer = 0; answer < kTruths; ++answer) {
      if (truth == answer) continue;
      if (ShaftAnswers::fault(static_cast<scene::Category>(truth), static_cast<Answer>(answer)) == fault) {
        sum += matrix[truth][answer];
      }
    }
  }
  return sum;
}

bool RowResult::promise_broken() const {
  if (threshold_exceeded > 0) return true;
  if (promise == name_of(Promise::none)) return false;
  if (count(Verdict::unsound) > 0) return true;
  if (in_domain && count(Verdict::undecided) > 0) return true;
  return promise == name_of(Promise::always_agrees) && count(Verdict::waste) > 0;
}

bool CampaignResult::promise_broken() const {
  return std::any_of(rows.begin(), rows.end(), [](const RowResult& row) { return row.promise_broken(); });
}

}  // namespace gnomon::fuzz
