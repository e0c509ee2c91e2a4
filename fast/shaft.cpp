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

/// All pairs of an element of one list with an element of the other on another axis, as far0 and far1 of
/// planes: which they are depends only on which box is extreme on which face, 3^6 outcomes. Looking them up
/// spares the formation the branches that no processor predicts.
struct PlanePairs {
  std::uint8_t count = 0;
  std::array<Face, 8> of_a{}, of_b{};
};

constexpr std::array<std::size_t, 6> kPowersOfThree{1, 3, 9, 27, 81, 243};

/// Digit f of the index, to base three: 0 tie, 1 a is extreme on face f, 2 b is.
constexpr std::array<PlanePairs, 729> kPlanePairs = [] {
  std::array<PlanePairs, 729> table{};
  for (std::size_t index = 0; index < table.size(); ++index) {
    PlanePairs& pairs = table[index];
    for (Face f = 0; f < 6; ++f) {
      if (index / kPowersOfThree[f] % 3 != 1) continue;
      for (Face g = 0; g < 6; ++g) {
        // Opposite sides of the extent box share no edge. At most 8 pairs are left: indexing past them would
        // not compile.
        if (index / kPowersOfThree[g] % 3 != 2 || axis_of(f) == axis_of(g)) continue;
        pairs.of_a[pairs.count] = f;
        pairs.of_b[pairs.count++] = g;
      }
    }
  }
  return table;
}();

template <class F>
const PlanePairs& plane_pairs(const scene::Box<F>& a, const scene::Box<F>& b) {
  std::size_t index = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t low = kPowersOfThree[axis], high = kPowersOfThree[axis + 3];
    index += (a.c[axis] < b.c[axis]) * low + (b.c[axis] < a.c[axis]) * 2 * low;
    index += (a.c[axis + 3] > b.c[axis + 3]) * high + (b.c[axis + 3] > a.c[axis + 3]) * 2 * high;
  }
  return kPlanePairs[index];
}

template <class F>
constexpr std::array<F, 6> kOutward{-1, -1, -1, 1, 1, 1};

/// The plane through the edges on the faces f (where a is extreme) and g (where b is). The differences have
/// one sign each because both are extreme, so the absolute values below only turn the normal outwards.
/// Written in place: a plane that is returned is copied in wider pieces than it was written in, which stalls.
template <class F>
void form_plane(ShaftPlane<F>& plane, const scene::Box<F>& a, const scene::Box<F>& b, Face f, Face g) {
  const F n0 = kOutward<F>[f] * std::fabs(b.c[g] - a.c[g]);
  const F n1 = kOutward<F>[g] * std::fabs(a.c[f] - b.c[f]);
  plane.n0 = n0;
  plane.n1 = n1;
  plane.d = -(n0 * a.c[f] + n1 * a.c[g]);
  plane.outside_threshold = 0;
  plane.inside_threshold = 0;
  plane.far0 = f;
  plane.far1 = g;
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
  const PlanePairs& pairs = plane_pairs(a, b);
  shaft.plane_count = pairs.count;
  for (std::size_t i = 0; i < pairs.count; ++i) {
    form_plane(shaft.plane_set[i], a, b, pairs.of_a[i], pairs.of_b[i]);
    if (normals == Normals::unit) normalise(shaft.plane_set[i]);
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
