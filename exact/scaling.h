// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of very large or very small numbers, brought near 1 by a power of two: the questions do not care, and
// the filter does. Internal to exact/.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/gap.h"
#include "scene/shaft_case.h"

namespace gnomon::exact {

template <class Visit>
void for_each_number(scene::ShaftBoxCase& c, const Visit& visit) {
  for (scene::Box<double>* box : {&c.a, &c.b, &c.t}) std::for_each(box->c.begin(), box->c.end(), visit);
}

template <class Visit>
void for_each_number(scene::ShaftBallCase& c, const Visit& visit) {
  for (scene::Box<double>* box : {&c.a, &c.b}) std::for_each(box->c.begin(), box->c.end(), visit);
  std::for_each(c.t.centre.begin(), c.t.centre.end(), visit);
  visit(c.t.radius);
}

/// The case times 2^exponent, exactly; exponent is 0 for cases that lie near enough to 1, or that would lose
/// digits.
template <class Case>
struct Scaled {
  Case c;
  int exponent = 0;

  explicit Scaled(const Case& original) : c(original) {
    constexpr double kNear = 1e60;
    double largest = 0;
    for_each_number(c, [&](double& x) { largest = std::max(largest, std::fabs(x)); });
    if (largest == 0 || (largest <= kNear && largest >= 1 / kNear)) return;
    exponent = -std::ilogb(largest);
    bool exact = true;
    for_each_number(c, [&](double& x) {
      const double scaled = std::ldexp(x, exponent);
      exact = exact && std::ldexp(scaled, -exponent) == x;
      x = scaled;
    });
    if (exact) return;
    c = original;
    exponent = 0;
  }

  /// A gap of the scaled case as one of the original; `degree` is 1 for lengths, 2 for squares.
  [[nodiscard]] Gap gap_of_original(Gap gap, int degree) const {
    const int by = -exponent * degree;
    if (by > 0) mpq_mul_2exp(gap.get_mpq_t(), gap.get_mpq_t(), static_cast<mp_bitcnt_t>(by));
    if (by < 0) mpq_div_2exp(gap.get_mpq_t(), gap.get_mpq_t(), static_cast<mp_bitcnt_t>(-by));
    return gap;
  }

  /// An upper bound on a gap of the scaled case as one on the original's.
  [[nodiscard]] double bound_of_original(double bound, int degree) const {
    return exponent == 0 ? bound : std::nextafter(std::ldexp(bound, -exponent * degree), HUGE_VAL);
  }
};

}  // namespace gnomon::exact
