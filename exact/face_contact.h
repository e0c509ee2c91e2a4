// SPDX-License-Identifier: GPL-3.0-or-later
// A path against a triangle and against a ball, in the arithmetic of a kernel. Internal to exact/: includes
// CGAL.
#pragma once

#include <array>
#include <concepts>
#include <optional>

#include "exact/flat_contact.h"
#include "scene/ball.h"

namespace gnomon::exact {

/// The kernel of intervals: signs may be unknown.
template <class FT>
concept Filter = std::same_as<FT, FilterKernel::FT>;

/// The plane of a triangle at both ends of a path: f(t) = n * (v0 - from - t * direction).
template <class FT>
struct PlaneEnds {
  Vector<FT> normal, direction;
  FT at_start;
  Sign start, finish;

  PlaneEnds(const Path& path, const Corners& v)
      : normal(cross(between<FT>(v[0], v[1]), between<FT>(v[0], v[2]))),
        direction(direction_of<FT>(path)),
        at_start(dot(normal, between<FT>(path.from, v[0]))),
        start(sign_of(at_start)),
        finish(path.kind == Path::Kind::segment ? sign_of(dot(normal, between<FT>(path.to, v[0])))
                                                : far_sign()) {}

 private:
  /// The sign of f at the far end of a ray.
  [[nodiscard]] Sign far_sign() const {
    switch (sign_of(dot(normal, direction))) {
      case Sign::zero:
        return start;
      case Sign::negative:
        return Sign::positive;
      case Sign::positive:
        return Sign::negative;
      default:
        return Sign::unknown;
    }
  }
};

/// Signs of det(direction, x, y) over the three sides x y of a triangle as seen from the start: they follow
/// the barycentric coordinates of the point where the line of the path meets the plane.
template <class FT>
std::array<Sign, 3> side_signs(const Path& path, const Vector<FT>& direction, const Corners& v) {
  std::array<Sign, 3> signs{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &x = v[(k + 1) % 3], &y = v[(k + 2) % 3];
    signs[k] = sign_of(dot(direction, cross(between<FT>(path.from, x), between<FT>(x, y))));
  }
  return signs;
}

[[nodiscard]] inline bool are_opposite(Sign a, Sign b) {
  return (a == Sign::negative && b == Sign::positive) || (a == Sign::positive && b == Sign::negative);
}

/// The contact of a path that lies in the plane of the triangle, as filters can see it: `none` when the
/// path's line has all corners strictly on one side, `grazing` when the path and an edge cross between the
/// ends of both. Empty for all that touches, and for degenerate triangles.
template <Filter FT>
std::optional<Contact> clear_flat_contact(const Path& path, const Corners& v, const PlaneEnds<FT>& plane) {
  std::array<Sign, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = sign_of(dot(plane.normal, cross(plane.direction, between<FT>(path.from, v[k]))));
  }
  const bool strict = sides[0] == Sign::negative || sides[0] == Sign::positive;
  if (strict && sides[0] == sides[1] && sides[0] == sides[2]) return Contact{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!are_opposite(sides[k], sides[(k + 1) % 3])) continue;
    const Vector<FT> edge = between<FT>(v[k], v[(k + 1) % 3]);
    const Vector<FT> end = path.kind == Path::Kind::ray ? plane.direction : between<FT>(v[k], path.to);
    const Sign start = sign_of(dot(plane.normal, cross(edge, between<FT>(v[k], path.from))));
    if (are_opposite(start, sign_of(dot(plane.normal, cross(edge, end))))) {
      return Contact{ContactKind::grazing};
    }
  }
  return std::nullopt;
}

