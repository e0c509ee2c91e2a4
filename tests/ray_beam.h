// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fast/hierarchy_beam.h"
#include "scene/ray_query.h"

namespace gnomon::tests {

/// The beam of a ray of floats, as the certified tier of fast::Hierarchy sets it up.
inline fast::Beam beam_of_ray(const scene::RayQuery& ray) {
  fast::Beam beam;
  for (std::size_t k = 0; k < 3; ++k) {
    beam.origin[k] = static_cast<float>(ray.origin[k]);
    beam.direction[k] = static_cast<float>(ray.direction[k]);
  }
  beam.measure();
  beam.prepare<true>();
  beam.leave_out_slow_axes();
  return beam;
}

}  // namespace gnomon::tests
