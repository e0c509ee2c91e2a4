// SPDX-License-Identifier: GPL-3.0-or-later
// A second reference for the shaft questions, straight from the definitions by brute force over the sixteen
// corners of the hull: no plane set, no parameter s, no filter, nothing shared with exact/ or fast/.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "scene/category.h"
#include "scene/shaft_case.h"

namespace gnomon::tests {

__extension__ typedef __int128 Int128;

struct ReferenceAnswer {
  scene::Category truth;
  bool touches_outside, touches_inside;

  friend bool operator==(const ReferenceAnswer&, const ReferenceAnswer&) = default;
};

/// Points in exact integers Z (long, Int128 or mpz_class): a case is multiplied by a power of two first.
template <class Z>
using Point = std::array<Z, 3>;

template <class Z>
Point<Z> minus(const Point<Z>& p, const Point<Z>& q) {
  return {Z(p[0] - q[0]), Z(p[1] - q[1]), Z(p[2] - q[2])};
}
template <class Z>
Z dot(const Point<Z>& p, const Point<Z>& q) {
  return Z(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
}
template <class Z>
Point<Z> cross(const Point<Z>& p, const Point<Z>& q) {
  return {Z(p[1] * q[2] - p[2] * q[1]), Z(p[2] * q[0] - p[0] * q[2]), Z(p[0] * q[1] - p[1] * q[0])};
}
template <class Z>
bool is_zero(const Point<Z>& p) {
  return p[0] == 0 && p[1] == 0 && p[2] == 0;
}

/// The half-space normal . x <= offset, with the hull inside and its plane touching the hull.
template <class Z>
struct Support {
  Point<Z> normal;
  Z offset;
};

/// The hull of two boxes given as six coordinates each (minima, then maxima).
///
/// Supports are taken from all planes through three corners, all planes through two corners parallel to an
/// axis, and the sides. They hold every facet normal of S - T for a box or a point T; and where S - T is
/// flat, for each of its edges u some u x e_i that is not normal to it, so that they tell a point from S - T
/// in every dimension.
template <class Z>
class BruteHull {
 public:
  BruteHull(const std::array<Z, 6>& a, const std::array<Z, 6>& b) {
    for (const std::array<Z, 6>* box : {&a, &b}) {
      for (std::size_t i = 0; i < 8; ++i) {
        const Point<Z> p{(*box)[i & 1 ? 3 : 0], (*box)[i & 2 ? 4 : 1], (*box)[i & 4 ? 5 : 2]};
        if (std::find(corners_.begin(), corners_.end(), p) == corners_.end()) corners_.push_back(p);
      }
    }
    const std::array<Point<Z>, 3> axes{Point<Z>{1, 0, 0}, Point<Z>{0, 1, 0}, Point<Z>{0, 0, 1}};
    for (const Point<Z>& axis : axes) {
      for (const Point<Z>& p : corners_) support(axis, p);
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      for (std::size_t j = i + 1; j < corners_.size(); ++j) {
        const Point<Z> edge = minus(corners_[j], corners_[i]);
        for (const Point<Z>& axis : axes) support(cross(edge, axis), corners_[i]);
        for (std::size_t k = j + 1; k < corners_.size(); ++k) {
          if (support(cross(edge, minus(corners_[k], corners_[i])), corners_[i])) {
            triangles_.push_back({corners_[i], corners_[j], corners_[k]});
          }
        }
      }
    }
  }

  [[nodiscard]] const std::vector<Support<Z>>& supports() const { return supports_; }

  /// Calls visit(n, d) with squared distances n / d from p to points of the hull, the least one among them:
  /// corners, feet on segments between corners, feet on triangles of the boundary.
  template <class Visit>
  void visit_squared_distances(const Point<Z>& p, Visit visit) const {
    const bool within = std::all_of(supports_.begin(), supports_.end(),
                                    [&p](const Support<Z>& s) { return dot(s.normal, p) <= s.offset; });
    if (within) visit(Z(0), Z(1));
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Point<Z> to_p = minus(p, corners_[i]);
      const Z square = dot(to_p, to_p);
      visit(square, Z(1));
      for (std::size_t j = i + 1; j < corners_.size(); ++j) {
        const Point<Z> edge = minus(corners_[j], corners_[i]);
        const Z along = dot(to_p, edge), length = dot(edge, edge);
        if (along > 0 && along < length) visit(Z(square * length - along * along), length);
      }
    }
    for (const std::array<Point<Z>, 3>& t : triangles_) {
      const Point<Z> n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
      bool foot_within = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point<Z>& q = t[i];
        foot_within &= dot(n, cross(minus(t[(i + 1) % 3], q), minus(p, q))) >= 0;
      }
      const Z height = dot(n, minus(p, t[0]));
      if (foot_within) visit(Z(height * height), dot(n, n));
    }
  }

