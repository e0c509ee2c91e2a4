// SPDX-License-Identifier: MIT
//
// Error bounds. u, eta, N, n, D, d, a as in shaft_spanned_inl.h; B is the greatest magnitude among t's
// bounds. A weight is a sum of at most two components of n (the third is 0), times 1, 1/2 or -1, -1/2, which
// are exact: two factors. A bound sum w_k b_k + d has a product and at most three sums more. The weights'
// terms add up to at most |N|_1 in each place, 3 |N|_1 B in all:
//     |bound - exact| <= 6.0001 u (3 |N|_1 B + sum |N_j a_j|) + 7 eta (1)
// Each single bound being that near, so are the least and the greatest of them: near and far value. 7 u pays
// for computing the right side. Diagonals: their weights are halves of small integers, at most |N|_1 = 3, so
// that t's range has a product and two sums: within 3.0001 u 9 B + 3 eta; the shaft's is a sum of three
// coordinates, two sums: within 2.0001 u M, M = sum |terms|. With their difference within 4.0002 u 9 B +
// 3.0002 u M + 3 eta (2), for which 5 u (9 B + M) pays. The range is t's own, not what its bounds along this
// diagonal say, which other slabs may cut: as that of all planes.
#include "fast/shaft_slabs.h"

#include <algorithm>
#include <cmath>

namespace gnomon::fast {

using scene::Category;
using scene::kSlabNormals;
using scene::SlabSet;

namespace {

using Integers = std::array<int, 3>;

constexpr Integers cross(const Integers& p, const Integers& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// Every three independent normals with their dual basis in halves.
struct Table {
  std::array<std::array<std::uint8_t, kSlabBases>, 3> slab{};
  std::array<std::array<Integers, kSlabBases>, 3> halves{};
};

constexpr Table kTable = [] {
  Table table;
  std::size_t count = 0;
  for (std::uint8_t p = 0; p < 7; ++p) {
    for (std::uint8_t q = 0; q < p; ++q) {
      for (std::uint8_t r = 0; r < q; ++r) {
        const std::array<std::uint8_t, 3> slab{p, q, r};
        const Integers qr = cross(kSlabNormals[q], kSlabNormals[r]);
        const int volume =
            kSlabNormals[p][0] * qr[0] + kSlabNormals[p][1] * qr[1] + kSlabNormals[p][2] * qr[2];
        if (volume == 0) continue;
        for (std::size_t place = 0; place < 3; ++place) {
          const Integers dual =
              cross(kSlabNormals[slab[(place + 1) % 3]], kSlabNormals[slab[(place + 2) % 3]]);
          table.slab[place][count] = slab[place];
          for (std::size_t j = 0; j < 3; ++j) table.halves[place][count][j] = 2 * dual[j] / volume;
        }
        ++count;
      }
    }
  }
  for (; count < kSlabBases; ++count) {
    for (std::size_t place = 0; place < 3; ++place) {
      table.slab[place][count] = table.slab[place][0];
      table.halves[place][count] = table.halves[place][0];
    }
  }
  return table;
}();

/// The weights of the diagonals, exact.
template <class F>
constexpr std::array<std::array<std::array<F, kSlabBases>, 3>, 4> kDiagonalWeights = [] {
  std::array<std::array<std::array<F, kSlabBases>, 3>, 4> weights{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t place = 0; place < 3; ++place) {
      for (std::size_t i = 0; i < kSlabBases; ++i) {
        const Integers& halves = kTable.halves[place][i];
        const Integers& n = kSlabNormals[k + 3];
        weights[k][place][i] = F(0.5) * F(halves[0] * n[0] + halves[1] * n[1] + halves[2] * n[2]);
      }
    }
  }
  return weights;
}();

/// t's bounds in the order of the bases, and their greatest magnitude.
template <class F>
struct Bounds {
  std::array<std::array<F, kSlabBases>, 3> lo, hi;
  F magnitude = 0;

