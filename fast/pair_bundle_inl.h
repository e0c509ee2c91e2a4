// SPDX-License-Identifier: MIT
//
// What the rays of a pair or a tile can meet, in one step down the tree, compiled once for each instruction
// set. Internal to fast/pair_*.
#if defined(GNOMON_FAST_PAIR_BUNDLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_PAIR_BUNDLE_INL_H_
#undef GNOMON_FAST_PAIR_BUNDLE_INL_H_
#else
#define GNOMON_FAST_PAIR_BUNDLE_INL_H_
#endif

#include <hwy/cache_control.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "fast/pair_cull_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// Faces that no ray can meet whatever the floats say.
struct Skipped {
  scene::FaceRun from, to;
};

/// True when no point of the plane's patch lies behind it and all points of the box lie in front, strictly:
/// every inner point of a ray then lies in front, strictly.
inline bool leaves_on_one_side(const OwnPlane& plane, const CentredBox& box) {
  float value = 0, reach = 0, c_most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float c = box.centre[k] - plane.corner[k], n = plane.normal[k];
    value += n * c;
    reach += (n < 0 ? -n : n) * box.half[k];
    const float magnitude = c < 0 ? -c : c;
    c_most = magnitude > c_most ? magnitude : c_most;
  }
  // As for Sides, which has v0 - o for c: the value's sign is the other one here.
  const float error =
      reach * (1 + 8 * Rounding<float>::u) + plane.error * (c_most + box.half_most) + kTriangleUnderflow;
  return plane.none_behind && value > error;
}

inline void add_half(const OwnPlane& plane, const PairPatch& from, const PairPatch& to, Bundle& bundle) {
  HalfSpace& half = bundle.halves[bundle.half_count++];
  half.plane = &plane;
  float most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    half.far_row[k] = static_cast<std::uint32_t>(plane.normal[k] < 0 ? k : k + 3);
    for (const PairPatch* patch : {&from, &to}) {
      for (const float x : {patch->box[k], patch->box[k + 3]}) {
        most = std::max(most, std::abs(x - plane.corner[k]));
      }
    }
  }
  half.box_threshold = plane.error == 0 ? 0 : -(plane.error * most + kTriangleUnderflow);
}

/// Adds the half-spaces that all rays keep to, and says which faces no ray can meet.
inline Skipped keep_in_front(const PairPatch& from, const PairPatch& to, Bundle& bundle) {
  Skipped skipped{from.own, to.own};
  if (leaves_on_one_side(from.plane, bundle.to)) {
    add_half(from.plane, from, to, bundle);
    if (from.convex.count != 0) skipped.from = from.convex;
  }
  if (leaves_on_one_side(to.plane, bundle.from)) {
    add_half(to.plane, from, to, bundle);
    if (to.convex.count != 0) skipped.to = to.convex;
  }
  return skipped;
}

/// Lanes of a leaf that the bundle's rays may meet.
HWY_INLINE std::uint32_t candidate_lanes(const PairArrays& arrays, const Bundle& bundle,
                                         const Skipped& skipped, ChildLink link) {
  if (link.has_balls()) {
    const BallBlock& block = arrays.tree.balls[link.block()];
    return link.lanes() & lanes_outside(skipped.from, block.face) & lanes_outside(skipped.to, block.face) &
           balls_between(bundle.shaft, block);
  }
  const TriangleBlock& block = arrays.tree.triangles[link.block()];
  return link.lanes() & lanes_outside(skipped.from, block.face) & lanes_outside(skipped.to, block.face) &
         triangles_between(bundle, block, arrays.corners[link.block()]);
}

/// Asks for the memory of a link that will be followed soon.
HWY_INLINE void fetch(const PairArrays& arrays, ChildLink link) {
  const auto fetch_all = [](const auto* data) {
    const auto* bytes = reinterpret_cast<const char*>(data);
    for (std::size_t i = 0; i < sizeof *data; i += 64) hwy::Prefetch(bytes + i);
  };
  if (!link.is_leaf()) {
    fetch_all(&arrays.tree.nodes[link.index()]);
  } else if (!link.has_balls()) {
    fetch_all(&arrays.tree.triangles[link.block()]);
    fetch_all(&arrays.corners[link.block()]);
  }
}

/// Appends the children that the bundle's rays may meet.
HWY_INLINE std::uint32_t* push_children(const Bundle& bundle, const WideNode& node, std::uint32_t* top) {
  const Floats d;
  const hn::Rebind<std::uint32_t, Floats> d_links;
  const auto* links = reinterpret_cast<const std::uint32_t*>(node.children.data());
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    const auto bound = [&](std::size_t row) { return hn::Load(d, node.bounds[row].data() + at); };
    M met = boxes_in_shaft(bundle.shaft, bound);
    for (std::size_t i = 0; i < bundle.half_count; ++i) {
      met = hn::AndNot(boxes_behind(bundle.halves[i], bound), met);
    }
    const auto kept = hn::RebindMask(d_links, met);
    hn::StoreU(hn::Compress(hn::Load(d_links, links + at), kept), d_links, top);
    top += hn::CountTrue(d_links, kept);
  }
  return top;
}

/// Appends the faces that the bundle's rays may meet.
HWY_INLINE void list(const PairArrays& arrays, const Bundle& bundle, const Skipped& skipped,
                     std::vector<std::uint32_t>& faces) {
  const HierarchyArrays& tree = arrays.tree;
  std::uint32_t stack[kStackSize];
  std::uint32_t* top = stack;
  ChildLink link = ChildLink::node(0);
  for (;;) {
    if (!link.is_leaf()) {
      top = push_children(bundle, tree.nodes[link.index()], top);
    } else {
      const auto& names =
          link.has_balls() ? tree.balls[link.block()].face : tree.triangles[link.block()].face;
      for (std::uint32_t lanes = candidate_lanes(arrays, bundle, skipped, link); lanes != 0;
           lanes &= lanes - 1) {
        faces.push_back(names[static_cast<std::size_t>(std::countr_zero(lanes))]);
      }
    }
    if (top == stack) return;
    link = ChildLink(*--top);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
