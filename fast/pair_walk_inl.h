// SPDX-License-Identifier: MIT
//
// One pair's walk and ray tests, tile by tile, compiled once for each instruction set. Internal to
// fast/pair_*.
#if defined(GNOMON_FAST_PAIR_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_PAIR_WALK_INL_H_
#undef GNOMON_FAST_PAIR_WALK_INL_H_
#else
#define GNOMON_FAST_PAIR_WALK_INL_H_
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "fast/hierarchy_query.h"
#include "fast/pair_bundle_inl.h"
#include "fast/pair_rays_inl.h"
#include "fast/pair_shaft.h"
#include "fast/pair_single_inl.h"
#include "fast/pair_tile.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// How many links to part a pair's tree into before its tiles go on by themselves.
inline constexpr std::size_t kSharedLinks = 24;

/// A tile whose links followed and faces tested are so many goes on ray by ray: its shaft holds much more
/// than a ray meets. In scenes where shafts pay, tiles have about 30.
inline constexpr std::size_t kMostShared = 64;

/// So many links may wait while the next one is asked for ahead.
inline constexpr std::size_t kMostAhead = 256;

template <class Tier>
class PairWalk {
 public:
  PairWalk(const PairView& view, const PairPatch& from, const PairPatch& to, PairScratch::Data& scratch,
           const ExactFaces* exact)
      : view_(view),
        arrays_(view.arrays),
        tree_(view.arrays.tree),
        from_(from),
        to_(to),
        scratch_(scratch),
        exact_(exact) {}

  PairResult run(std::span<ShadowAnswer> answers);
  void add_to(PairCounters& counters) const {
    counters.nodes += counts_.nodes;
    counters.leaves += counts_.leaves;
    counters.faces += counts_.faces;
    counters.tests += counts_.tests;
    counters.exact += counts_.exact;
  }

 private:
  /// Fills scratch.links; false when nothing can block.
  bool share_walk(const Bundle& bundle);
  void run_tile(const Bundle& bundle, std::span<const std::uint32_t> links);
  void run_alone(const Bundle& bundle, std::span<const std::uint32_t> links);
  bool test_leaf(ChildLink link, std::uint32_t lanes);
  bool test_triangle(ChildLink link, std::uint32_t lane, bool keep_open = true);
  bool try_last_blocker(const Bundle& bundle);
  void test_balls(ChildLink link, std::uint32_t lanes);
  void resolve();
  void store(std::span<ShadowAnswer> answers) const;

  const PairView& view_;
  const PairArrays& arrays_;
  const HierarchyArrays& tree_;
  const PairPatch &from_, &to_;
  PairScratch::Data& scratch_;
  const ExactFaces* exact_;
  Skipped skipped_;
  TileShape shape_{};
  std::size_t first_from_ = 0, first_to_ = 0;  ///< the tile's points
  PairCounters counts_;
  RayTile tile_;
  std::uint32_t valid_ = 0, live_ = 0, shadowed_ = 0, undecided_ = 0;
  std::uint32_t blocks_all_ = scene::kNoFace;  ///< a face that alone blocks all rays of the tile
  bool any_candidate_ = false;
};

template <class Tier>
bool PairWalk<Tier>::share_walk(const Bundle& bundle) {
  // First in, first out, so that what stays closed is of one size. A link is at most pushed once, and no more
  // nodes are opened than there may be links.
  std::vector<std::uint32_t>& links = scratch_.links;
  links.resize(kSharedLinks + kWidth);
  std::uint32_t queue[kWidth * (kSharedLinks + 2)];
  std::uint32_t *head = queue, *tail = queue;
  *tail++ = ChildLink::node(0).bits();
  std::size_t kept = 0, opened = 0;
  while (head != tail && static_cast<std::size_t>(tail - head) + kept < kSharedLinks &&
         opened < kSharedLinks) {
    const ChildLink link(*head++);
    if (link.is_leaf()) {
      ++counts_.leaves;
      if (candidate_lanes(arrays_, bundle, skipped_, link) != 0) links[kept++] = link.bits();
    } else {
      ++counts_.nodes;
      ++opened;
      tail = push_children(bundle, tree_.nodes[link.index()], tail);
    }
  }
  while (head != tail) links[kept++] = *head++;
  links.resize(kept);
  return kept != 0;
}