  explicit Bounds(const SlabSet<F>& t) {
    for (std::size_t place = 0; place < 3; ++place) {
      for (std::size_t i = 0; i < kSlabBases; ++i) {
        lo[place][i] = t.lo[kTable.slab[place][i]];
        hi[place][i] = t.hi[kTable.slab[place][i]];
      }
    }
    for (std::size_t k = 0; k < 7; ++k) {
      magnitude = std::max(magnitude, std::max(std::fabs(t.lo[k]), std::fabs(t.hi[k])));
    }
  }
};

template <class F>
struct Values {
  F near, far;
};

/// The least and the greatest n.x over t, by all bases at once.
template <class F>
Values<F> values_of(const std::array<std::array<F, kSlabBases>, 3>& weights, const Bounds<F>& t) {
  std::array<F, kSlabBases> low, high;
  for (std::size_t i = 0; i < kSlabBases; ++i) {
    const F x0 = weights[0][i] * t.lo[0][i], x1 = weights[0][i] * t.hi[0][i];
    const F y0 = weights[1][i] * t.lo[1][i], y1 = weights[1][i] * t.hi[1][i];
    const F z0 = weights[2][i] * t.lo[2][i], z1 = weights[2][i] * t.hi[2][i];
    low[i] = (std::min(x0, x1) + std::min(y0, y1)) + std::min(z0, z1);
    high[i] = (std::max(x0, x1) + std::max(y0, y1)) + std::max(z0, z1);
  }
  for (std::size_t half = kSlabBases / 2; half > 0; half /= 2) {
    for (std::size_t i = 0; i < half; ++i) {
      low[i] = std::max(low[i], low[i + half]);
      high[i] = std::min(high[i], high[i + half]);
    }
  }
  return {low[0], high[0]};
}

template <class F>
F error_of(const SupportPlane<F>& plane, F magnitude) {
  const F sum = 3 * plane.length * magnitude + plane.base;
  if (!(sum <= kLargestSafeSum<F>)) return std::numeric_limits<F>::infinity();
  return 7 * Rounding<F>::u * sum + 64 * Rounding<F>::two_eta;
}

template <class F>
F error_of_diagonal(const SlabShaft<F>& shaft, std::size_t k, F magnitude) {
  const F sum = 9 * magnitude + shaft.magnitude[k];
  if (!(sum <= kLargestSafeSum<F>)) return std::numeric_limits<F>::infinity();
  return 5 * Rounding<F>::u * sum + 64 * Rounding<F>::two_eta;
}

/// A point of t that surely is one: the middle of the axes' slabs, where it lies well within the diagonal
/// ones.
template <class F>
bool middle_of(const SlabSet<F>& t, F magnitude, std::array<F, 3>& middle) {
  if (!(magnitude <= kLargestSafeSum<F>)) return false;
  for (std::size_t j = 0; j < 3; ++j) {
    middle[j] = (t.lo[j] + t.hi[j]) / 2;
    if (!(t.lo[j] <= middle[j] && middle[j] <= t.hi[j])) return false;
  }
  const F slack = 9 * Rounding<F>::u * magnitude;  // two sums of three coordinates of at most B: 6.0001 u B
  for (std::size_t k = 3; k < 7; ++k) {
    const F x = F(kSlabNormals[k][0]) * middle[0], y = F(kSlabNormals[k][1]) * middle[1];
    const F value = (x + y) + middle[2];
    if (!(t.lo[k] <= value - slack && value + slack <= t.hi[k])) return false;
  }
  return true;
}

template <Rigour kRigour, class F>
Banded classify_slabs(const SlabShaft<F>& shaft, const SlabSet<F>& t) {
  constexpr bool kCertified = kRigour == Rigour::certified;
  const Bounds<F> bounds(t);
  for (std::size_t k = 0; k < 4; ++k) {
    F error = 0;
    if constexpr (kCertified) error = error_of_diagonal(shaft, k, bounds.magnitude);
    const Values<F> range = values_of(kDiagonalWeights<F>[k], bounds);
    if (range.near - shaft.most[k] > error || shaft.least[k] - range.far > error) {
      return {Category::outside, true};
    }
  }
  std::array<F, 3> middle{};
  bool middle_inside = kCertified && middle_of(t, bounds.magnitude, middle);
  bool inside = true, not_inside = false;
  for (std::size_t i = 0; i < shaft.support.plane_count; ++i) {
    const SupportPlane<F>& plane = shaft.support.plane_set[i];
    const Values<F> values = values_of(shaft.weights[i], bounds);
    F error = 0;
    if constexpr (kCertified) error = error_of(plane, bounds.magnitude);
    if (values.near + plane.d > error) return {Category::outside, true};
    const F far = values.far + plane.d;
    if constexpr (kCertified) inside &= std::isfinite(error);
    inside &= far <= -error;
    not_inside |= far > error;
    const F value = ((plane.n[0] * middle[0] + plane.n[1] * middle[1]) + plane.n[2] * middle[2]) + plane.d;
    middle_inside &= value <= -error;
  }
  if (inside) return {Category::inside, true};
  return {Category::overlap, middle_inside && not_inside};
}

}  // namespace

template <class F>
SlabShaft<F> form_slab_shaft(const scene::Box<F>& a, const scene::Box<F>& b) {
  SlabShaft<F> shaft;
  shaft.support = form_support_shaft(a, b);
  for (std::size_t i = 0; i < shaft.support.plane_count; ++i) {
    const std::array<F, 3>& n = shaft.support.plane_set[i].n;
    for (std::size_t place = 0; place < 3; ++place) {
      for (std::size_t basis = 0; basis < kSlabBases; ++basis) {
        const Integers& halves = kTable.halves[place][basis];
        F weight = 0;
        for (std::size_t j = 0; j < 3; ++j) weight += F(0.5) * F(halves[j]) * n[j];
        shaft.weights[i][place][basis] = weight;
      }
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    F least[2], most[2], magnitude = 0;
    for (const scene::Box<F>* box : {&a, &b}) {
      const std::size_t which = box == &a ? 0 : 1;
      F low = 0, high = 0, sum = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        const int sign = kSlabNormals[k + 3][j];
        low += sign > 0 ? box->c[j] : -box->c[j + 3];
        high += sign > 0 ? box->c[j + 3] : -box->c[j];
        sum += std::max(std::fabs(box->c[j]), std::fabs(box->c[j + 3]));
      }
      least[which] = low;
      most[which] = high;
      magnitude = std::max(magnitude, sum);
    }
    shaft.least[k] = std::min(least[0], least[1]);
    shaft.most[k] = std::max(most[0], most[1]);
    shaft.magnitude[k] = magnitude;
  }
  return shaft;
}

template <class F>
Banded classify(const SlabShaft<F>& shaft, const SlabSet<F>& t, Rigour rigour) {
  return rigour == Rigour::naive ? classify_slabs<Rigour::naive>(shaft, t)
                                 : classify_slabs<Rigour::certified>(shaft, t);
}

template <class F>
F stated_gap(const SlabShaft<F>& shaft, const SlabSet<F>& t) {
  const Bounds<F> bounds(t);
  F most = 0;
  for (const SupportPlane<F>& plane : shaft.support.planes()) {
    most = std::max(most, 2 * error_of(plane, bounds.magnitude) / plane.length);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    most = std::max(most, 2 * error_of_diagonal(shaft, k, bounds.magnitude) / 3);
  }
  return most * (1 + 16 * Rounding<F>::u) + Rounding<F>::two_eta;
}

template SlabShaft<float> form_slab_shaft(const scene::Box<float>&, const scene::Box<float>&);
template SlabShaft<double> form_slab_shaft(const scene::Box<double>&, const scene::Box<double>&);
template Banded classify(const SlabShaft<float>&, const SlabSet<float>&, Rigour);
template Banded classify(const SlabShaft<double>&, const SlabSet<double>&, Rigour);
template float stated_gap(const SlabShaft<float>&, const SlabSet<float>&);
template double stated_gap(const SlabShaft<double>&, const SlabSet<double>&);

}  // namespace gnomon::fast
