// SPDX-License-Identifier: GPL-3.0-or-later
// Polytopes against a shaft, for the questions shaft-slabs and shaft-oriented-box. Internal to exact/.
//
// A Body<FT> is the volume in the arithmetic of FT, multiplied by kScale:
//   range(n)   the least and the greatest n.x, exactly
//   edges(), faces()   directions of edges and normals of faces other than the axes
//   points()   some of its points, for a quick "meets"
//   kFacesInPlanes     do the naive methods test its faces, too?
#pragma once

#include <boost/container/small_vector.hpp>
#include <cmath>
#include <optional>

#include "exact/gap.h"
#include "exact/scaling.h"
#include "exact/separating_axes.h"
#include "exact/volume_reference.h"
#include "scene/volume_case.h"

namespace gnomon::exact {

/// What one normal n says of S - T: the signs of least over T - most over S, and of least over S - most over
/// T. Positive: n separates them strictly.
struct AxisSigns {
  Sign up = Sign::negative, down = Sign::negative;

  [[nodiscard]] bool any(Sign sign) const { return up == sign || down == sign; }
};

/// A case in the arithmetic of FT.
template <template <class> class Body, class FT>
class PolytopeCase {
 public:
  template <class Case>
  explicit PolytopeCase(const Case& c)
      : half_spaces_(c.a, c.b), body_(c.t), axes_(c.a, c.b, body_.edges(), body_.faces()) {}
  PolytopeCase(const PolytopeCase&) = delete;
  PolytopeCase& operator=(const PolytopeCase&) = delete;

  [[nodiscard]] std::size_t half_spaces() const { return half_spaces_.all().size(); }
  [[nodiscard]] std::size_t axes() const { return axes_.size(); }
  [[nodiscard]] std::size_t faces() const { return axes_.faces(); }
  [[nodiscard]] std::size_t faces_and_axes() const { return axes_.faces_and_axes(); }

  /// The least and the greatest n.x + d over t, times kScale, for half-space i.
  [[nodiscard]] Extremes<FT> beyond(std::size_t i) const {
    const HalfSpace<FT>& h = half_spaces_.all()[i];
    const Extremes<FT> t = body_.range(h.n);
    return {FT(t.least + scale() * h.d), FT(t.most + scale() * h.d)};
  }
  [[nodiscard]] FT growth_of_half_space(std::size_t i) const {
    return scale() * growth_of(half_spaces_.all()[i].n);
  }

  /// Both distances between the ranges of n.x, times kScale.
  [[nodiscard]] Extremes<FT> apart(const Vector<FT>& n) const {
    const Extremes<FT> t = body_.range(n), s = axes_.of_shaft(n);
    return {FT(t.least - scale() * s.most), FT(scale() * s.least - t.most)};
  }
  [[nodiscard]] Vector<FT> normal(std::size_t axis) const { return axes_.normal(axis); }

  [[nodiscard]] AxisSigns signs_at(std::size_t axis) const {
    const Vector<FT> n = normal(axis);
    bool nonzero = false, zero = true;
    for (const FT& x : n) {
      const Sign sign = sign_of(x);
      zero &= sign == Sign::zero;
      nonzero |= sign == Sign::positive || sign == Sign::negative;
    }
    if (zero) return {};  // parallel edges: no axis
    const Extremes<FT> distances = apart(n);
    const AxisSigns signs{sign_of(distances.least), sign_of(distances.most)};
    // The zero vector keeps nothing apart, so that positive means it is none; for the other signs it has to
    // be known.
    if (nonzero || signs.any(Sign::positive)) return signs;
    return {Sign::unknown, Sign::unknown};
  }

  /// True when some point of t surely lies in the shaft's interior.
  [[nodiscard]] bool surely_reaches_inside() const {
    for (const Vector<FT>& p : body_.points()) {
      bool within = true;
      for (const HalfSpace<FT>& h : half_spaces_.all()) {
        within = within && sign_of(FT(dot(h.n, p) + scale() * h.d)) == Sign::negative;
      }
      if (within) return true;
    }
    return false;
  }

  [[nodiscard]] static FT scale() { return FT(Body<FT>::kScale); }

 private:
  HalfSpaces<FT> half_spaces_;
  Body<FT> body_;
  SeparatingAxes<FT> axes_;
};

/// Signs by the arithmetic Quick, and by exact numbers, made when first needed, where that can't tell.
template <template <class> class Body, class Quick, class Case>
class PolytopeDecision {
 public:
  explicit PolytopeDecision(const Case& c) : original_(c), quick_(c) {}

