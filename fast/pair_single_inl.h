// SPDX-License-Identifier: MIT
//
// One ray of a tile down the tree by itself, compiled once for each instruction set: what pairs fall back to
// when their shaft holds much more than a ray meets. Internal to fast/pair_*.
#if defined(GNOMON_FAST_PAIR_SINGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_PAIR_SINGLE_INL_H_
#undef GNOMON_FAST_PAIR_SINGLE_INL_H_
#else
#define GNOMON_FAST_PAIR_SINGLE_INL_H_
#endif

#include "fast/pair_rays_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// Walks on from `start` as fast/hierarchy_shadow.cpp does; on_leaf(link) ends the walk when it answers true.
template <class OnNode, class OnLeaf>
HWY_INLINE bool walk_alone(const HierarchyArrays& tree, const BeamVectors& beam, ChildLink start,
                           const OnNode& on_node, const OnLeaf& on_leaf) {
  const Floats d;
  const hn::Rebind<std::uint32_t, Floats> d_links;
  std::uint32_t stack[kStackSize];
  std::uint32_t* top = stack;
  ChildLink link = start;
  for (;;) {
    if (!link.is_leaf()) {
      on_node();
      const WideNode& node = tree.nodes[link.index()];
      const auto* links = reinterpret_cast<const std::uint32_t*>(node.children.data());
      for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
        V entry;
        const auto kept = hn::RebindMask(d_links, boxes_met(beam, node, at, hn::Set(d, 1.0f), entry));
        hn::StoreU(hn::Compress(hn::Load(d_links, links + at), kept), d_links, top);
        top += hn::CountTrue(d_links, kept);
      }
    } else if (on_leaf(link)) {
      return true;
    }
    if (top == stack) return false;
    link = ChildLink(*--top);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
