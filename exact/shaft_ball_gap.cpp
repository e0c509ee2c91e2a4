// SPDX-License-Identifier: GPL-3.0-or-later
// How far a ball is from the decision boundaries of `shaft-sphere`.
#include <cmath>
#include <optional>

#include "exact/scaling.h"
#include "exact/shaft.h"
#include "exact/shaft_ball.h"
#include "exact/slab_ball.h"

namespace gnomon::exact {

using scene::Box;
using scene::Category;
using scene::ShaftBallCase;

namespace {

/// No interval of ours overflows on such a case.
bool is_clear_of_overflow(const ShaftBallCase& c) {
  double largest = c.t.radius;
  for (const Box<double>* box : {&c.a, &c.b}) {
    for (const double x : box->c) largest = std::fmax(largest, std::fabs(x));
  }
  for (const double x : c.t.centre) largest = std::fmax(largest, std::fabs(x));
  return largest <= kLargestInIntervals;
}

/// r^2 - v^2 / |n|^2 where v <= 0, and r^2 + v^2 / |n|^2 where v > 0.
template <class K>
typename K::FT reach_beyond(const typename K::FT& value, const typename K::FT& squared_length,
                            const typename K::FT& square) {
  using FT = typename K::FT;
  const FT length = CGAL::square(value) / squared_length;
  const Sign sign = sign_of(value);
  if constexpr (std::is_same_v<FT, FilterKernel::FT>) {
    if (sign == Sign::unknown) return FT(FT(square - length).inf(), FT(square + length).sup());
  }
  return sign == Sign::positive ? FT(square + length) : FT(square - length);
}

template <class K>
typename K::FT inside_gap(const ShaftBallCase& c) {
  using FT = typename K::FT;
  const FT square = CGAL::square(FT(c.t.radius));
  const Shaft<K> shaft(c.a, c.b);
  std::optional<FT> most;
  const auto take = [&](const FT& value, const FT& squared_length) {
    const FT reach = reach_beyond<K>(value, squared_length, square);
    most = most ? FT((CGAL::max)(*most, reach)) : reach;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const FT x(c.t.centre[static_cast<std::size_t>(axis)]);
    take(FT(x - FT(shaft.extent().hi(axis))), FT(1));
    take(FT(FT(shaft.extent().lo(axis)) - x), FT(1));
  }
  for (const ShaftPlane<K>& plane : shaft.planes()) take(plane.value_at(c.t.centre), plane.squared_length());
  return *most;
}

/// An upper bound on |d^2 - r^2|: d^2 lies between 0 and its value at any s.
double outside_gap_bound(const ShaftBallCase& c) {
  using FT = FilterKernel::FT;
  const double s = DistanceOverS<double>(c.a, c.b, c.t.centre).minimiser();
  if (!(s >= 0 && s <= 1)) return HUGE_VAL;
  const FT square = CGAL::square(FT(c.t.radius));
  const FT at_s = DistanceOverS<FT>(c.a, c.b, c.t.centre).at(FT(s));
  return std::fmax(FT(at_s - square).sup(), square.sup());
}

/// The plane test's answer for the radius r + growth; empty when the filter can't tell.
template <class K>
std::optional<Category> grown_with(const ShaftBallCase& c, double growth) {
  using FT = typename K::FT;
  const Shaft<K> shaft(c.a, c.b);
  const FT r = FT(c.t.radius) + FT(growth), square = CGAL::square(r);
  SignFold apart, beyond;
  apart.add(sign_of(FT(squared_distance<FT>(c.t.centre, shaft.extent()) - square)));
  for (int axis = 0; axis < 3; ++axis) {
    const FT x(c.t.centre[static_cast<std::size_t>(axis)]);
    beyond.add(sign_of(FT(x + r - FT(shaft.extent().hi(axis)))));
    beyond.add(sign_of(FT(FT(shaft.extent().lo(axis)) + r - x)));
  }
  for (const ShaftPlane<K>& plane : shaft.planes()) {
    const FT value = plane.value_at(c.t.centre);
    const Sign side = sign_of(value);
    const Sign reach = sign_of(FT(CGAL::square(value) - square * plane.squared_length()));
    if (side == Sign::unknown || reach == Sign::unknown) {
      apart.any_unknown = beyond.any_unknown = true;
      continue;
    }
    apart.any_positive |= side == Sign::positive && reach == Sign::positive;
    beyond.any_positive |= side == Sign::positive || reach == Sign::negative;
  }
  return category_of(apart, beyond);
}

}  // namespace

Gap gap(const ShaftBallCase& c, Boundary boundary) {
  const Scaled<ShaftBallCase> scaled(c);
  const ShaftBallCase& near_one = scaled.c;
  using FT = RationalKernel::FT;
  FT value;
  if (boundary == Boundary::inside) {
    value = inside_gap<RationalKernel>(near_one);
  } else {
    const DistanceOverS<FT> distance(near_one.a, near_one.b, near_one.t.centre);
    value = distance.at(distance.minimiser()) - CGAL::square(FT(near_one.t.radius));
  }
  return scaled.gap_of_original(Gap(value.mpq()), 2);
}

double gap_bound(const ShaftBallCase& c, Boundary boundary) {
  const Scaled<ShaftBallCase> scaled(c);
  if (!is_clear_of_overflow(scaled.c)) return HUGE_VAL;
  const CGAL::Interval_nt<false>::Protector upward;
  const double bound = boundary == Boundary::inside ? magnitude_bound(inside_gap<FilterKernel>(scaled.c))
                                                    : outside_gap_bound(scaled.c);
  return scaled.bound_of_original(bound, 2);
}

Category classify_grown(const ShaftBallCase& c, double growth) {
  if (std::isinf(growth)) return Category::overlap;  // grown without bound, it meets and is not within
  const Scaled<ShaftBallCase> scaled(c);
  const double by = std::ldexp(growth, scaled.exponent);
  const bool exact = std::isfinite(by) && std::ldexp(by, -scaled.exponent) == growth;
  if (exact && is_clear_of_overflow(scaled.c) && by <= kLargestInIntervals) {
    const CGAL::Interval_nt<false>::Protector upward;
    if (const std::optional<Category> grown = grown_with<FilterKernel>(scaled.c, by)) return *grown;
  }
  return *grown_with<ExactKernel>(c, growth);
}

}  // namespace gnomon::exact
