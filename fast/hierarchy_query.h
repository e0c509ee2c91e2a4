// SPDX-License-Identifier: MIT
// What a query does before and after it walks the tree: the own face's rules, and the faces left open.
// Internal to fast/hierarchy*.
#pragma once

#include <array>
#include <bit>
#include <span>

#include "fast/hierarchy.h"
#include "fast/hierarchy_beam.h"
#include "fast/hierarchy_build.h"

namespace gnomon::fast {

struct HierarchyView {
  const scene::Scene& scene;
  const HierarchyArrays& arrays;
  bool in_domain;
};

struct NaiveTier {
  static constexpr bool kCertified = false;
};
struct CertifiedTier {
  static constexpr bool kCertified = true;
};

/// Counts tests, or nothing at all.
struct NoCount {
  void node() {}
  void leaf(std::uint32_t) {}
  void exact(std::uint64_t) {}
};
struct Count {
  TestCounters& counters;
  void node() {
    ++counters.nodes;
    counters.boxes += kWidth;
  }
  void leaf(std::uint32_t faces) {
    ++counters.leaves;
    counters.faces += faces;
  }
  void exact(std::uint64_t calls) { counters.exact += calls; }
};

template <class Function>
void with_count(TestCounters* counters, const Function& function) {
  if (counters != nullptr) {
    Count count{*counters};
    function(count);
  } else {
    NoCount count;
    function(count);
  }
}

/// The faces that may block a segment and that floats leave open, a few at a time.
class ShadowCandidates {
 public:
  /// `exact` may be null: then nothing is resolved.
  ShadowCandidates(const scene::Scene& scene, const scene::ShadowQuery& query, const ExactFaces* exact)
      : scene_(scene), query_(query), exact_(exact) {}

  /// Adds the faces of these lanes; true when one is now known to block.
  bool add(const std::array<std::uint32_t, kWidth>& faces, std::uint32_t lanes);
  [[nodiscard]] bool any() const { return any_; }
  /// What is left open, decided if there are predicates: shadowed, lit or undecided.
  [[nodiscard]] ShadowAnswer resolve();

  /// Every face of the scene, by predicates alone; undecided without.
  [[nodiscard]] ShadowAnswer ask_about_all();
  /// Whether the answer is `facing`: 1, 0, or -1 for undecided.
  [[nodiscard]] int ask_about_facing();
  [[nodiscard]] std::uint64_t calls() const { return calls_; }

 private:
  [[nodiscard]] bool one_blocks();

  const scene::Scene& scene_;
  const scene::ShadowQuery& query_;
  const ExactFaces* exact_;
  std::size_t count_ = 0;
  bool any_ = false;
  std::uint64_t calls_ = 0;
  std::array<std::uint32_t, 3 * kWidth> faces_;
};

/// Sets the beam up; true when the answer is known without walking the tree.
template <class Tier>
[[nodiscard]] bool begin_shadow(const HierarchyView& hierarchy, const scene::ShadowQuery& query, Beam& beam,
                                ShadowCandidates& candidates, ShadowAnswer& answer);

/// The faces that a ray may meet first. Each has an interval of parameters, and is met for certain or not.
class HitCandidates {
 public:
  HitCandidates(const scene::Scene& scene, const scene::RayQuery& query, const ExactFaces* exact)
      : scene_(scene), query_(query), exact_(exact) {}

  void add(std::uint32_t face, float lo, float hi, bool certain) {
    if (lo > nearest_) return;
    if (certain && hi < nearest_) nearest_ = hi;
    if (count_ == hits_.size()) make_room();
    if (count_ < hits_.size()) hits_[count_++] = {lo, hi, face, certain};
  }
  /// No face beyond this parameter can be first.
  [[nodiscard]] float nearest() const { return nearest_; }
  [[nodiscard]] std::uint32_t resolve();
  [[nodiscard]] std::uint32_t ask_about_all();
  [[nodiscard]] std::uint64_t calls() const { return calls_; }

 private:
  struct Hit {
    float lo, hi;
    std::uint32_t face;
    bool certain;
  };
  void drop_farther();
  void make_room();
  /// Leaves the first of the faces that are met, if any.
  void leave_first();

  const scene::Scene& scene_;
  const scene::RayQuery& query_;
  const ExactFaces* exact_;
  float nearest_ = std::numeric_limits<float>::infinity();
  std::size_t count_ = 0;
  bool lost_ = false;  ///< there was no room, and no predicate to make some
  std::uint64_t calls_ = 0;
  std::array<Hit, 3 * kWidth> hits_;
};

/// The sign of (c - p) . d for a ball's lane: into the ball, out of it, or 0: not certain.
template <class Tier>
[[nodiscard]] int way_into(const BallBlock& block, std::size_t lane, const Beam& beam);

/// True when the ray and the scene are in the certified tier's domain.
[[nodiscard]] bool in_ray_domain(const HierarchyView& hierarchy, const scene::RayQuery& query);
/// Sets the beam up; false when there is nothing to meet.
template <class Tier>
[[nodiscard]] bool begin_ray(const HierarchyView& hierarchy, const scene::RayQuery& query, Beam& beam);

/// Implemented by fast/hierarchy_shadow.cpp and fast/hierarchy_first_hit.cpp. `exact` may be null.
void run_shadows(Hierarchy::Tier tier, const HierarchyView& hierarchy,
                 std::span<const scene::ShadowQuery> queries, std::span<ShadowAnswer> answers,
                 const ExactFaces* exact, TestCounters* counters);
void run_first_hits(Hierarchy::Tier tier, const HierarchyView& hierarchy,
                    std::span<const scene::RayQuery> queries, std::span<std::uint32_t> answers,
                    const ExactFaces* exact, TestCounters* counters);

}  // namespace gnomon::fast
