// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of candidate lists in result files of `gnomon measure`.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "reports/list_figures.h"

namespace gnomon::reports {

class Node;

/// The member `lists` of a result file: counts, the same on every run.
[[nodiscard]] nlohmann::ordered_json lists_json(std::span<const ListFigures> rows);

/// The member `lists` of `measured`: times, row by row as in lists_json().
[[nodiscard]] nlohmann::ordered_json list_times_json(std::span<const ListFigures> rows);

/// Reads both back; no rows where the file has none. Throws scene::InputError, with one line, for what is
/// missing or can't be.
[[nodiscard]] std::vector<ListFigures> read_lists(const Node& top);

}  // namespace gnomon::reports
