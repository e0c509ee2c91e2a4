// SPDX-License-Identifier: MIT
// Visibility of all rays between two sets of points, as radiosity asks for it between two patches: one walk
// of the scene for many rays (Haines, Wallace: "Shaft Culling for Efficient Ray-Cast Radiosity").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fast/hierarchy.h"
#include "fast/pair_patch.h"
#include "scene/box.h"
#include "scene/face_run.h"
#include "scene/patch_pair.h"
#include "scene/scene.h"

namespace gnomon::fast {

/// The rays from every point of `from` to every point of `to`: ray i * to.size() + k goes from from[i] to
/// to[k]. The faces of the own runs, which may be empty, block no ray.
struct RayBatch {
  std::span<const std::array<float, 3>> from, to;
  scene::FaceRun own_from, own_to;
};

/// What was found out about a pair as a whole.
/// all: no face is left after culling, so no ray was cast: every ray is lit.
/// none: a single face blocks every ray.
/// part: neither was noticed. The answers may still be all alike.
/// Naive: so the floats say. Certified and exact: all and none are right, in exact arithmetic.
struct PairResult {
  scene::PairVisibility visibility = scene::PairVisibility::part;
  std::uint32_t blocker = scene::kNoFace;  ///< none: the face that blocks every ray
};

/// What pairs cost, in tests: the same on every machine.
struct PairCounters {
  std::uint64_t pairs = 0, rays = 0;
  std::uint64_t all = 0, none = 0;  ///< pairs with this visibility
  std::uint64_t nodes = 0;          ///< nodes whose eight boxes were tested against a shaft
  std::uint64_t leaves = 0;         ///< leaves whose faces were culled, eight at a time
  std::uint64_t faces = 0;          ///< faces left by that
  std::uint64_t tests = 0;          ///< rays tested against a face, rays known or missing included
  std::uint64_t exact = 0;          ///< calls of the exact predicate

  friend bool operator==(const PairCounters&, const PairCounters&) = default;
};

/// Memory that queries work in, and the face that blocked last: one a thread. What it was used for before
/// changes no certified or exact answer of a ray. It may change whether a face that blocks all rays is
/// noticed (none or part), and which one; what is counted; and naive answers, where a ray that goes on by
/// itself misses the box of a face that floats let it hit. Nothing is allocated once it has seen the largest
/// pair.
class PairScratch {
 public:
  PairScratch();
  ~PairScratch();
  PairScratch(PairScratch&&) noexcept;
  PairScratch& operator=(PairScratch&&) noexcept;

  struct Data;
  [[nodiscard]] Data& data() const { return *data_; }

 private:
  std::unique_ptr<Data> data_;
};

struct PairArrays;

/// Answers for batches of rays. A ray (p, q) is shadowed when the open segment from p to q meets a closed
/// face that is in neither own run, else lit; p = q is lit. Queries of `const` objects may run in many
/// threads at once, each with a scratch of its own.
///
/// naive: floats, without any promise.
/// certified: every answer but `undecided` is right, in exact arithmetic. Undecided where a face that could
///   change the answer is too close to call; and every ray when a number of the batch or of the scene is
///   beyond 2^40 (Hierarchy's domain) or not finite.
/// exact: certified, and ExactFaces::blocks (with own = kNoFace) decides the rest: always right for finite
///   points. Out of the domain it is asked about every face, in O(n) time a ray. NaN, infinity: undecided.
/// The answers are the same on all instruction sets.
class PairCaster {
 public:
  /// Keeps a reference to the scene, which must be scene::is_valid(), but may have no faces.
  /// `convex_objects[i] != 0` says that object i is convex exactly: the solid that its faces bound lies
  /// behind the plane of each of its triangles, touching allowed, and each of its other faces too. Its other
  /// faces are then left out for rays that leave it on the front of an own face. Empty: none is known to be.
  /// Throws as Hierarchy does. O(n log n).
  explicit PairCaster(const scene::Scene& scene, std::span<const std::uint8_t> convex_objects = {});
  explicit PairCaster(scene::Scene&&, std::span<const std::uint8_t> = {}) = delete;
  ~PairCaster();
  PairCaster(const PairCaster&) = delete;
  PairCaster& operator=(const PairCaster&) = delete;

  /// answers.size() must be from.size() * to.size(). Either may be empty: then nothing is answered, and the
  /// visibility is `all`.
  PairResult shadows_naive(const RayBatch& batch, PairScratch& scratch, std::span<ShadowAnswer> answers,
                           PairCounters* counters = nullptr) const;
  PairResult shadows_certified(const RayBatch& batch, PairScratch& scratch, std::span<ShadowAnswer> answers,
                               PairCounters* counters = nullptr) const;
  PairResult shadows_exact(const ExactFaces& faces, const RayBatch& batch, PairScratch& scratch,
                           std::span<ShadowAnswer> answers, PairCounters* counters = nullptr) const;

  /// What of a pair's set-up depends on one patch only, done once for many pairs. `own` as in RayBatch.
  [[nodiscard]] PairPatch prepare(std::span<const std::array<float, 3>> points, scene::FaceRun own) const;
  void prepare(std::span<const std::array<float, 3>> points, scene::FaceRun own, PairPatch& patch) const;
  PairResult shadows_naive(const PairPatch& from, const PairPatch& to, PairScratch& scratch,
                           std::span<ShadowAnswer> answers, PairCounters* counters = nullptr) const;
  PairResult shadows_certified(const PairPatch& from, const PairPatch& to, PairScratch& scratch,
                               std::span<ShadowAnswer> answers, PairCounters* counters = nullptr) const;
  PairResult shadows_exact(const ExactFaces& faces, const PairPatch& from, const PairPatch& to,
                           PairScratch& scratch, std::span<ShadowAnswer> answers,
                           PairCounters* counters = nullptr) const;

  /// The faces that certified culling leaves for the pair, in any order, none twice. Every face of the scene
  /// but the own ones is among them that meets an open segment from a point of the hull of `from` to a point
  /// of the hull of `to`. Out of the domain: all but the own ones.
  void candidates(const PairPatch& from, const PairPatch& to, std::vector<std::uint32_t>& faces) const;

  /// The faces that certified culling leaves for the shaft between two valid boxes: every closed face that
  /// meets the closed shaft is among them. In any order, none twice. Out of the domain: all.
  void shaft_faces(const scene::Box<float>& a, const scene::Box<float>& b,
                   std::vector<std::uint32_t>& faces) const;

  /// The memory of nodes, leaves and the index of faces; the scene's own is not in it.
  [[nodiscard]] std::size_t bytes() const;
  /// True when all numbers of the scene are in the certified tier's domain.
  [[nodiscard]] bool in_domain() const { return in_domain_; }

 private:
  void prepare(const RayBatch& batch, PairScratch& scratch) const;
  void set_plane(PairPatch& patch) const;

  const scene::Scene& scene_;
  std::unique_ptr<const PairArrays> arrays_;
  std::vector<scene::FaceRun> convex_runs_;   ///< the triangles of convex objects; the first one is of none
  std::vector<std::uint32_t> convex_run_of_;  ///< of each triangle; empty when no object is convex
  bool in_domain_ = true;
};

}  // namespace gnomon::fast
