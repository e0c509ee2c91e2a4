// SPDX-License-Identifier: GPL-3.0-or-later
// How the path of a query lies to one closed face, exactly. Internal to exact/.
#pragma once

#include <compare>
#include <cstdint>

#include "exact/path.h"
#include "scene/scene.h"

namespace gnomon::exact {

/// `none`: no common point, not even with the path's ends. `at_end`: only an end of the path (a point of the
/// query, not of the open path) lies on the face; also said of the own ball when its product is 0. All others
/// meet the face: `grazing` within the plane of a triangle, on a degenerate one or tangent to a ball;
/// `on_edge` and `on_vertex` across the plane of a triangle on its border; `plain` where small moves don't
/// free the path.
enum class ContactKind : std::uint8_t { none, at_end, grazing, on_edge, on_vertex, plain };

struct Contact {
  ContactKind kind = ContactKind::none;
  /// on_vertex: the corner (0 to 2); on_edge: the corner that faces the edge.
  std::uint8_t corner = 0;

  [[nodiscard]] bool meets() const { return kind > ContactKind::at_end; }

  friend bool operator==(const Contact&, const Contact&) = default;
};

/// The contact of the query's path with one face, the own face by its own rules. Intervals first, rationals
/// where they leave something open; any finite doubles.
[[nodiscard]] Contact contact(const scene::Scene& scene, std::uint32_t face, const scene::ShadowQuery& query);
[[nodiscard]] Contact contact(const scene::Scene& scene, std::uint32_t face, const scene::RayQuery& query);

/// The same in rationals alone.
[[nodiscard]] Contact contact_in_rationals(const scene::Scene& scene, std::uint32_t face,
                                           const scene::ShadowQuery& query);
[[nodiscard]] Contact contact_in_rationals(const scene::Scene& scene, std::uint32_t face,
                                           const scene::RayQuery& query);

/// Doubles around the t at which a face is hit; lo is 0 and hi infinite where intervals can't tell.
struct HitBounds {
  double lo = 0, hi = 0;
};

/// Bounds on the infimum of all t > 0 in the face, which the ray must meet.
[[nodiscard]] HitBounds hit_bounds(const scene::Scene& scene, std::uint32_t face,
                                   const scene::RayQuery& query);

/// The order of those infima, in rationals and square roots.
[[nodiscard]] std::strong_ordering compare_hits_exactly(const scene::Scene& scene, std::uint32_t a,
                                                        std::uint32_t b, const scene::RayQuery& query);

/// The sign (-1, 0, 1) of n * (light - point), n = (v1 - v0) x (v2 - v0) of a triangle; `has_normal` is false
/// when n = 0.
struct FacingSign {
  int sign = 0;
  bool has_normal = false;
};
[[nodiscard]] FacingSign facing_sign(const scene::Scene& scene, std::uint32_t triangle,
                                     const scene::ShadowQuery& query);

/// The sign (-1, 0, 1) of det(direction of the path, a - apex, b - apex): on which side of a, seen along the
/// path from the apex, b lies.
[[nodiscard]] int turn_along(const Path& path, const std::array<double, 3>& apex,
                             const std::array<double, 3>& a, const std::array<double, 3>& b);

}  // namespace gnomon::exact
