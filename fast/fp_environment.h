// SPDX-License-Identifier: MIT
// What the floating-point environment of this process really does, witnessed by arithmetic.
#pragma once

#include <string_view>

#include "fast/strict_float.h"

namespace gnomon::fast {

/// Each member is the result of a computation whose outcome differs, done with values that the compiler can't
/// see.
struct FpEnvironment {
  bool rounds_to_nearest;  ///< 1 + u rounds to 1 and 1 + 3u to 1 + 4u, in both precisions
  bool keeps_denormals;    ///< no flush to zero, no denormals-are-zero
  bool fuses_products;    ///< x * x - y is computed with one rounding where the source says two (contraction)
  bool excess_precision;  ///< floats are computed in a wider format

  /// True when the promises of fast/ can hold.
  [[nodiscard]] bool is_strict() const {
    return rounds_to_nearest && keeps_denormals && !fuses_products && !excess_precision;
  }
};

/// Witnesses the calling thread's environment now.
[[nodiscard]] FpEnvironment witness_fp_environment();

}  // namespace gnomon::fast