template <class Tier>
bool PairWalk<Tier>::test_triangle(ChildLink link, std::uint32_t lane, bool keep_open) {
  const TriangleBlock& block = tree_.triangles[link.block()];
  counts_.tests += kTileRays;
  const RayBits bits = rays_on_triangle<Tier::kCertified>(tile_, block, lane, live_);
  const std::uint32_t certain = bits.certain & live_;
  if (certain != 0) {
    any_candidate_ = true;
    scratch_.last_blocker = {link, lane};
    std::uint32_t blocked = bits.certain;
    // The kernel may have passed over vectors without live rays. What is noticed must not depend on their
    // width; this happens at most once a tile.
    if (certain == live_ && live_ != valid_ && hn::Lanes(RayFloats()) < kTileRays) {
      blocked = rays_on_triangle<Tier::kCertified>(tile_, block, lane, valid_).certain;
    }
    if ((blocked & valid_) == valid_) blocks_all_ = block.face[lane];
    shadowed_ |= certain;
    live_ &= ~certain;
  }
  if (Tier::kCertified && keep_open) {
    const std::uint32_t open = bits.possible & live_;
    if (open != 0) scratch_.open.push_back({block.face[lane], open});
  }
  return live_ == 0;
}

/// The face that blocked last, before all others. Answers must not depend on which one that is: what is not
/// certain waits until the walk meets it, and a naive hit counts only where the walk would meet it.
template <class Tier>
bool PairWalk<Tier>::try_last_blocker(const Bundle& bundle) {
  const LeafLane last = scratch_.last_blocker;
  const std::uint32_t face = tree_.triangles[last.link.block()].face[last.lane];
  if (skipped_.from.contains(face) || skipped_.to.contains(face)) return false;
  if (!Tier::kCertified && (candidate_lanes(arrays_, bundle, skipped_, last.link) >> last.lane & 1u) == 0) {
    return false;
  }
  return test_triangle(last.link, last.lane, false);
}

template <class Tier>
void PairWalk<Tier>::test_balls(ChildLink link, std::uint32_t lanes) {
  const BallBlock& block = tree_.balls[link.block()];
  std::uint32_t all = lanes;  // that block every ray
  for (std::uint32_t rays = valid_ & live_; rays != 0; rays &= rays - 1) {
    const auto ray = static_cast<std::size_t>(std::countr_zero(rays));
    counts_.tests += static_cast<std::uint64_t>(std::popcount(lanes));
    const LeafBits bits = segment_balls<Tier::kCertified>(BeamVectors(beam_of(tile_, ray)), block);
    all &= bits.certain;
    if ((bits.certain & lanes) != 0) {
      shadowed_ |= 1u << ray;
    } else if (Tier::kCertified) {
      for (std::uint32_t open = bits.possible & lanes; open != 0; open &= open - 1) {
        scratch_.open.push_back({block.face[static_cast<std::size_t>(std::countr_zero(open))], 1u << ray});
      }
    }
  }
  if (live_ == valid_ && all != 0) {
    blocks_all_ = block.face[static_cast<std::size_t>(std::countr_zero(all))];
  }
  live_ &= ~shadowed_;
}

template <class Tier>
bool PairWalk<Tier>::test_leaf(ChildLink link, std::uint32_t lanes) {
  if (link.has_balls()) {
    test_balls(link, lanes);
    return live_ == 0;
  }
  for (; lanes != 0; lanes &= lanes - 1) {
    if (test_triangle(link, static_cast<std::uint32_t>(std::countr_zero(lanes)))) return true;
  }
  return false;
}

template <class Tier>
void PairWalk<Tier>::run_tile(const Bundle& bundle, std::span<const std::uint32_t> links) {
  if (scratch_.last_blocker.lane != kWidth && try_last_blocker(bundle)) return;
  // A link is asked for one step before it is followed. That mixes walks of two subtrees, which may leave
  // more links waiting than kStackSize; so it is done only as long as few wait. From there on, one subtree is
  // walked at a time.
  std::uint32_t stack[kMostAhead + kWidth + kStackSize];
  std::uint32_t* top = stack;
  std::size_t started = 1;
  ChildLink link(links[0]), next;
  bool has_next = false;
  for (std::size_t followed = 0;; ++followed) {
    if (followed >= kMostShared) {
      *top++ = link.bits();
      if (has_next) *top++ = next.bits();
      run_alone(bundle, {stack, top});
      run_alone(bundle, links.subspan(started));
      return;
    }
    if (!link.is_leaf()) {
      ++counts_.nodes;
      top = push_children(bundle, tree_.nodes[link.index()], top);
    } else {
      ++counts_.leaves;
      const std::uint32_t lanes = candidate_lanes(arrays_, bundle, skipped_, link);
      if (lanes != 0) {
        any_candidate_ = true;
        counts_.faces += static_cast<std::uint64_t>(std::popcount(lanes));
        followed += static_cast<std::size_t>(std::popcount(lanes));
        if (test_leaf(link, lanes)) return;
      }
    }
    if (has_next) {
      link = next;
    } else if (top != stack) {
      link = ChildLink(*--top);
    } else if (started != links.size()) {
      link = ChildLink(links[started++]);
    } else {
      return;
    }
    has_next = top != stack && top <= stack + kMostAhead;
    if (has_next) {
      next = ChildLink(*--top);
    } else if (top == stack && started != links.size()) {
      next = ChildLink(links[started++]);
      has_next = true;
    }
    if (has_next) fetch(arrays_, next);
  }
}

