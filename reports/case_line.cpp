// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/case_line.h"

#include "scene/float_text.h"

namespace gnomon::reports {
namespace {

std::string_view next_word(std::string_view& line) {
  const auto start = line.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return line = {};
  const auto end = line.find_first_of(" \t\r\n", start);
  const std::string_view word = line.substr(start, end == std::string_view::npos ? end : end - start);
  line = end == std::string_view::npos ? std::string_view{} : line.substr(end);
  return word;
}

}  // namespace

std::optional<std::vector<double>> numbers_of_case(std::string_view line) {
  line = line.substr(0, line.find('#'));
  next_word(line);  // the question
  std::vector<double> numbers;
  for (std::string_view word = next_word(line); !word.empty() && word != "->"; word = next_word(line)) {
    const std::optional<double> value = scene::parse_float_text(word);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

}  // namespace gnomon::reports
