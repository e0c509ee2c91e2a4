// SPDX-License-Identifier: GPL-3.0-or-later
// What is decided exactly about a volume other than box and ball against a shaft.
#pragma once

#include "scene/category.h"

namespace gnomon::exact {

struct VolumeReference {
  /// Geometric truth, from the definition.
  scene::Category truth;
  /// The test by the shaft's sides and planes alone, in exact arithmetic: the exact twin of the naive tests.
  /// It has no false culls; it misses what only an axis across two edges tells apart.
  scene::Category planes;
  /// The planes, the volume's faces and the products of its edges with the axes: the twin of the usual test
  /// of separating axes. For ellipsoids, which have no edges, the same as `planes`.
  scene::Category separating;
  /// The answer changes under arbitrarily small translations of t: between outside and overlap, or overlap
  /// and inside.
  bool touches_outside, touches_inside;

  friend bool operator==(const VolumeReference&, const VolumeReference&) = default;
};

}  // namespace gnomon::exact