 private:
  /// Adds the plane normal . x = normal . p, either way round, where the hull lies on one side of it.
  bool support(const Point<Z>& normal, const Point<Z>& p) {
    if (is_zero(normal)) return false;
    const Z offset = dot(normal, p);
    bool above = false, below = false;
    for (const Point<Z>& corner : corners_) {
      const Z value = dot(normal, corner);
      above |= value > offset;
      below |= value < offset;
      if (above && below) return false;
    }
    if (!above) supports_.push_back({normal, offset});
    if (!below) supports_.push_back({{Z(-normal[0]), Z(-normal[1]), Z(-normal[2])}, Z(-offset)});
    return true;
  }

  std::vector<Point<Z>> corners_;
  std::vector<Support<Z>> supports_;
  std::vector<std::array<Point<Z>, 3>> triangles_;
};

/// `shaft-box` by definition: the least and the largest value of every support over t's eight corners.
template <class Z>
ReferenceAnswer refer_by_brute_force(const BruteHull<Z>& hull, const std::array<Z, 6>& t) {
  bool apart = false, within = true, level = false, flush = false;
  for (const Support<Z>& s : hull.supports()) {
    Z least(0), largest(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Z at_lo = Z(s.normal[axis] * t[axis]), at_hi = Z(s.normal[axis] * t[axis + 3]);
      least += at_lo < at_hi ? at_lo : at_hi;
      largest += at_lo < at_hi ? at_hi : at_lo;
    }
    apart |= least > s.offset;
    within &= largest <= s.offset;
    level |= least == s.offset;
    flush |= largest == s.offset;
  }
  if (apart) return {scene::Category::outside, false, false};
  return {within ? scene::Category::inside : scene::Category::overlap, level, within && flush};
}

/// `shaft-sphere` by definition: the least of all squared distances, and r kept from every support.
template <class Z>
ReferenceAnswer refer_by_brute_force(const BruteHull<Z>& hull, const Point<Z>& centre, const Z& r) {
  const Z square = Z(r * r);
  bool nearer = false, level = false;
  hull.visit_squared_distances(centre, [&](const Z& n, const Z& d) {
    nearer |= n < Z(square * d);
    level |= n == Z(square * d);
  });
  bool within = true, flush = false;
  for (const Support<Z>& s : hull.supports()) {
    const Z kept = Z(s.offset - dot(s.normal, centre));
    const Z reach = Z(kept * kept - square * dot(s.normal, s.normal));
    within &= kept >= 0 && reach >= 0;
    flush |= reach == 0;
  }
  if (!nearer && !level) return {scene::Category::outside, false, false};
  // A point touches where it lies on the boundary; a real ball where its nearest distance is its radius.
  const bool touches = r == 0 ? flush : !nearer;
  return {within ? scene::Category::inside : scene::Category::overlap, touches, within && flush};
}

