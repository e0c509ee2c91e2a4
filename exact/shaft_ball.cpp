// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/shaft_ball.h"

#include <cmath>
#include <optional>

#include "exact/scaling.h"
#include "exact/shaft.h"
#include "exact/slab_ball.h"

namespace gnomon::exact {

using scene::Ball;
using scene::Box;
using scene::Category;
using scene::ShaftBallCase;

namespace {

/// The support function of the shaft in a direction: the larger one of both boxes' far corners.
template <class FT>
FT support(const ShaftBallCase& c, const std::array<double, 3>& n) {
  FT of_a(0), of_b(0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t far = n[axis] > 0 ? axis + 3 : axis;
    of_a += FT(n[axis]) * FT(c.a.c[far]);
    of_b += FT(n[axis]) * FT(c.b.c[far]);
  }
  return (CGAL::max)(of_a, of_b);
}

/// The sign of d^2 - r^2, d the distance from the centre to the shaft.
template <class K>
Sign distance_sign(const ShaftBallCase& c);

/// Intervals judge two certificates that doubles have guessed: any s bounds d from above, any direction from
/// below.
template <>
Sign distance_sign<FilterKernel>(const ShaftBallCase& c) {
  using FT = FilterKernel::FT;
  const FT square = CGAL::square(FT(c.t.radius));
  const double s = DistanceOverS<double>(c.a, c.b, c.t.centre).minimiser();
  if (!(s >= 0 && s <= 1)) return Sign::unknown;
  const FT at_s = DistanceOverS<FT>(c.a, c.b, c.t.centre).at(FT(s));
  const Sign above = sign_of(FT(at_s - square));
  if (above == Sign::negative) return Sign::negative;
  std::array<double, 3> n{};
  double length = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int i = static_cast<int>(axis);
    const double lo = c.a.lo(i) + s * (c.b.lo(i) - c.a.lo(i)), hi = c.a.hi(i) + s * (c.b.hi(i) - c.a.hi(i));
    const double x = c.t.centre[axis];
    n[axis] = x < lo ? x - lo : x > hi ? x - hi : 0;
    length += n[axis] * n[axis];
  }
  if (!(length > 0) || std::isinf(length)) return Sign::unknown;
  FT beyond = -support<FT>(c, n), squared_length(0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    beyond += FT(n[axis]) * FT(c.t.centre[axis]);
    squared_length += CGAL::square(FT(n[axis]));
  }
  if (sign_of(beyond) == Sign::positive &&
      sign_of(FT(CGAL::square(beyond) - square * squared_length)) == Sign::positive) {
    return Sign::positive;
  }
  return Sign::unknown;
}

template <class K>
Sign distance_sign(const ShaftBallCase& c) {
  using FT = typename K::FT;
  const DistanceOverS<FT> distance(c.a, c.b, c.t.centre);
  return sign_of(FT(distance.at(distance.minimiser()) - CGAL::square(FT(c.t.radius))));
}

/// The signs that planes and extent sides give: of v itself, and of |v| against r |n|.
struct PlaneSign {
  Sign value, reach;  ///< of v; of v^2 - r^2 |n|^2
};

template <class K>
PlaneSign sign_at(const ShaftPlane<K>& plane, const Ball<double>& t) {
  using FT = typename K::FT;
  const FT value = plane.value_at(t.centre);
  const FT reach = CGAL::square(value) - CGAL::square(FT(t.radius)) * plane.squared_length();
  return {sign_of(value), sign_of(reach)};
}

/// The sign of (distance kept from a side) - r, folded over the six sides as "what lies beyond r" is
/// positive.
template <class K>
void add_sides(SignFold& fold, const Box<double>& extent, const Ball<double>& t) {
  using FT = typename K::FT;
  for (int axis = 0; axis < 3; ++axis) {
    const FT x(t.centre[static_cast<std::size_t>(axis)]), r(t.radius);
    fold.add(sign_of(FT(x + r - FT(extent.hi(axis)))));
    fold.add(sign_of(FT(FT(extent.lo(axis)) + r - x)));
  }
}

/// "The ball reaches beyond this plane" as a sign: positive, touching, or not; unknown where it matters and
/// is.
Sign beyond_sign(const PlaneSign& s) {
  if (s.value == Sign::positive) return Sign::positive;
  if (s.reach == Sign::negative) return Sign::positive;  // |v| < r |n|, whatever the sign of v
  if (s.value == Sign::unknown || s.reach == Sign::unknown) return Sign::unknown;
  return s.reach == Sign::zero ? Sign::zero : Sign::negative;
}

/// "The ball lies wholly beyond this plane": v > 0 and v^2 > r^2 |n|^2.
Sign apart_sign(const PlaneSign& s) {
  if (s.value == Sign::negative || s.value == Sign::zero || s.reach == Sign::negative ||
      s.reach == Sign::zero) {
    return Sign::negative;
  }
  if (s.value == Sign::unknown || s.reach == Sign::unknown) return Sign::unknown;
  return Sign::positive;
}

/// As printed, "T > -radius": v > 0, or v = 0 and r > 0, or v^2 < r^2 |n|^2.
Sign printed_inside_sign(const PlaneSign& s, double radius) {
  if (s.value == Sign::positive) return Sign::positive;
  if (s.value == Sign::zero) return radius > 0 ? Sign::positive : Sign::negative;
  if (s.value == Sign::unknown || s.reach == Sign::unknown) return Sign::unknown;
  return s.reach == Sign::negative ? Sign::positive : Sign::negative;
}

/// Is the centre on the boundary of the shaft or beyond it? What a ball of radius 0 touches by.
template <class K>
SignFold point_signs(const Shaft<K>& shaft, const std::array<double, 3>& p) {
  SignFold fold;
  for (int axis = 0; axis < 3; ++axis) {
    const double x = p[static_cast<std::size_t>(axis)];
    fold.add(sign_of_difference(x, shaft.extent().hi(axis)));
    fold.add(sign_of_difference(shaft.extent().lo(axis), x));
  }
  for (const ShaftPlane<K>& plane : shaft.planes()) fold.add(sign_of(plane.value_at(p)));
  return fold;
}

template <class K>
std::optional<ShaftBallReference> refer_with(const ShaftBallCase& c) {
  using FT = typename K::FT;
  const Shaft<K> shaft(c.a, c.b);
  const FT square = CGAL::square(FT(c.t.radius));

  SignFold beyond, apart;
  bool printed_inside = true, printed_unknown = false;
  add_sides<K>(beyond, shaft.extent(), c.t);
  if (beyond.any_positive) printed_inside = false;
  if (!beyond.any_positive && beyond.any_unknown) return std::nullopt;
  apart.add(sign_of(FT(squared_distance<FT>(c.t.centre, shaft.extent()) - square)));
  for (const ShaftPlane<K>& plane : shaft.planes()) {
    const PlaneSign sign = sign_at(plane, c.t);
    beyond.add(beyond_sign(sign));
    apart.add(apart_sign(sign));
    const Sign inside = printed_inside_sign(sign, c.t.radius);
    printed_inside &= inside == Sign::positive;
    printed_unknown |= inside == Sign::unknown;
  }
  if (!apart.any_positive && apart.any_unknown) return std::nullopt;
  if (!beyond.any_positive && beyond.any_unknown) return std::nullopt;

  const Sign distance = distance_sign<K>(c);
  if (distance == Sign::unknown) return std::nullopt;
  const bool inside = !beyond.any_positive;

  ShaftBallReference reference{};
  reference.truth = distance == Sign::positive ? Category::outside
                    : inside                   ? Category::inside
                                               : Category::overlap;
  reference.planes = apart.any_positive ? Category::outside : inside ? Category::inside : Category::overlap;
  reference.touches_outside = distance == Sign::zero;
  if (distance == Sign::zero && c.t.radius == 0) {
    const SignFold at_centre = point_signs(shaft, c.t.centre);
    if (at_centre.any_unknown) return std::nullopt;
    reference.touches_outside = at_centre.any_zero;
  }
  reference.touches_inside = inside && beyond.any_zero;

  // As printed: extent box, reference boxes, planes, then the inverted sign for inside.
  reference.printed = Category::outside;
  if (!apart.any_positive) {
    const Sign to_a = sign_of(FT(squared_distance<FT>(c.t.centre, c.a) - square));
    const Sign to_b = sign_of(FT(squared_distance<FT>(c.t.centre, c.b) - square));
    const bool meets_one = (to_a != Sign::positive && to_a != Sign::unknown) ||
                           (to_b != Sign::positive && to_b != Sign::unknown);
    if (!meets_one && (to_a == Sign::unknown || to_b == Sign::unknown)) return std::nullopt;
    if (!meets_one && printed_unknown) return std::nullopt;
    reference.printed = !meets_one && printed_inside ? Category::inside : Category::overlap;
  }
  return reference;
}

}  // namespace

