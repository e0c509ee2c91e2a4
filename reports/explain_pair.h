// SPDX-License-Identifier: GPL-3.0-or-later
// One case of `shaft-candidates` or `patch-pair` in words, for people.
#pragma once

#include <string>

#include "scene/corpus.h"

namespace gnomon::reports {

/// The boxes and faces in decimals and hex floats, which faces meet the shaft, where between the boxes (the
/// exact range of s) or by how much a ball misses it (the exact gap), and what each method says. There is no
/// picture. Throws scene::InputError for a line that is no case.
[[nodiscard]] std::string explain_candidates(const scene::CorpusLine& line);

/// The patches and faces likewise: which faces block segments, for which s, and how many of the nine segments
/// between corners; on which sides of the patches' planes each lies, and whether it hides all.
[[nodiscard]] std::string explain_pair(const scene::CorpusLine& line);

}  // namespace gnomon::reports
