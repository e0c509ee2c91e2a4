// SPDX-License-Identifier: GPL-3.0-or-later
// A method that gave no answers.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::fuzz {

/// Thrown by a row whose method crashed, hung or answered nonsense: a plug-in's. what() is one whole line
/// that names the method.
class MethodFailure : public std::runtime_error {
 public:
  MethodFailure(const std::string& line, std::vector<std::string> cases)
      : std::runtime_error(line), cases_(std::move(cases)) {}

  /// Corpus lines: the one case to blame where it is known, else the whole batch.
  [[nodiscard]] const std::vector<std::string>& cases() const { return cases_; }

 private:
  std::vector<std::string> cases_;
};

}  // namespace gnomon::fuzz
