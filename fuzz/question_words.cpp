// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/question_words.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace gnomon::fuzz {

namespace {

constexpr Verdict kGood = Verdict::agree, kWaste = Verdict::waste, kBad = Verdict::unsound;
constexpr std::size_t kNo = kFaults;
using VerdictTable = std::array<std::array<Verdict, kTruths>, kTruths>;
using FaultTable = std::array<std::array<std::size_t, kTruths>, kTruths>;

constexpr std::array<std::string_view, kTruths> kShaftAnswers{"outside", "overlap", "inside"};
constexpr VerdictTable kShaftVerdicts{{{kGood, kWaste, kBad}, {kBad, kGood, kBad}, {kBad, kWaste, kGood}}};
constexpr FaultTable kShaftFaults{{{kNo, 2, 1}, {0, kNo, 1}, {0, 3, kNo}}};
constexpr std::array<std::string_view, kFaults> kShaftFaultNames{
    name_of(Fault::false_cull), name_of(Fault::false_inside), name_of(Fault::false_keep),
    name_of(Fault::missed_inside)};

constexpr QuestionWords kQuestions[] = {
    {"shaft-box", kShaftAnswers, kShaftAnswers, kShaftVerdicts, kShaftFaults, kShaftFaultNames},
    {"shaft-sphere", kShaftAnswers, kShaftAnswers, kShaftVerdicts, kShaftFaults, kShaftFaultNames},
    {"shaft-slabs", kShaftAnswers, kShaftAnswers, kShaftVerdicts, kShaftFaults, kShaftFaultNames},
    {"shaft-oriented-box", kShaftAnswers, kShaftAnswers, kShaftVerdicts, kShaftFaults, kShaftFaultNames},
    {"shaft-ellipsoid", kShaftAnswers, kShaftAnswers, kShaftVerdicts, kShaftFaults, kShaftFaultNames},
    // Is the true list empty, or has it some faces? A list may be the same set, a larger one, or lack a face.
    {"shaft-candidates",
     {"empty", "some", ""},
     {"same", "more", "missing"},
     {{{kGood, kWaste, kBad}, {kGood, kWaste, kBad}, {kGood, kWaste, kBad}}},
     {{{kNo, 1, 0}, {kNo, 1, 0}, {kNo, 1, 0}}},
     {"missing face", "excess face", "", ""},
     true,
     true},
    {"patch-pair",
     {"all", "none", "part"},
     {"all", "none", "part"},
     {{{kGood, kBad, kWaste}, {kBad, kGood, kWaste}, {kBad, kBad, kGood}}},
     {{{kNo, 1, 3}, {0, kNo, 2}, {0, 1, kNo}}},
     {"false all", "false none", "missed none", "missed all"},
     true},
};

}  // namespace

std::size_t QuestionWords::truth_count() const {
  return static_cast<std::size_t>(std::find(truths.begin(), truths.end(), std::string_view()) -
                                  truths.begin());
}

Verdict QuestionWords::judge(std::size_t truth, Answer answer) const {
  if (answer == kUndecided) return Verdict::undecided;
  if (answer == kRejected) return Verdict::rejected;
  return verdicts[truth][answer];
}

bool QuestionWords::can_be(std::size_t truth, std::size_t answer) const {
  return !(lists_faces && truth == 0 && answer == 2);
}

std::string_view QuestionWords::answer_name(Answer answer) const {
  if (answer == kUndecided) return "undecided";
  return answer == kRejected ? "rejected" : answers[answer];
}

std::span<const QuestionWords> campaign_questions() {
  return kQuestions;
}

const QuestionWords* find_question(std::string_view id) {
  for (const QuestionWords& words : kQuestions) {
    if (words.id == id) return &words;
  }
  return nullptr;
}

const QuestionWords& words_of(std::string_view id) {
  const QuestionWords* const words = find_question(id);
  if (words == nullptr) throw std::logic_error("no campaign asks " + std::string(id));
  return *words;
}

}  // namespace gnomon::fuzz
