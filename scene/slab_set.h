// SPDX-License-Identifier: MIT
// Slab sets (Kay, Kajiya: "Ray Tracing Complex Scenes", SIGGRAPH 1986).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace gnomon::scene {

/// The seven plane-set normals of Kay and Kajiya: the axes, then the diagonals (+-1, +-1, 1), as small
/// integers.
inline constexpr std::array<std::array<int, 3>, 7> kSlabNormals{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, -1, 1}}};

/// The closed set of all points x with lo[k] <= n_k.x <= hi[k] for the seven normals n_k. Flat sets and
/// points are slab sets too. The bounds need not be tight; some leave no point at all although lo <= hi.
template <class F>
struct SlabSet {
  std::array<F, 7> lo{}, hi{};

  friend bool operator==(const SlabSet&, const SlabSet&) = default;
};

/// True when every bound is finite and lo <= hi in each slab. The set may still be empty.
template <class F>
[[nodiscard]] bool is_valid(const SlabSet<F>& t) {
  for (std::size_t k = 0; k < 7; ++k) {
    if (!std::isfinite(t.lo[k]) || !std::isfinite(t.hi[k]) || !(t.lo[k] <= t.hi[k])) return false;
  }
  return true;
}

/// The set with its bounds converted: widening is exact, narrowing needs numbers that are floats.
template <class To, class From>
[[nodiscard]] SlabSet<To> converted(const SlabSet<From>& t) {
  SlabSet<To> result;
  for (std::size_t k = 0; k < 7; ++k) {
    result.lo[k] = static_cast<To>(t.lo[k]);
    result.hi[k] = static_cast<To>(t.hi[k]);
  }
  return result;
}

}  // namespace gnomon::scene
