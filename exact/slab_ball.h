// SPDX-License-Identifier: GPL-3.0-or-later
// The least squared distance from a point to the boxes (1-s)a + sb, for any number type. Internal to exact/.
#pragma once

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstddef>

#include "exact/number.h"
#include "scene/box.h"

namespace gnomon::exact {

/// The squared distance from a point to the box (1-s)a + sb, as a function of s: convex, and quadratic
/// between kinks.
template <class FT>
class DistanceOverS {
 public:
  DistanceOverS(const scene::Box<double>& a, const scene::Box<double>& b,
                const std::array<double, 3>& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int i = static_cast<int>(axis);
      p_[axis] = FT(a.lo(i)) - FT(point[axis]);
      q_[axis] = FT(b.lo(i)) - FT(a.lo(i));
      p_[axis + 3] = FT(point[axis]) - FT(a.hi(i));
      q_[axis + 3] = FT(a.hi(i)) - FT(b.hi(i));
    }
  }

  [[nodiscard]] FT at(const FT& s) const {
    FT sum(0);
    for (std::size_t i = 0; i < 6; ++i) {
      const FT beyond = (CGAL::max)(FT(p_[i] + q_[i] * s), FT(0));
      sum += beyond * beyond;
    }
    return sum;
  }

  /// A minimiser in [0, 1]. Exact for rationals; for doubles about where it is.
  [[nodiscard]] FT minimiser() const {
    boost::container::small_vector<FT, 8> kinks{FT(0), FT(1)};
    for (std::size_t i = 0; i < 6; ++i) {
      if (q_[i] == FT(0)) continue;
      const FT s = -p_[i] / q_[i];
      if (s > FT(0) && s < FT(1)) kinks.push_back(s);
    }
    std::sort(kinks.begin(), kinks.end());
    // The slope rises with s: the first piece that does not fall any more at its right end holds the minimum.
    for (std::size_t piece = 0; piece + 1 < kinks.size(); ++piece) {
      const FT& left = kinks[piece];
      const FT& right = kinks[piece + 1];
      const FT middle = (left + right) / FT(2);
      FT pq(0), qq(0);
      for (std::size_t i = 0; i < 6; ++i) {
        if (p_[i] + q_[i] * middle > FT(0)) {
          pq += p_[i] * q_[i];
          qq += q_[i] * q_[i];
        }
      }
      if (pq + qq * right < FT(0)) continue;
      if (qq == FT(0)) return left;
      return (CGAL::max)(left, FT(-pq / qq));
    }
    return FT(1);
  }

 private:
  std::array<FT, 6> p_, q_;  ///< sides lie beyond the point by p + q s: lower sides first, then upper ones
};

/// The squared distance from a point to a box.
template <class FT>
[[nodiscard]] FT squared_distance(const std::array<double, 3>& p, const scene::Box<double>& box) {
  FT sum(0);
  for (int axis = 0; axis < 3; ++axis) {
    const double x = p[static_cast<std::size_t>(axis)];
    if (x < box.lo(axis)) {
      sum += CGAL::square(FT(box.lo(axis)) - FT(x));
    } else if (x > box.hi(axis)) {
      sum += CGAL::square(FT(x) - FT(box.hi(axis)));
    }
  }
  return sum;
}

}  // namespace gnomon::exact
