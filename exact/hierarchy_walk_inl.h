// SPDX-License-Identifier: GPL-3.0-or-later
// How exact/hierarchy.h is walked. Everything in here and in what it includes is in a namespace
// GNOMON_EXACT_TARGET, since several units compile it, each for another set of instructions: no function
// may be shared between them. For the same reason they include all other headers before they choose theirs.
// Vectors are handed over by reference, as registers for them depend on the instructions.

namespace gnomon::exact::GNOMON_EXACT_TARGET {

using Int8 = std::int32_t __attribute__((vector_size(32)));
using Int64x4 = std::int64_t __attribute__((vector_size(32)));

template <std::size_t kLanes, class Lanes>
[[nodiscard, gnu::always_inline]] inline unsigned bits_of(const Lanes& lanes) {
  unsigned mask = 0;
  for (std::size_t i = 0; i < kLanes; ++i) mask |= static_cast<unsigned>(lanes[i] & 1) << i;
  return mask;
}

/// One bit for each lane that is true.
[[nodiscard, gnu::always_inline]] inline unsigned mask_of(const Int8& lanes) {
#if defined(__SSE2__)
  const Float8 f = reinterpret_cast<Float8>(lanes);
  const Float4 low = __builtin_shufflevector(f, f, 0, 1, 2, 3),
               high = __builtin_shufflevector(f, f, 4, 5, 6, 7);
  return static_cast<unsigned>(__builtin_ia32_movmskps(low) | __builtin_ia32_movmskps(high) << 4);
#else
  return bits_of<8>(lanes);
#endif
}
[[nodiscard, gnu::always_inline]] inline unsigned mask_of(const Int64x4& lanes) {
#if defined(__SSE2__)
  const Double4 d = reinterpret_cast<Double4>(lanes);
  using Double2 = double __attribute__((vector_size(16)));
  const Double2 low = __builtin_shufflevector(d, d, 0, 1), high = __builtin_shufflevector(d, d, 2, 3);
  return static_cast<unsigned>(__builtin_ia32_movmskpd(low) | __builtin_ia32_movmskpd(high) << 2);
#else
  return bits_of<4>(lanes);
#endif
}

/// Has the memory of something come nearer, for use a little later.
template <class T>
[[gnu::always_inline]] inline void fetch(const T& what) {
  for (std::size_t byte = 0; byte < sizeof what; byte += 64) {
    __builtin_prefetch(reinterpret_cast<const char*>(&what) + byte);
  }
}

/// The lanes that hold a number.
[[nodiscard, gnu::always_inline]] inline unsigned lanes_of(const std::array<std::uint32_t, kLeafLanes>& lanes,
                                                           std::uint32_t number) {
  unsigned mask = 0;
  for (std::size_t i = 0; i < kLeafLanes; ++i) mask |= unsigned{lanes[i] == number} << i;
  return mask;
}

[[nodiscard, gnu::always_inline]] inline std::size_t first_of(unsigned mask) {
  return static_cast<std::size_t>(__builtin_ctz(mask));
}

}  // namespace gnomon::exact::GNOMON_EXACT_TARGET

#include "exact/box_path_inl.h"
#include "exact/path_filter_inl.h"

namespace gnomon::exact::GNOMON_EXACT_TARGET {

using scene::RayQuery;
using scene::Scene;
using scene::ShadowQuery;

/// Counts nothing, and costs nothing.
struct NoCounters {
  static void add_boxes(unsigned) {}
  static void add_faces(unsigned) {}
  static void add_exact_face() {}
};

struct RealCounters {
  HierarchyCounters& counters;

  void add_boxes(unsigned lanes) const { counters.box_tests += count(lanes); }
  void add_faces(unsigned lanes) const { counters.face_tests += count(lanes); }
  void add_exact_face() const { ++counters.exact_face_tests; }

 private:
  static unsigned count(unsigned lanes) { return static_cast<unsigned>(__builtin_popcount(lanes)); }
};

/// Nodes and leaves that are yet to be visited. A node pushes at most seven more than it takes.
template <class Entry>
class Stack {
 public:
  [[nodiscard]] bool empty() const { return size_ == 0; }
  void push(const Entry& entry) { entries_[size_++] = entry; }
  [[nodiscard]] Entry pop() { return entries_[--size_]; }

