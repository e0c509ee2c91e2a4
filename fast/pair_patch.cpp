// SPDX-License-Identifier: MIT
#include "fast/pair_patch.h"

#include <algorithm>
#include <cmath>

#include "fast/hierarchy_bounds.h"

namespace gnomon::fast {

void PairPatch::assign(std::span<const std::array<float, 3>> points, scene::FaceRun own_run) {
  count = points.size();
  own = own_run;
  convex = {};
  plane = {};
  finite = in_domain = true;
  for (std::size_t k = 0; k < 3; ++k) {
    coordinates[k].resize(count + kPadding);
    if (count == 0) continue;
    float lo = points[0][k], hi = lo;
    bool all_finite = true, all_in_domain = true;
    for (std::size_t i = 0; i < count; ++i) {
      const float x = points[i][k];
      coordinates[k][i] = x;
      lo = std::min(lo, x);
      hi = std::max(hi, x);
      all_finite &= std::isfinite(x);
      all_in_domain &= std::abs(x) <= kMostMagnitude;
    }
    std::fill(coordinates[k].begin() + static_cast<std::ptrdiff_t>(count), coordinates[k].end(),
              points[count - 1][k]);
    box[k] = lo;
    box[k + 3] = hi;
    finite &= all_finite;
    in_domain &= all_in_domain;
  }
}

}  // namespace gnomon::fast