template <class Tier>
void PairWalk<Tier>::run_alone(const Bundle& bundle, std::span<const std::uint32_t> links) {
  any_candidate_ |= !links.empty();
  for (std::uint32_t rays = live_; rays != 0; rays &= rays - 1) {
    const auto ray = static_cast<std::size_t>(std::countr_zero(rays));
    Beam beam = beam_of(tile_, ray);
    beam.template prepare<Tier::kCertified>();
    const BeamVectors vectors(beam);
    const auto on_leaf = [&](ChildLink link) {
      ++counts_.leaves;
      const bool balls = link.has_balls();
      const auto& faces = balls ? tree_.balls[link.block()].face : tree_.triangles[link.block()].face;
      const LeafBits bits = balls
                                ? segment_balls<Tier::kCertified>(vectors, tree_.balls[link.block()])
                                : segment_triangles<Tier::kCertified>(vectors, tree_.triangles[link.block()]);
      std::uint32_t lanes = bits.possible & link.lanes();
      counts_.tests += link.count();
      if (lanes == 0) return false;
      // Naive hits count where the tile would meet the face: so the answer is the same wherever it went on
      // alone.
      lanes &= Tier::kCertified ? lanes_outside(skipped_.from, faces) & lanes_outside(skipped_.to, faces)
                                : candidate_lanes(arrays_, bundle, skipped_, link);
      if ((bits.certain & lanes) != 0) return true;
      for (; Tier::kCertified && lanes != 0; lanes &= lanes - 1) {
        scratch_.open.push_back({faces[static_cast<std::size_t>(std::countr_zero(lanes))], 1u << ray});
      }
      return false;
    };
    for (const std::uint32_t start : links) {
      if (!walk_alone(
              tree_, vectors, ChildLink(start), [&] { ++counts_.nodes; }, on_leaf))
        continue;
      shadowed_ |= 1u << ray;
      live_ &= ~(1u << ray);
      break;
    }
  }
}

/// The rays that are still open, by the predicate if there is one.
template <class Tier>
void PairWalk<Tier>::resolve() {
  for (const OpenFace& open : scratch_.open) {
    if (exact_ == nullptr) {
      undecided_ |= open.lanes & live_;
      continue;
    }
    for (std::uint32_t rays = open.lanes & live_; rays != 0; rays &= rays - 1) {
      const auto ray = static_cast<std::size_t>(std::countr_zero(rays));
      scene::ShadowQuery query;
      for (std::size_t k = 0; k < 3; ++k) {
        query.point[k] = static_cast<double>(tile_.origin[k][ray]);
      }
      // The light is not the sum of origin and direction, which was rounded.
      const std::size_t to = first_to_ + ray % shape_.to_count();
      for (std::size_t k = 0; k < 3; ++k) query.light[k] = static_cast<double>(to_.coordinates(k)[to]);
      ++counts_.exact;
      if (exact_->blocks(view_.scene, open.face, query)) {
        shadowed_ |= 1u << ray;
        live_ &= ~(1u << ray);
      }
    }
  }
}

template <class Tier>
void PairWalk<Tier>::store(std::span<ShadowAnswer> answers) const {
  const std::size_t rows = std::min(shape_.from_count(), from_.size() - first_from_),
                    columns = std::min(shape_.to_count(), to_.size() - first_to_);
  for (std::size_t i = 0; i < rows; ++i) {
    ShadowAnswer* const row = answers.data() + from_.given(first_from_ + i) * to_.size();
    const std::uint32_t shadowed = shadowed_ >> (i * shape_.to_count()),
                        undecided = undecided_ >> (i * shape_.to_count());
    if (columns == 4 && !to_.is_sorted() && undecided_ == 0) {
      // A byte for each bit.
      const std::uint32_t bytes = ((shadowed & 15u) * 0x0020'4081u) & 0x0101'0101u;
      std::memcpy(row + first_to_, &bytes, 4);
      continue;
    }
    for (std::size_t k = 0; k < columns; ++k) {
      row[to_.given(first_to_ + k)] =
          static_cast<ShadowAnswer>((shadowed >> k & 1u) + 3 * (undecided >> k & 1u));
    }
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
