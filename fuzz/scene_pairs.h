// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of boxes and of patches of one scene.
#pragma once

#include <span>
#include <vector>

#include "fuzz/pair_method.h"
#include "fuzz/random.h"
#include "scene/face_run.h"

namespace gnomon::fuzz {

/// Picks boxes of a scene's objects, polygons, faces, points on faces, nodes of a hierarchy and empty space,
/// and patches that are its faces, parts of these and parts of its polygon lights; in pairs that are far,
/// near, adjacent, nested, coplanar. The scene must outlive it and have floats alone, two faces at least, and
/// two triangles for patches.
class ScenePairs {
 public:
  explicit ScenePairs(const scene::Scene& scene);

  [[nodiscard]] BoxPair boxes(CaseRandom& random) const;
  [[nodiscard]] scene::PatchPair patches(CaseRandom& random) const;

 private:
  using Box = scene::Box<float>;
  using Point = std::array<double, 3>;

  [[nodiscard]] Box box_of_face(std::uint32_t face) const;
  [[nodiscard]] std::uint32_t relative(CaseRandom& random, std::uint32_t face, bool triangles) const;
  [[nodiscard]] Point point_on(CaseRandom& random, std::uint32_t face) const;
  [[nodiscard]] Box box_in_the_air(CaseRandom& random, const Point& centre) const;
  [[nodiscard]] Box pick_box(CaseRandom& random, std::uint32_t face) const;
  [[nodiscard]] scene::Patch pick_patch(CaseRandom& random, std::uint32_t face) const;
  [[nodiscard]] scene::Patch pick_light(CaseRandom& random) const;

  const scene::Scene& scene_;
  std::vector<scene::FaceRun> polygons_;
  std::vector<std::uint32_t> polygon_of_;  ///< by face
  std::vector<std::uint32_t> object_of_;   ///< by face
  Box bounds_;
  std::vector<Box> polygon_boxes_, object_boxes_;
  /// The faces along a space-filling curve, and where each stands: neighbours there are near each other.
  std::vector<std::uint32_t> order_, place_;
  /// levels_[k][j] bounds the faces j 2^k .. (j+1) 2^k - 1 of the order: a hierarchy without pointers.
  std::vector<std::vector<Box>> levels_;
  std::vector<std::uint32_t> first_at_point_, at_points_;  ///< the triangles at each point, run after run
};

}  // namespace gnomon::fuzz
