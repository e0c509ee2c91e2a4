// SPDX-License-Identifier: GPL-3.0-or-later
// Random points of triangles.
#pragma once

#include <cmath>

#include "fuzz/random.h"
#include "fuzz/vectors.h"

namespace gnomon::fuzz {

/// Uniform by area: u = 1 - sqrt(r), v = s sqrt(r) (Turk, "Generating random points in triangles", Graphics
/// Gems, 1990). In doubles, not yet rounded to floats.
[[nodiscard]] inline Vector3 point_in_triangle(const Vector3& a, const Vector3& b, const Vector3& c,
                                               CaseRandom& random) {
  const double root = std::sqrt(random.unit<double>()), s = random.unit<double>();
  return along(along(a, minus(b, a), root * (1 - s)), minus(c, a), root * s);
}

}  // namespace gnomon::fuzz
