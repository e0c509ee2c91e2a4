// SPDX-License-Identifier: GPL-3.0-or-later
// Replaying text corpora and witness files.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/plugin_host.h"
#include "fuzz/scene_method.h"
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

/// How corpora call the question of scene/shadow_case.h.
inline constexpr std::string_view kShadowQuestion = "shadow";

/// Rows beside the registries of shafts and of pairs: plug-ins' for shafts, and all those for `shadow`, which
/// other projects' may be among.
struct ReplayRows {
  const Plugins* plugins = nullptr;
  std::span<const SceneMethod> scene_methods = fuzz::scene_methods();
};

/// Runs the named methods (all when empty) on every case of their questions. Methods of a precision that a
/// case does not fit, or that don't know its faces, reject it; shafts of floats run in the float form. A
/// named method must exist for some question. Throws scene::InputError for lines that are no cases,
/// UsageError for unknown methods, std::logic_error should two exact references differ.
[[nodiscard]] ReplayResult replay(const std::vector<scene::CorpusLine>& corpus,
                                  const std::vector<std::string>& methods, const ReplayRows& rows = {});

}  // namespace gnomon::fuzz
