// SPDX-License-Identifier: GPL-3.0-or-later
//
// t is { c + M u : |u| <= 1 }. A half-space n.x + d <= 0 of the shaft is the row (M^T n).u <= -(n.c + d) in
// u, so that t meets the shaft when the least |u|^2 over the polyhedron of all rows is at most 1: a quadratic
// program in three variables, decided by +, -, * alone. A singular M needs no case of its own: the polyhedron
// may then be empty.
//
// Touching. With q the least |u|^2: q = 1 touches (the multipliers of the active rows add up to a normal that
// keeps t and shaft apart weakly). For q < 1 a normal n that does so must be orthogonal to all columns of M,
// as |u| < 1 can move both ways along them; t is then a point to n, and n is one of the normals of a
// parallelepiped with these edges (separating_axes.h), because only the projection of the shaft along M's
// range matters.
#include "exact/shaft_ellipsoid.h"

#include <boost/container/small_vector.hpp>
#include <cmath>
#include <optional>

#include "exact/least_square.h"
#include "exact/scaling.h"
#include "exact/separating_axes.h"

namespace gnomon::exact {

using scene::Category;
using scene::Ellipsoid;
using scene::ShaftEllipsoidCase;

namespace {

using Interval = FilterKernel::FT;

template <class FT>
Vector<FT> vector_of(const std::array<double, 3>& v) {
  return {FT(v[0]), FT(v[1]), FT(v[2])};
}

/// The rows of the shaft's half-spaces, in their order; each may be scaled, as only signs matter.
template <class FT>
class Rows {
 public:
  explicit Rows(const ShaftEllipsoidCase& c) {
    const HalfSpaces<FT> half_spaces(c.a, c.b);
    const Vector<FT> centre = vector_of<FT>(c.t.centre);
    std::array<Vector<FT>, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) columns[i] = vector_of<FT>(c.t.axes[i]);
    for (const HalfSpace<FT>& h : half_spaces.all()) {
      growth_[count_] = growth_of(h.n);
      rows_[count_++] = {{dot(h.n, columns[0]), dot(h.n, columns[1]), dot(h.n, columns[2])},
                         FT(-(dot(h.n, centre) + h.d))};
    }
  }

  [[nodiscard]] std::span<const Row<FT>> all() const { return {rows_.data(), count_}; }
  [[nodiscard]] const FT& growth(std::size_t i) const { return growth_[i]; }

  /// Brings each row near 1 by a power of two: products of ten of its numbers would overflow otherwise.
  void scale() {
    for (std::size_t i = 0; i < count_; ++i) {
      Row<FT>& row = rows_[i];
      double largest = magnitude_bound(row.b);
      for (const FT& x : row.r) largest = std::fmax(largest, magnitude_bound(x));
      if (!(largest > 0x1p-900 && largest < 0x1p900)) continue;
      const FT factor(std::ldexp(1.0, -std::ilogb(largest)));
      row.b *= factor;
      for (FT& x : row.r) x *= factor;
    }
  }

 private:
  std::array<Row<FT>, 14> rows_;
  std::array<FT, 14> growth_;
  std::size_t count_ = 0;
};

/// t lies wholly beyond the plane of a row: negative b, and b^2 > |r|^2. Positive: it does.
template <class FT>
Sign apart_sign(const FT& b, const FT& squared_reach) {
  const Sign value = sign_of(b);
  if (value == Sign::positive || value == Sign::zero) return Sign::negative;
  const Sign reach = sign_of(FT(CGAL::square(b) - squared_reach));
  if (reach == Sign::negative || reach == Sign::zero) return Sign::negative;
  return value == Sign::unknown || reach == Sign::unknown ? Sign::unknown : Sign::positive;
}

/// t reaches beyond the plane of a row: positive; zero: it touches it from within.
template <class FT>
Sign beyond_sign(const FT& b, const FT& squared_reach) {
  const Sign value = sign_of(b);
  if (value == Sign::negative) return Sign::positive;
  const Sign reach = sign_of(FT(squared_reach - CGAL::square(b)));
  if (reach == Sign::positive) return Sign::positive;  // whatever the sign of b
  return value == Sign::unknown ? Sign::unknown : reach;
}

/// Signs by the arithmetic Quick, and by exact numbers, made when first needed, where that can't tell.
template <class Quick>
class Decision {
 public:
  explicit Decision(const ShaftEllipsoidCase& c) : original_(c), quick_(c) {
    if constexpr (std::is_same_v<Quick, Interval>) quick_.scale();
  }

