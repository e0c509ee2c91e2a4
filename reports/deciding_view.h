// SPDX-License-Identifier: GPL-3.0-or-later
// What decides a shaft case, and its surroundings relative to the deciding corner.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reports/picture.h"
#include "reports/shaft_case.h"
#include "reports/silhouette.h"

namespace gnomon::reports {

/// Which boundary the case is nearest to.
enum class Decision { kOutside, kInside };

/// A line near the corner that decides, in units of the case's ulp with the corner at the origin:
/// x normal_x + y normal_y + offset <= 0 is the shaft's side, and the normal has length 1. The offset's sign
/// is exact.
struct LocalLine {
  double normal_x = 1, normal_y = 0, offset = 0;
};

/// The deciding projection and the neighbourhood of the corner (for balls: the nearest or farthest point) in
/// it.
struct DecidingView {
  Silhouette projection;
  Decision decision = Decision::kOutside;
  std::vector<LocalLine> sides;  ///< the silhouette is where all of them hold
  LocalLine line;                ///< the deciding one: a side or, for balls past a corner, the tangent there
  std::array<double, 2> corner{};  ///< where it is in the picture's axes, rounded to double
  int sign = 0;                    ///< exactly: 1 outside the line, 0 on it, -1 on the shaft's side
  double gap = 0;                  ///< box: value over |n|_1, ball: distance from the line; in ulps, signed
  double to_centre_x = 0, to_centre_y = 0;  ///< ball: the direction from the point to the centre
};

[[nodiscard]] DecidingView deciding_view(const ShaftCase& shaft, PictureFocus focus = PictureFocus::kNearer);

}  // namespace gnomon::reports