 private:
  std::array<Entry, (kNodeLanes - 1) * kMostLevels + kNodeLanes> entries_;
  std::size_t size_ = 0;
};

/// An own ball has a rule that asks for its centre alone: its box may be anywhere.
bool is_own_ball(const Scene& scene, std::uint32_t own) {
  return own != scene::kNoFace && own >= scene.triangles.size();
}

template <class F, class Counters>
class ShadowWalk {
 public:
  ShadowWalk(const Scene& scene, const BuiltHierarchy& built, const ShadowQuery& query, Counters counters)
      : scene_(scene), built_(built), query_(query), counters_(counters) {}

  ShadowTruth run() {
    const std::optional<int> facing = own_facing(scene_, query_);
    if (facing == -1) return {scene::Shadow::facing, false};
    const Path path(query_);
    ShadowFold fold(scene_, path, facing == 0);
    if (built_.nodes.empty()) return fold.truth();
    if (is_own_ball(scene_, query_.own)) {
      counters_.add_exact_face();
      fold.add(query_.own, contact(scene_, query_.own, query_));
      if (fold.settled()) return fold.truth();
    }
    const BoxPath box_path(built_.frame, path);
    const PathFilter filter(path);
    Stack<std::uint32_t> stack;
    std::uint32_t at = 0;
    for (;;) {
      const WideNode& node = built_.nodes[at];
      counters_.add_boxes(node.used);
      NearBounds near;
      const unsigned met = box_path.test(node, 1, near);
      const unsigned leaves = met & node.leaves;
      if (leaves != 0) fetch(built_.leaves<F>()[node.child[first_of(leaves)]]);
      unsigned inner = met & ~unsigned{node.leaves};
      if (inner != 0) {
        // The nearest one is next. A minimum of whole numbers needs no branch, which nothing could predict;
        // lower bounds are not negative, so that their bits are in order.
        std::uint64_t nearest = place_of(node, near, first_of(inner));
        while ((inner &= inner - 1) != 0) {
          const std::uint64_t place = place_of(node, near, first_of(inner));
          stack.push(static_cast<std::uint32_t>(std::max(nearest, place)));
          nearest = std::min(nearest, place);
        }
        stack.push(static_cast<std::uint32_t>(nearest));
      }
      const bool last = stack.empty();
      if (!last) {
        at = stack.pop();
        fetch(built_.nodes[at]);
      }
      for (unsigned mask = leaves; mask != 0; mask &= mask - 1) {
        leaf(built_.leaves<F>()[node.child[first_of(mask)]], filter, fold);
        if (fold.settled()) return fold.truth();
      }
      if (last) return fold.truth();
    }
  }

 private:
  [[gnu::always_inline]] static std::uint64_t place_of(const WideNode& node, const NearBounds& near,
                                                       std::size_t lane) {
    return std::uint64_t{near.bits[lane]} << 32 | node.child[lane];
  }

  [[gnu::always_inline]] void leaf(const Leaf<F>& leaf, const PathFilter& filter, ShadowFold& fold) {
    counters_.add_faces(leaf.used());
    const unsigned others = leaf.used() & ~lanes_of(leaf.face, query_.own);
    const CertainTriangles triangles = filter.segment_and(leaf);
    if ((triangles.plain & leaf.triangles & others) != 0) return fold.add_plain();
    unsigned open = leaf.triangles & others & ~triangles.none;
    for (unsigned mask = leaf.balls & others; mask != 0; mask &= mask - 1) {
      const Certain certain = filter.ball(leaf, first_of(mask));
      if (certain == Certain::plain) return fold.add_plain();
      if (certain == Certain::unknown) open |= mask & -mask;
    }
    for (; open != 0 && !fold.settled(); open &= open - 1) {
      const std::uint32_t face = leaf.face[first_of(open)];
      counters_.add_exact_face();
      fold.add(face, contact(scene_, face, query_));
    }
  }

  const Scene& scene_;
  const BuiltHierarchy& built_;
  const ShadowQuery& query_;
  Counters counters_;
};

struct HitEntry {
  std::uint32_t child;
  float near;
  bool is_leaf;
};

template <class F, class Counters>
class FirstHitWalk {
 public:
  FirstHitWalk(const Scene& scene, const BuiltHierarchy& built, const RayQuery& ray, Counters counters)
      : scene_(scene), built_(built), ray_(ray), counters_(counters) {}

