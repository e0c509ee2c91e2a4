// SPDX-License-Identifier: MIT
// The question `shadow`: any face that blocks will do.
#include "fast/hierarchy_query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/hierarchy_shadow.cpp"
#include <hwy/foreach_target.h>

#include "fast/hierarchy_balls_inl.h"
#include "fast/hierarchy_triangles_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// The lanes of face `own`, without a branch.
HWY_INLINE std::uint32_t lanes_of(std::uint32_t own, const std::array<std::uint32_t, kWidth>& faces) {
  const hn::Rebind<std::uint32_t, Floats> d;
  std::uint32_t lanes = 0;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    lanes |= static_cast<std::uint32_t>(bits_of(d, hn::Eq(hn::Load(d, faces.data() + at), hn::Set(d, own))))
             << at;
  }
  return lanes;
}

/// Walks the tree until a face blocks.
template <class Tier, class Count>
ShadowAnswer walk(const HierarchyArrays& arrays, const Beam& beam, const scene::ShadowQuery& query,
                  ShadowCandidates& candidates, Count& count) {
  const Floats d;
  const hn::Rebind<std::uint32_t, Floats> d_links;
  const BeamVectors vectors(beam);
  const V end = hn::Set(d, 1.0f);
  std::uint32_t stack[kStackSize];
  std::uint32_t* top = stack;
  ChildLink link = ChildLink::node(0);
  for (;;) {
    if (!link.is_leaf()) {
      const WideNode& node = arrays.nodes[link.index()];
      count.node();
      const auto* links = reinterpret_cast<const std::uint32_t*>(node.children.data());
      for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
        V entry;
        const M met = boxes_met(vectors, node, at, end, entry);
        const auto kept = hn::RebindMask(d_links, met);
        hn::StoreU(hn::Compress(hn::Load(d_links, links + at), kept), d_links, top);
        top += hn::CountTrue(d_links, kept);
      }
    } else {
      count.leaf(link.count());
      const std::array<std::uint32_t, kWidth>* faces;
      LeafBits bits;
      if (!link.has_balls()) {
        const TriangleBlock& block = arrays.triangles[link.block()];
        faces = &block.face;
        bits = segment_triangles<Tier::kCertified>(vectors, block);
      } else {
        const BallBlock& block = arrays.balls[link.block()];
        faces = &block.face;
        bits = segment_balls<Tier::kCertified>(vectors, block);
      }
      // The own face first: certified tests leave it open nearly always, and whether its leaf is this one is
      // hard to predict.
      const std::uint32_t possible = bits.possible & link.lanes() & ~lanes_of(query.own, *faces);
      if ((bits.certain & possible) != 0) return ShadowAnswer::shadowed;
      if (Tier::kCertified && possible != 0 && candidates.add(*faces, possible))
        return ShadowAnswer::shadowed;
    }
    if (top == stack) return ShadowAnswer::lit;
    link = ChildLink(*--top);
  }
}

template <class Tier, class Count>
void run(const HierarchyView& hierarchy, std::span<const scene::ShadowQuery> queries,
         std::span<ShadowAnswer> answers, const ExactFaces* exact, Count& count) {
  for (std::size_t i = 0; i < queries.size(); ++i) {
    ShadowCandidates candidates(hierarchy.scene, queries[i], exact);
    Beam beam;
    ShadowAnswer answer;
    if (!begin_shadow<Tier>(hierarchy, queries[i], beam, candidates, answer)) {
      answer = walk<Tier>(hierarchy.arrays, beam, queries[i], candidates, count);
      if (Tier::kCertified && answer == ShadowAnswer::lit && candidates.any()) answer = candidates.resolve();
    }
    count.exact(candidates.calls());
    answers[i] = answer;
  }
}

void run_naive(const HierarchyView& h, std::span<const scene::ShadowQuery> queries,
               std::span<ShadowAnswer> answers, const ExactFaces* exact, TestCounters* counters) {
  with_count(counters, [&](auto& count) { run<NaiveTier>(h, queries, answers, exact, count); });
}
void run_certified(const HierarchyView& h, std::span<const scene::ShadowQuery> queries,
                   std::span<ShadowAnswer> answers, const ExactFaces* exact, TestCounters* counters) {
  with_count(counters, [&](auto& count) { run<CertifiedTier>(h, queries, answers, exact, count); });
}

const char* target_name() {
  return hwy::TargetName(HWY_TARGET);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gnomon::fast {

namespace {

HWY_EXPORT(run_naive);
HWY_EXPORT(run_certified);
HWY_EXPORT(target_name);

}  // namespace

const char* hierarchy_instruction_set() {
  return HWY_DYNAMIC_DISPATCH(target_name)();
}

void run_shadows(Hierarchy::Tier tier, const HierarchyView& h, std::span<const scene::ShadowQuery> queries,
                 std::span<ShadowAnswer> answers, const ExactFaces* exact, TestCounters* counters) {
  if (tier == Hierarchy::Tier::naive) {
    HWY_DYNAMIC_DISPATCH(run_naive)(h, queries, answers, exact, counters);
  } else {
    HWY_DYNAMIC_DISPATCH(run_certified)(h, queries, answers, exact, counters);
  }
}

}  // namespace gnomon::fast
#endif  // HWY_ONCE
