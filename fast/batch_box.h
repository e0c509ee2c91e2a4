// SPDX-License-Identifier: MIT
// One shaft against many boxes, in vector registers: the kernels of fast/shaft_box.h, and an exact tier.
//
// The widest instruction set that the processor has is chosen at run time (Google Highway). Every one of them
// gives the same bytes: products and sums are rounded one by one (-ffp-contract=off), fused operations are
// used only where they are exact by definition (error-free transforms).
#pragma once

#include <span>

#include "fast/batch_types.h"
#include "fast/shaft.h"

namespace gnomon::fast {

/// A shaft laid out for classify_boxes(): made once a shaft, from one with naive or certified thresholds.
template <class F>
class BatchBoxShaft {
 public:
  BatchBoxShaft(const Shaft<F>& shaft);  // NOLINT(google-explicit-constructor): the same shaft, rearranged

  struct Plane {
    F n0, n1, d, outside_threshold, inside_threshold;
    Face far0, far1;
  };
  scene::Box<F> extent;
  std::array<Plane, 8> planes;
  std::size_t plane_count;
};

/// answers[i] becomes 0 (outside), 1 (overlap) or 2 (inside): bit for bit what classify(shaft,
/// boxes[i]).answer of fast/shaft_box.h says, for every input, NaN and infinity included; the promise is the
/// shaft's. `answers` must hold boxes.count bytes.
template <class F>
void classify_boxes(const BatchBoxShaft<F>& shaft, const BoxesSoA<F>& boxes, std::span<std::uint8_t> answers);

/// The same as bit planes; without `answers.inside` the inside test is left out.
template <class F>
void classify_boxes(const BatchBoxShaft<F>& shaft, const BoxesSoA<F>& boxes, BitPlanes answers);

/// The shaft between two boxes laid out for classify_boxes_exact(), made once a shaft. Both boxes must be
/// valid (scene::is_valid). See batch_box_exact.cpp for what the members mean.
template <class F>
class ExactBoxShaft {
 public:
  ExactBoxShaft(const scene::Box<F>& a, const scene::Box<F>& b);

  /// One side of the moving box (1-s)a + sb: t's side at x has it at s = (x - at) * inverse.
  struct Side {
    F at, inverse;
    Face face;
  };
  /// A plane n0 (x - a_far0) + n1 (y - a_far1) <= 0; normals are sums high + low, exact.
  struct Plane {
    double n0_high, n0_low, n1_high, n1_low;
    Face far0, far1;
    std::uint8_t to, from;  ///< the indices of its two sides
  };
  scene::Box<F> extent;
  std::array<Side, 6> to, from;  ///< on faces where a is extreme: s <= ...; where b is: s >= ...
  std::array<Plane, 8> planes;
  std::size_t to_count = 0, from_count = 0, plane_count = 0;
  bool has_filter;      ///< the first stage's bound holds
  bool has_error_free;  ///< the second stage's products neither under- nor overflow on the shaft's side
};

/// The exact category of every valid box: a filter on s, then error-free transforms in double precision, both
/// in vector registers, then `predicate` for what is left. Ties are decided without it as long as coordinates
/// are floats of similar size. The answers for invalid boxes (NaN, infinity, lo > hi) are unspecified
/// categories.
template <class F>
BatchCounters classify_boxes_exact(const ExactBoxShaft<F>& shaft, const BoxesSoA<F>& boxes,
                                   std::span<std::uint8_t> answers, ExactPredicate<scene::Box<F>> predicate);

/// The same as bit planes; without `answers.inside` the inside test is left out.
template <class F>
BatchCounters classify_boxes_exact(const ExactBoxShaft<F>& shaft, const BoxesSoA<F>& boxes, BitPlanes answers,
                                   ExactPredicate<scene::Box<F>> predicate);

}  // namespace gnomon::fast
