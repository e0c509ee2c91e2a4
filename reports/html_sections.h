// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the page, in its order; each is a complete HTML fragment and needs no script to be read.
#pragma once

#include <span>
#include <string>

#include "reports/claim.h"
#include "reports/result_set.h"

namespace gnomon::reports {

/// What this is, whether the promises held, and each question's answer in a few sentences.
[[nodiscard]] std::string verdict_section(std::span<const ResultFile> files);

/// Speed against error as still pictures, and their numbers as JSON for the plot with controls.
[[nodiscard]] std::string plot_section(std::span<const ResultFile> files);

/// A verdict, its reasons and the time for every method, all distributions together.
[[nodiscard]] std::string methods_section(std::span<const ResultFile> files);

/// Every row with counts, rates, intervals and times.
[[nodiscard]] std::string rows_section(std::span<const ResultFile> files);

/// Rounding against model error, and the full matrices of truth and answer.
[[nodiscard]] std::string error_sources_section(std::span<const ResultFile> files);

/// How long the lists of shaft-candidates are, and by how much wrong; empty without such rows.
[[nodiscard]] std::string lists_section(std::span<const ResultFile> files);

/// What each distribution asks: the shares of the exact answers and of touching cases.
[[nodiscard]] std::string mix_section(std::span<const ResultFile> files);

/// The worst witness of each method and verdict with a picture, the others as a list.
[[nodiscard]] std::string witness_section(std::span<const ResultFile> files);

/// Results of kinds other than "fuzz" as plain tables; empty when there are none.
[[nodiscard]] std::string other_results_section(std::span<const ResultFile> files);

/// The ledger of the papers' claims with status, counts and how to follow each; empty without claims.
[[nodiscard]] std::string claims_section(std::span<const Claim> claims);

/// Command lines, seeds, environments and licences.
[[nodiscard]] std::string foot_section(std::span<const ResultFile> files);

}  // namespace gnomon::reports
