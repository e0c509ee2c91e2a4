// SPDX-License-Identifier: MIT
// What the kernels of a Hierarchy compute on the way, for the tests of its error bounds. Internal to
// fast/hierarchy*.
#pragma once

#include <cstdint>

#include "fast/hierarchy_beam.h"
#include "fast/hierarchy_layout.h"

namespace gnomon::fast {

/// The values of fast/hierarchy_triangles_inl.h, and their thresholds. `edge_error` is what u and v alone
/// would need; the kernel uses `w_error` for them too.
struct TriangleProbe {
  Eight u, v, w, t, d, edge_error, w_error, t_error, d_error;
};
[[nodiscard]] TriangleProbe probe_triangles(const TriangleBlock& block, const Beam& beam);

/// G of fast/hierarchy_balls_inl.h for a range that ends at `end`, and its threshold.
struct BallProbe {
  Eight depth, error;
};
[[nodiscard]] BallProbe probe_balls(const BallBlock& block, const Beam& beam, float end);

/// What a ray without an end finds in a leaf: bits, and the parameters of lanes that are possible.
struct RayProbe {
  std::uint32_t certain, possible;
  Eight lo, hi;
};
[[nodiscard]] RayProbe probe_ray(const TriangleBlock& block, const Beam& beam);
/// `leaving`: the parameters at which it leaves the balls, as it does its own, not those at which it enters.
[[nodiscard]] RayProbe probe_ray(const BallBlock& block, const Beam& beam, bool leaving = false);

/// A bit for each child whose box is visited.
[[nodiscard]] std::uint32_t probe_boxes(const WideNode& node, const Beam& beam, float end);

}  // namespace gnomon::fast
