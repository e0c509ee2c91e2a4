// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle against the segments between two triangles, as inequalities in s. Internal to exact/: includes
// CGAL.
#pragma once

#include <array>
#include <cstdint>

#include "exact/range_of_s.h"
#include "exact/vector.h"

namespace gnomon::exact {

/// Three points, which may lie on a line or be equal.
template <class FT>
using Three = std::array<Vector<FT>, 3>;

template <class FT>
[[nodiscard]] Three<FT> three(const std::array<std::array<double, 3>, 3>& v) {
  Three<FT> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = {FT(v[k][0]), FT(v[k][1]), FT(v[k][2])};
  return result;
}

template <class FT>
[[nodiscard]] Vector<FT> difference(const Vector<FT>& to, const Vector<FT>& from) {
  return {FT(to[0] - from[0]), FT(to[1] - from[1]), FT(to[2] - from[2])};
}

/// Which corners are known to be equal: bit 3 * i + k for corner i of one and corner k of the other triangle.
/// What intervals can't see on their own; exact numbers do without.
struct SharedCorners {
  std::uint16_t a_and_face = 0, b_and_face = 0;
};

/// The closed sets D(s) = (1-s)a + sb - f, 0 < s < 1: f meets a segment between a and b at s exactly when
/// D(s) holds 0, which is so when no direction has all of D(s) on one side. As long as D(s) has inner points,
/// the normals of its faces are those of a, b and f, and products of edges of two of them; whatever its
/// dimension, the same together with the axes and their products with edges will do, as D(s) grown by a
/// little box has no other normals, and the sets are compact. None of these depends on s, and the ends of
/// D(s) along each are linear in s.
template <class FT>
class SegmentsOverS {
 public:
  SegmentsOverS(const Three<FT>& a, const Three<FT>& b, const Three<FT>& f, SharedCorners shared = {})
      : corners_{a, b, f}, shared_(shared) {
    for (std::size_t which = 0; which < 3; ++which) {
      const Three<FT>& v = corners_[which];
      for (std::size_t k = 0; k < 3; ++k) {
        seen_[which][k] = difference(v[k], f[0]);
        edges_[which][k] = difference(v[(k + 1) % 3], v[k]);
      }
      normals_[which] = cross(edges_[which][0], edges_[which][1]);
    }
  }

  /// Calls `add` with inequalities in s that hold together exactly for those s of (0, 1) for which f meets a
  /// segment at s; stops when it returns false, and returns what it returned last.
  template <class Add>
  bool for_each(Add&& add) const {
    bool has_inner_points = false;
    for (std::size_t which = 0; which < 3; ++which) {
      if (!along_normal(which, has_inner_points, add)) return false;
    }
    for (std::size_t which = 0; which < 3; ++which) {
      const std::size_t other = (which + 1) % 3;
      for (const Vector<FT>& x : edges_[which]) {
        for (const Vector<FT>& y : edges_[other]) {
          if (!along(cross(x, y), add)) return false;
        }
      }
    }
    return has_inner_points || along_axes(add);
  }

 private:
  /// The least and greatest of three numbers.
  struct Reach {
    FT lo, hi;
    explicit Reach(const std::array<FT, 3>& x)
        : lo((CGAL::min)((CGAL::min)(x[0], x[1]), x[2])), hi((CGAL::max)((CGAL::max)(x[0], x[1]), x[2])) {}
  };

  template <class Add>
  bool add_both(const std::array<std::array<FT, 3>, 3>& x, Add&& add) const {
    if ((shared_.a_and_face | shared_.b_and_face) != 0) {
      const auto [a_up, a_down] = gaps(x[0], x[2], shared_.a_and_face);
      const auto [b_up, b_down] = gaps(x[1], x[2], shared_.b_and_face);
      return add(LinearInS<FT>{a_up, b_up}) && add(LinearInS<FT>{a_down, b_down});
    }
    const Reach a(x[0]), b(x[1]), f(x[2]);
    return add(LinearInS<FT>{FT(a.hi - f.lo), FT(b.hi - f.lo)}) &&
           add(LinearInS<FT>{FT(f.hi - a.lo), FT(f.hi - b.lo)});
  }

  /// The greatest of all x - f and of all f - x, where the difference of equal corners is 0.
  static std::array<FT, 2> gaps(const std::array<FT, 3>& x, const std::array<FT, 3>& f,
                                std::uint16_t shared) {
    std::array<FT, 2> greatest;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const FT gap = (shared >> (3 * i + k) & 1) != 0 ? FT(0) : FT(x[i] - f[k]);
        greatest[0] = i + k == 0 ? gap : (CGAL::max)(greatest[0], gap);
        greatest[1] = i + k == 0 ? FT(-gap) : (CGAL::max)(greatest[1], FT(-gap));
      }
    }
    return greatest;
  }

  template <class Add>
  bool along(const Vector<FT>& n, Add&& add) const {
    std::array<std::array<FT, 3>, 3> x;
    for (std::size_t which = 0; which < 3; ++which) {
      for (std::size_t k = 0; k < 3; ++k) x[which][k] = dot(n, seen_[which][k]);
    }
    return add_both(x, add);
  }

  /// Along its own normal a triangle has one value, 0 as seen from a corner of its own.
  template <class Add>
  bool along_normal(std::size_t own, bool& has_inner_points, Add&& add) const {
    const Vector<FT>& n = normals_[own];
    std::array<std::array<FT, 3>, 3> x;
    for (std::size_t which = 0; which < 3; ++which) {
      for (std::size_t k = 0; k < 3; ++k) {
        x[which][k] = which == own || is_shared(own, which, k)
                          ? FT(0)
                          : dot(n, difference(corners_[which][k], corners_[own][0]));
      }
      if (which == own || has_inner_points) continue;
      for (std::size_t k = 0; k < 2; ++k) {
        const Sign sign = sign_of(FT(x[which][k + 1] - x[which][k]));
        has_inner_points = has_inner_points || sign == Sign::negative || sign == Sign::positive;
      }
    }
    return add_both(x, add);
  }

  /// True when corner k of a triangle is known to be one of another, of which one is f.
  [[nodiscard]] bool is_shared(std::size_t own, std::size_t which, std::size_t k) const {
    if (own != 2 && which != 2) return false;
    const unsigned pairs = own == 0 || which == 0 ? shared_.a_and_face : shared_.b_and_face;
    return which == 2 ? (pairs >> k & 0b001'001'001u) != 0 : (pairs >> (3 * k) & 0b111u) != 0;
  }

  template <class Add>
  bool along_axes(Add&& add) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vector<FT> unit{FT(0), FT(0), FT(0)};
      unit[axis] = FT(1);
      if (!along(unit, add)) return false;
      for (const Three<FT>& edges : edges_) {
        for (const Vector<FT>& edge : edges) {
          if (!along(cross(unit, edge), add)) return false;
        }
      }
    }
    return true;
  }

  std::array<Three<FT>, 3> corners_;
  SharedCorners shared_;
  std::array<Three<FT>, 3> seen_, edges_;
  std::array<Vector<FT>, 3> normals_;
};

}  // namespace gnomon::exact
