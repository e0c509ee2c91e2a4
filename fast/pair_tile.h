// SPDX-License-Identifier: MIT
// How the rays of a pair are cut into vectors, and the memory that a pair is worked on in. Internal to
// fast/pair_*.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fast/pair_arrays.h"
#include "fast/pair_visibility.h"

namespace gnomon::fast {

/// Rays of a tile: from a few points to a few points, `from_count` * `to_count` of them.
inline constexpr std::size_t kTileRays = 16;

struct TileShape {
  std::size_t from_log = 0, to_log = 0;  ///< binary logarithms of how many points; they add up to 4

  [[nodiscard]] constexpr std::size_t from_count() const { return std::size_t{1} << from_log; }
  [[nodiscard]] constexpr std::size_t to_count() const { return std::size_t{1} << to_log; }
};

/// As few tiles as can be; squares if there is a choice, as their shafts are the thinnest.
[[nodiscard]] constexpr TileShape best_tile_shape(std::size_t from, std::size_t to) {
  if (from % 4 == 0 && to % 4 == 0) return {2, 2};
  constexpr TileShape kShapes[] = {{2, 2}, {1, 3}, {3, 1}, {0, 4}, {4, 0}};
  TileShape best = kShapes[0];
  std::size_t least = ~std::size_t{0};
  for (const TileShape shape : kShapes) {
    const std::size_t tiles =
        ((from + shape.from_count() - 1) >> shape.from_log) * ((to + shape.to_count() - 1) >> shape.to_log);
    if (tiles < least) {
      least = tiles;
      best = shape;
    }
  }
  return best;
}

/// Rays i * to_count + k from point i to point k; lanes beyond the batch repeat its last points.
struct alignas(64) RayTile {
  using Lanes = std::array<float, kTileRays>;
  std::array<Lanes, 3> origin, direction;
  Lanes largest, third_spread;  ///< as in fast/hierarchy_beam.h and fast/hierarchy_vectors_inl.h
};

/// A face that is too close to call for the rays of these lanes.
struct OpenFace {
  std::uint32_t face, lanes;
};

/// A face of a leaf.
struct LeafLane {
  ChildLink link = ChildLink::leaf(false, 1, 0);
  std::uint32_t lane = kWidth;  ///< kWidth: none
};

struct PairScratch::Data {
  PairPatch from, to;
  std::vector<std::array<float, 6>> from_boxes, to_boxes;  ///< of the points of a row or column of tiles
  std::vector<std::uint32_t> links;  ///< what is left of the tree for the whole pair: bits of ChildLinks
  std::vector<OpenFace> open;
  LeafLane last_blocker;
  std::uint64_t owner = 0;  ///< the number of the caster that last_blocker is of
};

/// What the kernels see of a caster.
struct PairView {
  const scene::Scene& scene;
  const PairArrays& arrays;
};

/// Implemented by fast/pair_walk.cpp. There are rays and nodes, and in the certified tier all is in its
/// domain. `exact` and `counters` may be null.
PairResult run_pair(Hierarchy::Tier tier, const PairView& view, const PairPatch& from, const PairPatch& to,
                    PairScratch::Data& scratch, std::span<ShadowAnswer> answers, const ExactFaces* exact,
                    PairCounters* counters);
void run_candidates(const PairArrays& arrays, const PairPatch& from, const PairPatch& to,
                    std::vector<std::uint32_t>& faces);
void run_shaft_faces(const PairArrays& arrays, const std::array<float, 6>& a, const std::array<float, 6>& b,
                     std::vector<std::uint32_t>& faces);

}  // namespace gnomon::fast
