// SPDX-License-Identifier: MIT
// The cases of the questions shaft-slabs, shaft-oriented-box and shaft-ellipsoid: other volumes against a
// shaft.
#pragma once

#include "scene/box.h"
#include "scene/ellipsoid.h"
#include "scene/oriented_box.h"
#include "scene/slab_set.h"

namespace gnomon::scene {

/// One instance: the volume `t` against the convex hull of `a` and `b`. Every finite number of the format is
/// in the domain.
template <template <class> class Volume, class F>
struct VolumeCaseOf {
  Box<F> a, b;
  Volume<F> t;

  friend bool operator==(const VolumeCaseOf&, const VolumeCaseOf&) = default;
};

template <class F>
using ShaftSlabsCaseOf = VolumeCaseOf<SlabSet, F>;
template <class F>
using ShaftOrientedBoxCaseOf = VolumeCaseOf<OrientedBox, F>;
template <class F>
using ShaftEllipsoidCaseOf = VolumeCaseOf<Ellipsoid, F>;

/// The form that references, files and witnesses use: a single-precision case is held as the doubles that it
/// is.
using ShaftSlabsCase = ShaftSlabsCaseOf<double>;
using ShaftOrientedBoxCase = ShaftOrientedBoxCaseOf<double>;
using ShaftEllipsoidCase = ShaftEllipsoidCaseOf<double>;

/// The case with its numbers converted, as converted() of its parts.
template <class To, template <class> class Volume, class From>
[[nodiscard]] VolumeCaseOf<Volume, To> converted(const VolumeCaseOf<Volume, From>& c) {
  return {converted<To>(c.a), converted<To>(c.b), converted<To>(c.t)};
}

/// Visits every number of the volume in the order of the text corpus.
template <class F, class Visit>
void for_each_number(SlabSet<F>& t, const Visit& visit) {
  for (F& x : t.lo) visit(x);
  for (F& x : t.hi) visit(x);
}
template <class F, class Visit>
void for_each_number(OrientedBox<F>& t, const Visit& visit) {
  for (F& x : t.centre) visit(x);
  for (auto& axis : t.axes) {
    for (F& x : axis) visit(x);
  }
}
template <class F, class Visit>
void for_each_number(Ellipsoid<F>& t, const Visit& visit) {
  for (F& x : t.centre) visit(x);
  for (auto& axis : t.axes) {
    for (F& x : axis) visit(x);
  }
}

/// Visits every number of the case in the order of the text corpus.
template <template <class> class Volume, class F, class Visit>
void for_each_number(VolumeCaseOf<Volume, F>& c, const Visit& visit) {
  for (F& x : c.a.c) visit(x);
  for (F& x : c.b.c) visit(x);
  for_each_number(c.t, visit);
}

}  // namespace gnomon::scene
