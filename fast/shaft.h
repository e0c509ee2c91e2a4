// SPDX-License-Identifier: MIT
// The shaft between two boxes: extent box and plane set (Haines, Wallace: "Forming the Testing Structure").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fast/strict_float.h"
#include "scene/box.h"

namespace gnomon::fast {

/// A coordinate type of the paper's lists, as the offset of the coordinate in Box::c: 0..2 are MIN_X, MIN_Y,
/// MIN_Z, 3..5 are MAX_X, MAX_Y, MAX_Z.
using Face = std::uint8_t;

[[nodiscard]] constexpr int axis_of(Face face) {
  return face % 3;
}
[[nodiscard]] constexpr bool is_max(Face face) {
  return face >= 3;
}
/// near = (far + 3) mod 6, and the other way round (claim S5).
[[nodiscard]] constexpr Face opposite(Face face) {
  return static_cast<Face>((face + 3) % 6);
}

/// The paper's two lists: on which faces of the extent box is `a`, or `b`, strictly the extreme one. A face
/// on which both are equal is on neither list.
struct ExtremeLists {
  std::array<Face, 6> of_a{}, of_b{};
  std::uint8_t count_a = 0, count_b = 0;
};

template <class F>
[[nodiscard]] ExtremeLists extreme_lists(const scene::Box<F>& a, const scene::Box<F>& b);

/// One plane of the plane set: the closed half-space n0 x + n1 y + d <= 0, where x and y are the coordinates
/// on the axes of `far0` and `far1`; the third component of the normal is 0. The plane joins the edge of `a`
/// that lies on its faces far0 and far1 with that of `b`.
template <class F>
struct ShaftPlane {
  F n0, n1, d;
  F outside_threshold;  ///< a near corner valued above it is outside; 0 in the naive tier
  F inside_threshold;   ///< a far corner valued at most this is within; 0 in the naive tier, NaN: never
  Face far0, far1;      ///< offsets of the far corner's coordinates in Box::c

  /// The paper's T, evaluated as ((n0 x) + (n1 y)) + d: the order that the error bounds are proved for.
  [[nodiscard]] F value(F x, F y) const { return (n0 * x + n1 * y) + d; }
  [[nodiscard]] F far_value(const scene::Box<F>& t) const { return value(t.c[far0], t.c[far1]); }
  [[nodiscard]] F near_value(const scene::Box<F>& t) const {
    return value(t.c[opposite(far0)], t.c[opposite(far1)]);
  }
  [[nodiscard]] F value_at(const std::array<F, 3>& p) const {
    return value(p[static_cast<std::size_t>(axis_of(far0))], p[static_cast<std::size_t>(axis_of(far1))]);
  }
};

/// How long the normals of the plane set are made.
enum class Normals : std::uint8_t {
  as_formed,  ///< differences of coordinates, as the paper's box test uses them
  unit,       ///< divided by their length, as the paper's sphere test needs them
};

/// What the sphere test adds to or multiplies into its comparisons; the naive values change nothing.
template <class F>
struct BallSlack {
  F square_factor = 1;  ///< on r^2 in the test against the extent box
  F square_offset = 0;
  F inside_factor = 1;  ///< on r where the ball is held against the sides of the extent box
  F largest_radius = std::numeric_limits<F>::infinity();  ///< above it only overlap is answered
};

/// The stated threshold of a certified shaft: when a wrong keep (or a wrong "overlap" of an inside one) is
/// answered, growing T by base + per_radius * r on all sides would make the exact answer change too. For a
/// radius whose square overflows nothing is stated: infinity.
template <class F>
struct StatedGap {
  F base = 0, per_radius = 0;

  [[nodiscard]] F at(F radius) const {
    return radius * radius <= std::numeric_limits<F>::max() / 2 ? base + per_radius * radius
                                                                : std::numeric_limits<F>::infinity();
  }
};

/// A shaft: convex hull of the boxes `a` and `b`, as extent box and 0 to 8 planes.
template <class F>
struct Shaft {
  scene::Box<F> a, b, extent;
  std::array<ShaftPlane<F>, 8> plane_set;
  std::uint8_t plane_count = 0;
  BallSlack<F> slack;
  StatedGap<F> stated_gap;

  [[nodiscard]] std::span<const ShaftPlane<F>> planes() const { return {plane_set.data(), plane_count}; }
  [[nodiscard]] std::span<ShaftPlane<F>> planes() { return {plane_set.data(), plane_count}; }
};

/// The least box around `a` and `b`; exact.
template <class F>
[[nodiscard]] scene::Box<F> extent_of(const scene::Box<F>& a, const scene::Box<F>& b);

/// Forms the shaft between `a` and `b` with all thresholds 0 (the naive tier). Both boxes must be valid
/// (scene::is_valid). Planes are formed from the edge of `a`, in the paper's arithmetic, in the precision F;
/// where differences of coordinates overflow, planes are infinite or NaN and the naive tests answer as such
/// floats do.
template <class F>
[[nodiscard]] Shaft<F> form_shaft(const scene::Box<F>& a, const scene::Box<F>& b, Normals normals);

}  // namespace gnomon::fast
