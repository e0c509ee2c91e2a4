// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/patches_ball.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/face_contact.h"
#include "exact/segments_over_s.h"

namespace gnomon::exact {

namespace {

using scene::Ball;
using Point = std::array<double, 3>;

template <class FT>
using Six = std::array<Vector<FT>, 6>;

template <class FT>
Vector<FT> vector_of(const Point& p) {
  return {FT(p[0]), FT(p[1]), FT(p[2])};
}

template <class FT>
Six<FT> six(const SixPoints& points) {
  Six<FT> result;
  for (std::size_t i = 0; i < 6; ++i) result[i] = vector_of<FT>(points[i]);
  return result;
}

/// p is a point of an open segment between the triangles.
template <class FT>
bool is_between(const Six<FT>& v, const Vector<FT>& p) {
  RangeOfS<FT> range(Ends::open);
  return SegmentsOverS<FT>({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {p, p, p}).for_each([&](LinearInS<FT> f) {
    return range.add(std::move(f));
  });
}

/// The mean of three corners with these weights, over w > 0; d is w times its squared distance to c.
template <class FT>
struct Foot {
  std::array<std::size_t, 3> corners{};
  std::array<FT, 3> weights;
  FT w, d;
};

/// Calls `visit` with the nearest point to c of every corner, edge and triangle of the six points that is
/// orthogonal to its side of c. The nearest point of the hull is one of them unless c is an inner point: the
/// hull's faces are made up of such triangles. `visit` returns true to stop.
template <class FT, class Visit>
void for_each_foot(const Six<FT>& v, const Vector<FT>& c, Visit&& visit) {
  const auto not_negative = [](const FT& x) { return !(x < FT(0)); };
  Six<FT> to_c;
  for (std::size_t i = 0; i < 6; ++i) to_c[i] = difference(c, v[i]);
  for (std::size_t i = 0; i < 6; ++i) {
    if (visit(Foot<FT>{{i, i, i}, {FT(1), FT(0), FT(0)}, FT(1), square(to_c[i])})) return;
    for (std::size_t j = i + 1; j < 6; ++j) {
      const Vector<FT> e = difference(v[j], v[i]);
      const FT length = square(e), along = dot(e, to_c[i]);
      const FT rest = length - along;
      if (FT(0) < length && not_negative(along) && not_negative(rest)) {
        const FT d = square(to_c[i]) * length - CGAL::square(along);
        // d / length is the square of the distance.
        if (visit(Foot<FT>{{i, j, j}, {rest, along, FT(0)}, length, d})) return;
      }
      for (std::size_t k = j + 1; k < 6; ++k) {
        const Vector<FT> f = difference(v[k], v[i]);
        const Vector<FT> n = cross(e, f);
        const FT area = square(n);
        if (!(FT(0) < area)) continue;
        const FT of_k = dot(n, cross(e, to_c[i])), of_j = dot(n, cross(to_c[i], f));
        const FT of_i = area - of_k - of_j;
        if (!not_negative(of_k) || !not_negative(of_j) || !not_negative(of_i)) continue;
        if (visit(Foot<FT>{{i, j, k}, {of_i, of_j, of_k}, area, CGAL::square(dot(n, to_c[i]))})) return;
      }
    }
  }
}

/// In exact numbers alone.
bool blocks_exactly(const SixPoints& points, const Ball<double>& ball) {
  using FT = ExactFloat;
  const Six<FT> v = six<FT>(points);
  const Vector<FT> c = vector_of<FT>(ball.centre);
  if (is_between(v, c)) return true;
  const FT squared_radius = CGAL::square(FT(ball.radius));
  bool less = false;
  std::optional<Foot<FT>> tangent;
  for_each_foot(v, c, [&](const Foot<FT>& foot) {
    const Sign sign = sign_of(FT(foot.d - squared_radius * foot.w));
    less = sign == Sign::negative;
    if (sign == Sign::zero) tangent = foot;
    return less;
  });
  if (less || !tangent) return less;
  // The one nearest point, as a quotient.
  using Q = ExactKernel::FT;
  Vector<Q> nearest;
  for (std::size_t i = 0; i < 3; ++i) {
    FT sum(0);
    for (std::size_t k = 0; k < 3; ++k) sum = sum + tangent->weights[k] * v[tangent->corners[k]][i];
    nearest[i] = Q(sum, tangent->w);
  }
  return is_between(six<Q>(points), nearest);
}

/// Seen from the centre, so that nothing is lost far from the origin; about right.
Six<double> seen_from(const Point& centre, const SixPoints& points) {
  Six<double> v;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) v[i][axis] = points[i][axis] - centre[axis];
  }
  return v;
}

/// What intervals can tell: doubles guess the nearest point, which bounds the distance from above, and whose
/// direction bounds it from below.
std::optional<bool> blocks_surely(const SixPoints& points, const Ball<double>& ball) {
  using FT = FilterKernel::FT;
  const Six<double> near = seen_from(ball.centre, points);
  std::optional<Foot<double>> best;
  for_each_foot(near, {0, 0, 0}, [&](const Foot<double>& foot) {
    if (!best || foot.d / foot.w < best->d / best->w) best = foot;
    return false;
  });
  const CGAL::Interval_nt<false>::Protector upward;
  const FT squared_radius = CGAL::square(FT(ball.radius));
  Six<FT> from_centre;
  for (std::size_t i = 0; i < 6; ++i) from_centre[i] = between<FT>(ball.centre, points[i]);
  // A point with weights that are not negative is one of the hull, whatever their sum is divided by.
  Vector<FT> nearest{FT(0), FT(0), FT(0)};
  FT sum(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const FT weight(std::fmax(0.0, best->weights[k] / best->w));
    sum += weight;
    for (std::size_t i = 0; i < 3; ++i) nearest[i] += weight * from_centre[best->corners[k]][i];
  }
  if (sign_of(FT(square(nearest) - squared_radius * CGAL::square(sum))) == Sign::negative) return true;
  Vector<FT> n;
  for (std::size_t i = 0; i < 3; ++i) {
    double guess = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      guess += best->weights[k] / best->w * near[best->corners[k]][i];
    }
    n[i] = FT(guess);
  }
  FT least = dot(n, from_centre[0]);
  for (std::size_t i = 1; i < 6; ++i) least = (CGAL::min)(least, dot(n, from_centre[i]));
  if (sign_of(least) == Sign::positive &&
      sign_of(FT(CGAL::square(least) - squared_radius * square(n))) == Sign::positive) {
    return false;
  }
  const Vector<FT> c = vector_of<FT>(ball.centre);
  const Six<FT> v = six<FT>(points);
  RangeFilter range(Ends::open);
  const bool may_hold = SegmentsOverS<FT>({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {c, c, c})
                            .for_each([&](const LinearInS<FT>& f) { return range.add(f); });
  if (may_hold && range.has_some()) return true;
  return std::nullopt;
}

}  // namespace

bool ball_blocks(const SixPoints& points, const Ball<double>& ball, bool& exactly) {
  exactly = false;
  const auto in_range = [](const Point& p) {
    return std::ranges::all_of(p, [](double x) { return std::fabs(x) <= kLargestInIntervals; });
  };
  if (std::ranges::all_of(points, in_range) && in_range(ball.centre) && ball.radius <= kLargestInIntervals) {
    if (const std::optional<bool> sure = blocks_surely(points, ball)) return *sure;
  }
  exactly = true;
  return blocks_exactly(points, ball);
}

}  // namespace gnomon::exact