  [[nodiscard]] VolumeReference decide() {
    constexpr VolumeReference kOutside{Category::outside, Category::outside, Category::outside, false, false};
    VolumeReference r{Category::overlap, Category::overlap, Category::overlap, false, false};
    const std::size_t count = quick_.all().size();
    for (std::size_t i = 0; i < count; ++i) {
      if (sign(i, [](const auto& b, const auto& reach) { return apart_sign(b, reach); }) == Sign::positive) {
        return kOutside;
      }
    }
    if (!centre_surely_inside()) {
      const Sign least = least_square_against_1();
      if (least == Sign::positive) {
        r.truth = Category::outside;
        return r;
      }
      r.touches_outside = least == Sign::zero || touches_across();
    }
    SignFold beyond;
    for (std::size_t i = 0; i < count && !beyond.any_positive; ++i) {
      beyond.add(sign(i, [](const auto& b, const auto& reach) { return beyond_sign(b, reach); }));
    }
    if (!beyond.any_positive) {
      r.truth = r.planes = r.separating = Category::inside;
      r.touches_inside = beyond.any_zero;
    }
    return r;
  }

  [[nodiscard]] bool needed_exact_numbers() const { return exact_.has_value(); }

 private:
  using Exact = CGAL::Mpzf;

  template <class SignOf>
  Sign sign(std::size_t i, const SignOf& sign_of_row) {
    const Row<Quick>& row = quick_.all()[i];
    const Sign quick = sign_of_row(row.b, square(row.r));
    if (quick != Sign::unknown) return quick;
    const Row<Exact>& exact = in_exact_numbers().all()[i];
    return sign_of_row(exact.b, square(exact.r));
  }

  [[nodiscard]] bool centre_surely_inside() const {
    bool inside = true;
    for (const Row<Quick>& row : quick_.all()) inside = inside && sign_of(row.b) == Sign::positive;
    return inside;
  }

  /// The sign of (least |u|^2) - 1; positive, too, where no u satisfies all rows.
  Sign least_square_against_1() {
    Sign least = Sign::positive;
    boost::container::small_vector<ActiveRows, 32> open;
    for_each_active_rows(quick_.all(), [&](const ActiveRows& active) {
      look_at<Quick>(quick_.all(), active, least, [&] { open.push_back(active); });
      return least != Sign::negative;
    });
    if (least == Sign::negative) return least;
    for (const ActiveRows& active : open) {
      look_at<Exact>(in_exact_numbers().all(), active, least, [] {});
      if (least == Sign::negative) break;
    }
    return least;
  }

  template <class FT, class IfUnknown>
  static void look_at(std::span<const Row<FT>> rows, const ActiveRows& active, Sign& least,
                      const IfUnknown& if_unknown) {
    const Candidate<FT> candidate = candidate_of(rows, active);
    const Sign against_1 = sign_of(FT(candidate.square - candidate.square_divisor));
    if (against_1 == Sign::positive) return;
    const Sign holding = holds(rows, active, candidate);
    if (holding == Sign::negative) return;
    if (holding == Sign::unknown || against_1 == Sign::unknown) return if_unknown();
    if (against_1 == Sign::negative || least == Sign::positive) least = against_1;
  }

  /// For singular M: does a normal across M's columns keep t and shaft apart weakly?
  [[nodiscard]] bool touches_across() const {
    const Ellipsoid<double>& t = original_.t;
    {
      const CGAL::Interval_nt<false>::Protector upward;
      std::array<Vector<Interval>, 3> about;
      for (std::size_t i = 0; i < 3; ++i) about[i] = vector_of<Interval>(t.axes[i]);
      const Sign determinant = sign_of(dot(cross(about[0], about[1]), about[2]));
      if (determinant == Sign::positive || determinant == Sign::negative) return false;
    }
    std::array<Vector<Exact>, 3> columns, across;
    for (std::size_t i = 0; i < 3; ++i) columns[i] = vector_of<Exact>(t.axes[i]);
    for (std::size_t i = 0; i < 3; ++i) across[i] = cross(columns[(i + 1) % 3], columns[(i + 2) % 3]);
    if (sign_of(dot(across[0], columns[0])) != Sign::zero) return false;
    const SeparatingAxes<Exact> axes(original_.a, original_.b, columns, across);
    const Vector<Exact> centre = vector_of<Exact>(t.centre);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const Vector<Exact> n = axes.normal(i);
      if (is_zero(n)) continue;
      bool is_across = true;
      for (const Vector<Exact>& column : columns)
        is_across = is_across && sign_of(dot(n, column)) == Sign::zero;
      if (!is_across) continue;
      const Exact at = dot(n, centre);
      const Extremes<Exact> shaft = axes.of_shaft(n);
      if (sign_of(Exact(at - shaft.least)) == Sign::zero || sign_of(Exact(at - shaft.most)) == Sign::zero)
        return true;
    }
    return false;
  }

