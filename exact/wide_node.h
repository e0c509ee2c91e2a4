// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of exact/hierarchy.h, and a path that is tested against their boxes. Internal to exact/.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "exact/frame.h"
#include "exact/path.h"

namespace gnomon::exact {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

/// Up to four children and their boxes, in the frame, rounded outwards: two cache lines.
struct alignas(64) WideNode {
  /// The boxes' sides, as [2 * axis + (0: least, 1: greatest)], a child a lane. Unused lanes: see `used`.
  std::array<Float4, 6> sides{};
  /// The child node, or a leaf's first face.
  std::array<std::uint32_t, 4> first{};
  /// How many faces a leaf has; 0 for a node.
  std::array<std::uint8_t, 4> count{};
  std::uint8_t used = 0;  ///< one bit a lane
};
static_assert(sizeof(WideNode) == 128);

/// A face as leaves hold it, in the order in which they ask for it; in floats where these hold all of a
/// scene's numbers, for the sake of the caches.
template <class F>
struct LeafFace {
  /// The corners of a triangle, or a ball's centre and radius.
  std::array<F, 9> c{};
  std::uint32_t face = 0;
};

/// A path in the frame, for boxes that may hold a point of the closed path with t <= latest.
///
/// On each axis it has two origins and two inverse directions, rounded so that the t of the near side comes
/// out too small and that of the far side too large: by monotony nothing else than the three roundings of
/// each t is left to bound. Where a true near t is at most the true far t, both not negative, the computed
/// ones are at most (1 + u)^2 too large and (1 - u)^2 too small, u = 2^-24, and 2^-150 more where a product
/// underflows; kWiden and kTiny more than make up for it, and for the two roundings that they bring. A
/// negative near t counts as 0; a negative far t is negative as computed, since a difference of floats has
/// the sign of the exact one. An axis that tells nothing (0 times infinity) comes out as NaN, which no
/// comparison below lets through.
class BoxPath {
 public:
  BoxPath(const Frame& frame, const Path& path) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double unscaled = path.kind == Path::Kind::segment ? path.to[i] - path.from[i] : path.to[i];
      const double d = unscaled * frame.scale;
      const double start = frame.map(path.from[i], i);
      const bool backwards = unscaled < 0;  // of the exact difference, too
      near_side_[i] = static_cast<std::uint8_t>(2 * i + (backwards ? 1 : 0));
      const float below = float_below(start), above = float_above(start);
      near_origin_[i] = all(backwards ? below : above);
      far_origin_[i] = all(backwards ? above : below);
      if (unscaled == 0) {
        near_inverse_[i] = far_inverse_[i] = all(kInfinity);
      } else if (!(std::fabs(d) <= 1e300 && std::fabs(d) >= 1e-290)) {
        // Over- or underflow may have hit d or will hit 1 / d: only the side that the path leaves by counts.
        near_inverse_[i] = all(0);
        far_inverse_[i] = all(backwards ? -kInfinity : kInfinity);
      } else {
        const double inverse = 1 / std::fabs(d);
        const float least = std::max(0.0f, float_below(inverse)), greatest = float_above(inverse * kWiden);
        near_inverse_[i] = all(backwards ? -least : least);
        far_inverse_[i] = all(backwards ? -greatest : greatest);
      }
    }
  }

  struct Boxes {
    unsigned mask;  ///< one bit a lane
    Float4 near;    ///< lower bounds on t, for lanes in the mask
  };

  /// The children whose boxes can't be left out.
  [[nodiscard]] Boxes test(const WideNode& node, float latest) const {
    Float4 near = all(0), far = all(latest * kWiden);
    for (std::size_t i = 0; i < 3; ++i) {
      const Float4 in = (node.sides[near_side_[i]] - near_origin_[i]) * near_inverse_[i];
      const Float4 out = (node.sides[near_side_[i] ^ 1u] - far_origin_[i]) * far_inverse_[i];
      near = in > near ? in : near;
      far = out < far ? out : far;
    }
    const Int4 open = near <= far + kTiny;
    return {mask_of(open) & node.used, near};
  }

  /// True when something at this lower bound may still be no later than `latest`.
  [[nodiscard]] static bool in_time(float near, float latest) { return near <= latest * kWiden + kTiny; }

 private:
  static constexpr float kWiden = 1 + 0x1p-20f, kTiny = 1e-37f;

  [[nodiscard]] static Float4 all(float x) { return Float4{x, x, x, x}; }

  [[nodiscard]] static unsigned mask_of(Int4 lanes) {
#if defined(__SSE2__)
    return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<Float4>(lanes)));
#else
    return (lanes[0] & 1u) | (lanes[1] & 2u) | (lanes[2] & 4u) | (lanes[3] & 8u);
#endif
  }

  std::array<Float4, 3> near_origin_{}, far_origin_{}, near_inverse_{}, far_inverse_{};
  std::array<std::uint8_t, 3> near_side_{};
};

}  // namespace gnomon::exact
