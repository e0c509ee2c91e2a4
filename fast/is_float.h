// SPDX-License-Identifier: MIT
// Is the value of a double that of a float?
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "fast/strict_float.h"

namespace gnomon::fast {

/// The bits of a double that a float has none for; all 0 in every float.
inline constexpr std::uint64_t kBeyondFloat = (std::uint64_t{1} << 29) - 1;

/// True when a float has exactly this value, denormal ones included; false for NaN and infinity.
///
/// By bits, not by converting there and back: g++ 12 leaves both conversions out where it makes vectors of
/// them (-O2, two or more side by side), and so calls every number a float.
[[nodiscard]] inline bool is_float(double x) {
  const double magnitude = std::abs(x);
  if (magnitude >= 0x1p-126) {
    return magnitude < 0x1p128 && (std::bit_cast<std::uint64_t>(x) & kBeyondFloat) == 0;
  }
  const double scaled = x * 0x1p149;  // exact, as x is no denormal double there; else below 1
  return scaled == std::trunc(scaled);
}

}  // namespace gnomon::fast
