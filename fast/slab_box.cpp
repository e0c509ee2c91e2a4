// SPDX-License-Identifier: MIT
#include "fast/slab_box.h"

namespace gnomon::fast {

using scene::Box;
using scene::Category;

namespace {

/// The s for which the coordinate x lies between the two sides of (1-s)a + sb on the axis.
template <class F>
SInterval<F> interval_of(const Box<F>& a, const Box<F>& b, int axis, F x) {
  SInterval<F> interval;
  interval.cut(a.hi(axis) - x, b.hi(axis) - a.hi(axis));
  interval.cut(x - a.lo(axis), a.lo(axis) - b.lo(axis));
  return interval;
}

template <class F>
bool every_corner_has_its_s(const Box<F>& a, const Box<F>& b, const Box<F>& t) {
  SInterval<F> of[3][2];
  for (int axis = 0; axis < 3; ++axis) {
    of[axis][0] = interval_of(a, b, axis, t.lo(axis));
    of[axis][1] = interval_of(a, b, axis, t.hi(axis));
  }
  bool inside = true;
  for (int corner = 0; corner < 8; ++corner) {
    const SInterval<F>& x = of[0][corner & 1];
    const SInterval<F>& y = of[1][(corner >> 1) & 1];
    const SInterval<F>& z = of[2][(corner >> 2) & 1];
    inside &= std::max(std::max(x.from, y.from), z.from) <= std::min(std::min(x.to, y.to), z.to);
  }
  return inside;
}

}  // namespace

template <class F>
Category classify_by_slabs(const Box<F>& a, const Box<F>& b, const Box<F>& t) {
  SInterval<F> s;
  for (int axis = 0; axis < 3; ++axis) {
    s.cut(a.hi(axis) - t.lo(axis), b.hi(axis) - a.hi(axis));
    s.cut(t.hi(axis) - a.lo(axis), a.lo(axis) - b.lo(axis));
  }
  if (s.empty()) return Category::outside;
  return every_corner_has_its_s(a, b, t) ? Category::inside : Category::overlap;
}

template Category classify_by_slabs(const Box<float>&, const Box<float>&, const Box<float>&);
template Category classify_by_slabs(const Box<double>&, const Box<double>&, const Box<double>&);

}  // namespace gnomon::fast
