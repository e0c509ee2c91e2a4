// SPDX-License-Identifier: MIT
// How a Hierarchy lies in memory: eight boxes a node, up to eight faces a leaf, each number an array over the
// eight, so that one node or leaf is a few vector operations. Internal to fast/hierarchy*.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/strict_float.h"

namespace gnomon::fast {

inline constexpr std::size_t kWidth = 8;

/// Eight numbers, one a child or face.
using Eight = std::array<float, kWidth>;

/// A child: a node's index, or a leaf's kind, count and block. Less than 2^27 blocks.
class ChildLink {
 public:
  ChildLink() = default;
  explicit constexpr ChildLink(std::uint32_t bits) : bits_(bits) {}
  [[nodiscard]] static constexpr ChildLink node(std::size_t index) {
    return ChildLink(static_cast<std::uint32_t>(index));
  }
  [[nodiscard]] static constexpr ChildLink leaf(bool balls, std::size_t count, std::size_t block) {
    return ChildLink(kLeaf | (balls ? kBalls : 0u) | static_cast<std::uint32_t>((count - 1) << kBlockBits) |
                     static_cast<std::uint32_t>(block));
  }

  [[nodiscard]] constexpr bool is_leaf() const { return (bits_ & kLeaf) != 0; }
  [[nodiscard]] constexpr bool has_balls() const { return (bits_ & kBalls) != 0; }
  [[nodiscard]] constexpr std::uint32_t count() const { return ((bits_ >> kBlockBits) & 7u) + 1; }
  /// A bit for each face of the leaf.
  [[nodiscard]] constexpr std::uint32_t lanes() const { return 0xffu >> (kWidth - count()); }
  [[nodiscard]] constexpr std::uint32_t block() const { return bits_ & (kMostBlocks - 1); }
  [[nodiscard]] constexpr std::uint32_t index() const { return bits_; }
  [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }

  static constexpr int kBlockBits = 27;
  static constexpr std::uint32_t kMostBlocks = 1u << kBlockBits;

 private:
  static constexpr std::uint32_t kLeaf = 1u << 31, kBalls = 1u << 30;
  std::uint32_t bits_ = 0;
};

/// Eight closed boxes, minima in bounds[0..2] and maxima in bounds[3..5]. A missing child has the box from
/// +infinity to -infinity, which no beam meets unless its direction is infinite or NaN on every axis (naive
/// beams alone); its link is a leaf's, so that their walks end, too.
struct alignas(64) WideNode {
  std::array<Eight, 6> bounds;
  std::array<ChildLink, kWidth> children;
};

/// Up to eight triangles; lanes beyond the leaf's count repeat its first one. `to_v1` is v0 - v1, `to_v2` is
/// v2 - v0, rounded; the normal n = (v1 - v0) x (v2 - v0) from double precision, rounded.
struct alignas(32) TriangleBlock {
  std::array<Eight, 3> v0, to_v1, to_v2, normal;
  Eight edge_error, normal_error;  ///< E and N of fast/hierarchy_triangles_inl.h
  std::array<std::uint32_t, kWidth> face;
};

/// Up to eight balls, as triangles.
struct alignas(32) BallBlock {
  std::array<Eight, 3> centre;
  Eight radius;
  std::array<std::uint32_t, kWidth> face;
};

/// Where a face lies: its block and lane, and whether it is a triangle of an object with one side.
struct FacePlace {
  std::uint32_t lane : 3;
  std::uint32_t block : ChildLink::kBlockBits;
  std::uint32_t one_sided : 1;
};
static_assert(sizeof(FacePlace) == 4);

/// No path from the root has more nodes, leaves included. See fast/hierarchy_build.cpp.
inline constexpr std::size_t kMostDepth = 80;

/// Every node on a path leaves at most seven children waiting; a store of eight may go beyond the last.
inline constexpr std::size_t kStackSize = 7 * kMostDepth + 2 * kWidth;

}  // namespace gnomon::fast
