// SPDX-License-Identifier: GPL-3.0-or-later
// The rays that radiosity asks about: from points of a receiver to points of an emitter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fuzz/radiosity_patch.h"
#include "scene/shadow_query.h"

namespace gnomon::fuzz {

/// Sample points of a patch, floats: of a face exactly on its plane or in front of it.
struct PatchSamples {
  std::vector<Vector3> points;
  std::vector<std::uint32_t> faces;  ///< the triangle of `own` that each lies on; kNoFace on a polygon light
  scene::FaceRun own;                ///< the patch's triangles; none of a polygon light
  scene::Box<double> box;            ///< of the whole patch and the points, floats
  std::array<Vector3, 3> plane{};    ///< RadiosityPatch::plane
};

/// The rays between two patches that face each other: from each point of the receiver, in order, to every
/// point of the emitter. Every receiver's point is strictly in front of the emitter's plane, every emitter's
/// point strictly in front of the receiver's, exactly, so all of the rays face. Leaving out the triangles of
/// both patches changes no answer.
struct RadiosityPair {
  std::uint32_t emitter = 0, receiver = 0;  ///< numbers of patches, as the recorder says
  PatchSamples from;                        ///< of the receiver
  PatchSamples to;                          ///< of the emitter

  [[nodiscard]] std::size_t rays() const { return from.points.size() * to.points.size(); }
  /// Ray i as a query of `shadow`; its own face is the triangle that its point lies on.
  [[nodiscard]] scene::ShadowQuery query(std::size_t i) const {
    const std::size_t k = i / to.points.size();
    return {from.points[k], to.points[i % to.points.size()], from.faces[k]};
  }
};

/// All rays of the pairs, pair by pair.
[[nodiscard]] std::vector<scene::ShadowQuery> queries_of(std::span<const RadiosityPair> pairs);

struct RadiosityOptions {
  std::size_t rays = 64;         ///< of a pair: a square number, so many points on either side
  std::size_t queries = 100000;  ///< of all pairs at most
  std::uint64_t seed = 1;
};

/// Pairs drawn at random, each with just that many rays, points uniform by area. Emitters are the polygon
/// lights in turn; in scenes without any, polygons drawn by area. Receivers are drawn evenly among the
/// polygons, until one faces the emitter; where the part of one that faces the other is too small to be
/// met by points, the pair is drawn anew. `emitter` is the light's number, or that of the polygon in
/// patches_of(), as `receiver` is. The scene has floats alone. None where nothing is found.
[[nodiscard]] std::vector<RadiosityPair> record_pairs(const scene::Scene& scene,
                                                      const RadiosityOptions& options);

/// The parts of both lists that face each other, as a pair; without rays where one has none. Points of a
/// one-sided receiver that lie farther in front of its plane than an emitter's point, as rounding may have
/// it, are left out, too: no ray is answered `facing`.
[[nodiscard]] RadiosityPair facing_pair(const scene::Scene& scene, const RadiosityPatch& receiver,
                                        std::span<const Vector3> from, const RadiosityPatch& emitter,
                                        std::span<const Vector3> to);

}  // namespace gnomon::fuzz
