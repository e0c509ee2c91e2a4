// SPDX-License-Identifier: GPL-3.0-or-later
// The definition of `shaft-box` by the parameter s, in the arithmetic of a CGAL kernel. Internal to exact/.
#pragma once

#include "exact/number.h"
#include "scene/box.h"

namespace gnomon::exact {

/// The s in [0, 1] that satisfy inequalities p + q s >= 0; p and q are differences of doubles, whose signs
/// are known.
template <class K>
class SInterval {
 public:
  using FT = typename K::FT;

  /// Cuts by (px - py) + (qx - qy) s >= 0.
  void cut(double px, double py, double qx, double qy) {
    const Sign q = sign_of_difference(qx, qy);
    if (q == Sign::zero) {
      none_ |= px < py;
      return;
    }
    // A rising inequality that holds at 0, or a falling one that holds at 1, cuts nothing; the first is seen
    // at once.
    if (q == Sign::positive && px >= py) return;
    const FT root = (FT(py) - FT(px)) / (FT(qx) - FT(qy));
    if (q == Sign::positive) {
      from_ = max_of(from_, root);
    } else {
      to_ = min_of(to_, root);
    }
  }

  void cut(const SInterval& other) {
    none_ |= other.none_;
    from_ = max_of(from_, other.from_);
    to_ = min_of(to_, other.to_);
  }

  /// negative: no s; zero: one s; positive: more; unknown: the filter can't tell.
  [[nodiscard]] Sign extent() const { return none_ ? Sign::negative : sign_of(FT(to_ - from_)); }

 private:
  static FT max_of(const FT& x, const FT& y) { return (CGAL::max)(x, y); }
  static FT min_of(const FT& x, const FT& y) { return (CGAL::min)(x, y); }

  FT from_ = FT(0), to_ = FT(1);
  bool none_ = false;
};

/// negative: t misses the shaft; unknown: the filter can't tell; else t meets it.
template <class K>
[[nodiscard]] Sign common_s(const scene::Box<double>& a, const scene::Box<double>& b,
                            const scene::Box<double>& t) {
  SInterval<K> s;
  for (int axis = 0; axis < 3; ++axis) {
    s.cut(a.hi(axis), t.lo(axis), b.hi(axis), a.hi(axis));
    s.cut(t.hi(axis), a.lo(axis), a.lo(axis), b.lo(axis));
  }
  return s.extent();
}

/// negative: some corner of t lies outside the shaft; unknown: the filter can't tell; else all lie within.
template <class K>
[[nodiscard]] Sign every_corner_s(const scene::Box<double>& a, const scene::Box<double>& b,
                                  const scene::Box<double>& t) {
  SInterval<K> of[3][2];
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const double x = side == 0 ? t.lo(axis) : t.hi(axis);
      of[axis][side].cut(a.hi(axis), x, b.hi(axis), a.hi(axis));
      of[axis][side].cut(x, a.lo(axis), a.lo(axis), b.lo(axis));
    }
  }
  bool unknown = false;
  for (int corner = 0; corner < 8; ++corner) {
    SInterval<K> s = of[0][corner & 1];
    s.cut(of[1][(corner >> 1) & 1]);
    s.cut(of[2][(corner >> 2) & 1]);
    const Sign extent = s.extent();
    if (extent == Sign::negative) return Sign::negative;
    unknown |= extent == Sign::unknown;
  }
  return unknown ? Sign::unknown : Sign::zero;
}

}  // namespace gnomon::exact
