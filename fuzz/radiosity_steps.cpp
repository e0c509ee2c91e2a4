// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/radiosity_steps.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "scene/scene_facts.h"

namespace gnomon::fuzz {
namespace {

constexpr double kReflectance = 0.5;
constexpr std::size_t kDarkSources = 10;  // as many as the paper's office has lights

Vector3 unit_normal(const RadiosityPatch& patch) {
  return unit_of(cross_product(minus(patch.plane[1], patch.plane[0]), minus(patch.plane[2], patch.plane[0])));
}

/// What a point of the receiver gets of a sample that stands for a disc of the emitter's area, both per area:
/// Wallace, Elmquist and Haines, "A Ray Tracing Algorithm for Progressive Radiosity", 1989, their form factor
/// of a disc. For the choice of emitters alone.
double share_of_disc(const Vector3& point, const Vector3& normal, const Vector3& light, const Vector3& shine,
                     double area) {
  const Vector3 way = minus(light, point);
  const double square = dot_product(way, way);
  const double cosines = dot_product(way, normal) * -dot_product(way, shine);
  if (!(square > 0) || !(cosines > 0)) return 0;
  return cosines / square * area / (std::numbers::pi * square + area);
}

/// The polygons and lights of a scene, and the light that each has still to send.
class Room {
 public:
  Room(const scene::Scene& scene, double spacing)
      : scene_(scene),
        patches_(patches_of(scene)),
        lights_(light_patches_of(scene)),
        unsent_(patches_.size()) {
    meshes_.reserve(patches_.size());
    for (const RadiosityPatch& patch : patches_) meshes_.push_back(mesh_of(patch, spacing));
    if (lights_.empty()) {
      std::vector<std::size_t> largest(patches_.size());
      std::iota(largest.begin(), largest.end(), std::size_t{0});
      std::stable_sort(largest.begin(), largest.end(),
                       [&](std::size_t a, std::size_t b) { return patches_[a].area > patches_[b].area; });
      largest.resize(std::min(largest.size(), kDarkSources));
      for (const std::size_t number : largest) lights_.push_back(patches_[number]);
    }
  }

  [[nodiscard]] bool empty() const { return patches_.empty(); }

  RadiosityStep shoot(std::size_t number, std::size_t side,
                      const std::function<bool(const scene::ShadowQuery&)>& hidden) {
    RadiosityStep step;
    double radiosity = 1;
    if (number < lights_.size()) {
      step.emitter = lights_[number];
    } else {
      const auto brightest =
          static_cast<std::size_t>(std::max_element(unsent_.begin(), unsent_.end()) - unsent_.begin());
      step.emitter = patches_[brightest];
      radiosity = unsent_[brightest] / step.emitter.area;
      unsent_[brightest] = 0;
    }
    const std::vector<Vector3> samples = samples_of(step.emitter, side);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const RadiosityPatch& receiver = patches_[i];
      if (!step.emitter.is_light() && receiver.own == step.emitter.own) continue;
      RadiosityPair pair = facing_pair(scene_, receiver, meshes_[i], step.emitter, samples);
      if (pair.rays() == 0) continue;
      pair.emitter = static_cast<std::uint32_t>(number);
      pair.receiver = static_cast<std::uint32_t>(i);
      std::vector<bool> blocked(pair.rays());
      const Vector3 normal = unit_normal(receiver), shine = unit_normal(step.emitter);
      const double area = step.emitter.area / static_cast<double>(samples.size());
      double sum = 0;
      for (std::size_t ray = 0; ray < blocked.size(); ++ray) {
        const scene::ShadowQuery query = pair.query(ray);
        blocked[ray] = hidden(query);
        if (!blocked[ray]) sum += share_of_disc(query.point, normal, query.light, shine, area);
      }
      unsent_[i] += kReflectance * radiosity * sum / static_cast<double>(meshes_[i].size()) * receiver.area;
      step.pairs.push_back(std::move(pair));
      step.hidden.push_back(std::move(blocked));
    }
    return step;
  }

 private:
  const scene::Scene& scene_;
  std::vector<RadiosityPatch> patches_, lights_;
  std::vector<std::vector<Vector3>> meshes_;
  std::vector<double> unsent_;
};

}  // namespace

std::vector<RadiosityStep> record_steps(const scene::Scene& scene,
                                        const std::function<bool(const scene::ShadowQuery&)>& hidden,
                                        const StepOptions& options) {
  Room room(scene, options.spacing > 0 ? options.spacing : default_spacing(scene));
  std::vector<RadiosityStep> steps;
  for (std::size_t i = 0; i < options.steps && !room.empty(); ++i) {
    steps.push_back(room.shoot(i, options.emitter_side, hidden));
  }
  return steps;
}

double default_spacing(const scene::Scene& scene) {
  const scene::Box<double> extent = scene::extent_of(scene);
  double side = 0;
  for (int axis = 0; axis < 3; ++axis) side = std::max(side, extent.hi(axis) - extent.lo(axis));
  return side / 40;
}

}  // namespace gnomon::fuzz
