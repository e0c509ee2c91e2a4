// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/hierarchy.h"

#include <bit>
#include <optional>

#include "exact/contact.h"
#include "exact/first_hit_fold.h"
#include "exact/hierarchy_build.h"
#include "exact/path_filter.h"
#include "exact/shadow_fold.h"

namespace gnomon::exact {

using scene::RayQuery;
using scene::Scene;
using scene::ShadowQuery;

namespace {

/// Counts nothing, and costs nothing.
struct NoCounters {
  static void add_boxes(unsigned) {}
  static void add_face() {}
  static void add_exact_face() {}
};

struct RealCounters {
  HierarchyCounters& counters;

  void add_boxes(unsigned count) const { counters.box_tests += count; }
  void add_face() const { ++counters.face_tests; }
  void add_exact_face() const { ++counters.exact_face_tests; }
};

/// Nodes and leaves that are yet to be visited. A node pushes at most three more than it takes.
template <class Entry>
class Stack {
 public:
  [[nodiscard]] bool empty() const { return size_ == 0; }
  void push(const Entry& entry) { entries_[size_++] = entry; }
  [[nodiscard]] Entry pop() { return entries_[--size_]; }

 private:
  std::array<Entry, 3 * kMostLevels + 4> entries_;
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
      counters_.add_boxes(static_cast<unsigned>(std::popcount(node.used)));
      const BoxPath::Boxes boxes = box_path.test(node, 1);
      float nearest = kInfinity;
      std::uint32_t next = 0;
      for (unsigned mask = boxes.mask; mask != 0; mask &= mask - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(mask));
        const std::uint32_t first = node.first[lane];
        if (node.count[lane] != 0) {
          leaf(first, node.count[lane], filter, fold);
          if (fold.settled()) return fold.truth();
        } else if (next == 0) {
          next = first;
          nearest = boxes.near[lane];
        } else if (boxes.near[lane] < nearest) {
          stack.push(next);
          next = first;
          nearest = boxes.near[lane];
        } else {
          stack.push(first);
        }
      }
      if (next != 0) {
        at = next;
        continue;
      }
      if (stack.empty()) return fold.truth();
      at = stack.pop();
    }
  }

 private:
  void leaf(std::uint32_t first, std::uint32_t count, const PathFilter& filter, ShadowFold& fold) {
    const LeafFace<F>* const faces = built_.faces<F>();
    for (std::uint32_t i = first; i < first + count; ++i) {
      const LeafFace<F>& leaf = faces[i];
      counters_.add_face();
      if (leaf.face == query_.own) continue;
      const Certain certain =
          leaf.face < scene_.triangles.size() ? filter.triangle(leaf.c).certain : filter.ball(leaf.c);
      if (certain == Certain::none) continue;
      if (certain == Certain::plain) {
        fold.add_plain();
        return;
      }
      counters_.add_exact_face();
      fold.add(leaf.face, contact(scene_, leaf.face, query_));
      if (fold.settled()) return;
    }
  }

  const Scene& scene_;
  const BuiltHierarchy& built_;
  const ShadowQuery& query_;
  Counters counters_;
};

struct HitEntry {
  std::uint32_t first;
  std::uint32_t count;
  float near;
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
    stack.push({0, 0, 0});
    while (!stack.empty()) {
      const HitEntry entry = stack.pop();
      const float latest = float_above(fold.latest());
      if (!BoxPath::in_time(entry.near, latest)) continue;
      if (entry.count != 0) {
        leaf(entry.first, entry.count, filter, fold);
        continue;
      }
      const WideNode& node = built_.nodes[entry.first];
      counters_.add_boxes(static_cast<unsigned>(std::popcount(node.used)));
      const BoxPath::Boxes boxes = box_path.test(node, latest);
      // The children by distance, the nearest one on top.
      std::array<HitEntry, 4> sorted;
      std::size_t count = 0;
      for (unsigned mask = boxes.mask; mask != 0; mask &= mask - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(mask));
        const HitEntry child{node.first[lane], node.count[lane], boxes.near[lane]};
        std::size_t place = count++;
        for (; place > 0 && sorted[place - 1].near < child.near; --place) sorted[place] = sorted[place - 1];
        sorted[place] = child;
      }
      for (std::size_t i = 0; i < count; ++i) stack.push(sorted[i]);
    }
    return fold.result();
  }

 private:
  void leaf(std::uint32_t first, std::uint32_t count, const PathFilter& filter, FirstHitFold& fold) {
    const LeafFace<F>* const faces = built_.faces<F>();
    for (std::uint32_t i = first; i < first + count; ++i) {
      const LeafFace<F>& leaf = faces[i];
      counters_.add_face();
      if (leaf.face == ray_.own) continue;
      if (leaf.face < scene_.triangles.size()) {
        const PathFilter::TriangleResult result = filter.triangle(leaf.c);
        if (result.certain == Certain::none) continue;
        if (result.certain == Certain::plain) {
          if (result.t.lo <= fold.latest()) fold.add(leaf.face, {ContactKind::plain}, result.t);
          continue;
        }
      } else if (filter.ball(leaf.c) == Certain::none) {
        continue;
      }
      counters_.add_exact_face();
      fold.add(leaf.face, contact(scene_, leaf.face, ray_));
    }
  }

  const Scene& scene_;
  const BuiltHierarchy& built_;
  const RayQuery& ray_;
  Counters counters_;
};

template <class Counters>
ShadowTruth walk(const Scene& scene, const BuiltHierarchy& built, const ShadowQuery& query,
                 Counters counters) {
  if (!built.float_faces.empty()) return ShadowWalk<float, Counters>(scene, built, query, counters).run();
  return ShadowWalk<double, Counters>(scene, built, query, counters).run();
}

template <class Counters>
FirstHit walk(const Scene& scene, const BuiltHierarchy& built, const RayQuery& ray, Counters counters) {
  if (!built.float_faces.empty()) return FirstHitWalk<float, Counters>(scene, built, ray, counters).run();
  return FirstHitWalk<double, Counters>(scene, built, ray, counters).run();
}

}  // namespace

Hierarchy::Hierarchy(const Scene& scene)
    : scene_(scene), built_(std::make_unique<const BuiltHierarchy>(build_hierarchy(scene))) {}

Hierarchy::~Hierarchy() = default;

ShadowTruth Hierarchy::shadow(const ShadowQuery& query) const {
  return walk(scene_, *built_, query, NoCounters());
}

ShadowTruth Hierarchy::shadow(const ShadowQuery& query, HierarchyCounters& counters) const {
  return walk(scene_, *built_, query, RealCounters{counters});
}

FirstHit Hierarchy::first_hit(const RayQuery& ray) const {
  return walk(scene_, *built_, ray, NoCounters());
}

FirstHit Hierarchy::first_hit(const RayQuery& ray, HierarchyCounters& counters) const {
  return walk(scene_, *built_, ray, RealCounters{counters});
}

std::size_t Hierarchy::bytes() const {
  return sizeof *this + sizeof *built_ + built_->nodes.capacity() * sizeof(WideNode) +
         built_->float_faces.capacity() * sizeof(LeafFace<float>) +
         built_->double_faces.capacity() * sizeof(LeafFace<double>);
}

}  // namespace gnomon::exact
