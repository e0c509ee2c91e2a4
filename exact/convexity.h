// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects of a scene are convex, whatever their source declares: exactly.
#pragma once

#include "scene/object.h"
#include "scene/scene.h"

namespace gnomon::exact {

/// True for an object of one face, triangle or ball, degenerate or not; and for triangles that are the whole
/// boundary of a convex body with inner points: they cover it once, turn counterclockwise as seen from
/// outside, meet edge to edge (each edge in exactly two triangles, in opposite directions), and none is
/// degenerate. Neighbours may lie in one plane. Everything else is not convex: several balls, balls and
/// triangles, several triangles in one plane whatever their outline, and boundaries turned inside out.
///
/// So a point of a convex object that faces the light is never hidden by the object, and its shadow is that
/// of a convex set. The scene must be is_valid() and the object one of its own; any finite doubles. Time
/// n log n for n triangles (sorting edges), with about 8 determinants a triangle, in intervals first. Sets
/// the rounding mode for the time of the call and restores it.
[[nodiscard]] bool is_convex(const scene::Scene& scene, const scene::Object& object);

}  // namespace gnomon::exact
