// SPDX-License-Identifier: GPL-3.0-or-later
// Replaying text corpora and witness files.
#pragma once

#include <string>
#include <vector>

#include "fuzz/plugin_host.h"
#include "scene/corpus.h"

namespace gnomon::fuzz {

/// One case of a corpus by one method.
struct ReplayLine {
  std::string where;  ///< FILE:LINE
  std::string question, method, answer, reference, verdict;
  bool promise_broken = false;
};

/// A corpus line whose `-> answer` is not the exact one.
struct WrongAnswer {
  std::string where, stated, reference;
};

struct ReplayResult {
  std::vector<ReplayLine> lines;
  std::vector<WrongAnswer> wrong_answers;
  std::vector<std::string> failures;  ///< lines of methods that gave no answer: they were asked no more
  std::size_t cases = 0, stated = 0;

  [[nodiscard]] bool promise_broken() const;
};

/// Runs the named methods (all when empty) on every case. Methods of a precision that a case does not fit
/// reject it; float cases run in the float form. A named method must exist for at least one of the questions
/// in the corpus. Throws scene::InputError for lines that are no cases, UsageError for methods that no
/// question of the corpus has.
[[nodiscard]] ReplayResult replay(const std::vector<scene::CorpusLine>& corpus,
                                  const std::vector<std::string>& methods, const Plugins* plugins = nullptr);

}  // namespace gnomon::fuzz
