// SPDX-License-Identifier: MIT
//
// The rays of a tile against one triangle, compiled once for each instruction set: the arithmetic and the
// error bounds of fast/hierarchy_triangles_inl.h, with rays in the lanes in place of triangles. Internal to
// fast/pair_*.
#if defined(GNOMON_FAST_PAIR_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_PAIR_RAYS_INL_H_
#undef GNOMON_FAST_PAIR_RAYS_INL_H_
#else
#define GNOMON_FAST_PAIR_RAYS_INL_H_
#endif

#include "fast/hierarchy_balls_inl.h"
#include "fast/hierarchy_triangles_inl.h"
#include "fast/pair_tile.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

using RayFloats = hn::CappedTag<float, kTileRays>;
using RV = hn::Vec<RayFloats>;
using RM = hn::Mask<RayFloats>;

/// A bit for each ray.
struct RayBits {
  std::uint32_t certain = 0, possible = 0;
};

/// The numbers base[offset of each lane], for the lanes from `at` on.
HWY_INLINE RV spread_points(const float* base, const std::int32_t* offsets) {
  const RayFloats d;
  const hn::RebindToSigned<RayFloats> d_offsets;
  const auto indices = hn::LoadU(d_offsets, offsets);
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return hn::TableLookupLanes(hn::LoadU(d, base), hn::IndicesFromVec(d, indices));
#else
  return hn::GatherIndex(d, base, indices);
#endif
}

/// For each shape of a tile the offsets of its rays' points, by the binary logarithm of to_count.
struct TileOffsets {
  std::int32_t from[5][kTileRays], to[5][kTileRays];
};
inline constexpr TileOffsets kTileOffsets = [] {
  TileOffsets offsets{};
  for (std::size_t shape = 0; shape < 5; ++shape) {
    for (std::size_t ray = 0; ray < kTileRays; ++ray) {
      offsets.from[shape][ray] = static_cast<std::int32_t>(ray >> shape);
      offsets.to[shape][ray] = static_cast<std::int32_t>(ray & ((std::size_t{1} << shape) - 1));
    }
  }
  return offsets;
}();

/// Sets the tile up; a bit for each ray whose points differ.
HWY_INLINE std::uint32_t fill_tile(const PairPatch& from, std::size_t first_from, const PairPatch& to,
                                   std::size_t first_to, std::size_t shape, RayTile& tile) {
  const RayFloats d;
  std::uint32_t differ = 0;
  for (std::size_t at = 0; at < kTileRays; at += hn::Lanes(d)) {
    RV sum = hn::Zero(d), largest = hn::Zero(d);
    for (std::size_t k = 0; k < 3; ++k) {
      const RV p = spread_points(from.coordinates(k) + first_from, kTileOffsets.from[shape] + at);
      const RV q = spread_points(to.coordinates(k) + first_to, kTileOffsets.to[shape] + at);
      const RV direction = hn::Sub(q, p);
      hn::Store(p, d, tile.origin[k].data() + at);
      hn::Store(direction, d, tile.direction[k].data() + at);
      const RV magnitude = hn::Abs(direction);
      sum = hn::Add(sum, magnitude);
      largest = hn::Max(largest, magnitude);
    }
    const RV spread = hn::Min(sum, hn::Mul(hn::Set(d, 2.0f), largest));
    hn::Store(largest, d, tile.largest.data() + at);
    hn::Store(hn::Mul(hn::Set(d, kThirdEdge), spread), d, tile.third_spread.data() + at);
    differ |= static_cast<std::uint32_t>(bits_of(d, hn::Ne(largest, hn::Zero(d)))) << at;
  }
  return differ;
}

