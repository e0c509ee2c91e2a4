// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/contact.h"

#include <optional>

#include "exact/face_contact.h"

namespace gnomon::exact {

using scene::kNoFace;
using scene::RayQuery;
using scene::Scene;
using scene::ShadowQuery;

namespace {

Corners corners_of(const Scene& scene, std::size_t triangle) {
  return {scene.corner(triangle, 0), scene.corner(triangle, 1), scene.corner(triangle, 2)};
}

template <class FT>
std::optional<Contact> contact_with(const Scene& scene, std::uint32_t face, const Path& path,
                                    std::uint32_t own) {
  if (face < scene.triangles.size()) {
    if (face == own) return Contact{};
    return triangle_contact<FT>(path, corners_of(scene, face));
  }
  const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
  return face == own ? own_ball_contact<FT>(path, ball) : ball_contact<FT>(path, ball);
}

Contact filtered_contact(const Scene& scene, std::uint32_t face, const Path& path, std::uint32_t own) {
  {
    const CGAL::Interval_nt<false>::Protector upward;
    if (const auto found = contact_with<FilterKernel::FT>(scene, face, path, own)) return *found;
  }
  return *contact_with<ExactKernel::FT>(scene, face, path, own);
}

/// A sign from intervals, else from the exact kernel; `sign_with` is called with a number of the kernel.
template <class SignWith>
int filtered_sign(const SignWith& sign_with) {
  {
    const CGAL::Interval_nt<false>::Protector upward;
    const Sign sign = sign_with(FilterKernel::FT());
    if (sign != Sign::unknown) return static_cast<int>(sign);
  }
  return static_cast<int>(sign_with(ExactKernel::FT()));
}

/// One t as (q + s sqrt(d)) / w with w > 0.
template <class FT>
struct Hit {
  FT q, d, w;
  int s = 0;
};

/// Where the ray, which must meet the face, hits it first. Empty when the filter can't tell.
template <class FT>
std::optional<Hit<FT>> hit_of(const Scene& scene, std::uint32_t face, const RayQuery& query) {
  const Path path(query);
  if (face < scene.triangles.size()) {
    const Corners v = corners_of(scene, face);
    const PlaneEnds<FT> plane(path, v);
    FT q = plane.at_start, w = dot(plane.normal, plane.direction);
    const Sign across = sign_of(w);
    if (across == Sign::positive) return Hit<FT>{q, FT(0), w, 0};
    if (across == Sign::negative) return Hit<FT>{FT(-q), FT(0), FT(-w), 0};
    if constexpr (Filter<FT>) {
      return std::nullopt;
    } else {
      const auto range = flat_range(path.from, plane.direction, v, plane.normal);
      return Hit<FT>{(CGAL::max)(range->lo, FT(0)), FT(0), FT(1), 0};
    }
  }
  const BallQuadratic<FT> f(path, scene.balls[face - scene.triangles.size()]);
  if (sign_of(f.a) == Sign::unknown) return std::nullopt;
  FT d = f.discriminant();
  if (face == query.own) {
    // A start off the ball may lead past it: then the nearest point counts.
    if (sign_of(d) == Sign::unknown) return std::nullopt;
    if (sign_of(d) == Sign::negative) d = FT(0);
    return Hit<FT>{FT(-f.b), d, f.a, 1};
  }
  const Sign start = sign_of(f.c);
  if (start == Sign::unknown) return std::nullopt;
  if (start == Sign::negative) return Hit<FT>{FT(0), FT(0), FT(1), 0};
  return Hit<FT>{FT(-f.b), d, f.a, -1};
}

int sign_int(const ExactKernel::FT& x) {
  return static_cast<int>(sign_of(x));
}

/// The sign of x + s sqrt(p) + t sqrt(q), by squaring what has opposite signs.
int sign_of_roots(const ExactKernel::FT& x, int s, const ExactKernel::FT& p, int t,
                  const ExactKernel::FT& q) {
  using FT = ExactKernel::FT;
  const int of_p = s * sign_int(p), of_q = t * sign_int(q);
  int of_roots = of_p;
  if (of_p == 0) {
    of_roots = of_q;
  } else if (of_q != 0 && of_q != of_p) {
    of_roots = of_p * sign_int(FT(p - q));
  }
  const int of_x = sign_int(x);
  if (of_roots == 0 || of_x == of_roots) return of_x == 0 ? of_roots : of_x;
  if (of_x == 0) return of_roots;
  // Opposite signs: x^2 against p + q + 2 s t sqrt(pq).
  const FT y = CGAL::square(x) - (of_p != 0 ? p : FT(0)) - (of_q != 0 ? q : FT(0));
  const int cross_sign = -of_p * of_q, of_y = sign_int(y);
  int greater = 0;  // the sign of y + cross_sign * 2 sqrt(pq)
  if (cross_sign == 0) {
    greater = of_y;
  } else if (of_y == 0 || of_y == cross_sign) {
    greater = cross_sign;
  } else {
    greater = of_y * sign_int(FT(CGAL::square(y) - FT(4) * p * q));
  }
  return greater * of_x;
}

}  // namespace

Contact contact(const Scene& scene, std::uint32_t face, const ShadowQuery& query) {
  return filtered_contact(scene, face, Path(query), query.own);
}

Contact contact(const Scene& scene, std::uint32_t face, const RayQuery& query) {
  return filtered_contact(scene, face, Path(query), query.own);
}

Contact contact_in_rationals(const Scene& scene, std::uint32_t face, const ShadowQuery& query) {
  return *contact_with<ExactKernel::FT>(scene, face, Path(query), query.own);
}

Contact contact_in_rationals(const Scene& scene, std::uint32_t face, const RayQuery& query) {
  return *contact_with<ExactKernel::FT>(scene, face, Path(query), query.own);
}

HitBounds hit_bounds(const Scene& scene, std::uint32_t face, const RayQuery& query) {
  constexpr HitBounds kAnywhere{0, HUGE_VAL};
  const CGAL::Interval_nt<false>::Protector upward;
  const auto hit = hit_of<FilterKernel::FT>(scene, face, query);
  if (!hit || !(hit->w.inf() > 0)) return kAnywhere;
  FilterKernel::FT t = hit->q;
  if (hit->s != 0) {
    if (!(hit->d.sup() >= 0)) return kAnywhere;
    const FilterKernel::FT root = CGAL::sqrt(hit->d);
    t = hit->s > 0 ? t + root : t - root;
  }
  t = t / hit->w;
  if (!(t.sup() >= 0)) return kAnywhere;
  return {t.inf() > 0 ? t.inf() : 0, t.sup()};
}

std::strong_ordering compare_hits_exactly(const Scene& scene, std::uint32_t a, std::uint32_t b,
                                          const RayQuery& query) {
  using FT = ExactKernel::FT;
  const Hit<FT> first = *hit_of<FT>(scene, a, query), second = *hit_of<FT>(scene, b, query);
  // Both times w w' > 0.
  const int sign =
      sign_of_roots(FT(first.q * second.w - second.q * first.w), first.s,
                    FT(first.d * CGAL::square(second.w)), -second.s, FT(second.d * CGAL::square(first.w)));
  return sign <=> 0;
}

FacingSign facing_sign(const Scene& scene, std::uint32_t triangle, const ShadowQuery& query) {
  const Corners v = corners_of(scene, triangle);
  const int sign = filtered_sign([&](auto number) {
    using FT = decltype(number);
    const Vector<FT> n = cross(between<FT>(v[0], v[1]), between<FT>(v[0], v[2]));
    return sign_of(dot(n, between<FT>(query.point, query.light)));
  });
  if (sign != 0) return {sign, true};
  using FT = ExactKernel::FT;
  return {0, !is_zero(cross(between<FT>(v[0], v[1]), between<FT>(v[0], v[2])))};
}

int turn_along(const Path& path, const std::array<double, 3>& apex, const std::array<double, 3>& a,
               const std::array<double, 3>& b) {
  return filtered_sign([&](auto number) {
    using FT = decltype(number);
    return sign_of(dot(direction_of<FT>(path), cross(between<FT>(apex, a), between<FT>(apex, b))));
  });
}

}  // namespace gnomon::exact
