// SPDX-License-Identifier: GPL-3.0-or-later
// Result files: the JSON that scripts and the report read.
#pragma once

#include <string>

#include "fuzz/row_result.h"

namespace gnomon::reports {

/// The result file of a campaign, schema 1. Everything but `measured` is a function of the command's meaning:
/// equal for any number of jobs. Ends with a newline.
[[nodiscard]] std::string result_json(const fuzz::CampaignResult& result);

}  // namespace gnomon::reports
