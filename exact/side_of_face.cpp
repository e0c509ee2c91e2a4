// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/side_of_face.h"

#include "exact/vector.h"

namespace gnomon::exact {

namespace {

using Corners = std::array<std::array<double, 3>, 3>;

template <class FT>
Vector<FT> normal_of(const Corners& v) {
  return cross(between<FT>(v[0], v[1]), between<FT>(v[0], v[2]));
}

template <class FT>
Sign side(const Corners& v, const std::array<double, 3>& p) {
  return sign_of(dot(normal_of<FT>(v), between<FT>(v[0], p)));
}

}  // namespace

int side_of_face(const Corners& corners, const std::array<double, 3>& p) {
  if (p == corners[0] || p == corners[1] || p == corners[2]) return 0;
  {
    const CGAL::Interval_nt<false>::Protector upward;
    const Sign sign = side<FilterKernel::FT>(corners, p);
    if (sign != Sign::unknown) return static_cast<int>(sign);
  }
  return static_cast<int>(side<ExactFloat>(corners, p));
}

int side_of_face(const scene::Scene& scene, std::uint32_t triangle, const std::array<double, 3>& p) {
  return side_of_face({scene.corner(triangle, 0), scene.corner(triangle, 1), scene.corner(triangle, 2)}, p);
}

bool is_degenerate(const Corners& corners) {
  {
    const CGAL::Interval_nt<false>::Protector upward;
    for (const auto& x : normal_of<FilterKernel::FT>(corners)) {
      const Sign sign = sign_of(x);
      if (sign == Sign::negative || sign == Sign::positive) return false;
    }
  }
  return is_zero(normal_of<ExactFloat>(corners));
}

}  // namespace gnomon::exact
