// SPDX-License-Identifier: MIT
#include "fast/shaft.h"

#include <algorithm>
#include <cmath>

namespace gnomon::fast {

template <class F>
ExtremeLists extreme_lists(const scene::Box<F>& a, const scene::Box<F>& b) {
  ExtremeLists lists;
  for (Face face = 0; face < 6; ++face) {
    const F of_a = is_max(face) ? a.c[face] : -a.c[face];
    const F of_b = is_max(face) ? b.c[face] : -b.c[face];
    if (of_a > of_b) lists.of_a[lists.count_a++] = face;
    if (of_b > of_a) lists.of_b[lists.count_b++] = face;
  }
  return lists;
}

template <class F>
scene::Box<F> extent_of(const scene::Box<F>& a, const scene::Box<F>& b) {
  scene::Box<F> extent;
  for (int axis = 0; axis < 3; ++axis) {
    extent.lo(axis) = std::min(a.lo(axis), b.lo(axis));
    extent.hi(axis) = std::max(a.hi(axis), b.hi(axis));
  }
  return extent;
}

namespace {

/// The plane through the edges on the faces f (where a is extreme) and g (where b is). The differences have
/// one sign each because both are extreme, so the absolute values below only turn the normal outwards.
template <class F>
ShaftPlane<F> form_plane(const scene::Box<F>& a, const scene::Box<F>& b, Face f, Face g) {
  ShaftPlane<F> plane{};
  plane.far0 = f;
  plane.far1 = g;
  const F run0 = std::fabs(b.c[g] - a.c[g]);
  const F run1 = std::fabs(a.c[f] - b.c[f]);
  plane.n0 = is_max(f) ? run0 : -run0;
  plane.n1 = is_max(g) ? run1 : -run1;
  plane.d = -(plane.n0 * a.c[f] + plane.n1 * a.c[g]);
  return plane;
}

template <class F>
void normalise(ShaftPlane<F>& plane) {
  const F length = std::sqrt(plane.n0 * plane.n0 + plane.n1 * plane.n1);
  plane.n0 /= length;
  plane.n1 /= length;
  plane.d /= length;
}

}  // namespace

template <class F>
Shaft<F> form_shaft(const scene::Box<F>& a, const scene::Box<F>& b, Normals normals) {
  Shaft<F> shaft;
  shaft.a = a;
  shaft.b = b;
  shaft.extent = extent_of(a, b);
  const ExtremeLists lists = extreme_lists(a, b);
  for (int i = 0; i < lists.count_a; ++i) {
    for (int j = 0; j < lists.count_b; ++j) {
      const Face f = lists.of_a[static_cast<std::size_t>(i)];
      const Face g = lists.of_b[static_cast<std::size_t>(j)];
      if (axis_of(f) == axis_of(g)) continue;  // opposite sides of the extent box share no edge
      ShaftPlane<F> plane = form_plane(a, b, f, g);
      if (normals == Normals::unit) normalise(plane);
      shaft.plane_set[shaft.plane_count++] = plane;  // at most 8: proved, and enumerated in the tests
    }
  }
  return shaft;
}

template ExtremeLists extreme_lists(const scene::Box<float>&, const scene::Box<float>&);
template ExtremeLists extreme_lists(const scene::Box<double>&, const scene::Box<double>&);
template scene::Box<float> extent_of(const scene::Box<float>&, const scene::Box<float>&);
template scene::Box<double> extent_of(const scene::Box<double>&, const scene::Box<double>&);
template Shaft<float> form_shaft(const scene::Box<float>&, const scene::Box<float>&, Normals);
template Shaft<double> form_shaft(const scene::Box<double>&, const scene::Box<double>&, Normals);

}  // namespace gnomon::fast
