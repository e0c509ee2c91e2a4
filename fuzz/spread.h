// SPDX-License-Identifier: GPL-3.0-or-later
// Median and quartiles of measured values.
#pragma once

#include <vector>

namespace gnomon::fuzz {

/// Half of the rounds took `median` or less, a quarter `low25` or less, three quarters `high75` or less.
struct Spread {
  double median = 0, low25 = 0, high75 = 0;
};

/// Quartiles, interpolated between neighbours. At least one value.
[[nodiscard]] Spread spread_of(std::vector<double> values);

}  // namespace gnomon::fuzz
