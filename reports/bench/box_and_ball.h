// SPDX-License-Identifier: GPL-3.0-or-later
// Claim S24: the box test is about as fast as the sphere test.
#pragma once

#include <cstddef>

namespace gnomon::bench {

struct BoxAndBallOptions {
  int rounds = 31;
  /// The branch predictor learns the answers of a thousand by heart, and not those of so many.
  std::size_t items = 40000;
};

/// Times the paper's tests, one item at a time, for boxes and for balls in their place, and prints medians
/// and ratios of paired rounds.
void print_box_and_ball(const BoxAndBallOptions& options);

}  // namespace gnomon::bench
