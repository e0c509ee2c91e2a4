// SPDX-License-Identifier: GPL-3.0-or-later
// One case of `shadow` in words, for people.
#pragma once

#include <string>

#include "scene/corpus.h"

namespace gnomon::reports {

/// Point, light and faces in decimals and hex floats; the exact answer; for every face that has a point in
/// common with the closed segment, how and where: the parameter along the segment (0 the point, 1 the light)
/// as a rational, and whether a border is sealed; what each method says. Of faces that are not met, only the
/// first dozen. Throws scene::InputError for a line that is no case.
[[nodiscard]] std::string explain_shadow(const scene::CorpusLine& line);

}  // namespace gnomon::reports
