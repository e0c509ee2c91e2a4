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
//
// BEHIND AN OWN PLANE. When no point of a patch lies behind the plane of its own triangle, and all points of
// the other patch lie in front of it, strictly, all inner points x of all rays have N . (x - a) > 0, a being
// a corner of that triangle. So nothing that lies on the plane or behind it is met. For a box: if it is met
// at x, x lies in the extent box, and N . (x - a) as computed, which is off by at most E = N' |x - a|_m +
// 2^-104, is more than -E; the corner that lies farthest along n has at least that value, as rounding is
// monotone. So a box is dropped whose farthest value is at most -E, E from the extent box. For a vertex of a
// face: the same with |v - a|_m itself, or when it is a corner of the own triangle. Planes perpendicular to
// an axis have E = 0: signs of differences are exact.
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

/// The lanes of boxes that the shaft meets, or may; bound(row) are their minima (0 to 2) and maxima.
template <class Bound>
HWY_INLINE M boxes_in_shaft(const PairShaft& shaft, const Bound& bound) {
  const Floats d;
  V near = hn::Zero(d), far = hn::Set(d, kShaftEnd);
  const auto parameter = [&](std::size_t i) {
    return hn::Mul(hn::Sub(bound(shaft.row[i]), hn::Set(d, shaft.origin[i])), hn::Set(d, shaft.inverse[i]));
  };
  if (shaft.lower == 3) {
    // A lower and an upper bound of each axis: boxes that lie apart, in most pairs.
    for (std::size_t i = 0; i < 3; ++i) {
      near = more_or_second(parameter(i), near);
      far = less_or_second(parameter(i + 3), far);
    }
  } else {
    std::size_t i = 0;
    for (; i < shaft.lower; ++i) near = more_or_second(parameter(i), near);
    for (; i < 6; ++i) far = less_or_second(parameter(i), far);
  }
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

/// What lies on or behind an own plane can't be met.
struct HalfSpace {
  const OwnPlane* plane = nullptr;
  std::array<std::uint32_t, 3> far_row{};  ///< of WideNode::bounds: the corner farthest along the normal
  float box_threshold = 0;                 ///< -E
};

/// The lanes of boxes that lie behind for certain.
template <class Bound>
HWY_INLINE M boxes_behind(const HalfSpace& half, const Bound& bound) {
  const Floats d;
  V value = hn::Zero(d);
  for (std::size_t k = 0; k < 3; ++k) {
    const V term = hn::Mul(hn::Set(d, half.plane->normal[k]),
                           hn::Sub(bound(half.far_row[k]), hn::Set(d, half.plane->corner[k])));
    value = k == 0 ? term : hn::Add(value, term);
  }
  return hn::Le(value, hn::Set(d, half.box_threshold));
}

/// The lanes of triangles' corners that lie on the plane or behind it for certain.
HWY_INLINE M corners_behind(const OwnPlane& plane, const std::array<Eight, 3>& corners,
                            const std::array<std::uint32_t, kWidth>& numbers, std::size_t at) {
  const Floats d;
  const hn::Rebind<std::uint32_t, Floats> d_numbers;
  V value = hn::Zero(d), most = hn::Zero(d);
  for (std::size_t k = 0; k < 3; ++k) {
    const V c = hn::Sub(hn::Load(d, corners[k].data() + at), hn::Set(d, plane.corner[k]));
    const V term = hn::Mul(hn::Set(d, plane.normal[k]), c);
    value = k == 0 ? term : hn::Add(value, term);
    most = hn::Max(most, hn::Abs(c));
  }
  const float tiny = plane.error == 0 ? 0 : kTriangleUnderflow;
  const V threshold = hn::Neg(hn::Add(hn::Mul(hn::Set(d, plane.error), most), hn::Set(d, tiny)));
  const auto number = hn::Load(d_numbers, numbers.data() + at);
  const auto same = [&](std::size_t i) {
    return hn::RebindMask(d, hn::Eq(number, hn::Set(d_numbers, plane.corners[i])));
  };
  return hn::Or(hn::Le(value, threshold), hn::Or(same(0), hn::Or(same(1), same(2))));
}

/// The bounds of what rays can meet: of all rays of a pair, or of a tile.
struct Bundle {
  PairShaft shaft;
  CentredBox from, to;
  std::array<HalfSpace, 2> halves;
  std::size_t half_count = 0;

  Bundle(const std::array<float, 6>& a, const std::array<float, 6>& b) : shaft(a, b), from(a), to(b) {}
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

/// The lanes of triangles that the bundle's rays may meet.
HWY_INLINE std::uint32_t triangles_between(const Bundle& bundle, const TriangleBlock& block,
                                           const CornerBlock& corners) {
  const Floats d;
  std::uint32_t lanes = 0;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    V box[6];
    for (std::size_t k = 0; k < 3; ++k) {
      const V a = hn::Load(d, block.v0[k].data() + at), b = hn::Load(d, corners.v1[k].data() + at),
              c = hn::Load(d, corners.v2[k].data() + at);
      box[k] = hn::Min(hn::Min(a, b), c);
      box[k + 3] = hn::Max(hn::Max(a, b), c);
    }
    const auto bound = [&](std::size_t row) { return box[row]; };
    M kept = boxes_in_shaft(bundle.shaft, bound);
    for (std::size_t i = 0; i < bundle.half_count; ++i) {
      kept = hn::AndNot(boxes_behind(bundle.halves[i], bound), kept);
    }
    const Sides a = sides_of_planes(bundle.from, block, at), b = sides_of_planes(bundle.to, block, at);
    kept = hn::AndNot(hn::Or(hn::And(a.front, b.front), hn::And(a.behind, b.behind)), kept);
    std::uint64_t bits = bits_of(d, kept);
    if (bits == 0) continue;
    for (std::size_t i = 0; i < bundle.half_count; ++i) {
      const OwnPlane& plane = *bundle.halves[i].plane;
      // Their boxes tell as much where the plane is perpendicular to an axis.
      if (plane.error == 0) continue;
      const M behind = hn::And(hn::And(corners_behind(plane, block.v0, corners.number[0], at),
                                       corners_behind(plane, corners.v1, corners.number[1], at)),
                               corners_behind(plane, corners.v2, corners.number[2], at));
      bits &= ~static_cast<std::uint64_t>(bits_of(d, behind));
    }
    lanes |= static_cast<std::uint32_t>(bits) << at;
  }
  return lanes;
}

/// The lanes of balls whose boxes the shaft meets, or may. c - r is off by at most u (|c| + r), and exact
/// when that is below the least denormal; 4 u pays for it and for two roundings more.
HWY_INLINE std::uint32_t balls_between(const PairShaft& shaft, const BallBlock& block) {
  const Floats d;
  std::uint32_t lanes = 0;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const V r = hn::Load(d, block.radius.data() + at);
    V box[6];
    for (std::size_t k = 0; k < 3; ++k) {
      const V c = hn::Load(d, block.centre[k].data() + at);
      const V slack = hn::Mul(hn::Add(hn::Abs(c), r), hn::Set(d, 4 * Rounding<float>::u));
      box[k] = hn::Sub(hn::Sub(c, r), slack);
      box[k + 3] = hn::Add(hn::Add(c, r), slack);
    }
    const M met = boxes_in_shaft(shaft, [&](std::size_t row) { return box[row]; });
    lanes |= static_cast<std::uint32_t>(bits_of(d, met)) << at;
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
