// SPDX-License-Identifier: MIT
#include "fast/shaft_oriented_box.h"

#include "fast/shaft_spanned_inl.h"

namespace gnomon::fast {

using scene::Category;
using scene::OrientedBox;

namespace {

template <class F>
using Vector = std::array<F, 3>;

template <class F>
Vector<F> cross(const Vector<F>& p, const Vector<F>& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// Do the ranges of n.x over the shaft and over t lie apart? The zero vector of parallel edges keeps nothing
/// apart.
template <class F>
bool separates(const Vector<F>& n, const SupportShaft<F>& shaft, const OrientedBox<F>& t) {
  F least_a = 0, most_a = 0, least_b = 0, most_b = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    // Relative to t's centre, so that the ranges are no small differences of large numbers.
    const F a0 = n[j] * (shaft.a.c[j] - t.centre[j]), a1 = n[j] * (shaft.a.c[j + 3] - t.centre[j]);
    const F b0 = n[j] * (shaft.b.c[j] - t.centre[j]), b1 = n[j] * (shaft.b.c[j + 3] - t.centre[j]);
    least_a += std::min(a0, a1);
    most_a += std::max(a0, a1);
    least_b += std::min(b0, b1);
    most_b += std::max(b0, b1);
  }
  const F reach = BoxReach::of(dot(n, t.axes[0]), dot(n, t.axes[1]), dot(n, t.axes[2]));
  return std::min(least_a, least_b) > reach || std::max(most_a, most_b) < -reach;
}

template <class F>
Vector<F> corner_of(const scene::Box<F>& box, std::size_t corner) {
  return {box.c[corner & 1 ? 3 : 0], box.c[corner & 2 ? 4 : 1], box.c[corner & 4 ? 5 : 2]};
}

template <class F>
bool separates_by_further_axes(const SupportShaft<F>& shaft, const OrientedBox<F>& t, FurtherAxes axes) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (separates(cross(t.axes[(i + 1) % 3], t.axes[(i + 2) % 3]), shaft, t)) return true;
  }
  for (const Vector<F>& u : t.axes) {
    if (separates<F>({0, u[2], -u[1]}, shaft, t) || separates<F>({-u[2], 0, u[0]}, shaft, t) ||
        separates<F>({u[1], -u[0], 0}, shaft, t)) {
      return true;
    }
  }
  if (axes == FurtherAxes::faces_and_box_edges) return false;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const Vector<F> from = corner_of(shaft.a, corner), to = corner_of(shaft.b, corner);
    const Vector<F> edge{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    for (const Vector<F>& u : t.axes) {
      if (separates(cross(u, edge), shaft, t)) return true;
    }
  }
  return false;
}

}  // namespace

template <class F>
Banded classify(const SupportShaft<F>& shaft, const OrientedBox<F>& t, Rigour rigour) {
  return rigour == Rigour::naive ? classify_spanned<BoxReach, Rigour::naive>(shaft, t)
                                 : classify_spanned<BoxReach, Rigour::certified>(shaft, t);
}

template <class F>
Category classify_separating(const SupportShaft<F>& shaft, const OrientedBox<F>& t, FurtherAxes axes) {
  const Category by_planes = classify(shaft, t, Rigour::naive).answer;
  // What lies inside of every plane is not held against further axes: rounding could only make it worse.
  if (by_planes != Category::overlap || !separates_by_further_axes(shaft, t, axes)) return by_planes;
  return Category::outside;
}

template <class F>
F stated_gap(const SupportShaft<F>& shaft, const OrientedBox<F>& t) {
  return stated_gap_of<BoxReach>(shaft, t);
}

template Banded classify(const SupportShaft<float>&, const OrientedBox<float>&, Rigour);
template Banded classify(const SupportShaft<double>&, const OrientedBox<double>&, Rigour);
template Category classify_separating(const SupportShaft<float>&, const OrientedBox<float>&, FurtherAxes);
template Category classify_separating(const SupportShaft<double>&, const OrientedBox<double>&, FurtherAxes);
template float stated_gap(const SupportShaft<float>&, const OrientedBox<float>&);
template double stated_gap(const SupportShaft<double>&, const OrientedBox<double>&);

}  // namespace gnomon::fast
