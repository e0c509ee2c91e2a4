// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/first_hit_row.h"

#include <numeric>

namespace gnomon::fuzz {

std::uint64_t FirstHitRow::truths(const Matrix& m, std::size_t truth) {
  return std::accumulate(m[truth].begin(), m[truth].end(), std::uint64_t{0});
}

bool FirstHitRow::promise_broken() const {
  return is_broken(method->promise, unsound(matrix), column(matrix, undecided) + column(matrix, rejected));
}

}  // namespace gnomon::fuzz
