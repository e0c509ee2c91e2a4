// SPDX-License-Identifier: GPL-3.0-or-later
// Random points of a scene's surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fuzz/random.h"
#include "scene/ray_query.h"
#include "scene/scene.h"

namespace gnomon::fuzz {

/// A point and the face that it was made on.
struct SurfacePoint {
  std::array<double, 3> point{};
  std::uint32_t face = 0;
};

/// Draws faces by their area, in doubles. Degenerate faces have none.
class SurfaceSampler {
 public:
  explicit SurfaceSampler(const scene::Scene& scene);

  /// False when no face has an area: then nothing can be drawn.
  [[nodiscard]] bool has_area() const { return !sums_.empty() && sums_.back() > 0; }
  /// The face at a share in [0, 1) of the whole area, faces laid end to end.
  [[nodiscard]] std::uint32_t face_at(double share) const;
  /// A point of the face, uniform by area, rounded to floats.
  [[nodiscard]] SurfacePoint point_on(std::uint32_t face, CaseRandom& random) const;
  /// A point of the whole surface.
  [[nodiscard]] SurfacePoint draw(CaseRandom& random) const {
    return point_on(face_at(random.unit<double>()), random);
  }

 private:
  const scene::Scene& scene_;
  std::vector<double> sums_;  // of the areas up to each face
};

/// Where the ray meets a face that it is known to meet, as doubles find it, rounded to floats.
[[nodiscard]] std::array<double, 3> hit_point(const scene::Scene& scene, std::uint32_t face,
                                              const scene::RayQuery& ray);

}  // namespace gnomon::fuzz
