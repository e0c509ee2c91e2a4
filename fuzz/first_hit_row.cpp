// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/first_hit_row.h"

#include <numeric>

namespace gnomon::fuzz {

std::uint64_t FirstHitRow::truths(const Matrix& m, std::size_t truth) {
  return std::accumulate(m[truth].begin(), m[truth].end(), std::uint64_t{0});
}

bool FirstHitRow::promise_broken() const {
  switch (method->promise) {
    case Promise::none:
      return false;
    case Promise::never_unsound:
      return unsound(matrix) > 0;
    case Promise::always_agrees:
      return unsound(matrix) + column(matrix, undecided) + column(matrix, rejected) > 0;
  }
  return false;
}

}  // namespace gnomon::fuzz
