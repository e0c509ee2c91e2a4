// SPDX-License-Identifier: MIT
// Directions around a circle, the same on every machine. Internal to scene/.
#pragma once

#include <cstdint>

namespace gnomon::scene {

/// The cosine and sine of a fraction of a full turn.
struct Direction {
  double cos = 1, sin = 0;
};

/// The direction after step/steps of a counterclockwise turn, to within 2^-51. No library function is
/// called, whose last digit depends on the library: series of +, -, *, / alone.
[[nodiscard]] Direction turn(std::uint64_t step, std::uint64_t steps);

}  // namespace gnomon::scene
