// SPDX-License-Identifier: GPL-3.0-or-later
// Campaigns and the registry as text for terminals.
#pragma once

#include <string>

#include "fuzz/plugin_host.h"
#include "fuzz/row_result.h"

namespace gnomon::reports {

/// A table a distribution: mix of truths, then a line a method with counts, rates with their 95 % bounds, and
/// time.
[[nodiscard]] std::string campaign_text(const fuzz::CampaignResult& result);

/// What `gnomon list` prints: questions, methods (those of plug-ins too), distributions, and what was not
/// built in.
[[nodiscard]] std::string list_text(const fuzz::Plugins* plugins = nullptr);
[[nodiscard]] std::string list_json(const fuzz::Plugins* plugins = nullptr);

}  // namespace gnomon::reports
