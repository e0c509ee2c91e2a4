// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/workload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fuzz/camera.h"
#include "fuzz/lights.h"
#include "fuzz/surface_sampler.h"
#include "fuzz/vectors.h"
#include "fuzz/workload_parts.h"
#include "scene/printable.h"
#include "scene/scene_facts.h"

namespace gnomon::fuzz {
namespace {

constexpr WorkloadKind kKinds[] = {
    {"primary", "first hits of the view's pixels, each to every light"},
    {"surface", "random points of faces, by area, to the lights in turn"},
    {"light-rays", "from the lights to first hits, and a little beyond and before them"},
    {"emitter", "points of polygon lights to receivers spread over the faces"},
    {"hard", "shadow boundaries to the last bit, edges, vertices, grazing and axis-parallel segments"},
    {"radiosity", "pairs of patches, all rays between points of both; radiosity@N: N rays a pair, a square"},
};
constexpr Queries (*kRecorders[])(const scene::Scene&, const Oracle&, const WorkloadOptions&) = {
    record_primary, record_surface, record_light_rays, record_emitter, record_hard};

constexpr WorkloadKind kRayKinds[] = {
    {"primary-rays", "the rays of the view's pixels"},
    {"hard-rays", "rays at edges, vertices and silhouettes, grazing, axis-parallel, off surfaces"},
};
constexpr Rays (*kRayRecorders[])(const scene::Scene&, const WorkloadOptions&) = {record_primary_rays,
                                                                                  record_hard_rays};

constexpr std::string_view kRadiosity = "radiosity";
constexpr std::size_t kLargestSide = 100;

const WorkloadKind* find_kind(std::span<const WorkloadKind> kinds, std::string_view name) {
  if (is_radiosity(name)) {
    static_cast<void>(pair_rays_of(name));
    name = kRadiosity;
  }
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [name](const WorkloadKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

[[noreturn]] void fail_unknown(std::span<const std::span<const WorkloadKind>> lists, std::string_view name) {
  std::string known;
  for (const auto& kinds : lists) {
    for (const WorkloadKind& kind : kinds) known += (known.empty() ? "" : ", ") + std::string(kind.name);
  }
  throw std::runtime_error("--workload: expected a workload (" + known + "), found \"" +
                           scene::printable(name) + "\"");
}

}  // namespace

std::span<const WorkloadKind> workload_kinds() {
  return kKinds;
}

bool is_radiosity(std::string_view name) {
  return name == kRadiosity || name.starts_with(std::string(kRadiosity) + "@");
}

std::size_t pair_rays_of(std::string_view name) {
  if (name == kRadiosity) return kDefaultPairRays;
  const std::string_view digits = name.substr(kRadiosity.size() + 1);
  for (std::size_t side = 1; side <= kLargestSide; ++side) {
    if (digits == std::to_string(side * side)) return side * side;
  }
  throw std::runtime_error(
      "--workload: expected radiosity@RAYS with a square number of rays from 1 to 10000, found \"" +
      scene::printable(name) + "\"");
}

std::span<const WorkloadKind> ray_workload_kinds() {
  return kRayKinds;
}

const WorkloadKind& workload_kind(std::string_view name) {
  for (const auto& kinds : {workload_kinds(), ray_workload_kinds()}) {
    if (const WorkloadKind* const kind = find_kind(kinds, name)) return *kind;
  }
  fail_unknown(std::array{workload_kinds(), ray_workload_kinds()}, name);
}

Workload record_workload(std::string_view name, const scene::Scene& scene, const Oracle& oracle,
                         const WorkloadOptions& options) {
  const WorkloadKind* const kind = find_kind(kKinds, name);
  if (kind == nullptr) fail_unknown(std::array{workload_kinds()}, name);
  Workload workload{std::string(name), {}, {}};
  if (is_radiosity(name)) {
    workload.pairs = record_pairs(scene, {pair_rays_of(name), options.queries, options.seed});
    workload.queries = queries_of(workload.pairs);
    return workload;
  }
  workload.queries = kRecorders[kind - kKinds](scene, oracle, options);
  thin(workload.queries, options.queries);
  return workload;
}

Rays record_rays(std::string_view name, const scene::Scene& scene, const WorkloadOptions& options) {
  const WorkloadKind* const kind = find_kind(kRayKinds, name);
  if (kind == nullptr) fail_unknown(std::array{ray_workload_kinds()}, name);
  return kRayRecorders[kind - kRayKinds](scene, options);
}

void thin(std::vector<scene::ShadowQuery>& queries, std::size_t count) {
  if (queries.size() <= count) return;
  const std::size_t size = queries.size();
  // Place i comes from i size / count >= i: nothing is overwritten before it is read.
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = i * (size / count) + i * (size % count) / count;
    queries[i] = queries[from];
  }
  queries.resize(count);
}

std::vector<std::uint32_t> shuffled_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  CaseRandom random(1, stream_of("shuffled order"), count);
  for (std::size_t i = count; i > 1; --i) {  // Fisher and Yates
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
  return order;
}

namespace {

/// The share of the picture that sees a face, by a small one; at least the share of one pixel.
double share_of_hits(const scene::View& view, const Oracle& oracle) {
  const auto [columns, rows] = picture_size(view, 1024);
  const Camera camera(view, columns, rows);
  std::size_t hits = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      hits += oracle.first_hit(camera.ray(column, row)) != scene::kNoFace ? 1U : 0U;
    }
  }
  return static_cast<double>(std::max<std::size_t>(hits, 1)) / static_cast<double>(columns * rows);
}

}  // namespace

