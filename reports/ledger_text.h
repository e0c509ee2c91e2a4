// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger as people and scripts read it.
#pragma once

#include <span>
#include <string>

#include "reports/claim.h"

namespace gnomon::reports {

/// A table for a terminal: id, both statuses, the claim, and below it the note and how to follow each
/// pointer.
[[nodiscard]] std::string ledger_text(std::span<const Claim> claims);

/// proofs/claims.json again, each pointer with the command that follows it.
[[nodiscard]] std::string ledger_json(std::span<const Claim> claims);

/// proofs/CLAIMS.md: what the statuses mean, a table a paper, and the evidence claim by claim.
[[nodiscard]] std::string ledger_markdown(std::span<const Claim> claims);

}  // namespace gnomon::reports