  [[nodiscard]] VolumeReference decide() {
    using scene::Category;
    constexpr VolumeReference kOutside{Category::outside, Category::outside, Category::outside, false, false};
    VolumeReference r{Category::overlap, Category::overlap, Category::overlap, false, false};
    for (std::size_t i = 0; i < quick_.half_spaces(); ++i) {
      if (sign([i](const auto& c) { return c.beyond(i).least; }) == Sign::positive) return kOutside;
    }
    if (!quick_.surely_reaches_inside() && !look_at_axes(r)) return r;

    SignFold far;
    for (std::size_t i = 0; i < quick_.half_spaces() && !far.any_positive; ++i) {
      far.add(sign([i](const auto& c) { return c.beyond(i).most; }));
    }
    if (!far.any_positive) {
      r.truth = r.planes = r.separating = Category::inside;
      r.touches_inside = far.any_zero;
    }
    return r;
  }

  [[nodiscard]] bool needed_exact_numbers() const { return exact_.has_value(); }

 private:
  using Exact = PolytopeCase<Body, CGAL::Mpzf>;

  /// False when an axis separates; says so in `r`.
  bool look_at_axes(VolumeReference& r) {
    using scene::Category;
    for (std::size_t i = 0; i < quick_.axes(); ++i) {
      AxisSigns signs = quick_.signs_at(i);
      if (!signs.any(Sign::positive) && signs.any(Sign::unknown)) signs = in_exact_numbers().signs_at(i);
      r.touches_outside |= signs.any(Sign::zero);
      if (!signs.any(Sign::positive)) continue;
      r.truth = Category::outside;
      r.touches_outside = false;
      if (i < quick_.faces_and_axes()) r.separating = Category::outside;
      if (i < quick_.faces() && Body<Quick>::kFacesInPlanes) r.planes = Category::outside;
      return false;
    }
    return true;
  }

  template <class Value>
  Sign sign(const Value& value) {
    const Sign quick = sign_of(value(quick_));
    return quick != Sign::unknown ? quick : sign_of(value(in_exact_numbers()));
  }

  const Exact& in_exact_numbers() {
    if (!exact_) exact_.emplace(original_);
    return *exact_;
  }

  const Case& original_;
  PolytopeCase<Body, Quick> quick_;
  std::optional<Exact> exact_;
};

template <template <class> class Body, class Case>
std::uint64_t refer_polytopes(std::span<const Case> cases, std::span<VolumeReference> references) {
  std::uint64_t in_exact_numbers = 0;
  const CGAL::Interval_nt<false>::Protector upward;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Scaled<Case> scaled(cases[i]);
    PolytopeDecision<Body, FilterKernel::FT, Case> decision(scaled.c);
    references[i] = decision.decide();
    in_exact_numbers += decision.needed_exact_numbers();
  }
  return in_exact_numbers;
}

/// A maximum over normals, without those that may be 0.
template <class FT>
struct GapOverNormals {
  FT most;
  bool passed_over;  ///< some normal may be 0, by intervals, and could say more
};

/// max over the shaft's sides and planes (inside), or over all separating axes (outside); for intervals the
/// bounds of that maximum.
template <template <class> class Body, class FT, class Case>
GapOverNormals<FT> polytope_gap(const Case& c, Boundary boundary) {
  const PolytopeCase<Body, FT> polytope(c);
  std::optional<FT> most;
  const auto take = [&most](const FT& value) { most = most ? FT((CGAL::max)(*most, value)) : value; };
  bool passed_over = false;
  if (boundary == Boundary::inside) {
    for (std::size_t i = 0; i < polytope.half_spaces(); ++i) {
      take(FT(polytope.beyond(i).most / polytope.growth_of_half_space(i)));
    }
  } else {
    for (std::size_t i = 0; i < polytope.axes(); ++i) {
      const Vector<FT> n = polytope.normal(i);
      const FT growth = PolytopeCase<Body, FT>::scale() * growth_of(n);
      const Sign sign = sign_of(growth);
      passed_over |= sign == Sign::unknown;
      if (sign != Sign::positive) continue;
      const Extremes<FT> apart = polytope.apart(n);
      take(FT(apart.least / growth));
      take(FT(apart.most / growth));
    }
  }
  return {*most, passed_over};
}

