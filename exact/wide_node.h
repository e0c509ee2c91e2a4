// SPDX-License-Identifier: GPL-3.0-or-later
// What exact/hierarchy.h is built of. Internal to exact/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace gnomon::exact {

using Float8 = float __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

inline constexpr std::size_t kNodeLanes = 8, kLeafLanes = 4;

// How g++ aligns these depends on the instructions that it may use. What holds them has an alignment of its
// own, so that units that differ in that agree.

/// Up to eight children and their boxes, in the frame, rounded outwards: four cache lines.
struct alignas(64) WideNode {
  /// The boxes' sides, as [2 * axis + (0: least, 1: greatest)], a child a lane. Unused lanes: see `used`.
  std::array<Float8, 6> sides{};
  /// The child node, or the leaf.
  std::array<std::uint32_t, kNodeLanes> child{};
  std::uint8_t used = 0;    ///< one bit a lane
  std::uint8_t leaves = 0;  ///< one bit a lane
};
static_assert(sizeof(WideNode) == 256);

/// Up to four faces of a leaf, a face a lane; in floats where these hold all of a scene's numbers, for the
/// sake of the caches: three lines then.
template <class F>
struct alignas(64) Leaf {
  using Lanes = std::conditional_t<sizeof(F) == sizeof(float), Float4, Double4>;

  /// The corners' coordinates of a triangle, or a ball's centre and radius; 0 in lanes without a face.
  std::array<Lanes, 9> c{};
  std::array<std::uint32_t, kLeafLanes> face{};
  std::uint8_t triangles = 0, balls = 0;  ///< one bit a lane

  [[nodiscard]] unsigned used() const { return static_cast<unsigned>(triangles | balls); }
};
static_assert(sizeof(Leaf<float>) == 192);

}  // namespace gnomon::exact
