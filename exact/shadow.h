// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `shadow`.
#pragma once

#include <cstdint>

#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::exact {

/// An answer, and whether it is a touching one, which arbitrarily small moves may change:
/// - shadowed, but every contact of the open segment with a face other than the own one is tangent to a ball,
///   within a triangle's plane, on a degenerate face, or on an edge or a vertex that is not sealed;
/// - lit, and the point or the light lies on a closed face other than the own one, or the own ball's product
///   (below) is 0;
/// - lit or shadowed, and the product that decides about facing is 0.
///
/// A contact on an edge is sealed when, seen along the segment, triangles that share the edge (by point
/// index) lie on both sides of it; one on a vertex when those that share the vertex cover a full turn around
/// it. The own face, degenerate triangles and those whose plane holds the segment close nothing.
struct ShadowTruth {
  scene::Shadow answer = scene::Shadow::lit;
  bool touching = false;

  friend bool operator==(const ShadowTruth&, const ShadowTruth&) = default;
};

/// True when the open segment from the point to the light has a point in the closed face. The own triangle
/// never blocks; the own ball blocks exactly when (point - centre) * (light - point) < 0. Degenerate
/// triangles and balls of radius 0 are closed sets like any other; equal point and light make an empty
/// segment that nothing blocks. All finite doubles are in the domain.
[[nodiscard]] bool blocks(const scene::Scene& scene, std::uint32_t face, const scene::ShadowQuery& query);

/// True when the own face is a triangle of a one-sided object and n * (light - point) < 0 for
/// n = (v1 - v0) x (v2 - v0).
[[nodiscard]] bool faces_away(const scene::Scene& scene, const scene::ShadowQuery& query);

/// Asks face by face. The scene must be valid (scene::is_valid) but may be empty, the own face a face of it
/// or kNoFace.
[[nodiscard]] ShadowTruth shadow_by_all_faces(const scene::Scene& scene, const scene::ShadowQuery& query);

}  // namespace gnomon::exact
