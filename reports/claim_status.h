// SPDX-License-Identifier: GPL-3.0-or-later
// How a claim of a paper can end.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace gnomon::reports {

enum class ClaimStatus : std::uint8_t { proved, confirmed, refuted, erratum, reproduced, open };

/// All of them, settled ones first.
[[nodiscard]] std::span<const ClaimStatus> claim_statuses();

/// "proved", ...
[[nodiscard]] std::string_view name_of(ClaimStatus status);

/// What has to be shown for a claim to have the status, as a sentence without its full stop.
[[nodiscard]] std::string_view meaning_of(ClaimStatus status);

/// The status of that name, if there is one.
[[nodiscard]] std::optional<ClaimStatus> status_of(std::string_view name);

}  // namespace gnomon::reports
