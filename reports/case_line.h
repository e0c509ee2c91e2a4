// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers out of a text-corpus line.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace gnomon::reports {

/// The numbers of "QUESTION number... [-> answer] [# comment]", decimal or hex float; nothing when a word
/// between the question and the arrow is not one number. Independent of the locale.
[[nodiscard]] std::optional<std::vector<double>> numbers_of_case(std::string_view line);

}  // namespace gnomon::reports
