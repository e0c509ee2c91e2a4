// SPDX-License-Identifier: MIT
#include "scene/turn.h"

#include <utility>

namespace gnomon::scene {
namespace {

/// Taylor's series for 0 <= x <= pi / 4: the first term left out is below 2^-60 for both.
Direction series(double x) {
  const double square = x * x;
  double cos = 1, sin = 1;
  for (int k = 16; k >= 2; k -= 2) {
    cos = 1 - square / (k * (k - 1)) * cos;
    sin = 1 - square / (k * (k + 1)) * sin;
  }
  return {cos, x * sin};
}

}  // namespace

Direction turn(std::uint64_t step, std::uint64_t steps) {
  constexpr double kEighth = 0x1.921fb54442d18p-1;  // pi / 4, rounded
  const std::uint64_t eighths = 8 * (step % steps), octant = eighths / steps, rest = eighths % steps;
  const std::uint64_t from_axis = octant % 2 == 0 ? rest : steps - rest;
  Direction d = series(kEighth * static_cast<double>(from_axis) / static_cast<double>(steps));
  if (octant % 4 == 1 || octant % 4 == 2) std::swap(d.cos, d.sin);
  if (octant >= 2 && octant < 6) d.cos = -d.cos;
  if (octant >= 4) d.sin = -d.sin;
  return d;
}

}  // namespace gnomon::scene
