// SPDX-License-Identifier: GPL-3.0-or-later
// Rates with their uncertainty.
#pragma once

#include <cstdint>

namespace gnomon::fuzz {

/// A share of trials with its two-sided 95 % Clopper-Pearson interval. Zero of no trials is 0 in [0, 1].
struct Rate {
  double value = 0, low95 = 0, high95 = 1;
};

/// Exact binomial interval by Boost.Math. `hits` <= `trials`.
[[nodiscard]] Rate rate_of(std::uint64_t hits, std::uint64_t trials);

}  // namespace gnomon::fuzz
