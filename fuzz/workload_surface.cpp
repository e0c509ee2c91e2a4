// SPDX-License-Identifier: GPL-3.0-or-later
// Workloads whose points are drawn from the surface: surface and emitter.
#include "fuzz/lights.h"
#include "fuzz/surface_sampler.h"
#include "fuzz/workload_parts.h"

namespace gnomon::fuzz {

Queries record_surface(const scene::Scene& scene, const Oracle& /*oracle*/, const WorkloadOptions& options) {
  const std::vector<std::array<double, 3>> lights = light_points(scene);
  const SurfaceSampler sampler(scene);
  Queries queries;
  if (!sampler.has_area()) return queries;
  queries.reserve(options.queries);
  const std::uint32_t stream = stream_of("surface");
  for (std::size_t i = 0; i < options.queries; ++i) {
    CaseRandom random(options.seed, stream, i);
    const SurfacePoint at = sampler.draw(random);
    queries.push_back({at.point, lights[i % lights.size()], at.face});
  }
  return queries;
}

/// Receivers stand at even shares of the whole area, as patches of equal size do; each is asked about
/// kSamples points of every light, as an estimate of a form factor is.
Queries record_emitter(const scene::Scene& scene, const Oracle& /*oracle*/, const WorkloadOptions& options) {
  constexpr std::size_t kSamples = 16;
  const SurfaceSampler sampler(scene);
  Queries queries;
  if (scene.polygon_lights.empty() || !sampler.has_area()) return queries;
  const std::size_t each = kSamples * scene.polygon_lights.size();
  const std::size_t receivers = options.queries / each + 1;
  queries.reserve(receivers * each);
  const std::uint32_t stream = stream_of("emitter");
  for (std::size_t i = 0; i < receivers; ++i) {
    CaseRandom random(options.seed, stream, i);
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(receivers);
    const SurfacePoint at = sampler.point_on(sampler.face_at(share), random);
    for (const scene::PolygonLight& light : scene.polygon_lights) {
      for (std::size_t k = 0; k < kSamples; ++k) {
        queries.push_back({at.point, point_on(light, random), at.face});
      }
    }
  }
  return queries;
}

}  // namespace gnomon::fuzz
