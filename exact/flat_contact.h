// SPDX-License-Identifier: GPL-3.0-or-later
// Paths against triangles whose plane they lie in, and against degenerate ones. Internal to exact/: includes
// CGAL.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "exact/contact.h"
#include "exact/vector.h"

namespace gnomon::exact {

using Corners = std::array<std::array<double, 3>, 3>;

/// All t from lo to hi.
template <class FT>
struct Range {
  FT lo, hi;
};

/// The t for which the line from + t * direction lies on a triangle with normal n != 0, whose plane contains
/// the line: each side cuts off a half of the line. The direction must not be 0; the kernel must be exact.
template <class FT>
std::optional<Range<FT>> range_in_plane(const std::array<double, 3>& from, const Vector<FT>& direction,
                                        const Corners& v, const Vector<FT>& n) {
  std::size_t dropped = 0;
  while (sign_of(n[dropped]) == Sign::zero) ++dropped;
  const std::size_t i = (dropped + 1) % 3, j = (dropped + 2) % 3;
  const bool turned = sign_of(n[dropped]) == Sign::negative;
  std::optional<FT> lo, hi;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<FT> side = between<FT>(v[k], v[(k + 1) % 3]), start = between<FT>(v[k], from);
    FT at_start = side[i] * start[j] - side[j] * start[i];
    FT slope = side[i] * direction[j] - side[j] * direction[i];
    if (turned) {
      at_start = -at_start;
      slope = -slope;
    }
    // Inside of this side where at_start + t * slope >= 0.
    const Sign rise = sign_of(slope);
    if (rise == Sign::zero) {
      if (sign_of(at_start) == Sign::negative) return std::nullopt;
      continue;
    }
    const FT t = -at_start / slope;
    if (rise == Sign::positive && (!lo || *lo < t)) lo = t;
    if (rise == Sign::negative && (!hi || t < *hi)) hi = t;
  }
  // A triangle is bounded, so that both ends were found.
  if (*hi < *lo) return std::nullopt;
  return Range<FT>{*lo, *hi};
}

/// The t for which the line lies on the segment a b, which may be a point.
template <class FT>
std::optional<Range<FT>> range_on_segment(const std::array<double, 3>& from, const Vector<FT>& direction,
                                          const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const Vector<FT> side = between<FT>(a, b), to_a = between<FT>(from, a), to_b = between<FT>(from, b);
  const Vector<FT> normal = cross(direction, side);
  const FT squared = square(direction);
  if (is_zero(normal)) {
    if (!is_zero(cross(direction, to_a))) return std::nullopt;
    const FT t = dot(to_a, direction) / squared, u = dot(to_b, direction) / squared;
    return t < u ? Range<FT>{t, u} : Range<FT>{u, t};
  }
  if (sign_of(dot(normal, to_a)) != Sign::zero) return std::nullopt;
  const FT area = square(normal);
  const FT along = dot(cross(to_a, direction), normal);  // area times the place on the side
  if (sign_of(along) == Sign::negative || area < along) return std::nullopt;
  const FT t = dot(cross(to_a, side), normal) / area;
  return Range<FT>{t, t};
}

/// The ends of the segment that a triangle with normal 0 is: corners on a line are sorted along it by x, y,
/// z.
inline std::array<std::array<double, 3>, 2> ends_of_degenerate(const Corners& v) {
  return {std::min({v[0], v[1], v[2]}), std::max({v[0], v[1], v[2]})};
}

/// The t for which the line of a path lies on a triangle that shares its plane or is degenerate.
template <class FT>
std::optional<Range<FT>> flat_range(const std::array<double, 3>& from, const Vector<FT>& direction,
                                    const Corners& v, const Vector<FT>& n) {
  if (!is_zero(n)) return range_in_plane(from, direction, v, n);
  const auto ends = ends_of_degenerate(v);
  return range_on_segment(from, direction, ends[0], ends[1]);
}

/// True when p, which lies in the plane of v unless v is degenerate, is a point of the triangle: any line
/// through p within the plane tells.
template <class FT>
bool flat_contains(const Corners& v, const std::array<double, 3>& p, const Vector<FT>& n) {
  Vector<FT> line = between<FT>(v[0], v[1]);
  if (is_zero(n)) {
    const auto ends = ends_of_degenerate(v);
    line = between<FT>(ends[0], ends[1]);
    if (is_zero(line)) return ends[0] == p;
  }
  const std::optional<Range<FT>> range = flat_range(p, line, v, n);
  return range && sign_of(range->lo) != Sign::positive && sign_of(range->hi) != Sign::negative;
}

/// The contact of a path whose line and the face have exactly this range in common.
template <class FT>
Contact contact_of_range(const Path& path, const std::optional<Range<FT>>& range) {
  if (!range) return {};
  const bool bounded = path.kind == Path::Kind::segment;
  const Sign first = bounded ? sign_of(FT(range->lo - FT(1))) : Sign::negative, last = sign_of(range->hi);
  if (first == Sign::negative && last == Sign::positive) return {ContactKind::grazing};
  if (first == Sign::zero || last == Sign::zero) return {ContactKind::at_end};
  return {};
}

}  // namespace gnomon::exact
