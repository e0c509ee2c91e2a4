// SPDX-License-Identifier: GPL-3.0-or-later
// Workloads: the queries that a scene really asks, recorded first, so that every method is asked the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/radiosity.h"
#include "scene/ray_query.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::fuzz {

/// A kind of workload.
struct WorkloadKind {
  std::string_view name;
  std::string_view description;
};

/// The kinds that ask `shadow`, in the order of reports.
[[nodiscard]] std::span<const WorkloadKind> workload_kinds();

/// Those that ask `first-hit`.
[[nodiscard]] std::span<const WorkloadKind> ray_workload_kinds();

/// The kind of that name, of either question; @RAYS may follow `radiosity`. Throws std::runtime_error, naming
/// the known ones.
[[nodiscard]] const WorkloadKind& workload_kind(std::string_view name);

/// The rays of a pair where a workload of radiosity doesn't say.
inline constexpr std::size_t kDefaultPairRays = 64;

/// True of `radiosity` and `radiosity@RAYS`.
[[nodiscard]] bool is_radiosity(std::string_view name);

/// The rays of a pair of such a workload. Throws std::runtime_error unless they are a square number from 1 to
/// 10000.
[[nodiscard]] std::size_t pair_rays_of(std::string_view name);

/// Exact answers about the scene that a workload is recorded from.
struct Oracle {
  /// A face that the ray meets first, the lowest of tied ones, or kNoFace.
  std::function<std::uint32_t(const scene::RayQuery&)> first_hit;
  std::function<scene::Shadow(const scene::ShadowQuery&)> shadow;
};

struct WorkloadOptions {
  std::size_t queries = 100000;  ///< at most so many
  std::uint64_t seed = 1;
};

/// The queries of a workload in the order in which a renderer would ask them; every number is a float.
struct Workload {
  std::string name;
  std::vector<scene::ShadowQuery> queries;
  /// Of radiosity: the pairs whose rays the queries are, in their order.
  std::vector<RadiosityPair> pairs;
};

/// Records a workload from a scene of floats that has lights and a view (complete()); the same scene, options
/// and answers give the same queries everywhere. Nothing where the scene asks no such query: `emitter`
/// without polygon lights, surfaces of a scene without area. Throws std::runtime_error, naming the known
/// ones, for a name that is none of `shadow`.
///
/// primary: the pixels of the view, each one's first hit to every light (polygon lights by
///   kPointsPerPolygonLight points); the picture is made smaller than the view's where it would ask more
///   than it may.
/// surface: points of faces, uniform by area, to the lights in turn.
/// light-rays: from each light towards random points of the scene's box to the first hit: the segment from
///   there (own face: the one hit), from a little beyond it and from a little before it back to the light.
/// emitter: radiosity's form factors: points of polygon lights to receivers spread evenly over the faces.
/// hard: see workload_hard.cpp.
/// radiosity@RAYS: pairs of patches with so many rays each, as record_pairs() draws them; kDefaultPairRays
///   without @RAYS.
[[nodiscard]] Workload record_workload(std::string_view name, const scene::Scene& scene, const Oracle& oracle,
                                       const WorkloadOptions& options);

/// Records the rays of a workload of `first-hit`, of the same kind of scene; every number is a float.
/// Nothing where the scene has no surface to aim at. Throws std::runtime_error, naming the known ones, for a
/// name that is none.
///
/// primary-rays: those of the view's pixels, row by row; the picture is made smaller than the view's where
///   it has more pixels than may be asked.
/// hard-rays: see workload_hard_rays.cpp.
[[nodiscard]] std::vector<scene::RayQuery> record_rays(std::string_view name, const scene::Scene& scene,
                                                       const WorkloadOptions& options);

/// `count` of the queries (all when they are fewer), evenly chosen, in their order.
void thin(std::vector<scene::ShadowQuery>& queries, std::size_t count);

/// The numbers 0 .. count-1 in random order: the same for the same count.
[[nodiscard]] std::vector<std::uint32_t> shuffled_order(std::size_t count);

}  // namespace gnomon::fuzz
