// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/scene_measurement.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gnomon::fuzz {

std::uint64_t ShadowRow::truths(const Matrix& m, std::size_t truth) {
  return std::accumulate(m[truth].begin(), m[truth].end(), std::uint64_t{0});
}

bool ShadowRow::promise_broken() const {
  return is_broken(method->promise, unsound(matrix), column(matrix, kUndecided) + column(matrix, kRejected));
}

Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
  };
  return {at(0.5), at(0.25), at(0.75)};
}

bool Measurement::promise_broken() const {
  const auto broken = [](const auto& row) { return row.promise_broken(); };
  return std::any_of(rows.begin(), rows.end(), broken) ||
         std::any_of(hit_rows.begin(), hit_rows.end(), broken);
}

}  // namespace gnomon::fuzz
