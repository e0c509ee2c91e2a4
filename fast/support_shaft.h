// SPDX-License-Identifier: MIT
// A shaft for volumes that are known by how far they reach in a direction: sides of the extent box and planes
// alike, as half-spaces with normals of three components.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fast/shaft.h"

namespace gnomon::fast {

/// The closed half-space n.x + d <= 0.
template <class F>
struct SupportPlane {
  std::array<F, 3> n;
  F d;
  F base;    ///< sum |n_j a_j|, a the point that d was made from: its share of what rounding is measured by
  F length;  ///< |n_x| + |n_y| + |n_z|
};

/// Sides of the extent box first, then the plane set: 6 to 14 half-spaces whose intersection is the shaft.
template <class F>
struct SupportShaft {
  scene::Box<F> a, b;
  std::array<SupportPlane<F>, 14> plane_set;
  std::uint8_t plane_count = 0;

  [[nodiscard]] std::span<const SupportPlane<F>> planes() const { return {plane_set.data(), plane_count}; }
};

/// Forms the shaft between two valid boxes. Normals are those of the paper's planes times a power of two that
/// brings them to a length of 1 to 4, so that products of them neither overflow nor vanish early; where that
/// would lose digits they stay as they are.
template <class F>
[[nodiscard]] SupportShaft<F> form_support_shaft(const scene::Box<F>& a, const scene::Box<F>& b);

/// Sums of products above this may overflow on the way.
template <class F>
constexpr F kLargestSafeSum = std::numeric_limits<F>::max() / 256;

/// Do rounded values decide as they are, or only where their proved error lets them?
enum class Rigour : std::uint8_t { naive, certified };

}  // namespace gnomon::fast