  FirstHit run() {
    FirstHitFold fold(scene_, ray_);
    if (built_.nodes.empty()) return fold.result();
    if (is_own_ball(scene_, ray_.own)) {
      counters_.add_exact_face();
      fold.add(ray_.own, contact(scene_, ray_.own, ray_));
    }
    const Path path(ray_);
    const BoxPath box_path(built_.frame, path);
    const PathFilter filter(path);
    Stack<HitEntry> stack;
    stack.push({0, 0, false});
    while (!stack.empty()) {
      const HitEntry entry = stack.pop();
      const float latest = float_above(fold.latest());
      if (!BoxPath::in_time(entry.near, latest)) continue;
      if (entry.is_leaf) {
        leaf(built_.leaves<F>()[entry.child], filter, fold);
        continue;
      }
      const WideNode& node = built_.nodes[entry.child];
      counters_.add_boxes(node.used);
      NearBounds near;
      const unsigned met = box_path.test(node, latest, near);
      // The children by distance, the nearest one on top.
      std::array<HitEntry, kNodeLanes> sorted;
      std::size_t count = 0;
      for (unsigned mask = met; mask != 0; mask &= mask - 1) {
        const std::size_t lane = first_of(mask);
        const HitEntry child{node.child[lane], near.of[lane], (node.leaves >> lane & 1) != 0};
        std::size_t place = count++;
        for (; place > 0 && sorted[place - 1].near < child.near; --place) sorted[place] = sorted[place - 1];
        sorted[place] = child;
      }
      for (std::size_t i = 0; i < count; ++i) stack.push(sorted[i]);
    }
    return fold.result();
  }

 private:
  [[gnu::always_inline]] void leaf(const Leaf<F>& leaf, const PathFilter& filter, FirstHitFold& fold) {
    counters_.add_faces(leaf.used());
    const unsigned others = leaf.used() & ~lanes_of(leaf.face, ray_.own);
    HitLanes earliest, latest;
    const CertainTriangles triangles = filter.ray_and(leaf, earliest, latest);
    unsigned open = leaf.triangles & others & ~(triangles.none | triangles.plain);
    for (unsigned mask = triangles.plain & leaf.triangles & others; mask != 0; mask &= mask - 1) {
      const std::size_t lane = first_of(mask);
      if (earliest.of[lane] > fold.latest()) continue;
      fold.add(leaf.face[lane], {ContactKind::plain}, {earliest.of[lane], latest.of[lane]});
    }
    for (unsigned mask = leaf.balls & others; mask != 0; mask &= mask - 1) {
      if (filter.ball(leaf, first_of(mask)) != Certain::none) open |= mask & -mask;
    }
    for (; open != 0; open &= open - 1) {
      const std::uint32_t face = leaf.face[first_of(open)];
      counters_.add_exact_face();
      fold.add(face, contact(scene_, face, ray_));
    }
  }

  const Scene& scene_;
  const BuiltHierarchy& built_;
  const RayQuery& ray_;
  Counters counters_;
};

template <class Counters>
ShadowTruth walk_shadow(const Scene& scene, const BuiltHierarchy& built, const ShadowQuery& query,
                        Counters counters) {
  if (!built.float_leaves.empty()) return ShadowWalk<float, Counters>(scene, built, query, counters).run();
  return ShadowWalk<double, Counters>(scene, built, query, counters).run();
}

template <class Counters>
FirstHit walk_first_hit(const Scene& scene, const BuiltHierarchy& built, const RayQuery& ray,
                        Counters counters) {
  if (!built.float_leaves.empty()) return FirstHitWalk<float, Counters>(scene, built, ray, counters).run();
  return FirstHitWalk<double, Counters>(scene, built, ray, counters).run();
}

ShadowTruth shadow(const Scene& scene, const BuiltHierarchy& built, const ShadowQuery& query,
                   HierarchyCounters* counters) {
  if (counters == nullptr) return walk_shadow(scene, built, query, NoCounters());
  return walk_shadow(scene, built, query, RealCounters{*counters});
}

FirstHit first_hit(const Scene& scene, const BuiltHierarchy& built, const RayQuery& ray,
                   HierarchyCounters* counters) {
  if (counters == nullptr) return walk_first_hit(scene, built, ray, NoCounters());
  return walk_first_hit(scene, built, ray, RealCounters{*counters});
}

}  // namespace gnomon::exact::GNOMON_EXACT_TARGET
