// SPDX-License-Identifier: MIT
// What the kernels of a Hierarchy share, compiled once for each instruction set: a beam in vectors, and the
// test of a node's boxes. Internal to fast/hierarchy*.
#if defined(GNOMON_FAST_HIERARCHY_VECTORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_HIERARCHY_VECTORS_INL_H_
#undef GNOMON_FAST_HIERARCHY_VECTORS_INL_H_
#else
#define GNOMON_FAST_HIERARCHY_VECTORS_INL_H_
#endif

#include "fast/batch_vector_inl.h"
#include "fast/hierarchy_beam.h"
#include "fast/hierarchy_layout.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

using Floats = hn::CappedTag<float, kWidth>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;

/// A bit for each face of a leaf (lanes beyond its count included).
struct LeafBits {
  std::uint32_t certain = 0, possible = 0;
};

/// The faces of a leaf that a ray meets, and the parameters between which it does so first. Naive: the
/// parameter is `lo`, and only `possible` is set.
struct LeafHits {
  LeafBits bits;
  HWY_ALIGN_MAX float lo[kWidth], hi[kWidth];
};

struct BeamVectors {
  V origin[3], direction[3];
  V near_origin[3], far_origin[3], near_inverse[3], far_inverse[3];
  V largest, third_spread, spread;
  std::uint32_t near_row[3], far_row[3];

  HWY_INLINE explicit BeamVectors(const Beam& beam) {
    const Floats d;
    for (std::size_t k = 0; k < 3; ++k) {
      origin[k] = hn::Set(d, beam.origin[k]);
      direction[k] = hn::Set(d, beam.direction[k]);
      near_origin[k] = hn::Set(d, beam.near_origin[k]);
      far_origin[k] = hn::Set(d, beam.far_origin[k]);
      near_inverse[k] = hn::Set(d, beam.near_inverse[k]);
      far_inverse[k] = hn::Set(d, beam.far_inverse[k]);
      near_row[k] = beam.near_row[k];
      far_row[k] = beam.far_row[k];
    }
    largest = hn::Set(d, beam.largest);
    spread = hn::Set(d, beam.spread);
    third_spread = hn::Set(d, kThirdEdge * beam.spread);
  }
};

/// x if x < y (x > y), else y: a NaN in x is ignored, on every instruction set.
HWY_INLINE V less_or_second(V x, V y) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  return hn::Min(x, y);
#else
  return hn::IfThenElse(hn::Lt(x, y), x, y);
#endif
}
HWY_INLINE V more_or_second(V x, V y) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  return hn::Max(x, y);
#else
  return hn::IfThenElse(hn::Gt(x, y), x, y);
#endif
}

/// Where the beam enters the boxes of lanes from `at` on; which it meets at parameters from 0 to `end`.
HWY_INLINE M boxes_met(const BeamVectors& beam, const WideNode& node, std::size_t at, V end, V& entry) {
  const Floats d;
  V near = hn::Zero(d), far = end;
  for (std::size_t k = 0; k < 3; ++k) {
    const V lo = hn::Load(d, node.bounds[beam.near_row[k]].data() + at),
            hi = hn::Load(d, node.bounds[beam.far_row[k]].data() + at);
    near = more_or_second(hn::Mul(hn::Sub(lo, beam.near_origin[k]), beam.near_inverse[k]), near);
    far = less_or_second(hn::Mul(hn::Sub(hi, beam.far_origin[k]), beam.far_inverse[k]), far);
  }
  entry = near;
  return hn::Le(near, far);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