std::uint64_t refer(std::span<const ShaftBallCase> cases, std::span<ShaftBallReference> references) {
  std::uint64_t in_rationals = 0;
  const CGAL::Interval_nt<false>::Protector upward;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::optional<ShaftBallReference> reference = refer_with<FilterKernel>(cases[i]);
    if (!reference) {
      ++in_rationals;
      const Scaled<ShaftBallCase> scaled(cases[i]);
      if (scaled.exponent != 0) reference = refer_with<FilterKernel>(scaled.c);
      if (!reference) reference = refer_with<ExactKernel>(scaled.c);
    }
    references[i] = *reference;
  }
  return in_rationals;
}

ShaftBallReference refer_in_rationals(const ShaftBallCase& c) {
  return *refer_with<RationalKernel>(c);
}

namespace {

template <class K>
std::optional<Category> truth_of(const ShaftBallCase& c) {
  const Sign distance = distance_sign<K>(c);
  if (distance == Sign::positive) return Category::outside;
  if (distance == Sign::unknown) return std::nullopt;
  const Shaft<K> shaft(c.a, c.b);
  SignFold beyond;
  add_sides<K>(beyond, shaft.extent(), c.t);
  for (const ShaftPlane<K>& plane : shaft.planes()) {
    if (beyond.any_positive) return Category::overlap;
    beyond.add(beyond_sign(sign_at(plane, c.t)));
  }
  if (beyond.any_positive) return Category::overlap;
  if (beyond.any_unknown) return std::nullopt;
  return Category::inside;
}

}  // namespace

Category classify(const ShaftBallCase& c) {
  const Scaled<ShaftBallCase> scaled(c);
  {
    const CGAL::Interval_nt<false>::Protector upward;
    if (const std::optional<Category> truth = truth_of<FilterKernel>(scaled.c)) return *truth;
  }
  return *truth_of<ExactKernel>(scaled.c);
}

bool meets(const ShaftBallCase& c) {
  const Scaled<ShaftBallCase> scaled(c);
  Sign distance = Sign::unknown;
  {
    const CGAL::Interval_nt<false>::Protector upward;
    distance = distance_sign<FilterKernel>(scaled.c);
  }
  if (distance == Sign::unknown) distance = distance_sign<ExactKernel>(scaled.c);
  return distance != Sign::positive;
}

}  // namespace gnomon::exact