Queries record_primary(const scene::Scene& scene, const Oracle& oracle, const WorkloadOptions& options) {
  const std::vector<Vector3> lights = light_points(scene);
  const double pixels = static_cast<double>(std::max<std::size_t>(1, options.queries / lights.size()));
  const auto [columns, rows] =
      picture_size(*scene.view, static_cast<std::size_t>(pixels / share_of_hits(*scene.view, oracle)));
  const Camera camera(*scene.view, columns, rows);
  Queries queries;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const scene::RayQuery ray = camera.ray(column, row);
      const std::uint32_t face = oracle.first_hit(ray);
      if (face == scene::kNoFace) continue;
      const Vector3 point = hit_point(scene, face, ray);
      for (const Vector3& light : lights) queries.push_back({point, light, face});
    }
  }
  return queries;
}

Rays record_primary_rays(const scene::Scene& scene, const WorkloadOptions& options) {
  Rays rays;
  if (scene.face_count() == 0) return rays;
  const auto [columns, rows] = picture_size(*scene.view, options.queries);
  const Camera camera(*scene.view, columns, rows);
  rays.reserve(columns * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) rays.push_back(camera.ray(column, row));
  }
  return rays;
}

Queries record_light_rays(const scene::Scene& scene, const Oracle& oracle, const WorkloadOptions& options) {
  const std::vector<Vector3> lights = light_points(scene);
  const scene::Box<double> extent = scene::extent_of(scene);
  Queries queries;
  const std::uint32_t stream = stream_of("light-rays");
  // Rays that miss ask nothing: at most twice as many as would fill the workload.
  const std::size_t most = 2 * (options.queries / 3 + 1);
  for (std::size_t i = 0; i < most && queries.size() < options.queries; ++i) {
    CaseRandom random(options.seed, stream, i);
    const Vector3& light = lights[i % lights.size()];
    Vector3 target;
    for (int axis = 0; axis < 3; ++axis) {
      target[static_cast<std::size_t>(axis)] = random.between(extent.lo(axis), extent.hi(axis));
    }
    const Vector3 direction = as_floats(unit_of(minus(target, light)));
    if (length_of(direction) == 0) continue;
    const scene::RayQuery ray{light, direction, scene::kNoFace};
    const std::uint32_t face = oracle.first_hit(ray);
    if (face == scene::kNoFace) continue;
    const Vector3 hit = hit_point(scene, face, ray);
    // From an ulp or so of the distance to a 256th of it.
    const double step = std::ldexp(1.0, -random.integer(8, 24));
    queries.push_back({hit, light, face});
    queries.push_back({as_floats(along(hit, minus(hit, light), step)), light, scene::kNoFace});
    queries.push_back({as_floats(along(hit, minus(light, hit), step)), light, scene::kNoFace});
  }
  return queries;
}

}  // namespace gnomon::fuzz
