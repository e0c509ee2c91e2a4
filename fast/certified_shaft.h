// SPDX-License-Identifier: MIT
// Thresholds under which the naive kernels are never unsound.
#pragma once

#include "fast/shaft.h"

namespace gnomon::fast {

/// The constants that the thresholds below are made of, in units of the roundoff u unless said otherwise.
/// Each is derived in certified_shaft.cpp and tested from both sides.
struct CertifiedConstants {
  /// Box planes: |T - exact| <= 4.000002 u S + 5 eta, S = |N0|(|x| + |a0|) + |N1|(|y| + |a1|); the rest of
  /// the 5 pays for computing S itself in floating point.
  static constexpr int box_plane = 5;
  /// Ball planes: normals are made 1 - 5 u long or less; the 5 u absorb the error that grows with the radius.
  static constexpr int ball_shortening = 5;
  /// Ball planes, outside: (3 P + 3 D + 2 B) u; inside: (7.1 P + 3 D) u; see the derivation.
  static constexpr double ball_outside_p = 3, ball_outside_d = 3, ball_outside_b = 2;
  static constexpr double ball_inside_p = 7.1, ball_inside_d = 3;
  /// Squared distances: the factor on r^2 is 1 + 10 u, the offset 8 eta.
  static constexpr int square_factor = 10;
  /// Sides of the extent box: the factor on r is 1 + 4 u.
  static constexpr int side_factor = 4;
};

/// The shaft between two valid boxes for the certified box test: planes as formed, one threshold a plane that
/// holds for every test box. Planes whose evaluation could overflow within the extent box never decide
/// anything.
template <class F>
[[nodiscard]] Shaft<F> form_certified_box_shaft(const scene::Box<F>& a, const scene::Box<F>& b);

/// The same for the certified ball test: shortened normals, thresholds and slacks.
template <class F>
[[nodiscard]] Shaft<F> form_certified_ball_shaft(const scene::Box<F>& a, const scene::Box<F>& b);

}  // namespace gnomon::fast
