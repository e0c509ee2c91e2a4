// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors in the arithmetic of a CGAL kernel. Internal to exact/: includes CGAL.
#pragma once

#include <array>
#include <cstddef>

#include "exact/number.h"
#include "exact/path.h"

namespace gnomon::exact {

template <class FT>
using Vector = std::array<FT, 3>;

template <class FT>
[[nodiscard]] Vector<FT> between(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  return {FT(FT(to[0]) - FT(from[0])), FT(FT(to[1]) - FT(from[1])), FT(FT(to[2]) - FT(from[2]))};
}

template <class FT>
[[nodiscard]] Vector<FT> cross(const Vector<FT>& a, const Vector<FT>& b) {
  return {FT(a[1] * b[2] - a[2] * b[1]), FT(a[2] * b[0] - a[0] * b[2]), FT(a[0] * b[1] - a[1] * b[0])};
}

template <class FT>
[[nodiscard]] FT dot(const Vector<FT>& a, const Vector<FT>& b) {
  return FT(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/// a * a, whose intervals never reach below 0.
template <class FT>
[[nodiscard]] FT square(const Vector<FT>& a) {
  return FT(CGAL::square(a[0]) + CGAL::square(a[1]) + CGAL::square(a[2]));
}

/// True for the zero vector of a kernel that has no unknown signs.
template <class FT>
[[nodiscard]] bool is_zero(const Vector<FT>& a) {
  for (const FT& x : a) {
    if (sign_of(x) != Sign::zero) return false;
  }
  return true;
}

/// The vector by which t is multiplied along the path.
template <class FT>
[[nodiscard]] Vector<FT> direction_of(const Path& path) {
  if (path.kind == Path::Kind::ray) return {FT(path.to[0]), FT(path.to[1]), FT(path.to[2])};
  return between<FT>(path.from, path.to);
}

}  // namespace gnomon::exact
