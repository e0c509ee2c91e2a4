// SPDX-License-Identifier: MIT
//
// Eight boxes, or the eight faces of a leaf, against the shaft of many rays, compiled once for each
// instruction set. Internal to fast/pair_*.
//
// ONE SIDE OF A TRIANGLE'S PLANE. With the exact normal N, n as stored, a box of points p with centre o and
// half widths h (both floats, |p - o| <= h on each axis) and c = v0 - o:
//     N . (v0 - p) = N . c - N . (p - o),   |N . (p - o)| <= |n| . h + |N - n|_1 |h|_m.
// n . c is off by at most N' |c|_m + 2^-104, N' = 5 u |n|_1 + |N - n|_1 being the block's normal_error
// (fast/hierarchy_triangles_inl.h), and |n| . h is computed within g(3) of itself and 3 eta: the factor 1 + 8
// u pays for it and for the sums below. So all p lie strictly on the side of n . c's sign when its magnitude
// exceeds (1 + 8 u) |n| . h + N' (|c|_m + |h|_m) + 2^-104, where N' was rounded up by 16 u.
// If all the points of both ends lie strictly on one side, no segment between them meets the plane.
#if defined(GNOMON_FAST_PAIR_CULL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_PAIR_CULL_INL_H_
#undef GNOMON_FAST_PAIR_CULL_INL_H_
#else
#define GNOMON_FAST_PAIR_CULL_INL_H_
#endif

#include "fast/hierarchy_vectors_inl.h"
#include "fast/pair_shaft.h"
#include "fast/pair_tile.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// The children of lanes from `at` on whose boxes the shaft meets, or may.
HWY_INLINE M boxes_in_shaft(const PairShaft& shaft, const WideNode& node, std::size_t at) {
  const Floats d;
  V near = hn::Zero(d), far = hn::Set(d, kShaftEnd);
  const auto bound = [&](std::size_t i) {
    return hn::Mul(hn::Sub(hn::Load(d, node.bounds[shaft.row[i]].data() + at), hn::Set(d, shaft.origin[i])),
                   hn::Set(d, shaft.inverse[i]));
  };
  std::size_t i = 0;
  for (; i < shaft.lower; ++i) near = more_or_second(bound(i), near);
  for (; i < 6; ++i) far = less_or_second(bound(i), far);
  return hn::Le(near, far);
}

/// A box of points as centre and half widths.
struct CentredBox {
  std::array<float, 3> centre, half;
  float half_most;

  explicit CentredBox(const std::array<float, 6>& box) {
    half_most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      centre[k] = 0.5f * box[k] + 0.5f * box[k + 3];
      const float up = box[k + 3] - centre[k], down = centre[k] - box[k];
      // Differences of floats are exact when denormal, so that a factor is enough.
      half[k] = (up > down ? up : down) * (1 + 4 * Rounding<float>::u);
      half_most = half[k] > half_most ? half[k] : half_most;
    }
  }
};

/// Sets the lanes where all points of the box lie strictly on one side, in front or behind: where N . (v0 -
/// p) is negative or positive.
struct Sides {
  M front, behind;
};
HWY_INLINE Sides sides_of_planes(const CentredBox& box, const TriangleBlock& block, std::size_t at) {
  const Floats d;
  V value = hn::Zero(d), reach = hn::Zero(d), c_most = hn::Zero(d);
  for (std::size_t k = 0; k < 3; ++k) {
    const V n = hn::Load(d, block.normal[k].data() + at);
    const V c = hn::Sub(hn::Load(d, block.v0[k].data() + at), hn::Set(d, box.centre[k]));
    value = k == 0 ? hn::Mul(n, c) : hn::Add(value, hn::Mul(n, c));
    reach = hn::Add(reach, hn::Mul(hn::Abs(n), hn::Set(d, box.half[k])));
    c_most = hn::Max(c_most, hn::Abs(c));
  }
  const V size = hn::Add(c_most, hn::Set(d, box.half_most));
  const V error = hn::Add(hn::Add(hn::Mul(reach, hn::Set(d, 1 + 8 * Rounding<float>::u)),
                                  hn::Mul(hn::Load(d, block.normal_error.data() + at), size)),
                          hn::Set(d, kTriangleUnderflow));
  return {hn::Lt(value, hn::Neg(error)), hn::Gt(value, error)};
}

/// The lanes of triangles that segments from one box to the other may meet.
HWY_INLINE std::uint32_t triangles_between(const CentredBox& from, const CentredBox& to,
                                           const TriangleBlock& block) {
  const Floats d;
  std::uint32_t lanes = 0;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const Sides a = sides_of_planes(from, block, at), b = sides_of_planes(to, block, at);
    const M beside = hn::Or(hn::And(a.front, b.front), hn::And(a.behind, b.behind));
    lanes |= static_cast<std::uint32_t>(bits_of(d, hn::Not(beside))) << at;
  }
  return lanes;
}

/// The lanes of faces that are not in the run.
HWY_INLINE std::uint32_t lanes_outside(const scene::FaceRun& run,
                                       const std::array<std::uint32_t, kWidth>& faces) {
  // face - first < count for numbers without signs, which vectors only compare with signs.
  constexpr std::uint32_t kTop = 1u << 31;
  const hn::Rebind<std::uint32_t, Floats> d;
  const hn::Rebind<std::int32_t, Floats> d_signed;
  std::uint32_t lanes = 0;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const auto offset = hn::Sub(hn::Load(d, faces.data() + at), hn::Set(d, run.first + kTop));
    const auto inside =
        hn::Lt(hn::BitCast(d_signed, offset), hn::Set(d_signed, static_cast<std::int32_t>(run.count + kTop)));
    lanes |= static_cast<std::uint32_t>(bits_of(d_signed, hn::Not(inside))) << at;
  }
  return lanes;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
