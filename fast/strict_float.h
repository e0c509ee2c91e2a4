// SPDX-License-Identifier: MIT
// Every header of fast/ includes this file first: our promises hold for IEEE arithmetic only.
#pragma once

#ifdef __FAST_MATH__
#error "gnomon/fast: the promises hold for IEEE arithmetic; compile without -ffast-math"
#endif

#include <limits>

namespace gnomon::fast {

/// The unit roundoff u and half of the smallest denormal, eta: |fl(x) - x| <= u |x| + eta for every real x
/// that does not overflow (round to nearest). Sums and differences of floats need no eta: they are exact when
/// denormal.
template <class F>
struct Rounding {
  static_assert(std::numeric_limits<F>::is_iec559);
  static constexpr F u = std::numeric_limits<F>::epsilon() / 2;
  /// 2 eta, the smallest denormal: eta itself is no number of the format.
  static constexpr F two_eta = std::numeric_limits<F>::denorm_min();
};

}  // namespace gnomon::fast
