// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/row_result.h"

#include <algorithm>

#include "fuzz/method.h"

namespace gnomon::fuzz {

const QuestionWords& RowResult::words() const {
  const QuestionWords* const known = find_question(question);
  return known != nullptr ? *known : campaign_questions().front();
}

std::uint64_t RowResult::truths(std::size_t truth) const {
  std::uint64_t sum = 0;
  for (const std::uint64_t n : matrix[truth]) sum += n;
  return sum;
}

std::uint64_t RowResult::count(Verdict verdict) const {
  std::uint64_t sum = 0;
  for (std::size_t truth = 0; truth < words().truth_count(); ++truth) {
    for (std::size_t answer = 0; answer < kColumns; ++answer) {
      if (words().judge(truth, static_cast<Answer>(answer)) == verdict) sum += matrix[truth][answer];
    }
  }
  return sum;
}

std::uint64_t RowResult::count(Fault fault) const {
  return count_fault(static_cast<std::size_t>(fault));
}

std::uint64_t RowResult::count_fault(std::size_t fault) const {
  std::uint64_t sum = 0;
  for (std::size_t truth = 0; truth < words().truth_count(); ++truth) {
    for (std::size_t answer = 0; answer < kTruths; ++answer) {
      if (words().faults[truth][answer] == fault) sum += matrix[truth][answer];
    }
  }
  return sum;
}

PairChances chances_of(const RowResult& row) {
  const QuestionWords& words = row.words();
  PairChances chances;
  for (std::size_t truth = 0; truth < words.truth_count(); ++truth) {
    bool may_waste = false, may_lie = false;
    for (std::size_t answer = 0; answer < kTruths; ++answer) {
      if (!words.can_be(truth, answer)) continue;
      may_waste |= words.verdicts[truth][answer] == Verdict::waste;
      may_lie |= words.verdicts[truth][answer] == Verdict::unsound;
    }
    if (may_waste) chances.waste += row.truths(truth);
    if (may_lie) chances.unsound += row.truths(truth);
  }
  return chances;
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
