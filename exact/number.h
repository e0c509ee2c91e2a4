// SPDX-License-Identifier: GPL-3.0-or-later
// The two kernels that exact/ runs on, and signs that may be unknown. Internal to exact/: includes CGAL.
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "scene/category.h"

namespace gnomon::exact {

/// Directed-rounding intervals: the filter. Valid only under Interval_nt<false>::Protector (rounding mode
/// upwards).
using FilterKernel = CGAL::Simple_cartesian<CGAL::Interval_nt<false>>;
/// Quotients of CGAL's exact binary floats: the answer to whatever the filter leaves open. Numbers are never
/// reduced, so a case costs multiplications and no greatest common divisors; denormals cost no more than
/// other numbers.
using ExactKernel = CGAL::Simple_cartesian<CGAL::Quotient<CGAL::Mpzf>>;
/// The exact binary floats themselves, for what needs no division.
using ExactFloat = CGAL::Mpzf;
/// Reduced rationals of GMP: gaps as they are printed, and a second opinion for the tests.
using RationalKernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

/// The sign of a number of either kernel; an interval around 0 has none. A type of its own, so that "unknown"
/// can't be taken for zero.
enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1, unknown = 2 };

[[nodiscard]] inline Sign sign_of(const CGAL::Interval_nt<false>& x) {
  if (x.inf() > 0) return Sign::positive;
  if (x.sup() < 0) return Sign::negative;
  if (x.inf() == 0 && x.sup() == 0) return Sign::zero;
  return Sign::unknown;  // also for the NaN of overflowed intervals
}
[[nodiscard]] inline Sign sign_of(const CGAL::Quotient<CGAL::Mpzf>& x) {
  return static_cast<Sign>(static_cast<int>(CGAL::sign(x)));
}
[[nodiscard]] inline Sign sign_of(const CGAL::Mpzf& x) {
  return static_cast<Sign>(static_cast<int>(CGAL::sign(x)));
}
[[nodiscard]] inline Sign sign_of(const CGAL::Gmpq& x) {
  return static_cast<Sign>(static_cast<int>(CGAL::sign(x)));
}
/// The sign of x - y for given numbers; exact.
[[nodiscard]] inline Sign sign_of_difference(double x, double y) {
  return x < y ? Sign::negative : x > y ? Sign::positive : Sign::zero;
}

/// Folds signs into "is any of them positive", "is any of them zero", with unknowns kept.
struct SignFold {
  bool any_positive = false, any_zero = false, any_unknown = false;
  void add(Sign sign) {
    any_positive |= sign == Sign::positive;
    any_zero |= sign == Sign::zero;
    any_unknown |= sign == Sign::unknown;
  }
};

/// The category by the signs of how far the volume is apart from each plane and side, and of how far it
/// reaches beyond it: outside when one is apart, inside when none is reached beyond. Nothing where a sign
/// that matters is unknown.
[[nodiscard]] inline std::optional<scene::Category> category_of(const SignFold& apart,
                                                                const SignFold& beyond) {
  if (apart.any_positive) return scene::Category::outside;
  if (apart.any_unknown) return std::nullopt;
  if (beyond.any_positive) return scene::Category::overlap;
  if (beyond.any_unknown) return std::nullopt;
  return scene::Category::inside;
}

/// Coordinates up to this size overflow no interval of ours (products of four, the most that a gap takes).
inline constexpr double kLargestInIntervals = 1e70;

/// An upper bound on |x|, for intervals that have not overflowed.
[[nodiscard]] inline double magnitude_bound(const CGAL::Interval_nt<false>& x) {
  return std::fmax(std::fabs(x.inf()), std::fabs(x.sup()));
}

}  // namespace gnomon::exact
