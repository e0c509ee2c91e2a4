// SPDX-License-Identifier: MIT
// A segment or ray as the kernels of a Hierarchy want it. Internal to fast/hierarchy*.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "fast/hierarchy_bounds.h"
#include "fast/is_float.h"

namespace gnomon::fast {

/// True when all six numbers are floats of at most kMostMagnitude: never for a NaN.
[[nodiscard]] inline bool in_certified_domain(const std::array<double, 3>& a,
                                              const std::array<double, 3>& b) {
  // Magnitudes are ordered as their bits are. All six at once, and 0 apart from what lies below 2^-126, which
  // is rare and looked at one by one.
  constexpr auto kMost = std::bit_cast<std::uint64_t>(static_cast<double>(kMostMagnitude));
  constexpr auto kLeast = std::bit_cast<std::uint64_t>(0x1p-126);
  std::uint64_t all = 0;
  bool large = false, small = false;
  for (const auto* numbers : {&a, &b}) {
    for (const double x : *numbers) {
      const auto magnitude = std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63);
      all |= magnitude;
      large |= magnitude > kMost;
      small |= magnitude - 1 < kLeast - 1;
    }
  }
  if (large || (all & kBeyondFloat) != 0) return false;
  if (!small) return true;
  bool floats = true;
  for (std::size_t k = 0; k < 3; ++k) floats &= is_float(a[k]) && is_float(b[k]);
  return floats;
}

/// The points origin + t * direction.
///
/// SLABS. A box's slab on an axis with direction d > 0 holds the parameters from (lo - p) / d to (hi - p) /
/// d. The kernel computes near = (lo - near_origin) * near_inverse and far = (hi - far_origin) * far_inverse,
/// and visits the box when the largest near (and 0) is at most the smallest far (and the beam's end).
///
/// Naive beams have the origin itself and the inverse 1 / d. Certified ones are never wrong to skip a box,
/// also when d is the difference of two floats, rounded. Let s = 2^-80 be kOriginShift, and say the beam
/// meets the box at a parameter t within its range, so that near and far's exact values n <= t <= f.
///  - |d| >= 2^-81. near_origin = fl(p + s) and far_origin = fl(p - s). Rounding is monotone, so near is at
///    most what p itself would give. If lo - p >= 2^-81 no product is below 2^-81 * 2^-41, normal, and three
///    or four roundings (the difference, d, 1/d, the product) give near <= n (1 + u)^4. If lo - p <= 0, so is
///    near. In between |lo - p| < 2^-81 is not 0, so both are below 2^-57 (or their difference would be a
///    multiple of 2^-81), p + s is off by at most 2^-81, and lo - near_origin <= 0. In the same way far >=
///    f (1 - u)^4 * 12 u more: if hi - p is 0 or >= 2^-81 by the roundings (one more for the factor), else
///    because hi - far_origin >= 2^-81 > hi - p. And (1 + u)^4 <= (1 - u)^5 (1 + 12 u) (1 - u).
///  - |d| < 2^-81, 0 included: the whole segment lies within 2^-81 of p on this axis. The inverse is
///    infinite: near is +infinity when lo > fl(p + s), which is at least p + 2^-81 or p itself when p and lo
///    are multiples of 2^-80; else -infinity, or a NaN, which the kernel ignores. Far likewise. A ray leaves
///    that slab unless d = 0: its inverse is a NaN then, so that the kernel ignores the axis altogether.
/// The end 1 of a segment skips no box that it meets at a t < 1: lo lies before the light there, so that
/// fl(lo - near_origin) <= d, near <= fl(d fl(1 / d)) and that is at most 1, as fl(1 / d) < (1 + u) / d.
struct Beam {
  std::array<float, 3> origin, direction;
  std::array<float, 3> near_origin, far_origin, near_inverse, far_inverse;
  std::array<std::uint32_t, 3> near_row, far_row;  ///< of WideNode::bounds
  float largest;                                   ///< the largest magnitude of the direction
  float spread;  ///< min(2 largest, sum of magnitudes): |d_j| + |d_k| or more, j != k, but for a rounding

  /// `origin` and `direction` must be set: sets `largest` and `spread`, all that tests of single faces need.
  void measure() {
    float sum = 0;
    largest = 0;
    for (const float d : direction) {
      const float magnitude = d < 0 ? -d : d;
      largest = magnitude > largest ? magnitude : largest;
      sum += magnitude;
    }
    spread = sum < 2 * largest ? sum : 2 * largest;
  }

  /// Sets what tests of boxes need.
  template <bool kCertified>
  void prepare() {
    for (std::size_t k = 0; k < 3; ++k) {
      const float d = direction[k], magnitude = d < 0 ? -d : d;
      const bool up = !(d < 0) || (kCertified && magnitude < kLeastDirection);
      near_row[k] = static_cast<std::uint32_t>(up ? k : k + 3);
      far_row[k] = static_cast<std::uint32_t>(up ? k + 3 : k);
      if (kCertified) {
        const float shift = up ? kOriginShift : -kOriginShift;
        near_origin[k] = origin[k] + shift;
        far_origin[k] = origin[k] - shift;
        near_inverse[k] = magnitude < kLeastDirection ? std::numeric_limits<float>::infinity() : 1 / d;
        far_inverse[k] = near_inverse[k] * kFarFactor;
      } else {
        near_origin[k] = far_origin[k] = origin[k];
        near_inverse[k] = far_inverse[k] = 1 / (d == 0 ? 0.0f : d);
      }
    }
  }

  /// After prepare<true>(), for rays: axes of 0 < |d| < 2^-81 exclude no box.
  void leave_out_slow_axes() {
    for (std::size_t k = 0; k < 3; ++k) {
      const float d = direction[k];
      if (d == 0 || d >= kLeastDirection || d <= -kLeastDirection) continue;
      near_inverse[k] = far_inverse[k] = std::numeric_limits<float>::quiet_NaN();
    }
  }
};

}  // namespace gnomon::fast
