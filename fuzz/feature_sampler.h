// SPDX-License-Identifier: GPL-3.0-or-later
// Random vertices, edges and planes of a scene's triangles: what the hard workloads aim at.
#pragma once

#include <cstddef>

#include "fuzz/random.h"
#include "fuzz/vectors.h"
#include "scene/scene.h"

namespace gnomon::fuzz {

/// Draws features of triangles, each triangle as likely as any other. The scene has triangles and outlives
/// the sampler. Each number is drawn in a statement of its own: compilers differ in which argument of a call
/// they evaluate first, and the same queries must come everywhere.
class FeatureSampler {
 public:
  explicit FeatureSampler(const scene::Scene& scene) : scene_(scene) {}

  /// The number of a triangle.
  [[nodiscard]] std::size_t triangle(CaseRandom& random) const {
    return static_cast<std::size_t>(random.below(static_cast<int>(scene_.triangles.size())));
  }

  [[nodiscard]] const Vector3& vertex(CaseRandom& random) const {
    const auto k = static_cast<std::size_t>(random.below(3));
    return scene_.corner(triangle(random), k);
  }

  struct Edge {
    Vector3 from, to;

    /// Rounded to floats.
    [[nodiscard]] Vector3 at(double share) const { return as_floats(along(from, minus(to, from), share)); }
  };
  [[nodiscard]] Edge edge(CaseRandom& random) const {
    const std::size_t t = triangle(random), k = static_cast<std::size_t>(random.below(3));
    return {scene_.corner(t, k), scene_.corner(t, (k + 1) % 3)};
  }

  /// A point of the triangle's plane, in it or within a few times its size, rounded to floats.
  [[nodiscard]] Vector3 point_in_plane(std::size_t triangle, CaseRandom& random) const {
    const Vector3& a = scene_.corner(triangle, 0);
    const Vector3 ab = minus(scene_.corner(triangle, 1), a), ac = minus(scene_.corner(triangle, 2), a);
    const double v = random.between(-2.0, 3.0), u = random.between(-2.0, 3.0);
    return as_floats(along(along(a, ab, u), ac, v));
  }

 private:
  const scene::Scene& scene_;
};

}  // namespace gnomon::fuzz
