// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/question_words.h"
#include "reports/html_sections.h"
#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

std::string cell(std::uint64_t n, const char* look) {
  return fmt::format("<td class=\"num {}\">{}</td>", n == 0 ? "quiet" : look, thousands(n));
}

std::string name_cell(const Summary& s) {
  return fmt::format("<th scope=\"row\"><span class=\"dot t-{}\"></span>{}</th>", escaped(s.tier),
                     escaped(s.label));
}

std::string split_table(std::span<const Summary> summaries) {
  std::string out =
      "<div class=\"scroll\"><table class=\"grid2\"><thead><tr><td></td><th scope=\"colgroup\" "
      "colspan=\"2\">exact twin = "
      "truth</th><th scope=\"colgroup\" colspan=\"2\">exact twin ≠ truth</th></tr>\n<tr><th "
      "scope=\"col\">Method</th><th "
      "scope=\"col\">float = twin<small>no error</small></th><th scope=\"col\">float ≠ "
      "twin<small>rounding</small></th><th "
      "scope=\"col\">float = twin<small>model</small></th><th scope=\"col\">float ≠ twin<small>both; may "
      "cancel</small></th></tr></thead><tbody>\n";
  for (const Summary& s : summaries) {
    const std::uint64_t wrong = s.rounding + s.model + s.rounding_and_model + s.rejected;
    out += "<tr>" + name_cell(s) + cell(s.trials - std::min(wrong, s.trials), "") + cell(s.rounding, "warn") +
           cell(s.model, "warn") + cell(s.rounding_and_model, "warn") + "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

const char* look_of_pair(const fuzz::QuestionWords& words, const std::string& truth,
                         const std::string& answer) {
  for (std::size_t row = 0; row < words.truth_count(); ++row) {
    for (std::size_t column = 0; column < fuzz::kTruths; ++column) {
      if (words.truths[row] != truth || words.answers[column] != answer) continue;
      const fuzz::Verdict verdict = words.verdicts[row][column];
      return verdict == fuzz::Verdict::agree ? "agree" : verdict == fuzz::Verdict::waste ? "warn" : "bad";
    }
  }
  return "";
}

/// How bad it is to say `answer` when the truth is `truth`.
const char* look_of(const std::string& question, const std::string& truth, const std::string& answer) {
  if (truth == answer) return "agree";
  if (const fuzz::QuestionWords* const words = fuzz::find_question(question); words && words->about_pairs) {
    return look_of_pair(*words, truth, answer);
  }
  const bool known = truth == "outside" || truth == "overlap" || truth == "inside";
  if (!known || answer == "undecided") return "";
  return answer == "outside" || answer == "inside" ? "bad" : "warn";
}

std::string matrix_table(std::span<const Summary> summaries) {
  std::vector<std::string> truths, answers;
  Matrix all;
  for (const Summary& s : summaries) {
    for (const auto& [truth, row] : s.matrix) {
      all[truth];
      for (const auto& [answer, n] : row) all[truth][answer] += n;
    }
  }
  const std::string& question = summaries.front().question;
  if (const fuzz::QuestionWords* const words = fuzz::find_question(question); words && words->about_pairs) {
    truths.assign(words->truths.begin(), words->truths.begin() + static_cast<long>(words->truth_count()));
    answers.assign(words->answers.begin(), words->answers.end());
  } else {
    answers = answers_of(all);
    std::copy_if(answers.begin(), answers.end(), std::back_inserter(truths),
                 [&](const std::string& a) { return all.contains(a); });
  }
  std::string out = "<div class=\"scroll\"><table class=\"grid2\"><thead><tr><td></td>";
  for (const auto& truth : truths) {
    out +=
        fmt::format("<th scope=\"colgroup\" colspan=\"{}\">exactly {}</th>", answers.size(), escaped(truth));
  }
  out += "</tr>\n<tr><th scope=\"col\">Method says</th>";
  for (std::size_t i = 0; i < truths.size(); ++i) {
    for (const auto& answer : answers) out += fmt::format("<th scope=\"col\">{}</th>", escaped(answer));
  }
  out += "</tr></thead><tbody>\n";
  for (const Summary& s : summaries) {
    out += "<tr>" + name_cell(s);
    for (const auto& truth : truths) {
      for (const auto& answer : answers) {
        const auto row = s.matrix.find(truth);
        const auto n = row == s.matrix.end() || !row->second.contains(answer) ? 0 : row->second.at(answer);
        out += cell(n, look_of(question, truth, answer));
      }
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace

std::string error_sources_section(std::span<const ResultFile> files) {
  const std::vector<Summary> pooled = group(files, Grouping::kMethod);
  if (pooled.empty()) return "";
  std::string out =
      "<section id=\"sources\"><h2>Where the errors come from</h2>\n<p>A method's <i>exact twin</i> is the "
      "same "
      "method in exact arithmetic. Where float and twin differ, rounding is to blame; where twin and truth "
      "differ, the method itself is. The second table counts each exact answer against what was said; "
      "<span class=\"bad\">unsound</span> and <span class=\"warn\">wasteful</span> answers are marked.</p>\n";
  for (auto first = pooled.begin(); first != pooled.end();) {
    const auto last =
        std::find_if(first, pooled.end(), [&](const Summary& s) { return s.question != first->question; });
    const std::span<const Summary> question(first, last);
    out += fmt::format("<h3><code>{}</code></h3>\n", escaped(first->question)) + "<div class=\"beside\">\n" +
           (first->about_pairs ? "" : split_table(question)) + matrix_table(question) + "</div>\n";
    first = last;
  }
  return out + "</section>\n";
}

}  // namespace gnomon::reports
