// SPDX-License-Identifier: GPL-3.0-or-later
// One case in words, for people.
#pragma once

#include <string>

#include "fuzz/plugin_host.h"
#include "scene/corpus.h"

namespace gnomon::reports {

/// The case in words, decimals and hex floats, its exact answer with the gap to both boundaries as rationals,
/// what each method says of it, and a picture in characters, looked at along the axis that the deciding plane
/// leaves out; a case of `shadow` as reports/explain_shadow.h says, of `shaft-candidates` and `patch-pair` as
/// reports/explain_pair.h does. Throws scene::InputError for a line that is no case.
[[nodiscard]] std::string explain(const scene::CorpusLine& line, const fuzz::Plugins* plugins = nullptr);

/// The same case as a picture (SVG). There is none but of shafts: others throw scene::InputError.
[[nodiscard]] std::string explain_svg(const scene::CorpusLine& line);

}  // namespace gnomon::reports
