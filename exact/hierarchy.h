// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `shadow` and `first-hit`, in much less time than face by face.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "exact/first_hit.h"
#include "exact/shadow.h"

namespace gnomon::exact {

/// What queries have cost: boxes tested (eight of them at a time), faces tested, and faces that plain doubles
/// could not decide about, so that intervals or rationals did; of own balls and of balls that a ray may meet,
/// all.
struct HierarchyCounters {
  std::uint64_t box_tests = 0, face_tests = 0, exact_face_tests = 0;
};

struct BuiltHierarchy;

/// A hierarchy of bounding boxes over all faces of a scene. Its answers are those of shadow_by_all_faces()
/// and first_hit_by_all_faces(), touching included, for all finite doubles: boxes are rounded outwards,
/// their tests keep whatever rounding leaves open, and faces are decided on exactly.
///
/// Keeps a reference to the scene, which must be valid and must not change. Queries may run in any number of
/// threads at once; they allocate nothing unless a path meets borders of faces (shadow) or anything at all
/// (first-hit), or rationals have to decide.
class Hierarchy {
 public:
  explicit Hierarchy(const scene::Scene& scene);
  ~Hierarchy();
  Hierarchy(const Hierarchy&) = delete;
  Hierarchy& operator=(const Hierarchy&) = delete;

  [[nodiscard]] ShadowTruth shadow(const scene::ShadowQuery& query) const;
  [[nodiscard]] FirstHit first_hit(const scene::RayQuery& ray) const;

  /// The same, adding to the counters.
  [[nodiscard]] ShadowTruth shadow(const scene::ShadowQuery& query, HierarchyCounters& counters) const;
  [[nodiscard]] FirstHit first_hit(const scene::RayQuery& ray, HierarchyCounters& counters) const;

  /// The memory that it takes beside the scene.
  [[nodiscard]] std::size_t bytes() const;

 private:
  const scene::Scene& scene_;
  std::unique_ptr<const BuiltHierarchy> built_;
};

}  // namespace gnomon::exact
