// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/statistics.h"

#include <boost/math/distributions/binomial.hpp>

namespace gnomon::fuzz {

Rate rate_of(std::uint64_t hits, std::uint64_t trials) {
  if (trials == 0) return {};
  using Binomial = boost::math::binomial_distribution<double>;
  const double n = static_cast<double>(trials), k = static_cast<double>(hits);
  Rate rate;
  rate.value = k / n;
  rate.low95 = Binomial::find_lower_bound_on_p(n, k, 0.025);
  rate.high95 = Binomial::find_upper_bound_on_p(n, k, 0.025);
  return rate;
}

}  // namespace gnomon::fuzz
