// SPDX-License-Identifier: GPL-3.0-or-later
// Linear programs in rationals, small and slow: Dantzig's tableau in two phases, with Bland's rule, which
// can't cycle.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace gnomon::tests {

/// All x >= 0 with A x = b.
class ExactSimplex {
 public:
  using Row = std::vector<mpq_class>;

  /// Rows of A, each with its b as the last number.
  explicit ExactSimplex(std::vector<Row> rows) : rows_(std::move(rows)), columns_(rows_.front().size() - 1) {
    // One artificial variable a row, numbered from columns_ on; none of them ever comes back.
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i].back() < 0) {
        for (mpq_class& x : rows_[i]) x = -x;
      }
      basis_.push_back(columns_ + i);
    }
    Row cost(columns_ + 1, 0);
    for (const Row& row : rows_) {
      for (std::size_t j = 0; j <= columns_; ++j) cost[j] += row[j];
    }
    climb(cost);
    feasible_ = cost.back() == 0;
    for (std::size_t i = 0; feasible_ && i < rows_.size(); ++i) {
      if (basis_[i] < columns_) continue;
      std::size_t j = 0;
      while (j < columns_ && rows_[i][j] == 0) ++j;
      if (j < columns_) pivot(i, j, cost);  // else the row says 0 = 0
    }
  }

  [[nodiscard]] bool feasible() const { return feasible_; }

  /// The greatest value of c * x, which must be bounded; only if feasible().
  [[nodiscard]] mpq_class greatest(const std::vector<mpq_class>& c) const {
    ExactSimplex copy(*this);
    Row cost(c);
    cost.push_back(0);
    for (std::size_t i = 0; i < copy.rows_.size(); ++i) {
      if (copy.basis_[i] >= columns_ || c[copy.basis_[i]] == 0) continue;
      const mpq_class by = c[copy.basis_[i]];
      for (std::size_t j = 0; j <= columns_; ++j) cost[j] -= by * copy.rows_[i][j];
    }
    copy.climb(cost);
    return -cost.back();
  }

 private:
  /// Pivots until no column has a positive cost.
  void climb(Row& cost) {
    for (;;) {
      std::size_t j = 0;
      while (j < columns_ && cost[j] <= 0) ++j;
      if (j == columns_) return;
      std::optional<std::size_t> leaving;
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i][j] <= 0) continue;
        if (!leaving) {
          leaving = i;
          continue;
        }
        const mpq_class x = rows_[i].back() * rows_[*leaving][j], y = rows_[*leaving].back() * rows_[i][j];
        if (x < y || (x == y && basis_[i] < basis_[*leaving])) leaving = i;
      }
      if (!leaving) return;  // unbounded: none of ours is
      pivot(*leaving, j, cost);
    }
  }

  void pivot(std::size_t i, std::size_t j, Row& cost) {
    const mpq_class by = rows_[i][j];
    for (mpq_class& x : rows_[i]) x /= by;
    const auto clear = [&](Row& row) {
      const mpq_class times = row[j];
      if (times == 0) return;
      for (std::size_t k = 0; k <= columns_; ++k) row[k] -= times * rows_[i][k];
    };
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (k != i) clear(rows_[k]);
    }
    clear(cost);
    basis_[i] = j;
  }

  std::vector<Row> rows_;
  std::size_t columns_;
  std::vector<std::size_t> basis_;
  bool feasible_ = false;
};

}  // namespace gnomon::tests
