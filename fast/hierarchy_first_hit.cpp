// SPDX-License-Identifier: MIT
// The question `first-hit`: near children first, and nothing beyond the nearest hit.
#include "fast/hierarchy_query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/hierarchy_first_hit.cpp"
#include <hwy/foreach_target.h>

#include "fast/hierarchy_balls_inl.h"
#include "fast/hierarchy_triangles_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// The nearest face of the naive tier.
class NearestHit {
 public:
  void add(std::uint32_t face, float t, float /*hi*/, bool /*certain*/) {
    if (t < t_) {
      t_ = t;
      face_ = face;
    }
  }
  [[nodiscard]] float limit() const { return t_; }
  [[nodiscard]] std::uint32_t resolve() const { return face_; }
  [[nodiscard]] static std::uint64_t calls() { return 0; }

 private:
  float t_ = std::numeric_limits<float>::infinity();
  std::uint32_t face_ = scene::kNoFace;
};

class CertifiedHits : public HitCandidates {
 public:
  using HitCandidates::HitCandidates;
  [[nodiscard]] float limit() const { return nearest() * kLimitFactor; }
};

struct Waiting {
  float entry;
  ChildLink link;
};

/// Puts the children met on the stack, the nearest on top.
HWY_INLINE Waiting* push_children(const BeamVectors& vectors, const WideNode& node, float limit,
                                  Waiting* top) {
  const Floats d;
  HWY_ALIGN_MAX float entries[kWidth];
  std::uint32_t bits = 0;
  for (std::size_t at = 0; at < kWidth; at += hn::Lanes(d)) {
    V entry;
    bits |= bits_of(d, boxes_met(vectors, node, at, hn::Set(d, limit), entry)) << at;
    hn::Store(entry, d, entries + at);
  }
  Waiting* const bottom = top;
  for (; bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
    const Waiting child{entries[lane], node.children[lane]};
    Waiting* place = top++;
    for (; place != bottom && place[-1].entry < child.entry; --place) *place = place[-1];
    *place = child;
  }
  return top;
}

template <class Hits>
HWY_INLINE void add_hits(const LeafHits& leaf, std::uint32_t lanes,
                         const std::array<std::uint32_t, kWidth>& faces, std::uint32_t own, Hits& hits) {
  for (std::uint32_t rest = leaf.bits.possible & lanes; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
    if (faces[lane] == own) continue;
    hits.add(faces[lane], leaf.lo[lane], leaf.hi[lane], (leaf.bits.certain >> lane & 1) != 0);
  }
}

/// The own ball, which the ray meets where it leaves it.
template <class Tier, class Hits>
void add_own_ball(const HierarchyArrays& arrays, std::uint32_t own, const Beam& beam,
                  const BeamVectors& vectors, Hits& hits) {
  const FacePlace place = arrays.places[own];
  const BallBlock& block = arrays.balls[place.block];
  const std::size_t lane = place.lane;
  const int way = way_into<Tier>(block, lane, beam);
  if (way < 0 || (!Tier::kCertified && way == 0)) return;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const LeafHits leaf = ray_balls<Tier::kCertified>(vectors, block, kInfinity, true);
  const auto has = [lane](std::uint32_t bits) { return (bits >> lane & 1) != 0; };
  if (!Tier::kCertified) {
    if (has(leaf.bits.possible)) hits.add(own, leaf.lo[lane], kInfinity, true);
  } else if (way > 0 && has(leaf.bits.certain)) {
    hits.add(own, leaf.lo[lane], leaf.hi[lane], true);
  } else {
    hits.add(own, 0, kInfinity, false);
  }
}

template <class Tier, class Hits, class Count>
void walk(const HierarchyView& hierarchy, const Beam& beam, const scene::RayQuery& query, Hits& hits,
          Count& count) {
  const HierarchyArrays& arrays = hierarchy.arrays;
  const BeamVectors vectors(beam);
  if (query.own >= hierarchy.scene.triangles.size() && query.own < hierarchy.scene.face_count()) {
    add_own_ball<Tier>(arrays, query.own, beam, vectors, hits);
  }
  Waiting stack[kStackSize];
  Waiting* top = stack;
  *top++ = {0, ChildLink::node(0)};
  while (top != stack) {
    const Waiting next = *--top;
    if (next.entry > hits.limit()) continue;
    if (!next.link.is_leaf()) {
      count.node();
      top = push_children(vectors, arrays.nodes[next.link.index()], hits.limit(), top);
      continue;
    }
    count.leaf(next.link.count());
    if (!next.link.has_balls()) {
      const TriangleBlock& block = arrays.triangles[next.link.block()];
      add_hits(ray_triangles<Tier::kCertified>(vectors, block, hits.limit()), next.link.lanes(), block.face,
               query.own, hits);
    } else {
      const BallBlock& block = arrays.balls[next.link.block()];
      add_hits(ray_balls<Tier::kCertified>(vectors, block, hits.limit(), false), next.link.lanes(),
               block.face, query.own, hits);
    }
  }
}

template <class Tier, class Count, class Hits>
std::uint32_t first_hit(const HierarchyView& hierarchy, const scene::RayQuery& query, Hits& hits,
                        Count& count) {
  Beam beam;
  if (!begin_ray<Tier>(hierarchy, query, beam)) return scene::kNoFace;
  walk<Tier>(hierarchy, beam, query, hits, count);
  return hits.resolve();
}

void run_naive(const HierarchyView& h, std::span<const scene::RayQuery> queries,
               std::span<std::uint32_t> answers, const ExactFaces* /*exact*/, TestCounters* counters) {
  with_count(counters, [&](auto& count) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      NearestHit hit;
      answers[i] = first_hit<NaiveTier>(h, queries[i], hit, count);
    }
  });
}

void run_certified(const HierarchyView& h, std::span<const scene::RayQuery> queries,
                   std::span<std::uint32_t> answers, const ExactFaces* exact, TestCounters* counters) {
  with_count(counters, [&](auto& count) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      CertifiedHits hits(h.scene, queries[i], exact);
      answers[i] = in_ray_domain(h, queries[i]) ? first_hit<CertifiedTier>(h, queries[i], hits, count)
                                                : hits.ask_about_all();
      count.exact(hits.calls());
    }
  });
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

}  // namespace

void run_first_hits(Hierarchy::Tier tier, const HierarchyView& h, std::span<const scene::RayQuery> queries,
                    std::span<std::uint32_t> answers, const ExactFaces* exact, TestCounters* counters) {
  if (tier == Hierarchy::Tier::naive) {
    HWY_DYNAMIC_DISPATCH(run_naive)(h, queries, answers, exact, counters);
  } else {
    HWY_DYNAMIC_DISPATCH(run_certified)(h, queries, answers, exact, counters);
  }
}

}  // namespace gnomon::fast
#endif  // HWY_ONCE
