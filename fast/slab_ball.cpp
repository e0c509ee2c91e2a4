// SPDX-License-Identifier: MIT
#include "fast/slab_ball.h"

#include "fast/box_relation.h"

namespace gnomon::fast {

using scene::Ball;
using scene::Box;
using scene::Category;

namespace {

/// p + q s, the signed distance by which a point lies beyond one side of the moving box.
template <class F>
struct Side {
  F p, q;
  [[nodiscard]] F at(F s) const { return p + q * s; }
};

template <class F>
using Sides = std::array<Side<F>, 6>;

template <class F>
F squared_distance_at(const Sides<F>& sides, F s) {
  F sum = 0;
  for (const Side<F>& side : sides) {
    const F beyond = std::max(side.at(s), F(0));
    sum += beyond * beyond;
  }
  return sum;
}

/// The minimiser of the quadratic that holds around `middle`, kept to [from, to]. Where no side is left
/// behind, or those that are don't move, the function is constant and `from` as good as any.
template <class F>
F minimiser(const Sides<F>& sides, F from, F to) {
  const F middle = from + (to - from) / 2;
  F pq = 0, qq = 0;
  for (const Side<F>& side : sides) {
    if (side.at(middle) > 0) {
      pq += side.p * side.q;
      qq += side.q * side.q;
    }
  }
  if (!(qq > 0)) return from;
  return std::min(std::max(-pq / qq, from), to);
}

}  // namespace

template <class F>
F squared_distance_to_shaft(const Box<F>& a, const Box<F>& b, const std::array<F, 3>& p) {
  Sides<F> sides;
  std::array<F, 8> kinks{0, 1};
  std::size_t count = 2;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t i = static_cast<std::size_t>(axis);
    sides[2 * i] = {a.lo(axis) - p[i], b.lo(axis) - a.lo(axis)};
    sides[2 * i + 1] = {p[i] - a.hi(axis), a.hi(axis) - b.hi(axis)};
  }
  for (const Side<F>& side : sides) {
    const F s = -side.p / side.q;  // NaN and infinities fail the comparison
    if (s > 0 && s < 1) {
      // Insertion into so few keeps them sorted faster than a sort; the 1 at the end moves up by one.
      std::size_t at = count++;
      for (; kinks[at - 1] > s; --at) kinks[at] = kinks[at - 1];
      kinks[at] = s;
    }
  }

  F least = std::min(squared_distance_at(sides, F(0)), squared_distance_at(sides, F(1)));
  for (std::size_t i = 0; i + 1 < count; ++i) {
    least = std::min(least, squared_distance_at(sides, minimiser(sides, kinks[i], kinks[i + 1])));
  }
  return least;
}

template <class F>
Category classify_by_slabs(const Shaft<F>& shaft, const Ball<F>& t) {
  const F square = t.radius * t.radius;
  if (squared_distance_to_shaft(shaft.a, shaft.b, t.centre) > square) return Category::outside;
  for (int axis = 0; axis < 3; ++axis) {
    const F x = t.centre[static_cast<std::size_t>(axis)];
    if (!(x - shaft.extent.lo(axis) >= t.radius) || !(shaft.extent.hi(axis) - x >= t.radius))
      return Category::overlap;
  }
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    const F value = plane.value_at(t.centre);
    if (!(value <= 0) || !(value * value >= square * (plane.n0 * plane.n0 + plane.n1 * plane.n1)))
      return Category::overlap;
  }
  return Category::inside;
}

template float squared_distance_to_shaft(const Box<float>&, const Box<float>&, const std::array<float, 3>&);
template double squared_distance_to_shaft(const Box<double>&, const Box<double>&,
                                          const std::array<double, 3>&);
template Category classify_by_slabs(const Shaft<float>&, const Ball<float>&);
template Category classify_by_slabs(const Shaft<double>&, const Ball<double>&);

}  // namespace gnomon::fast
