// SPDX-License-Identifier: MIT
// The shaft between two boxes of points as a slab test in its parameter. Internal to fast/pair_*.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "fast/hierarchy_bounds.h"

namespace gnomon::fast {

/// The hull of the boxes A and B is the union of the boxes (1-s)A + sB, 0 <= s <= 1. A box T meets it when an
/// s satisfies, on each axis,
///     (1-s) A.lo + s B.lo <= T.hi    and    (1-s) A.hi + s B.hi >= T.lo:
/// six inequalities linear in s, each a bound of s from below or from above, or none (Helly's theorem makes
/// the paper's plane set of their pairs). So the test is that of a ray against a box, with an origin and a
/// direction for each of the six faces: with A' = A.lo and D = B.lo - A.lo, the first one reads s <= (T.hi -
/// A') / D for D > 0, and s >= the same for D < 0. T is dropped when the largest lower bound (and 0) exceeds
/// the smallest upper one (and 1).
///
/// ERRORS, as in fast/hierarchy_beam.h. Say T meets the hull at an s. Origins are moved by 2^-80 so that the
/// bounds loosen: A.lo down, A.hi up. Let x stand for a T.hi or T.lo, a for A' and x - a for the exact
/// difference, |D| >= 2^-81.
///  - A lower bound that is exactly n = (x - a) / D <= s: if x - a and D have one sign and |x - a| >= 2^-81,
///    the moved origin (rounding is monotone) gives at most what a itself would: four roundings (difference,
///    D, 1 / D, product), no underflow: n (1 + u)^4. If |x - a| is smaller, x - a' has the sign of the move
///    or is 0, and the bound is at most 0. If x - a and D have opposite signs or x = a, so do x - a' and D.
///  - An upper bound f >= s >= 0, so x - a is 0 or has D's sign: likewise f (1 - u)^4 (1 + 12 u) (1 - u) or
///    more if |x - a| is 0 or at least 2^-81 (for 0: 0 or more, as s is 0), else at least 2^-81 / |D| > f but
///    for roundings, which the factor pays.
///  - So the largest lower bound is at most s (1 + u)^4, every upper one at least s (1 + u)^4, and the upper
///    bound 1 is computed as 1 + 8 u.
///  - |D| < 2^-81: the inequality says x >= A.lo - 2^-81 (x <= A.hi + 2^-81) whatever s is; as an upper bound
///    with an infinite inverse: +infinity, or a NaN, which the kernel ignores, when x - a' >= 0 (<= 0), else
///    -infinity. fl(A.lo - 2^-80) is at most A.lo - 2^-81, or A.lo itself when A.lo, and so each of B.lo and
///    T that it could tell from it, are multiples of 2^-80.
struct PairShaft {
  std::array<std::uint32_t, 6> row;  ///< of WideNode::bounds; the lower bounds come first
  std::array<float, 6> origin, inverse;
  std::uint32_t lower = 0;  ///< how many are lower bounds

  /// Boxes are minima, then maxima, of magnitudes up to kMostMagnitude.
  PairShaft(const std::array<float, 6>& a, const std::array<float, 6>& b) {
    std::uint32_t first = 0, last = 6;
    for (std::uint32_t i = 0; i < 6; ++i) {
      const bool is_lo = i < 3;
      const float difference = b[i] - a[i];
      const float magnitude = difference < 0 ? -difference : difference;
      const bool slow = magnitude < kLeastDirection;
      const bool is_upper = slow || (difference > 0) == is_lo;
      const std::uint32_t at = is_upper ? --last : first++;
      constexpr float kInfinity = std::numeric_limits<float>::infinity();
      const float exact_inverse = 1 / difference;
      row[at] = is_lo ? i + 3 : i - 3;
      origin[at] = a[i] + (is_lo ? -kOriginShift : kOriginShift);
      inverse[at] = slow ? (is_lo ? kInfinity : -kInfinity) : exact_inverse * (is_upper ? kFarFactor : 1.0f);
    }
    lower = first;
  }
};

/// The upper end of s.
inline constexpr float kShaftEnd = kLimitFactor;

}  // namespace gnomon::fast