/// The rays that the triangle blocks for certain, and those that it may block. Naive: both the same, edges
/// included, ends not.
template <bool kCertified>
HWY_INLINE RayBits rays_on_triangle(const RayTile& tile, const TriangleBlock& block, std::size_t lane,
                                    [[maybe_unused]] std::uint32_t live) {
  const RayFloats d;
  const RV zero = hn::Zero(d);
  RayBits bits;
  for (std::size_t at = 0; at < kTileRays; at += hn::Lanes(d)) {
    const auto load = [&](const RayTile::Lanes& lanes) { return hn::Load(d, lanes.data() + at); };
    const auto same = [&](const Eight& eight) { return hn::Set(d, eight[lane]); };
    const RV cx = hn::Sub(same(block.v0[0]), load(tile.origin[0])),
             cy = hn::Sub(same(block.v0[1]), load(tile.origin[1])),
             cz = hn::Sub(same(block.v0[2]), load(tile.origin[2]));
    const RV dx = load(tile.direction[0]), dy = load(tile.direction[1]), dz = load(tile.direction[2]);
    const RV rx = hn::Sub(hn::Mul(cy, dz), hn::Mul(cz, dy)), ry = hn::Sub(hn::Mul(cz, dx), hn::Mul(cx, dz)),
             rz = hn::Sub(hn::Mul(cx, dy), hn::Mul(cy, dx));
    const auto dot = [&](const std::array<Eight, 3>& a, RV x, RV y, RV z) {
      return hn::Add(hn::Add(hn::Mul(same(a[0]), x), hn::Mul(same(a[1]), y)), hn::Mul(same(a[2]), z));
    };
    const RV u = dot(block.to_v2, rx, ry, rz), v = dot(block.to_v1, rx, ry, rz);
    const RV along = dot(block.normal, dx, dy, dz);
    const RV w = hn::Sub(along, hn::Add(u, v));
    const RV least = hn::Min(hn::Min(u, v), w), most = hn::Max(hn::Max(u, v), w);
    if constexpr (kCertified) {
      const RV c_most = hn::Max(hn::Max(hn::Abs(cx), hn::Abs(cy)), hn::Abs(cz));
      const RV normal_error = same(block.normal_error), tiny = hn::Set(d, kTriangleUnderflow);
      const RV d_error = hn::Add(hn::Mul(normal_error, load(tile.largest)), tiny);
      const RV w_error =
          hn::Add(hn::Mul(hn::Mul(same(block.edge_error), c_most), load(tile.third_spread)), d_error);
      const RM positive = hn::Gt(least, w_error), negative = hn::Lt(most, hn::Neg(w_error));
      const RM crosses = hn::And(hn::Gt(most, w_error), hn::Lt(least, hn::Neg(w_error)));
      const std::uint64_t open = bits_of(d, hn::Not(crosses));
      if ((open & (live >> at)) == 0) continue;
      const RV t = dot(block.normal, cx, cy, cz);
      const RV t1 = hn::Sub(t, along);
      const RV t_error = hn::Add(hn::Mul(normal_error, c_most), tiny);
      const RM ends = hn::And(hn::Gt(hn::Abs(t), t_error), hn::Gt(hn::Abs(t1), hn::Add(t_error, d_error)));
      const RM opposite = hn::Xor(hn::Gt(t, zero), hn::Gt(t1, zero));  // where neither is 0
      bits.certain |=
          static_cast<std::uint32_t>(bits_of(d, hn::And(hn::Or(positive, negative), hn::And(ends, opposite))))
          << at;
      bits.possible |=
          static_cast<std::uint32_t>(bits_of(d, hn::Not(hn::Or(crosses, hn::AndNot(opposite, ends))))) << at;
    } else {
      const RV t = dot(block.normal, cx, cy, cz);
      const RV t1 = hn::Sub(t, along);
      const RM crosses = hn::And(hn::Gt(most, zero), hn::Lt(least, zero));
      const RM ends =
          hn::Or(hn::And(hn::Gt(t, zero), hn::Lt(t1, zero)), hn::And(hn::Lt(t, zero), hn::Gt(t1, zero)));
      bits.possible |= static_cast<std::uint32_t>(bits_of(d, hn::AndNot(crosses, ends))) << at;
    }
  }
  if (!kCertified) bits.certain = bits.possible;
  return bits;
}

/// One ray of the tile, as the kernels that test eight faces against it want it.
HWY_INLINE Beam beam_of(const RayTile& tile, std::size_t ray) {
  Beam beam{};
  for (std::size_t k = 0; k < 3; ++k) {
    beam.origin[k] = tile.origin[k][ray];
    beam.direction[k] = tile.direction[k][ray];
  }
  beam.measure();
  return beam;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
