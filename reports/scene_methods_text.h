// SPDX-License-Identifier: GPL-3.0-or-later
// What `gnomon list` says of questions about scenes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace gnomon::reports {

/// The methods of shadow and first-hit with the peers that are built in, then workloads and variants of
/// scenes.
[[nodiscard]] std::string scene_methods_text();

/// Each question in the form of those about shafts, and its workloads and variants.
[[nodiscard]] nlohmann::ordered_json shadow_question_json();
[[nodiscard]] nlohmann::ordered_json first_hit_question_json();

/// What could be built in and is not.
[[nodiscard]] std::vector<std::string> not_built_in();

}  // namespace gnomon::reports
