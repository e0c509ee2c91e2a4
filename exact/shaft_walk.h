// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a hierarchy whose boxes may meet a shaft. Internal to exact/.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "exact/hierarchy_build.h"
#include "scene/box.h"

namespace gnomon::exact {

/// A shaft, in the frame of a hierarchy and rounded outwards, against the boxes of its nodes.
///
/// Bounds. A box meets the shaft exactly when some s of [0, 1] satisfies six inequalities (1-s) f + s g >= 0,
/// two an axis. f and g are differences of floats, rounded once, so that their signs are right; where these
/// differ, the s of equality is the quotient f / (f - g), of five roundings of 2^-24 without cancellation,
/// less where it underflows. kWiden and kTiny are more than what both bounds on s may be off by.
class ShaftWalk {
 public:
  ShaftWalk(const BuiltHierarchy& built, const scene::Box<double>& a, const scene::Box<double>& b)
      : built_(built) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int axis = static_cast<int>(i);
      a_[i] = float_below(built.frame.map(a.lo(axis), i));
      a_[i + 3] = float_above(built.frame.map(a.hi(axis), i));
      b_[i] = float_below(built.frame.map(b.lo(axis), i));
      b_[i + 3] = float_above(built.frame.map(b.hi(axis), i));
    }
    for (std::size_t i = 0; i < 6; ++i) {
      in_range_ = in_range_ && std::fabs(a_[i]) <= kLargest && std::fabs(b_[i]) <= kLargest;
    }
  }

  /// Calls `visit` with every face of the leaves whose boxes may meet the shaft, in no order, until it
  /// returns true. Adds the number of nodes tested to `nodes`.
  template <class Visit>
  void run(Visit&& visit, std::uint64_t& nodes) const {
    if (built_.nodes.empty()) return;
    std::array<std::uint32_t, kMostLevels * kNodeLanes> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
      const WideNode& node = built_.nodes[stack[--size]];
      ++nodes;
      for (unsigned mask = met(node); mask != 0; mask &= mask - 1) {
        const auto lane = static_cast<std::size_t>(__builtin_ctz(mask));
        if ((node.leaves >> lane & 1) == 0) {
          stack[size++] = node.child[lane];
        } else if (built_.float_leaves.empty() ? leaf(built_.double_leaves[node.child[lane]], visit)
                                               : leaf(built_.float_leaves[node.child[lane]], visit)) {
          return;
        }
      }
    }
  }

 private:
  static constexpr float kWiden = 1 + 0x1p-20f, kTiny = 1e-37f, kLargest = 1e30f;

  template <class F, class Visit>
  static bool leaf(const Leaf<F>& leaf, Visit&& visit) {
    for (unsigned mask = leaf.used(); mask != 0; mask &= mask - 1) {
      if (visit(leaf.face[static_cast<std::size_t>(__builtin_ctz(mask))])) return true;
    }
    return false;
  }

  /// The children whose boxes can't be left out, a bit each.
  [[nodiscard]] unsigned met(const WideNode& node) const {
    if (!in_range_) return node.used;
    alignas(32) std::array<float, kNodeLanes> lo{}, hi;
    alignas(32) std::array<int, kNodeLanes> apart{};
    hi.fill(1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto &least = node.sides[2 * axis], &greatest = node.sides[2 * axis + 1];
      for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t lane = 0; lane < kNodeLanes; ++lane) {
          const float f = side == 0 ? greatest[lane] - a_[axis] : a_[axis + 3] - least[lane];
          const float g = side == 0 ? greatest[lane] - b_[axis] : b_[axis + 3] - least[lane];
          const float s = f / (f - g);
          apart[lane] |= static_cast<int>(f < 0) & static_cast<int>(g < 0);
          const float from = f < 0 ? s : 0, to = g < 0 ? s : 1;
          lo[lane] = from > lo[lane] ? from : lo[lane];
          hi[lane] = to < hi[lane] ? to : hi[lane];
        }
      }
    }
    unsigned met = 0;
    for (std::size_t lane = 0; lane < kNodeLanes; ++lane) {
      if (apart[lane] == 0 && lo[lane] <= hi[lane] * kWiden + kTiny) met |= 1u << lane;
    }
    return met & node.used;
  }

  const BuiltHierarchy& built_;
  std::array<float, 6> a_{}, b_{};  ///< least coordinates, then greatest ones
  bool in_range_ = true;
};

}  // namespace gnomon::exact
