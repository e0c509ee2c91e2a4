// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/volume_shapes.h"

namespace gnomon::fuzz {

namespace {

template <class F>
using Vector = std::array<F, 3>;

/// The nearest multiple of unit.
template <class F>
F to_unit(F x, F unit) {
  return unit > 0 ? std::round(x / unit) * unit : x;
}

/// A rotation from a random quaternion, orthogonal up to rounding.
template <class F>
std::array<Vector<F>, 3> rotation(CaseRandom& random) {
  F q[4], square = 0;
  do {
    square = 0;
    for (F& x : q) {
      x = random.between<F>(-1, 1);
      square += x * x;
    }
  } while (square > 1 || square < F(0.01));
  const F w = q[0], x = q[1], y = q[2], z = q[3], s = 2 / square;
  return {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
           {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
           {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}};
}

template <class F>
Vector<F> halves_of(const scene::Box<F>& t) {
  return {t.hi(0) / 2 - t.lo(0) / 2, t.hi(1) / 2 - t.lo(1) / 2, t.hi(2) / 2 - t.lo(2) / 2};
}

/// Makes the axes dependent in one of several ways.
template <class F>
void degenerate(CaseRandom& random, std::array<Vector<F>, 3>& axes) {
  const int kind = random.below(6), i = random.below(3), j = (i + 1 + random.below(2)) % 3;
  Vector<F>& u = axes[static_cast<std::size_t>(i)];
  const Vector<F>& v = axes[static_cast<std::size_t>(j)];
  const Vector<F>& w = axes[static_cast<std::size_t>(3 - i - j)];
  if (kind == 0) u = {0, 0, 0};
  if (kind == 1) u = v;
  for (std::size_t k = 0; k < 3; ++k) {
    if (kind == 2) u[k] = -v[k] / 2;
    if (kind == 3) u[k] = v[k] / 2 + w[k] / 2;
  }
  if (kind == 4) axes = {};
  if (kind == 5) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (random.chance(0.5)) u[k] = 0;
    }
  }
}

/// x + y + z rounded down (towards -1) or up (+1), by error-free sums.
template <class F>
F sum_towards(int direction, F x, F y, F z) {
  const auto error = [](F p, F q, F sum) {
    const F part = sum - p;
    return (p - (sum - part)) + (q - part);
  };
  const F xy = x + y, sum = xy + z;
  const F rest = error(x, y, xy) + error(xy, z, sum);
  if (rest == 0) return sum;
  return step_ulps(sum + rest, 2 * direction);
}

}  // namespace

template <class F>
Spanned<F> spanned_about(CaseRandom& random, const scene::Box<F>& t, Flavour flavour, F unit) {
  const Vector<F> half = halves_of(t);
  Spanned<F> result;
  for (int axis = 0; axis < 3; ++axis) {
    result.centre[static_cast<std::size_t>(axis)] = to_unit(t.lo(axis) / 2 + t.hi(axis) / 2, unit);
  }
  if (flavour == Flavour::small_ints) {
    const bool small = random.chance(0.5);
    for (Vector<F>& axis : result.axes) {
      for (F& x : axis) x = F(random.integer(small ? -1 : -2, small ? 1 : 2));
      if (random.chance(0.1)) axis = {0, 0, 0};
    }
    return result;
  }
  const std::array<Vector<F>, 3> turn = rotation<F>(random);
  const bool along_axes = flavour == Flavour::degenerate && random.chance(0.5);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      F& x = result.axes[i][j];
      if (flavour == Flavour::mixed) {
        x = random.between<F>(-1, 1) * half[j];
      } else if (along_axes) {
        x = i == j ? half[i] : F(0);
      } else {
        x = turn[i][j] * half[i] * F(0.7);
      }
    }
  }
  if (flavour == Flavour::rotated && random.chance(0.25)) {  // sheared
    for (std::size_t j = 0; j < 3; ++j) result.axes[0][j] += result.axes[1][j] / 2;
  }
  if (flavour == Flavour::degenerate && random.chance(0.7)) degenerate(random, result.axes);
  for (Vector<F>& axis : result.axes) {
    for (F& x : axis) x = std::isfinite(x) ? to_unit(x, unit) : F(0);
  }
  return result;
}

template <class F>
scene::SlabSet<F> slabs_about(CaseRandom& random, const scene::Box<F>& t, Flavour flavour, F unit) {
  std::array<Vector<F>, 8> points{};
  int count = 8;
  const int kind = random.below(3);
  if (kind == 0) {
    const Spanned<F> turned = spanned_about(random, t, flavour, unit);
    for (std::size_t corner = 0; corner < 8; ++corner) {
      for (std::size_t j = 0; j < 3; ++j) {
        F x = turned.centre[j];
        for (std::size_t i = 0; i < 3; ++i) x += corner >> i & 1 ? turned.axes[i][j] : -turned.axes[i][j];
        points[corner][j] = x;
      }
    }
  } else {
    if (kind == 2) count = random.integer(1, 6);
    for (std::size_t corner = 0; corner < static_cast<std::size_t>(count); ++corner) {
      for (int j = 0; j < 3; ++j) {
        const bool high = corner >> j & 1;
        const F share = random.unit<F>(), x = t.lo(j) + share * (t.hi(j) - t.lo(j));
        points[corner][static_cast<std::size_t>(j)] =
            kind == 1 || !std::isfinite(x) ? (high ? t.hi(j) : t.lo(j)) : to_unit(x, unit);
      }
      if (kind == 2 && flavour == Flavour::small_ints) {
        for (F& x : points[corner]) x = std::round(x);
      }
    }
  }
  scene::SlabSet<F> set;
  for (std::size_t k = 0; k < 7; ++k) {
    const auto& n = scene::kSlabNormals[k];
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const F x = F(n[0]) * points[i][0], y = F(n[1]) * points[i][1], z = F(n[2]) * points[i][2];
      const F low = sum_towards(-1, x, y, z), high = sum_towards(1, x, y, z);
      set.lo[k] = i == 0 ? low : std::min(set.lo[k], low);
      set.hi[k] = i == 0 ? high : std::max(set.hi[k], high);
    }
    if (random.chance(0.15)) {
      const F width = to_unit(set.hi[k] / 2 - set.lo[k] / 2, unit);
      if (std::isfinite(set.hi[k] + width)) set.hi[k] += width;
      if (random.chance(0.5) && std::isfinite(set.lo[k] - width)) set.lo[k] -= width;
    }
  }
  return set;
}

template Spanned<float> spanned_about(CaseRandom&, const scene::Box<float>&, Flavour, float);
template Spanned<double> spanned_about(CaseRandom&, const scene::Box<double>&, Flavour, double);
template scene::SlabSet<float> slabs_about(CaseRandom&, const scene::Box<float>&, Flavour, float);
template scene::SlabSet<double> slabs_about(CaseRandom&, const scene::Box<double>&, Flavour, double);

}  // namespace gnomon::fuzz
