// SPDX-License-Identifier: GPL-3.0-or-later
// The workload `hard-rays`: first hits that are decided by the last bits. In shares of the whole:
//   1/5  through a point of an edge, 3/20 through a vertex: from points in and around the scene. In half of
//        them the direction has few bits and the origin is found from it backwards: where the bits suffice
//        the ray then meets the edge or vertex exactly, and the faces around it tie;
//   3/20 origin and direction in, or within two ulps of, the plane of a face, half of them with it as own
//        face;
//   3/20 axis-parallel through a vertex, the middle of an edge or a point of a face: exactly so;
//   1/4  from points of faces, with their own face: to random sides, to corners and to points of other faces;
//   1/10 along balls: tangents by the axes, and to points of their silhouette.
// Faces that coincide tie wherever the scene has some.
#include <cmath>

#include "fuzz/feature_sampler.h"
#include "fuzz/surface_sampler.h"
#include "fuzz/vectors.h"
#include "fuzz/workload_parts.h"
#include "scene/scene_facts.h"

namespace gnomon::fuzz {
namespace {

class HardRayRecorder {
 public:
  HardRayRecorder(const scene::Scene& scene, const WorkloadOptions& options)
      : scene_(scene),
        options_(options),
        sampler_(scene),
        features_(scene),
        extent_(scene::extent_of(scene)) {
    size_ = length_of(
        {extent_.hi(0) - extent_.lo(0), extent_.hi(1) - extent_.lo(1), extent_.hi(2) - extent_.lo(2)});
  }

  Rays record() {
    if (!sampler_.has_area()) return {};
    if (!scene_.triangles.empty()) {
      fill("hard rays edge", 4, &HardRayRecorder::through_edge);
      fill("hard rays vertex", 3, &HardRayRecorder::through_vertex);
      fill("hard rays grazing", 3, &HardRayRecorder::grazing);
      fill("hard rays axis", 3, &HardRayRecorder::axis_parallel);
    }
    fill("hard rays surface", 5, &HardRayRecorder::off_surface);
    if (!scene_.balls.empty()) fill("hard rays ball", 2, &HardRayRecorder::along_ball);
    return std::move(rays_);
  }

 private:
  /// Records so many twentieths of the rays.
  void fill(std::string_view stream, std::size_t share, void (HardRayRecorder::*draw)(CaseRandom&)) {
    // Rounded up: a workload of one ray has one.
    const std::size_t count = (options_.queries * share + 19) / 20;
    for (std::size_t i = 0; i < count && rays_.size() < options_.queries; ++i) {
      CaseRandom random(options_.seed, stream_of(stream), i);
      (this->*draw)(random);
    }
  }

  /// Rays whose direction is rounded away are left out: a direction must not be 0.
  void add(const Vector3& origin, const Vector3& direction, std::uint32_t own = scene::kNoFace) {
    const scene::RayQuery ray{as_floats(origin), as_floats(direction), own};
    if (ray.direction != Vector3{}) rays_.push_back(ray);
  }

  /// In the scene's box and as far beyond it as it is large.
  Vector3 any_point(CaseRandom& random) const {
    Vector3 point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double lo = extent_.lo(static_cast<int>(axis)), hi = extent_.hi(static_cast<int>(axis));
      point[axis] = random.between(lo - (hi - lo) / 2, hi + (hi - lo) / 2);
    }
    return as_floats(point);
  }
  static Vector3 any_direction(CaseRandom& random) {
    return {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
  }

  void through(const Vector3& target, CaseRandom& random) {
    if (random.chance(0.5)) {
      const Vector3 origin = any_point(random);
      return add(origin, minus(target, origin));
    }
    // Whole numbers times a power of two of about the scene's size.
    const double unit = std::ldexp(1.0, std::ilogb(size_) - random.integer(3, 8));
    Vector3 direction;
    for (double& c : direction) c = unit * random.integer(-8, 8);
    add(minus(target, times(direction, random.integer(1, 4))), direction);
  }
  void through_edge(CaseRandom& random) {
    const double share = random.chance(0.5) ? 0.5 : random.unit<double>();
    through(features_.edge(random).at(share), random);
  }
  void through_vertex(CaseRandom& random) { through(features_.vertex(random), random); }

  void grazing(CaseRandom& random) {
    const std::size_t t = features_.triangle(random);
    const int ulps = random.integer(0, 2);
    const Vector3 origin = features_.point_in_plane(t, random), to = features_.point_in_plane(t, random);
    const std::uint32_t own = random.chance(0.5) ? static_cast<std::uint32_t>(t) : scene::kNoFace;
    const Vector3 direction = nudged(as_floats(minus(to, origin)), random, ulps);
    add(nudged(origin, random, ulps), direction, own);
  }

  void axis_parallel(CaseRandom& random) {
    const int what = random.below(3);
    const Vector3 target = what == 0   ? features_.vertex(random)
                           : what == 1 ? features_.edge(random).at(0.5)
                                       : sampler_.draw(random).point;
    const auto axis = static_cast<std::size_t>(random.below(3));
    Vector3 origin = target, direction{};
    direction[axis] = random.chance(0.5) ? 1 : -1;
    origin[axis] -= direction[axis] * size_ * random.between(0.001, 1.0);
    if (random.chance(0.5)) direction[axis] *= size_ * random.between(0.01, 1.0);
    add(origin, direction);
  }

  void off_surface(CaseRandom& random) {
    const SurfacePoint from = sampler_.draw(random);
    const int what = random.below(scene_.triangles.empty() ? 2 : 3);
    const Vector3 direction = what == 0   ? any_direction(random)
                              : what == 1 ? minus(sampler_.draw(random).point, from.point)
                                          : minus(features_.vertex(random), from.point);
    add(from.point, direction, from.face);
  }

  void along_ball(CaseRandom& random) {
    const auto& ball =
        scene_.balls[static_cast<std::size_t>(random.below(static_cast<int>(scene_.balls.size())))];
    const Vector3& centre = ball.centre;
    const auto axis = static_cast<std::size_t>(random.below(3));
    Vector3 side{}, forward{};
    side[axis] = random.chance(0.5) ? ball.radius : -ball.radius;
    if (random.chance(0.5)) {
      forward[(axis + 1) % 3] = random.chance(0.5) ? 1 : -1;
      return add(along(plus(centre, side), forward, -size_ * random.between(0.001, 1.0)), forward);
    }
    // A point of the silhouette as seen from the origin: seen from outside, the sine of the angle between
    // the tangent and the way to the centre is radius / distance.
    const Vector3 origin = any_point(random), to = minus(centre, origin);
    const double distance = length_of(to);
    if (!(distance > ball.radius)) return add(origin, any_direction(random));
    const Vector3 aside = unit_of(cross_product(to, any_direction(random)));
    const double sine = ball.radius / distance, cosine = std::sqrt(1 - sine * sine);
    add(origin, along(times(unit_of(to), cosine), aside, sine));
  }

  const scene::Scene& scene_;
  const WorkloadOptions& options_;
  SurfaceSampler sampler_;
  FeatureSampler features_;
  scene::Box<double> extent_;
  double size_ = 0;
  Rays rays_;
};

}  // namespace

Rays record_hard_rays(const scene::Scene& scene, const WorkloadOptions& options) {
  return HardRayRecorder(scene, options).record();
}

}  // namespace gnomon::fuzz