/// Empty when the filter can't tell.
template <class FT>
std::optional<Contact> triangle_contact(const Path& path, const Corners& v) {
  const PlaneEnds<FT> plane(path, v);
  const bool strict = plane.start == Sign::negative || plane.start == Sign::positive;
  if (strict && plane.start == plane.finish) return Contact{};
  const std::array<Sign, 3> sides = side_signs(path, plane.direction, v);
  SignFold fold, opposite;
  for (const Sign sign : sides) {
    fold.add(sign);
    if (sign == Sign::negative) opposite.any_positive = true;
  }
  if (fold.any_positive && opposite.any_positive) return Contact{};
  if (plane.start == Sign::zero && plane.finish == Sign::zero) {
    if constexpr (Filter<FT>) {
      return clear_flat_contact(path, v, plane);
    } else if (is_zero(plane.direction)) {
      return Contact{flat_contains(v, path.from, plane.normal) ? ContactKind::at_end : ContactKind::none};
    } else {
      return contact_of_range(path, flat_range(path.from, plane.direction, v, plane.normal));
    }
  }
  if (plane.start == Sign::unknown || plane.finish == Sign::unknown || fold.any_unknown) return std::nullopt;
  // The line crosses the plane in one point, which lies in the triangle and on the closed path.
  if (plane.start == Sign::zero || plane.finish == Sign::zero) return Contact{ContactKind::at_end};
  std::uint8_t zeros = 0, zero = 0, other = 0;
  for (std::uint8_t k = 0; k < 3; ++k) {
    if (sides[k] == Sign::zero) {
      ++zeros;
      zero = k;
    } else {
      other = k;
    }
  }
  if (zeros == 0) return Contact{ContactKind::plain};
  return zeros == 1 ? Contact{ContactKind::on_edge, zero} : Contact{ContactKind::on_vertex, other};
}

/// The quadratic a t^2 + 2 b t + c of a path and a ball: the squared distance from the centre less r^2.
template <class FT>
struct BallQuadratic {
  FT a, b, c;

  BallQuadratic(const Path& path, const scene::Ball<double>& ball) {
    const Vector<FT> direction = direction_of<FT>(path), to_start = between<FT>(ball.centre, path.from);
    a = square(direction);
    b = dot(direction, to_start);
    c = square(to_start) - CGAL::square(FT(ball.radius));
  }

  /// A quarter of the discriminant: positive when the line meets the open ball.
  [[nodiscard]] FT discriminant() const { return CGAL::square(b) - a * c; }
};

/// Empty when the filter can't tell.
template <class FT>
std::optional<Contact> ball_contact(const Path& path, const scene::Ball<double>& ball) {
  const BallQuadratic<FT> f(path, ball);
  const bool bounded = path.kind == Path::Kind::segment;
  const Sign length = sign_of(f.a), start = sign_of(f.c);
  Sign finish = Sign::positive;
  if (bounded) {
    const FT at_end = square(between<FT>(ball.centre, path.to)) - CGAL::square(FT(ball.radius));
    finish = sign_of(at_end);
  }
  if (length == Sign::unknown) return std::nullopt;
  if (length == Sign::zero) {
    if (start == Sign::unknown) return std::nullopt;
    return Contact{start == Sign::positive ? ContactKind::none : ContactKind::at_end};
  }
  // An end within the open ball brings points of the open path with it.
  if (start == Sign::negative || finish == Sign::negative) return Contact{ContactKind::plain};
  const Sign discriminant = sign_of(f.discriminant());
  if (discriminant == Sign::negative) return Contact{};
  // The least value lies strictly between the ends when f falls at the start and rises at the end.
  const Sign slope = sign_of(f.b), slope_at_end = bounded ? sign_of(FT(f.a + f.b)) : Sign::positive;
  const bool between_ends = slope == Sign::negative && slope_at_end == Sign::positive;
  if (start == Sign::unknown || finish == Sign::unknown) {
    if (between_ends && discriminant == Sign::positive) return Contact{ContactKind::plain};
    return std::nullopt;
  }
  if (slope == Sign::unknown || slope_at_end == Sign::unknown || discriminant == Sign::unknown) {
    if (start == Sign::positive && finish == Sign::positive) {
      const bool beside = slope == Sign::positive || slope == Sign::zero || slope_at_end == Sign::negative ||
                          slope_at_end == Sign::zero;
      if (beside) return Contact{};
    }
    return std::nullopt;
  }
  if (between_ends) return Contact{discriminant == Sign::zero ? ContactKind::grazing : ContactKind::plain};
  const bool end = start == Sign::zero || finish == Sign::zero;
  return Contact{end ? ContactKind::at_end : ContactKind::none};
}

/// The own ball's rule: met exactly when the path sets out into it.
template <class FT>
std::optional<Contact> own_ball_contact(const Path& path, const scene::Ball<double>& ball) {
  switch (sign_of(BallQuadratic<FT>(path, ball).b)) {
    case Sign::negative:
      return Contact{ContactKind::plain};
    case Sign::zero:
      return Contact{ContactKind::at_end};
    case Sign::positive:
      return Contact{};
    default:
      return std::nullopt;
  }
}

}  // namespace gnomon::exact
