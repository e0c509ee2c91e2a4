// SPDX-License-Identifier: GPL-3.0-or-later
// The trial loop of questions about pairs in a scene.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fuzz/campaign.h"
#include "fuzz/pair_question.h"

namespace gnomon::fuzz {

/// Runs a campaign of CandidateQuestion or PatchQuestion. Cases are floats, and no plug-in knows these
/// questions: throws UsageError for scalar f64 and for plug-ins, besides for methods and distributions that
/// do not exist, and scene::InputError for scenes that can't be read. `methods` are the rows to choose from;
/// the registry's unless a test brings its own. Else as run_campaign().
template <class Q>
[[nodiscard]] CampaignResult run_pair_campaign(const CampaignOptions& options,
                                               const OnProgress& on_progress = {},
                                               const OnBatch& on_batch = {},
                                               std::span<const typename Q::Method> methods = Q::methods());

}  // namespace gnomon::fuzz