  const Rows<Exact>& in_exact_numbers() {
    if (!exact_) exact_.emplace(original_);
    return *exact_;
  }

  const ShaftEllipsoidCase& original_;
  Rows<Quick> quick_;
  std::optional<Rows<Exact>> exact_;
};

/// The bounds of the least |u|^2 by intervals, infinity where there may be none, and who may attain it.
struct SquareBounds {
  double least = HUGE_VAL, most = HUGE_VAL;
  boost::container::small_vector<ActiveRows, 32> attained_by;
};

/// The least |u|^2 that reaches a corner of one of the boxes, from above; infinity for singular M. Corners
/// lie on many planes at once, so that intervals alone seldom know the candidates there to hold.
double bound_by_corners(const ShaftEllipsoidCase& c) {
  std::array<Vector<Interval>, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) columns[i] = vector_of<Interval>(c.t.axes[i]);
  const Interval determinant = dot(cross(columns[0], columns[1]), columns[2]);
  const Sign sign = sign_of(determinant);
  if (sign != Sign::positive && sign != Sign::negative) return HUGE_VAL;
  double least = HUGE_VAL;
  for (const scene::Box<double>* box : {&c.a, &c.b}) {
    for (std::size_t corner = 0; corner < 8; ++corner) {
      Vector<Interval> to_corner;
      for (std::size_t i = 0; i < 3; ++i) {
        to_corner[i] = Interval(box->c[corner >> i & 1 ? i + 3 : i]) - Interval(c.t.centre[i]);
      }
      Interval sum(0);
      for (std::size_t i = 0; i < 3; ++i) {
        sum += CGAL::square(dot(cross(columns[(i + 1) % 3], columns[(i + 2) % 3]), to_corner) / determinant);
      }
      if (sum.sup() < least) least = sum.sup();
    }
  }
  return least;
}

SquareBounds bound_square(const ShaftEllipsoidCase& c) {
  const CGAL::Interval_nt<false>::Protector upward;
  Rows<Interval> rows(c);
  rows.scale();
  SquareBounds bounds;
  bounds.most = bound_by_corners(c);
  boost::container::small_vector<std::pair<double, ActiveRows>, 32> possible;
  for_each_active_rows(rows.all(), [&](const ActiveRows& active) {
    const Candidate<Interval> candidate = candidate_of(rows.all(), active);
    const Sign holding = holds(rows.all(), active, candidate);
    if (holding == Sign::negative) return true;
    const Interval value = candidate.square / candidate.square_divisor;
    const double low = std::isnan(value.inf()) ? 0 : std::fmax(0, value.inf());
    if (holding == Sign::positive && value.sup() < bounds.most) bounds.most = value.sup();
    bounds.least = std::fmin(bounds.least, low);
    possible.emplace_back(low, active);
    return true;
  });
  for (const auto& [low, active] : possible) {
    if (low <= bounds.most) bounds.attained_by.push_back(active);
  }
  return bounds;
}

/// From here on a gap is 1: the ellipsoid would have to be eight times as large.
constexpr double kFarSquare = 64;

/// The least |u|^2; nothing when no u satisfies all rows, or when it exceeds kFarSquare.
std::optional<CGAL::Gmpq> least_square(const ShaftEllipsoidCase& c) {
  const SquareBounds bounds = bound_square(c);
  if (bounds.least > kFarSquare) return std::nullopt;
  const Rows<CGAL::Gmpq> rows(c);
  std::optional<CGAL::Gmpq> least;
  for (const ActiveRows& active : bounds.attained_by) {
    const Candidate<CGAL::Gmpq> candidate = candidate_of(rows.all(), active);
    if (holds(rows.all(), active, candidate) != Sign::positive) continue;
    const CGAL::Gmpq square = candidate.square / candidate.square_divisor;
    if (!least || square < *least) least = square;
  }
  if (least && *least > CGAL::Gmpq(kFarSquare)) return std::nullopt;
  return least;
}