/// The maximum over the separating axes, in rationals for those alone that intervals see within reach of it.
template <template <class> class Body, class Case>
CGAL::Gmpq outside_gap(const Case& c) {
  using Interval = FilterKernel::FT;
  boost::container::small_vector<double, 80> at_most;
  double most = -HUGE_VAL;
  {
    const CGAL::Interval_nt<false>::Protector upward;
    const PolytopeCase<Body, Interval> polytope(c);
    for (std::size_t i = 0; i < polytope.axes(); ++i) {
      const Vector<Interval> n = polytope.normal(i);
      const Interval growth = PolytopeCase<Body, Interval>::scale() * growth_of(n);
      if (sign_of(growth) != Sign::positive) {
        at_most.push_back(sign_of(growth) == Sign::zero ? -HUGE_VAL : HUGE_VAL);
        continue;
      }
      const Extremes<Interval> apart = polytope.apart(n);
      const Interval value = (CGAL::max)(apart.least, apart.most) / growth;
      at_most.push_back(std::isnan(value.sup()) ? HUGE_VAL : value.sup());
      most = std::fmax(most, value.inf());
    }
  }
  const PolytopeCase<Body, CGAL::Gmpq> polytope(c);
  std::optional<CGAL::Gmpq> gap;
  for (std::size_t i = 0; i < polytope.axes(); ++i) {
    if (at_most[i] < most || at_most[i] == -HUGE_VAL) continue;
    const Vector<CGAL::Gmpq> n = polytope.normal(i);
    if (is_zero(n)) continue;
    const Extremes<CGAL::Gmpq> apart = polytope.apart(n);
    const CGAL::Gmpq growth = PolytopeCase<Body, CGAL::Gmpq>::scale() * growth_of(n);
    const CGAL::Gmpq value = (std::max)(apart.least, apart.most) / growth;
    if (!gap || value > *gap) gap = value;
  }
  return *gap;
}

template <template <class> class Body, class Case>
Gap exact_polytope_gap(const Case& c, Boundary boundary) {
  const Scaled<Case> scaled(c);
  if (boundary == Boundary::outside) return scaled.gap_of_original(Gap(outside_gap<Body>(scaled.c).mpq()), 1);
  return scaled.gap_of_original(Gap(polytope_gap<Body, CGAL::Gmpq>(scaled.c, boundary).most.mpq()), 1);
}

template <template <class> class Body, class Case>
double polytope_gap_bound(const Case& c, Boundary boundary) {
  const Scaled<Case> scaled(c);
  const CGAL::Interval_nt<false>::Protector upward;
  const GapOverNormals<FilterKernel::FT> gap = polytope_gap<Body, FilterKernel::FT>(scaled.c, boundary);
  double bound = magnitude_bound(gap.most);
  if (gap.passed_over) return HUGE_VAL;
  if (!(bound < HUGE_VAL)) bound = HUGE_VAL;
  return scaled.bound_of_original(bound, 1);
}

/// The plane test's answer after growth.
template <template <class> class Body, class FT, class Case>
std::optional<scene::Category> grown_with(const Case& c, double growth) {
  const PolytopeCase<Body, FT> polytope(c);
  SignFold near, far;
  for (std::size_t i = 0; i < polytope.half_spaces(); ++i) {
    const Extremes<FT> beyond = polytope.beyond(i);
    const FT by = FT(growth) * polytope.growth_of_half_space(i);
    near.add(sign_of(FT(beyond.least - by)));
    far.add(sign_of(FT(beyond.most + by)));
  }
  for (std::size_t i = 0; Body<FT>::kFacesInPlanes && i < polytope.faces(); ++i) {
    const Vector<FT> n = polytope.normal(i);
    const Extremes<FT> apart = polytope.apart(n);
    const FT by = FT(growth) * PolytopeCase<Body, FT>::scale() * growth_of(n);
    near.add(sign_of(FT(apart.least - by)));
    near.add(sign_of(FT(apart.most - by)));
  }
  return category_of(near, far);
}

template <template <class> class Body, class Case>
scene::Category polytope_grown(const Case& c, double growth) {
  if (std::isinf(growth)) return scene::Category::overlap;  // grown without bound, it meets and is not within
  {
    const CGAL::Interval_nt<false>::Protector upward;
    const auto grown = grown_with<Body, FilterKernel::FT>(c, growth);
    if (grown) return *grown;
  }
  return *grown_with<Body, CGAL::Mpzf>(c, growth);
}

}  // namespace gnomon::exact
