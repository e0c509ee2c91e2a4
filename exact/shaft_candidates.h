// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `shaft-candidates`: which faces meet the shaft between two boxes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "scene/box.h"
#include "scene/scene.h"

namespace gnomon::exact {

/// What queries have cost: nodes of the tree tested, faces tested, and faces that neither doubles nor
/// intervals could decide about.
struct CandidateCounters {
  std::uint64_t nodes = 0, faces = 0, exact_faces = 0;
};

/// The shaft between two boxes: the convex hull of both, closed. The boxes must be valid (any finite doubles,
/// flat and point boxes too).
class CandidateShaft {
 public:
  CandidateShaft(const scene::Box<double>& a, const scene::Box<double>& b);

  /// True when the closed face has a point in common with the shaft: exact for any finite doubles. Doubles
  /// first, then intervals, then exact floats.
  [[nodiscard]] bool meets(const scene::Scene& scene, std::uint32_t face) const;
  [[nodiscard]] bool meets(const scene::Scene& scene, std::uint32_t face, CandidateCounters& counters) const;

 private:
  scene::Box<double> a_, b_;
  bool in_range_;  ///< near enough to 1 for intervals
};

/// The same for one face.
[[nodiscard]] bool meets_shaft(const scene::Scene& scene, std::uint32_t face, const scene::Box<double>& a,
                               const scene::Box<double>& b);

/// All faces that meet the shaft, in ascending order, one by one.
[[nodiscard]] std::vector<std::uint32_t> shaft_candidates_by_all_faces(const scene::Scene& scene,
                                                                       const scene::Box<double>& a,
                                                                       const scene::Box<double>& b);

struct BuiltHierarchy;

/// The same in much less time, by a hierarchy of boxes that are rounded outwards.
///
/// Keeps a reference to the scene, which must be valid and must not change. Queries may run in any number of
/// threads at once; they allocate nothing but in `out`, unless exact floats have to decide.
class ShaftCandidates {
 public:
  explicit ShaftCandidates(const scene::Scene& scene);
  ~ShaftCandidates();
  ShaftCandidates(const ShaftCandidates&) = delete;
  ShaftCandidates& operator=(const ShaftCandidates&) = delete;

  /// `out` is overwritten; ascending.
  void faces(const scene::Box<double>& a, const scene::Box<double>& b, std::vector<std::uint32_t>& out) const;
  void faces(const scene::Box<double>& a, const scene::Box<double>& b, std::vector<std::uint32_t>& out,
             CandidateCounters& counters) const;

 private:
  const scene::Scene& scene_;
  std::unique_ptr<const BuiltHierarchy> built_;
};

}  // namespace gnomon::exact
