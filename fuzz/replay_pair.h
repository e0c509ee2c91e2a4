// SPDX-License-Identifier: GPL-3.0-or-later
// Replaying lines of the questions `shaft-candidates` and `patch-pair`.
#pragma once

#include <span>
#include <string_view>

#include "fuzz/pair_method.h"
#include "fuzz/replay.h"
#include "scene/corpus.h"

namespace gnomon::fuzz {

/// How corpora call the questions of scene/pair_case.h.
inline constexpr std::string_view kCandidatesQuestion = "shaft-candidates", kPairQuestion = "patch-pair";

/// Appends what each of the methods says of the line's case; answers of shaft-candidates are sets of faces,
/// numbered as on the line. Methods reject a case whose numbers are not all floats. The truth is found face
/// by face and by a hierarchy. Throws scene::InputError for a line that is no case, std::logic_error when the
/// two references differ, or a method names a face twice or one that is not there.
void replay_candidates(const scene::CorpusLine& line, std::span<const CandidateMethod* const> methods,
                       ReplayResult& result);
void replay_pair(const scene::CorpusLine& line, std::span<const PairMethod* const> methods,
                 ReplayResult& result);

}  // namespace gnomon::fuzz
