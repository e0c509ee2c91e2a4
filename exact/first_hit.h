// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `first-hit`.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "scene/ray_query.h"
#include "scene/scene.h"

namespace gnomon::exact {

/// The faces that a ray meets first, in rising order; more than one when they tie, none when it meets
/// nothing. A face is hit at the infimum of all t > 0 of its points on the ray: where the ray enters it, and
/// at 0 when the ray starts in it and goes on in it.
///
/// Touching: the hit, or that there is none, may change under arbitrarily small moves, because all contacts
/// with those faces are tangent to a ball, within a triangle's plane, on a degenerate face, or on an edge or
/// a vertex that is not sealed (as in exact/shadow.h); or because the origin lies on a face other than the
/// own one that the ray only leaves, or the own ball's product (scene/ray_query.h) is 0.
struct FirstHit {
  std::vector<std::uint32_t> faces;
  bool touching = false;

  friend bool operator==(const FirstHit&, const FirstHit&) = default;
};

/// True when the closed face has a point on the ray, at some t > 0; the own face by its own rules.
[[nodiscard]] bool meets(const scene::Scene& scene, std::uint32_t face, const scene::RayQuery& ray);

/// Compares where the ray hits two faces, both of which it must meet. The own ball is hit where the ray
/// leaves it; if the line of the ray misses it, at the point nearest to its centre. Intervals first, then
/// rationals and square roots, exactly.
[[nodiscard]] std::strong_ordering compare_hits(const scene::Scene& scene, std::uint32_t a, std::uint32_t b,
                                                const scene::RayQuery& ray);

/// Asks face by face. The scene must be valid (scene::is_valid) but may be empty; the direction must not be
/// 0.
[[nodiscard]] FirstHit first_hit_by_all_faces(const scene::Scene& scene, const scene::RayQuery& ray);

}  // namespace gnomon::exact
