// SPDX-License-Identifier: GPL-3.0-or-later
// Claim S24: the box test is about as fast as the sphere test.
#pragma once

namespace gnomon::bench {

/// Times the paper's tests, one item at a time, for boxes and for balls in their place, and prints medians
/// and ratios of paired rounds.
void print_box_and_ball(int rounds);

}  // namespace gnomon::bench
