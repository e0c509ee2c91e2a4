// SPDX-License-Identifier: GPL-3.0-or-later
// The workload `hard`: queries that are decided by the last bits. In shares of the whole:
//   2/5  shadow boundaries: between two points of a face, or two points beside a line from a light past an
//        edge, that are exactly one lit and one not, bisected until no float lies between; both ends, and
//        four points within two ulps of them;
//   1/5  segments from a light through a point of an edge to a point beyond;
//   1/10 the same through a vertex;
//   3/20 both ends in, or within two ulps of, the plane of a face;
//   3/20 axis-parallel segments through a vertex or a point of a face.
// The lights of the last two kinds are points of their own: no light of the scene lies there.
#include <cmath>
#include <limits>

#include "fuzz/feature_sampler.h"
#include "fuzz/lights.h"
#include "fuzz/surface_sampler.h"
#include "fuzz/vectors.h"
#include "fuzz/workload_parts.h"
#include "scene/scene_facts.h"

namespace gnomon::fuzz {

Vector3 nudged(const Vector3& point, CaseRandom& random, int most) {
  Vector3 result = point;
  for (double& c : result) {
    float moved = static_cast<float>(c);
    const int steps = random.integer(-most, most);
    const float towards = (steps < 0 ? -1.0F : 1.0F) * std::numeric_limits<float>::max();
    for (int k = 0; k < std::abs(steps); ++k) moved = std::nextafter(moved, towards);
    c = static_cast<double>(moved);
  }
  return result;
}

namespace {

class HardRecorder {
 public:
  HardRecorder(const scene::Scene& scene, const Oracle& oracle, const WorkloadOptions& options)
      : scene_(scene),
        oracle_(oracle),
        options_(options),
        sampler_(scene),
        features_(scene),
        lights_(light_points(scene)) {
    const scene::Box<double> box = scene::extent_of(scene);
    size_ = length_of({box.hi(0) - box.lo(0), box.hi(1) - box.lo(1), box.hi(2) - box.lo(2)});
  }

  Queries record() {
    if (!sampler_.has_area()) return {};
    fill("hard boundary", 2, 5, 6, &HardRecorder::boundary);
    if (scene_.triangles.empty()) return std::move(queries_);
    fill("hard edge", 1, 5, 1, &HardRecorder::through_edge);
    fill("hard vertex", 1, 10, 1, &HardRecorder::through_vertex);
    fill("hard grazing", 3, 20, 1, &HardRecorder::grazing);
    fill("hard axis", 3, 20, 1, &HardRecorder::axis_parallel);
    return std::move(queries_);
  }

 private:
  /// Records a share of the queries by drawing cases, which add some queries or none. Cases that add none are
  /// given up after as many tries as there are queries to find.
  void fill(std::string_view stream, std::size_t share, std::size_t of, std::size_t each,
            void (HardRecorder::*draw)(CaseRandom&)) {
    const std::size_t count = options_.queries * share / of, last = queries_.size() + count;
    for (std::size_t i = 0; i < count && queries_.size() + each <= last; ++i) {
      CaseRandom random(options_.seed, stream_of(stream), i);
      (this->*draw)(random);
    }
  }

  const Vector3& any_light(CaseRandom& random) const {
    return lights_[static_cast<std::size_t>(random.below(static_cast<int>(lights_.size())))];
  }
  Vector3 any_edge_point(CaseRandom& random) const {
    const FeatureSampler::Edge edge = features_.edge(random);
    return edge.at(random.unit<double>());
  }

  void boundary(CaseRandom& random) {
    const Vector3& light = any_light(random);
    Vector3 a, b;
    std::uint32_t own = scene::kNoFace;
    if (scene_.triangles.empty() || random.chance(0.5)) {
      const SurfacePoint from = sampler_.draw(random);
      own = from.face;
      a = from.point;
      b = sampler_.point_on(own, random).point;
    } else {
      const Vector3 edge = any_edge_point(random);
      const Vector3 beyond = along(edge, unit_of(minus(edge, light)), size_ * random.between(0.001, 0.3));
      const double reach = size_ * 0.01 * random.unit<double>();
      const Vector3 aside =
          times({random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)}, reach);
      a = as_floats(plus(beyond, aside));
      b = as_floats(minus(beyond, aside));
    }
    const scene::Shadow first = oracle_.shadow({a, light, own});
    if (oracle_.shadow({b, light, own}) == first) return;
    // Each step halves the floats between on some axis: 32 bits and three axes end it.
    for (int step = 0; step < 100; ++step) {
      const Vector3 middle = as_floats(times(plus(a, b), 0.5));
      if (middle == a || middle == b) break;
      (oracle_.shadow({middle, light, own}) == first ? a : b) = middle;
    }
    queries_.push_back({a, light, own});
    queries_.push_back({b, light, own});
    for (int k = 0; k < 4; ++k) queries_.push_back({nudged(k % 2 == 0 ? a : b, random, 2), light, own});
  }

  /// A point beyond `through` as seen from a light. Halves, ones and twos make the point exactly collinear
  /// where the numbers' bits suffice.
  void beyond(const Vector3& through, CaseRandom& random) {
    constexpr double kSteps[] = {0.5, 1, 2};
    const Vector3& light = any_light(random);
    const double step = random.chance(0.5) ? kSteps[random.below(3)] : random.unit<double>();
    queries_.push_back({as_floats(along(through, minus(through, light), step)), light, scene::kNoFace});
  }
  void through_edge(CaseRandom& random) { beyond(any_edge_point(random), random); }
  void through_vertex(CaseRandom& random) { beyond(features_.vertex(random), random); }

  void grazing(CaseRandom& random) {
    const std::size_t t = features_.triangle(random);
    const int ulps = random.integer(0, 2);
    const Vector3 point = features_.point_in_plane(t, random), light = features_.point_in_plane(t, random);
    queries_.push_back({nudged(point, random, ulps), nudged(light, random, ulps),
                        random.chance(0.5) ? static_cast<std::uint32_t>(t) : scene::kNoFace});
  }

  void axis_parallel(CaseRandom& random) {
    const Vector3 through = random.chance(0.5) ? features_.vertex(random) : sampler_.draw(random).point;
    const auto axis = static_cast<std::size_t>(random.below(3));
    Vector3 point = through, light = through;
    point[axis] += size_ * random.between(0.001, 1.0);
    light[axis] -= size_ * random.between(0.001, 1.0);
    if (random.chance(0.5)) std::swap(point, light);
    queries_.push_back({as_floats(point), as_floats(light), scene::kNoFace});
  }

  const scene::Scene& scene_;
  const Oracle& oracle_;
  const WorkloadOptions& options_;
  SurfaceSampler sampler_;
  FeatureSampler features_;
  std::vector<Vector3> lights_;
  double size_ = 0;
  Queries queries_;
};

}  // namespace

Queries record_hard(const scene::Scene& scene, const Oracle& oracle, const WorkloadOptions& options) {
  return HardRecorder(scene, oracle, options).record();
}

}  // namespace gnomon::fuzz
