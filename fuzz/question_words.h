// SPDX-License-Identifier: GPL-3.0-or-later
// What a question's truths, answers and faults are called, and which answers are how wrong.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "fuzz/verdict.h"

namespace gnomon::fuzz {

/// One question in words. Matrices have a row for each truth and a column for each answer.
struct QuestionWords {
  std::string_view id;
  std::array<std::string_view, kTruths> truths;                  ///< empty names after the last
  std::array<std::string_view, kTruths> answers;                 ///< what methods say
  std::array<std::array<Verdict, kTruths>, kTruths> verdicts;    ///< of truth, then answer
  std::array<std::array<std::size_t, kTruths>, kTruths> faults;  ///< numbers of fault_names; kFaults: none
  std::array<std::string_view, kFaults> fault_names;             ///< worst first
  bool about_pairs = false;  ///< of a scene, rather than about a shaft and one volume
  bool lists_faces = false;  ///< answers are lists of faces

  [[nodiscard]] std::size_t truth_count() const;
  /// Of an answer, undecided and rejected too.
  [[nodiscard]] Verdict judge(std::size_t truth, Answer answer) const;
  /// False for what can't happen: no face of an empty list is missing.
  [[nodiscard]] bool can_be(std::size_t truth, std::size_t answer) const;
  [[nodiscard]] std::string_view answer_name(Answer answer) const;
};

/// The questions that campaigns ask: those about a shaft and one volume, then those about pairs.
[[nodiscard]] std::span<const QuestionWords> campaign_questions();

/// The words of a question; null when no campaign asks it.
[[nodiscard]] const QuestionWords* find_question(std::string_view id);
/// The words of a question that there is.
[[nodiscard]] const QuestionWords& words_of(std::string_view id);

}  // namespace gnomon::fuzz