/// The numbers of a case times one power of two, as integers.
class ScaledIntegers {
 public:
  explicit ScaledIntegers(std::span<const double> numbers) {
    for (const double x : numbers) {
      int exponent = 0;
      if (x != 0) std::frexp(x, &exponent);
      if (x != 0) lowest_ = std::min(lowest_, exponent - 53);
    }
    for (const double x : numbers) {
      int exponent = 0;
      const double fraction = std::frexp(x, &exponent);
      mpz_class integer(std::ldexp(fraction, 53));
      if (x != 0) integer <<= static_cast<mp_bitcnt_t>(exponent - 53 - lowest_);
      integers_.push_back(integer);
    }
    mpz_class all(0);
    for (const mpz_class& x : integers_) all |= abs(x);
    const mp_bitcnt_t spare = all == 0 ? 0 : mpz_scan1(all.get_mpz_t(), 0);
    for (mpz_class& x : integers_) x >>= spare;
    lowest_ += static_cast<int>(spare);
    all >>= spare;
    bits_ = mpz_sizeinbase(all.get_mpz_t(), 2);
  }

  [[nodiscard]] std::size_t bits() const { return bits_; }
  /// The case is integers() * 2^exponent().
  [[nodiscard]] int exponent() const { return lowest_; }

  template <class Z, std::size_t n>
  [[nodiscard]] std::array<Z, n> take(std::size_t from) const {
    std::array<Z, n> taken;
    for (std::size_t i = 0; i < n; ++i) {
      if constexpr (std::is_same_v<Z, mpz_class>) {
        taken[i] = integers_[from + i];
      } else {
        taken[i] = integers_[from + i].get_si();
      }
    }
    return taken;
  }

 private:
  std::vector<mpz_class> integers_;
  int lowest_ = 2000;
  std::size_t bits_ = 0;
};

inline ScaledIntegers scaled(const scene::ShaftBoxCase& c) {
  std::vector<double> numbers;
  for (const scene::Box<double>* box : {&c.a, &c.b, &c.t})
    numbers.insert(numbers.end(), box->c.begin(), box->c.end());
  return ScaledIntegers(numbers);
}

inline ScaledIntegers scaled(const scene::ShaftBallCase& c) {
  std::vector<double> numbers;
  for (const scene::Box<double>* box : {&c.a, &c.b})
    numbers.insert(numbers.end(), box->c.begin(), box->c.end());
  numbers.insert(numbers.end(), c.t.centre.begin(), c.t.centre.end());
  numbers.push_back(c.t.radius);
  return ScaledIntegers(numbers);
}

template <class Z>
BruteHull<Z> hull_of(const ScaledIntegers& numbers) {
  return BruteHull<Z>(numbers.take<Z, 6>(0), numbers.take<Z, 6>(6));
}

/// Values of supports are below 2^(3 bits + 6).
inline ReferenceAnswer refer_by_brute_force(const scene::ShaftBoxCase& c) {
  const ScaledIntegers n = scaled(c);
  if (n.bits() <= 19) return refer_by_brute_force(hull_of<long>(n), n.take<long, 6>(12));
  if (n.bits() <= 40) return refer_by_brute_force(hull_of<Int128>(n), n.take<Int128, 6>(12));
  return refer_by_brute_force(hull_of<mpz_class>(n), n.take<mpz_class, 6>(12));
}

/// Squares of such values are below 2^(6 bits + 12).
inline ReferenceAnswer refer_by_brute_force(const scene::ShaftBallCase& c) {
  const ScaledIntegers n = scaled(c);
  if (n.bits() <= 8)
    return refer_by_brute_force(hull_of<long>(n), n.take<long, 3>(12), n.take<long, 1>(15)[0]);
  if (n.bits() <= 19) {
    return refer_by_brute_force(hull_of<Int128>(n), n.take<Int128, 3>(12), n.take<Int128, 1>(15)[0]);
  }
  return refer_by_brute_force(hull_of<mpz_class>(n), n.take<mpz_class, 3>(12), n.take<mpz_class, 1>(15)[0]);
}

}  // namespace gnomon::tests
