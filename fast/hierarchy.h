// SPDX-License-Identifier: MIT
// The common ray caster over scenes, in float32: the questions `shadow` and `first-hit` in three tiers.
//
// Boxes are tested eight at a time, and the faces of a leaf too, by the widest instruction set that the
// processor has (Google Highway). Every one of them gives the same answers.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "fast/strict_float.h"
#include "scene/ray_query.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::fast {

/// Answers of the question `shadow`: scene::Shadow, or that the tier cannot tell.
enum class ShadowAnswer : std::uint8_t { lit, shadowed, facing, undecided };

/// Stands for "cannot tell" where a face's number (or scene::kNoFace) is expected.
inline constexpr std::uint32_t kUndecidedFace = 0xffff'fffe;

/// The exact predicates that the exact tier asks about the few faces that floats leave open. They may throw;
/// the call then ends with its answers unspecified.
struct ExactFaces {
  /// Does the face block the query's open segment? The own face's rules included.
  std::function<bool(const scene::Scene&, std::uint32_t face, const scene::ShadowQuery&)> blocks;
  /// Is the answer `facing`?
  std::function<bool(const scene::Scene&, const scene::ShadowQuery&)> faces_away;
  /// Does the ray meet the face? The own face's rules included.
  std::function<bool(const scene::Scene&, std::uint32_t face, const scene::RayQuery&)> meets;
  /// Which of two faces that the ray meets does it meet first?
  std::function<std::strong_ordering(const scene::Scene&, std::uint32_t a, std::uint32_t b,
                                     const scene::RayQuery&)>
      compare_hits;
};

/// What queries cost, in tests: the same on every machine.
struct TestCounters {
  std::uint64_t nodes = 0;   ///< nodes visited
  std::uint64_t boxes = 0;   ///< boxes of their children tested
  std::uint64_t leaves = 0;  ///< leaves visited
  std::uint64_t faces = 0;   ///< faces of theirs tested
  std::uint64_t exact = 0;   ///< calls of exact predicates

  friend bool operator==(const TestCounters&, const TestCounters&) = default;
};

struct HierarchyArrays;

/// A bounding volume hierarchy over all faces of a scene, eight boxes a node, up to eight faces a leaf.
/// Queries of `const` objects may run in many threads at once, and allocate nothing (the predicates may).
///
/// naive: the usual arithmetic in floats, without any promise. Numbers of a query that are no floats are
///   rounded. An edge belongs to both its faces; the ends of a segment to none.
/// certified: the same kernels with error thresholds. Every answer but `undecided` is right, in exact
///   arithmetic. Undecided where a face that could change the answer is too close to call, and for queries
///   and scenes outside the domain: all numbers must be floats (doubles whose value is a float) of magnitude
///   at most 2^40; the largest of a ray's direction, besides, at least 2^-81 (or all 0). Thresholds hold an
///   absolute term for underflow, 2^-104 for a product of three lengths: below scenes of about 1e-9 units
///   with triangles of 1e-12 all is undecided.
/// exact: certified, with the undecided faces handed to the predicates, so always right. Outside the domain
///   every face of the scene is handed over, in O(n) time.
///
/// Numbers of a query must be finite, or the naive tier's answer is any, the certified one `undecided`. `own`
/// must be kNoFace or the number of a face; other numbers count as kNoFace.
class Hierarchy {
 public:
  enum class Tier : std::uint8_t { naive, certified };

  /// Keeps a reference to the scene, which must be scene::is_valid(), but may have no faces. Throws
  /// std::runtime_error when a coordinate or radius is no float, or for more than 2^27 leaves. O(n log n).
  explicit Hierarchy(const scene::Scene& scene);
  explicit Hierarchy(scene::Scene&&) = delete;
  ~Hierarchy();
  Hierarchy(const Hierarchy&) = delete;
  Hierarchy& operator=(const Hierarchy&) = delete;

  /// answers[i] answers queries[i]; the spans must be of one size.
  void shadows(Tier tier, std::span<const scene::ShadowQuery> queries, std::span<ShadowAnswer> answers) const;
  void shadows_exact(const ExactFaces& faces, std::span<const scene::ShadowQuery> queries,
                     std::span<ShadowAnswer> answers) const;

  /// The number of the face, kNoFace, or kUndecidedFace (certified: also when several faces may be first).
  void first_hits(Tier tier, std::span<const scene::RayQuery> queries,
                  std::span<std::uint32_t> answers) const;
  /// Of the faces that the ray meets first, all at the same place, the one with the least number.
  void first_hits_exact(const ExactFaces& faces, std::span<const scene::RayQuery> queries,
                        std::span<std::uint32_t> answers) const;

  /// The same, adding up their tests: slower, for statistics.
  void shadows(Tier tier, std::span<const scene::ShadowQuery> queries, std::span<ShadowAnswer> answers,
               TestCounters& counters) const;
  void shadows_exact(const ExactFaces& faces, std::span<const scene::ShadowQuery> queries,
                     std::span<ShadowAnswer> answers, TestCounters& counters) const;
  void first_hits(Tier tier, std::span<const scene::RayQuery> queries, std::span<std::uint32_t> answers,
                  TestCounters& counters) const;
  void first_hits_exact(const ExactFaces& faces, std::span<const scene::RayQuery> queries,
                        std::span<std::uint32_t> answers, TestCounters& counters) const;

  [[nodiscard]] ShadowAnswer shadow(Tier tier, const scene::ShadowQuery& query) const {
    ShadowAnswer answer{};
    shadows(tier, {&query, 1}, {&answer, 1});
    return answer;
  }
  [[nodiscard]] ShadowAnswer shadow_exact(const ExactFaces& faces, const scene::ShadowQuery& query) const {
    ShadowAnswer answer{};
    shadows_exact(faces, {&query, 1}, {&answer, 1});
    return answer;
  }
  [[nodiscard]] std::uint32_t first_hit(Tier tier, const scene::RayQuery& query) const {
    std::uint32_t answer{};
    first_hits(tier, {&query, 1}, {&answer, 1});
    return answer;
  }
  [[nodiscard]] std::uint32_t first_hit_exact(const ExactFaces& faces, const scene::RayQuery& query) const {
    std::uint32_t answer{};
    first_hits_exact(faces, {&query, 1}, {&answer, 1});
    return answer;
  }

  /// The memory of nodes, leaves and the index of faces; the scene's own is not in it.
  [[nodiscard]] std::size_t bytes() const;
  /// True when all numbers of the scene are in the certified tier's domain.
  [[nodiscard]] bool in_domain() const { return in_domain_; }

 private:
  const scene::Scene& scene_;
  std::unique_ptr<const HierarchyArrays> arrays_;
  bool in_domain_ = true;
};

/// The instruction set that hierarchies run on in this process now, in Highway's words.
[[nodiscard]] const char* hierarchy_instruction_set();

}  // namespace gnomon::fast
