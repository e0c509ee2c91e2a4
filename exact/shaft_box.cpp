// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/shaft_box.h"

#include <cmath>
#include <optional>

#include "exact/scaling.h"
#include "exact/shaft.h"
#include "exact/slab_box.h"

namespace gnomon::exact {

using scene::Box;
using scene::Category;
using scene::ShaftBoxCase;

namespace {

bool meets(const Box<double>& t, const Box<double>& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (t.lo(axis) > box.hi(axis) || t.hi(axis) < box.lo(axis)) return false;
  }
  return true;
}

/// Truth; empty when the filter can't tell.
template <class K>
std::optional<Category> truth_of(const ShaftBoxCase& c) {
  switch (common_s<K>(c.a, c.b, c.t)) {
    case Sign::negative:
      return Category::outside;
    case Sign::unknown:
      return std::nullopt;
    default:
      break;
  }
  switch (every_corner_s<K>(c.a, c.b, c.t)) {
    case Sign::negative:
      return Category::overlap;
    case Sign::unknown:
      return std::nullopt;
    default:
      return Category::inside;
  }
}

/// The signs of all near and far values, extent sides first (those are exact comparisons).
template <class K>
struct PlaneSigns {
  SignFold near, far;

  PlaneSigns(const Shaft<K>& shaft, const Box<double>& t) {
    const Box<double>& extent = shaft.extent();
    for (int axis = 0; axis < 3; ++axis) {
      near.add(sign_of_difference(t.lo(axis), extent.hi(axis)));
      near.add(sign_of_difference(extent.lo(axis), t.hi(axis)));
      far.add(sign_of_difference(t.hi(axis), extent.hi(axis)));
      far.add(sign_of_difference(extent.lo(axis), t.lo(axis)));
    }
    for (const ShaftPlane<K>& plane : shaft.planes()) {
      if (near.any_positive) return;
      near.add(sign_of(plane.near_value(t)));
    }
    for (const ShaftPlane<K>& plane : shaft.planes()) {
      if (near.any_positive || far.any_positive) return;
      far.add(sign_of(plane.far_value(t)));
    }
  }
};

template <class K>
std::optional<ShaftBoxReference> refer_with(const ShaftBoxCase& c) {
  const std::optional<Category> truth = truth_of<K>(c);
  if (!truth) return std::nullopt;
  const PlaneSigns<K> signs(Shaft<K>(c.a, c.b), c.t);

  ShaftBoxReference reference{*truth, Category::outside, Category::outside, false, false};
  if (signs.near.any_positive) return reference;
  if (signs.near.any_unknown) return std::nullopt;
  reference.touches_outside = signs.near.any_zero;
  reference.planes = Category::overlap;
  if (!signs.far.any_positive) {
    if (signs.far.any_unknown) return std::nullopt;
    reference.planes = Category::inside;
    reference.touches_inside = signs.far.any_zero;
  }
  reference.printed = meets(c.t, c.a) || meets(c.t, c.b) ? Category::overlap : reference.planes;
  return reference;
}

template <class K>
typename K::FT gap_with(const ShaftBoxCase& c, Boundary boundary) {
  using FT = typename K::FT;
  const Shaft<K> shaft(c.a, c.b);
  const Box<double>& extent = shaft.extent();
  const bool near = boundary == Boundary::outside;
  std::optional<FT> most;
  const auto take = [&most](const FT& value) { most = most ? FT((CGAL::max)(*most, value)) : value; };
  for (int axis = 0; axis < 3; ++axis) {
    take(FT(near ? c.t.lo(axis) : c.t.hi(axis)) - FT(extent.hi(axis)));
    take(FT(extent.lo(axis)) - FT(near ? c.t.hi(axis) : c.t.lo(axis)));
  }
  for (const ShaftPlane<K>& plane : shaft.planes()) {
    take((near ? plane.near_value(c.t) : plane.far_value(c.t)) / plane.growth());
  }
  return *most;
}

bool is_clear_of_overflow(const ShaftBoxCase& c) {
  for (const Box<double>* box : {&c.a, &c.b, &c.t}) {
    for (const double x : box->c) {
      if (!(std::fabs(x) <= kLargestInIntervals)) return false;
    }
  }
  return true;
}

}  // namespace

std::uint64_t refer(std::span<const ShaftBoxCase> cases, std::span<ShaftBoxReference> references) {
  std::uint64_t in_rationals = 0;
  const CGAL::Interval_nt<false>::Protector upward;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::optional<ShaftBoxReference> reference = refer_with<FilterKernel>(cases[i]);
    if (!reference) {
      ++in_rationals;
      const Scaled<ShaftBoxCase> scaled(cases[i]);
      if (scaled.exponent != 0) reference = refer_with<FilterKernel>(scaled.c);
      if (!reference) reference = refer_with<ExactKernel>(scaled.c);
    }
    references[i] = *reference;
  }
  return in_rationals;
}

ShaftBoxReference refer_in_rationals(const ShaftBoxCase& c) {
  return *refer_with<RationalKernel>(c);
}

Category classify(const ShaftBoxCase& c) {
  const Scaled<ShaftBoxCase> scaled(c);
  {
    const CGAL::Interval_nt<false>::Protector upward;
    if (const std::optional<Category> truth = truth_of<FilterKernel>(scaled.c)) return *truth;
  }
  return *truth_of<ExactKernel>(scaled.c);
}

Gap gap(const ShaftBoxCase& c, Boundary boundary) {
  const Scaled<ShaftBoxCase> scaled(c);
  return scaled.gap_of_original(Gap(gap_with<RationalKernel>(scaled.c, boundary).mpq()), 1);
}

double gap_bound(const ShaftBoxCase& c, Boundary boundary) {
  const Scaled<ShaftBoxCase> scaled(c);
  if (!is_clear_of_overflow(scaled.c)) return HUGE_VAL;
  const CGAL::Interval_nt<false>::Protector upward;
  return scaled.bound_of_original(magnitude_bound(gap_with<FilterKernel>(scaled.c, boundary)), 1);
}

namespace {

/// The answer after growth, from both gaps; empty when the filter can't tell.
template <class K>
std::optional<Category> grown_with(const ShaftBoxCase& c, double growth) {
  using FT = typename K::FT;
  const Sign beyond = sign_of(FT(gap_with<K>(c, Boundary::outside) - FT(growth)));
  if (beyond == Sign::unknown) return std::nullopt;
  if (beyond == Sign::positive) return Category::outside;
  const Sign sticking_out = sign_of(FT(gap_with<K>(c, Boundary::inside) + FT(growth)));
  if (sticking_out == Sign::unknown) return std::nullopt;
  return sticking_out == Sign::positive ? Category::overlap : Category::inside;
}

}  // namespace

Category classify_grown(const ShaftBoxCase& c, double growth) {
  if (std::isinf(growth)) return Category::overlap;  // grown without bound, it meets and is not within
  const Scaled<ShaftBoxCase> scaled(c);
  const double by = std::ldexp(growth, scaled.exponent);
  const bool exact = std::isfinite(by) && std::ldexp(by, -scaled.exponent) == growth;
  if (exact && is_clear_of_overflow(scaled.c) && by <= kLargestInIntervals) {
    const CGAL::Interval_nt<false>::Protector upward;
    if (const std::optional<Category> grown = grown_with<FilterKernel>(scaled.c, by)) return *grown;
  }
  return *grown_with<ExactKernel>(c, growth);
}

}  // namespace gnomon::exact
