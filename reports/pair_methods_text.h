// SPDX-License-Identifier: GPL-3.0-or-later
// What `gnomon list` says of questions about pairs in a scene.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace gnomon::reports {

/// The methods of shaft-candidates and patch-pair, and an empty line after each.
[[nodiscard]] std::string pair_methods_text();
/// Their distributions.
[[nodiscard]] std::string pair_distributions_text();

/// Each question in the form of those about shafts.
[[nodiscard]] nlohmann::ordered_json candidate_question_json();
[[nodiscard]] nlohmann::ordered_json patch_question_json();
[[nodiscard]] nlohmann::ordered_json pair_distributions_json();

}  // namespace gnomon::reports
