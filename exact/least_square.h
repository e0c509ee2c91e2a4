// SPDX-License-Identifier: GPL-3.0-or-later
// The least |u|^2 over a polyhedron of R^3, by its finitely many candidates. Internal to exact/.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "exact/half_spaces.h"
#include "exact/number.h"
#include "exact/vector.h"

namespace gnomon::exact {

/// r.u <= b; r may be 0.
template <class FT>
struct Row {
  Vector<FT> r;
  FT b;
};

/// Up to three rows that hold with equality.
struct ActiveRows {
  std::array<std::uint8_t, 3> row{};
  std::uint8_t count = 0;
};

/// The point u / divisor of least length among those that hold the active rows with equality, and its squared
/// length square / square_divisor. No such single point is known when `divisor` is 0.
template <class FT>
struct Candidate {
  Vector<FT> u;
  FT divisor, square, square_divisor;
};

/// The minimum is the least-norm point of some independent active rows (Karush, Kuhn, Tucker; Caratheodory),
/// so that it is among the candidates of all sets of at most three rows that satisfy the other rows; and each
/// of those bounds it from above.
template <class FT>
[[nodiscard]] Candidate<FT> candidate_of(std::span<const Row<FT>> rows, const ActiveRows& active) {
  const auto combined = [](const FT& x, const Vector<FT>& p, const FT& y, const Vector<FT>& q) {
    return Vector<FT>{FT(x * p[0] + y * q[0]), FT(x * p[1] + y * q[1]), FT(x * p[2] + y * q[2])};
  };
  Candidate<FT> c{{FT(0), FT(0), FT(0)}, FT(1), FT(0), FT(1)};
  if (active.count == 0) return c;
  const Row<FT>& p = rows[active.row[0]];
  if (active.count == 1) {
    c.u = {FT(p.b * p.r[0]), FT(p.b * p.r[1]), FT(p.b * p.r[2])};
    c.divisor = c.square_divisor = square(p.r);
    c.square = CGAL::square(p.b);
    return c;
  }
  const Row<FT>& q = rows[active.row[1]];
  const Vector<FT> w = cross(p.r, q.r);
  if (active.count == 2) {
    c.u = combined(p.b, cross(q.r, w), q.b, cross(w, p.r));
    c.divisor = c.square_divisor = square(w);
    c.square = square(combined(p.b, q.r, FT(-q.b), p.r));
    return c;
  }
  const Row<FT>& r = rows[active.row[2]];
  c.divisor = dot(w, r.r);
  c.u = combined(p.b, cross(q.r, r.r), q.b, cross(r.r, p.r));
  for (std::size_t i = 0; i < 3; ++i) c.u[i] += r.b * w[i];
  c.square = square(c.u);
  c.square_divisor = CGAL::square(c.divisor);
  return c;
}

/// Does the candidate satisfy all rows? negative: no, or it is none; positive: yes; unknown: the arithmetic
/// can't tell.
template <class FT>
[[nodiscard]] Sign holds(std::span<const Row<FT>> rows, const ActiveRows& active, const Candidate<FT>& c) {
  const Sign divisor = sign_of(c.divisor);
  if (divisor == Sign::zero) return Sign::negative;
  if (divisor == Sign::unknown) return Sign::unknown;
  bool unknown = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bool is_active = false;
    for (std::size_t k = 0; k < active.count; ++k) is_active |= active.row[k] == i;
    if (is_active) continue;
    const Sign beyond = sign_of(FT(dot(rows[i].r, c.u) - rows[i].b * c.divisor));
    if (beyond == Sign::unknown) {
      unknown = true;
    } else if (beyond == divisor) {
      return Sign::negative;
    }
  }
  return unknown ? Sign::unknown : Sign::positive;
}

/// Visits all sets of at most three rows that may hold the minimum, small ones first, until `visit` returns
/// false. The minimum is -(sum of the multipliers times b), so that a set of rows that are surely satisfied
/// at 0 can't hold it, unless it is the empty one.
template <class FT, class Visit>
void for_each_active_rows(std::span<const Row<FT>> rows, const Visit& visit_any) {
  const auto n = static_cast<std::uint8_t>(rows.size());
  std::array<bool, 14> may_exclude_0{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Sign sign = sign_of(rows[i].b);
    may_exclude_0[i] = sign == Sign::negative || sign == Sign::unknown;
  }
  const auto visit = [&](const ActiveRows& active) {
    bool may = active.count == 0;
    for (std::size_t k = 0; k < active.count; ++k) may |= may_exclude_0[active.row[k]];
    return !may || visit_any(active);
  };
  if (!visit(ActiveRows{})) return;
  for (std::uint8_t i = 0; i < n; ++i) {
    if (!visit(ActiveRows{{i}, 1})) return;
  }
  for (std::uint8_t i = 0; i < n; ++i) {
    for (std::uint8_t j = 0; j < i; ++j) {
      if (!visit(ActiveRows{{j, i}, 2})) return;
    }
  }
  for (std::uint8_t i = 0; i < n; ++i) {
    for (std::uint8_t j = 0; j < i; ++j) {
      for (std::uint8_t k = 0; k < j; ++k) {
        if (!visit(ActiveRows{{k, j, i}, 3})) return;
      }
    }
  }
}

}  // namespace gnomon::exact