CGAL::Gmpq inside_gap(const ShaftEllipsoidCase& c) {
  const Rows<CGAL::Gmpq> rows(c);
  CGAL::Gmpq most(-1);
  for (const Row<CGAL::Gmpq>& row : rows.all()) {
    if (row.b < 0) return CGAL::Gmpq(1);
    const CGAL::Gmpq reach = square(row.r), kept = CGAL::square(row.b), sum = reach + kept;
    most = (std::max)(most, sum == 0 ? CGAL::Gmpq(0) : CGAL::Gmpq((reach - kept) / sum));
  }
  return most;
}

double inside_gap_bound(const ShaftEllipsoidCase& c) {
  const CGAL::Interval_nt<false>::Protector upward;
  Rows<Interval> rows(c);
  rows.scale();
  double least = -1, most = -1;
  for (const Row<Interval>& row : rows.all()) {
    const Interval reach = square(row.r), kept = CGAL::square(row.b), sum = reach + kept;
    if (sign_of(row.b) != Sign::positive || sign_of(sum) != Sign::positive) return 1;
    const Interval value = (reach - kept) / sum;
    if (std::isnan(value.inf()) || std::isnan(value.sup())) return 1;
    least = std::fmax(least, value.inf());
    most = std::fmax(most, value.sup());
  }
  return std::fmin(1, std::fmax(std::fabs(least), std::fabs(most)));
}

/// The plane test's answer after growth; empty when the filter can't tell.
template <class FT>
std::optional<Category> grown_with(const ShaftEllipsoidCase& c, double growth) {
  const Rows<FT> rows(c);
  SignFold apart, beyond;
  for (std::size_t i = 0; i < rows.all().size(); ++i) {
    const Row<FT>& row = rows.all()[i];
    const FT by = FT(growth) * rows.growth(i), reach = square(row.r);
    apart.add(apart_sign(FT(row.b + by), reach));
    beyond.add(beyond_sign(FT(row.b - by), reach));
  }
  return category_of(apart, beyond);
}

}  // namespace

std::uint64_t refer(std::span<const ShaftEllipsoidCase> cases, std::span<VolumeReference> references) {
  std::uint64_t in_exact_numbers = 0;
  const CGAL::Interval_nt<false>::Protector upward;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Scaled<ShaftEllipsoidCase> scaled(cases[i]);
    Decision<Interval> decision(scaled.c);
    references[i] = decision.decide();
    in_exact_numbers += decision.needed_exact_numbers();
  }
  return in_exact_numbers;
}

VolumeReference refer_in_rationals(const ShaftEllipsoidCase& c) {
  return Decision<CGAL::Gmpq>(c).decide();
}

Category classify(const ShaftEllipsoidCase& c) {
  VolumeReference reference;
  refer(std::span(&c, 1), std::span(&reference, 1));
  return reference.truth;
}

Gap gap(const ShaftEllipsoidCase& c, Boundary boundary) {
  const Scaled<ShaftEllipsoidCase> scaled(c);
  if (boundary == Boundary::inside) return Gap(inside_gap(scaled.c).mpq());
  const std::optional<CGAL::Gmpq> square = least_square(scaled.c);
  if (!square) return Gap(1);
  return Gap(CGAL::Gmpq((*square - 1) / (*square + 1)).mpq());
}

double gap_bound(const ShaftEllipsoidCase& c, Boundary boundary) {
  const Scaled<ShaftEllipsoidCase> scaled(c);
  if (boundary == Boundary::inside) return inside_gap_bound(scaled.c);
  const SquareBounds square = bound_square(scaled.c);
  const auto gap_of = [](double q) { return q <= kFarSquare ? std::fabs((q - 1) / (q + 1)) : 1; };
  // (q - 1) / (q + 1) rises with q; a few roundings on top.
  return std::fmin(1, std::fmax(gap_of(square.least), gap_of(square.most)) * (1 + 0x1p-48) + 0x1p-1000);
}

Category classify_grown(const ShaftEllipsoidCase& c, double growth) {
  if (std::isinf(growth)) return Category::overlap;  // grown without bound, it meets and is not within
  {
    const CGAL::Interval_nt<false>::Protector upward;
    if (const std::optional<Category> grown = grown_with<Interval>(c, growth)) return *grown;
  }
  return *grown_with<CGAL::Mpzf>(c, growth);
}

}  // namespace gnomon::exact
