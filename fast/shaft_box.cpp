// SPDX-License-Identifier: MIT
#include "fast/shaft_box.h"

#include "fast/box_relation.h"

namespace gnomon::fast {

using scene::Category;

template <class F>
Banded classify(const Shaft<F>& shaft, const scene::Box<F>& t) {
  if (!meets(t, shaft.extent)) return {Category::outside, true};

  // Near corners. A value above the threshold is outside; one above inside_threshold could be.
  bool certain = true;
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    const F value = plane.near_value(t);
    if (value > plane.outside_threshold) return {Category::outside, true};
    certain &= value <= plane.inside_threshold;
  }

  // Far corners: they lie in the extent box, for which the thresholds are proved, only when all of t does.
  if (!contains(shaft.extent, t)) return {Category::overlap, certain};
  bool inside = true, surely_not_inside = false;
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    const F value = plane.far_value(t);
    inside &= value <= plane.inside_threshold;
    surely_not_inside |= value > plane.outside_threshold;
  }
  // What is inside by its far corners meets the shaft for certain, whatever the near corners' band says.
  if (inside) return {Category::inside, true};
  return {Category::overlap, certain && surely_not_inside};
}

template <class F>
Category classify_as_printed(const Shaft<F>& shaft, const scene::Box<F>& t) {
  if (!meets(t, shaft.extent)) return Category::outside;
  if (meets(t, shaft.a) || meets(t, shaft.b)) return Category::overlap;
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    if (plane.near_value(t) > 0) return Category::outside;
  }
  if (!contains(shaft.extent, t)) return Category::overlap;
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    if (plane.far_value(t) > 0) return Category::overlap;
  }
  return Category::inside;
}

template Banded classify(const Shaft<float>&, const scene::Box<float>&);
template Banded classify(const Shaft<double>&, const scene::Box<double>&);
template Category classify_as_printed(const Shaft<float>&, const scene::Box<float>&);
template Category classify_as_printed(const Shaft<double>&, const scene::Box<double>&);

}  // namespace gnomon::fast
