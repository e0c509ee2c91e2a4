// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger of the papers' claims: proofs/claims.json, embedded when this library is built.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/claim.h"

namespace gnomon::reports {

struct Paper {
  std::string_view id, title;
  char letter;          ///< that its claims begin with
  unsigned claims = 0;  ///< numbered from 1
};

/// The papers whose claims are kept, in the ledger's order.
[[nodiscard]] std::span<const Paper> papers();

/// All entries in their order. Throws scene::InputError when what was embedded is no ledger.
[[nodiscard]] const std::vector<Claim>& ledger();

/// Reads a ledger from JSON text; `name` stands for it in messages. Throws scene::InputError naming the place
/// for what is not JSON, for missing, unknown or mistyped fields, unknown papers, statuses and kinds of
/// pointers, for ids that are not the paper's or come twice, and for a settled entry that points nowhere.
[[nodiscard]] std::vector<Claim> read_ledger(std::string_view json, const std::string& name);

/// How many entries have each status, in the order of claim_statuses().
using StatusCounts = std::array<std::size_t, 6>;
[[nodiscard]] StatusCounts count_statuses(std::span<const Claim> claims, ClaimStatus Claim::*which);

/// "3 proved, 2 refuted, 60 open": those that occur.
[[nodiscard]] std::string counts_text(const StatusCounts& counts);

}  // namespace gnomon::reports
