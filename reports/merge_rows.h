// SPDX-License-Identifier: GPL-3.0-or-later
// How the rows, witnesses and timings of result files add up. Used by merge.cpp.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "reports/json_node.h"

namespace gnomon::reports {

/// "shaft-box naive-f32 uniform f32": names a row, and the row of a witness or timing.
[[nodiscard]] std::string row_key(const Node& node);

/// Where a case is from: trials of lower seeds come first.
struct TrialPlace {
  std::uint64_t seed = 0, trial = 0;
  friend auto operator<=>(const TrialPlace&, const TrialPlace&) = default;
};

/// Throws scene::InputError unless the row has what add_row() relies on.
void check_row(const Node& row);

/// Adds the row `more` to `sum`, except for its witnesses: counts add, also those that this version does not
/// know; rates are computed anew; the larger worst gap stays (of equal ones that of the lower trial); all
/// else must be equal.
void add_row(Json& sum, const Node& more);

/// Of the witnesses in `all`, those that one run would have kept: for each row and fault the `keep` lowest
/// trials. Writes them, in the order of rows and faults, to result["witnesses"], and their names to the rows.
void keep_witnesses(Json& result, std::vector<Node> all, std::uint64_t keep);

/// `measured` of all files: `files` are their tops, in the order of the result.
[[nodiscard]] Json merged_measurements(const std::vector<Node>& files);

}  // namespace gnomon::reports
