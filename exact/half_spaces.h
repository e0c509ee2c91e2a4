// SPDX-License-Identifier: GPL-3.0-or-later
// The shaft as the intersection of half-spaces: its extent box's sides and its planes. Internal to exact/.
#pragma once

#include <array>
#include <span>

#include "exact/shaft.h"
#include "exact/vector.h"

namespace gnomon::exact {

/// n.x + d <= 0; n is not 0.
template <class FT>
struct HalfSpace {
  Vector<FT> n;
  FT d;
};

template <class FT>
[[nodiscard]] FT magnitude_of(const FT& x) {
  return FT(CGAL::abs(x));
}

/// |n_x| + |n_y| + |n_z|: what the largest n.x over a set grows by when the set grows by 1 on all sides.
template <class FT>
[[nodiscard]] FT growth_of(const Vector<FT>& n) {
  return FT(magnitude_of(n[0]) + magnitude_of(n[1]) + magnitude_of(n[2]));
}

/// The six sides, then the planes.
template <class FT>
class HalfSpaces {
 public:
  HalfSpaces(const scene::Box<double>& a, const scene::Box<double>& b) {
    const Shaft<CGAL::Simple_cartesian<FT>> shaft(a, b);
    for (int axis = 0; axis < 3; ++axis) {
      for (const int sign : {-1, 1}) {
        HalfSpace<FT>& side = all_[count_++];
        for (int i = 0; i < 3; ++i) side.n[static_cast<std::size_t>(i)] = FT(i == axis ? sign : 0);
        side.d = sign < 0 ? FT(shaft.extent().lo(axis)) : FT(-FT(shaft.extent().hi(axis)));
      }
    }
    for (const auto& plane : shaft.planes()) {
      HalfSpace<FT>& half_space = all_[count_++];
      half_space.n = {FT(0), FT(0), FT(0)};
      half_space.n[plane.far0 % 3] = plane.n0;
      half_space.n[plane.far1 % 3] = plane.n1;
      half_space.d = plane.d;
    }
  }

  [[nodiscard]] std::span<const HalfSpace<FT>> all() const { return {all_.data(), count_}; }

 private:
  std::array<HalfSpace<FT>, 14> all_;
  std::size_t count_ = 0;
};

}  // namespace gnomon::exact
