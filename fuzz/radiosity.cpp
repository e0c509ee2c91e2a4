// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/radiosity.h"

#include <algorithm>
#include <cmath>

#include "exact/shadow.h"

namespace gnomon::fuzz {
namespace {

/// Points of `patch` in front of `other`, drawn until there are `count`; fewer where they are rare.
std::vector<Vector3> draw_facing(const RadiosityPatch& patch, const RadiosityPatch& other, std::size_t count,
                                 CaseRandom& random) {
  std::vector<Vector3> points;
  points.reserve(count);
  for (std::size_t tries = 0; tries < 4 * count && points.size() < count; ++tries) {
    const Vector3 point = point_on(patch, random);
    if (side_of(other, point) > 0) points.push_back(point);
  }
  return points;
}

/// Whether a corner of the patch lies in front of the other one's plane.
bool reaches_before(const RadiosityPatch& patch, const RadiosityPatch& other) {
  return std::any_of(patch.corners.begin(), patch.corners.end(),
                     [&](const Vector3& corner) { return side_of(other, corner) > 0; });
}

PatchSamples samples_with_box(const RadiosityPatch& patch, std::vector<Vector3> points) {
  PatchSamples samples{std::move(points), {}, patch.own, patch.box, patch.plane};
  for (const Vector3& point : samples.points) {
    samples.faces.push_back(face_of(patch, point));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      samples.box.c[axis] = std::min(samples.box.c[axis], point[axis]);
      samples.box.c[axis + 3] = std::max(samples.box.c[axis + 3], point[axis]);
    }
  }
  return samples;
}

/// A patch at a share in [0, 1) of the area of all.
class PatchesByArea {
 public:
  explicit PatchesByArea(std::span<const RadiosityPatch> patches) {
    double sum = 0;
    for (const RadiosityPatch& patch : patches) sums_.push_back(sum += patch.area);
  }
  [[nodiscard]] std::size_t at(double share) const {
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), share * sums_.back());
    return std::min(static_cast<std::size_t>(found - sums_.begin()), sums_.size() - 1);
  }

 private:
  std::vector<double> sums_;
};

}  // namespace

std::vector<scene::ShadowQuery> queries_of(std::span<const RadiosityPair> pairs) {
  std::vector<scene::ShadowQuery> queries;
  for (const RadiosityPair& pair : pairs) {
    for (std::size_t i = 0; i < pair.rays(); ++i) queries.push_back(pair.query(i));
  }
  return queries;
}

RadiosityPair facing_pair(const scene::Scene& scene, const RadiosityPatch& receiver,
                          std::span<const Vector3> from, const RadiosityPatch& emitter,
                          std::span<const Vector3> to) {
  RadiosityPair pair;
  std::vector<Vector3> points, lights;
  for (const Vector3& point : from) {
    if (side_of(emitter, point) > 0) points.push_back(point);
  }
  if (points.empty()) return pair;
  for (const Vector3& light : to) {
    if (side_of(receiver, light) > 0) lights.push_back(light);
  }
  if (lights.empty()) return pair;
  if (receiver.one_sided) {
    std::erase_if(points, [&](const Vector3& point) {
      return std::any_of(lights.begin(), lights.end(), [&](const Vector3& light) {
        return exact::faces_away(scene, {point, light, receiver.own.first});
      });
    });
  }
  pair.from = samples_with_box(receiver, std::move(points));
  pair.to = samples_with_box(emitter, std::move(lights));
  return pair;
}

std::vector<RadiosityPair> record_pairs(const scene::Scene& scene, const RadiosityOptions& options) {
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(options.rays))));
  const std::vector<RadiosityPatch> patches = patches_of(scene), lights = light_patches_of(scene);
  std::vector<RadiosityPair> pairs;
  if (patches.empty()) return pairs;
  const PatchesByArea by_area(patches);
  const std::size_t count = options.queries / options.rays;
  const std::uint32_t stream = stream_of("radiosity");
  // A pair that doesn't face costs little; scenes where none does end some time.
  const std::size_t most = 64 * count + 4096;
  for (std::size_t i = 0; i < most && pairs.size() < count; ++i) {
    CaseRandom random(options.seed, stream, i);
    const std::size_t turn = pairs.size() % std::max<std::size_t>(lights.size(), 1);
    const std::size_t chosen = lights.empty() ? by_area.at(random.unit<double>()) : turn;
    const RadiosityPatch& emitter = lights.empty() ? patches[chosen] : lights[chosen];
    const auto number = static_cast<std::size_t>(random.below(static_cast<int>(patches.size())));
    const RadiosityPatch& receiver = patches[number];
    if (receiver.own == emitter.own || !reaches_before(receiver, emitter) ||
        !reaches_before(emitter, receiver)) {
      continue;
    }
    const std::vector<Vector3> from = draw_facing(receiver, emitter, side, random);
    const std::vector<Vector3> to = draw_facing(emitter, receiver, side, random);
    RadiosityPair pair = facing_pair(scene, receiver, from, emitter, to);
    if (pair.rays() != side * side) continue;
    pair.emitter = static_cast<std::uint32_t>(chosen);
    pair.receiver = static_cast<std::uint32_t>(number);
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace gnomon::fuzz
