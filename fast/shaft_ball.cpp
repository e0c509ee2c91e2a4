// SPDX-License-Identifier: MIT
#include "fast/shaft_ball.h"

#include "fast/box_relation.h"

namespace gnomon::fast {

using scene::Category;

namespace {

/// True when the ball keeps within all six sides of the box; `factor` widens the radius.
template <class F>
bool within_sides(const scene::Box<F>& box, const scene::Ball<F>& t, F factor) {
  const F reach = t.radius * factor;
  bool within = true;
  for (int axis = 0; axis < 3; ++axis) {
    const F x = t.centre[static_cast<std::size_t>(axis)];
    within &= x - box.lo(axis) >= reach;
    within &= box.hi(axis) - x >= reach;
  }
  return within;
}

}  // namespace

template <class F>
Banded classify(const Shaft<F>& shaft, const scene::Ball<F>& t) {
  const BallSlack<F>& slack = shaft.slack;
  const F square = t.radius * t.radius;
  if (squared_distance(t.centre, shaft.extent) > square * slack.square_factor + slack.square_offset) {
    return {Category::outside, true};
  }
  if (!(t.radius <= slack.largest_radius)) return {Category::overlap, false};

  // Outside and inside compare the same value with two bounds that differ by the diameter (claim S8).
  bool inside = within_sides(shaft.extent, t, slack.inside_factor);
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    const F value = plane.value_at(t.centre);
    if (value > t.radius + plane.outside_threshold) return {Category::outside, true};
    inside &= value <= plane.inside_threshold - t.radius;
  }
  if (inside) return {Category::inside, true};
  return {Category::overlap, false};
}

template <class F>
Category classify_as_printed(const Shaft<F>& shaft, const scene::Ball<F>& t) {
  const F square = t.radius * t.radius;
  if (squared_distance(t.centre, shaft.extent) > square) return Category::outside;
  if (squared_distance(t.centre, shaft.a) <= square || squared_distance(t.centre, shaft.b) <= square) {
    return Category::overlap;
  }
  bool inside = within_sides(shaft.extent, t, F(1));
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    const F value = plane.value_at(t.centre);
    if (value > t.radius) return Category::outside;
    inside &= value > -t.radius;
  }
  return inside ? Category::inside : Category::overlap;
}

template Banded classify(const Shaft<float>&, const scene::Ball<float>&);
template Banded classify(const Shaft<double>&, const scene::Ball<double>&);
template Category classify_as_printed(const Shaft<float>&, const scene::Ball<float>&);
template Category classify_as_printed(const Shaft<double>&, const scene::Ball<double>&);

}  // namespace gnomon::fast
