// SPDX-License-Identifier: MIT
// One end of a batch of rays: points, and what is known of the face that they lie on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fast/strict_float.h"
#include "scene/face_run.h"

namespace gnomon::fast {

/// The plane of an own triangle: a corner, and the normal from double precision; of a plane that is
/// perpendicular to an axis the unit vector along it, which is exact but for its length.
struct OwnPlane {
  std::array<float, 3> corner{}, normal{};
  float error = 0;  ///< N of fast/hierarchy_triangles_inl.h; 0 for a plane perpendicular to an axis
  std::array<std::uint32_t, 3> corners{};  ///< the triangle's, as the scene numbers its points
  bool none_behind = false;  ///< known: every point lies on the plane or in front of it, exactly
};

/// Points as arrays of coordinates, in an order in which neighbours are close to each other. Made by
/// PairCaster::prepare; for one caster only.
class PairPatch {
 public:
  /// Points that follow the last one, equal to it, so that whole vectors may be read from any point on.
  static constexpr std::size_t kPadding = 16;
  /// So many points at a time are kept together.
  static constexpr std::size_t kCluster = 4;

  /// Takes the points. Allocates nothing when there is room from before.
  void assign(std::span<const std::array<float, 3>> points, scene::FaceRun own_run);

  [[nodiscard]] std::size_t size() const { return count_; }
  /// The coordinates on one axis, and kPadding times the last one's.
  [[nodiscard]] const float* coordinates(std::size_t axis) const {
    return coordinates_.data() + axis * (count_ + kPadding);
  }
  [[nodiscard]] std::array<float, 3> point(std::size_t i) const {
    return {coordinates(0)[i], coordinates(1)[i], coordinates(2)[i]};
  }
  /// The place among the points as they were given.
  [[nodiscard]] std::size_t given(std::size_t i) const { return sorted_ ? order_[i] : i; }
  /// True when the points are not in the order in which they were given.
  [[nodiscard]] bool is_sorted() const { return sorted_; }

  std::array<float, 6> box{};  ///< minima, then maxima; of no meaning without points
  bool in_domain = true;       ///< all coordinates are at most kMostMagnitude
  scene::FaceRun own;
  scene::FaceRun convex;  ///< all triangles of the own triangle's object when that is convex, else none
  OwnPlane plane;

 private:
  void sort(std::span<const std::array<float, 3>> points);

  std::vector<float> coordinates_;
  std::vector<std::uint32_t> order_;  ///< and room for a copy
  std::vector<float> keys_;
  std::size_t count_ = 0;
  bool sorted_ = false;
};

}  // namespace gnomon::fast
