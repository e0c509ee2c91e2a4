// SPDX-License-Identifier: GPL-3.0-or-later
// The exact answers to `shaft-sphere`.
#pragma once

#include <cstdint>
#include <span>

#include "exact/gap.h"
#include "scene/category.h"
#include "scene/shaft_case.h"

namespace gnomon::exact {

/// Everything that is decided exactly about one case. Boxes and ball must be valid; any finite doubles.
struct ShaftBallReference {
  /// Geometric truth: outside when the least squared distance over s exceeds r^2; inside when the centre
  /// keeps r from every extent side and plane: v <= 0 and v^2 >= r^2 |n|^2.
  scene::Category truth;
  /// The paper's sphere test in exact arithmetic (v > 0 and v^2 > r^2 |n|^2), corrected and as printed.
  scene::Category planes, printed;
  bool touches_outside, touches_inside;
};

/// Answers every case: intervals first, rationals where they leave something open. Returns how many needed
/// rationals. The spans have one size. Sets the rounding mode for the time of the call and restores it.
std::uint64_t refer(std::span<const scene::ShaftBallCase> cases, std::span<ShaftBallReference> references);

/// The same for one case, in rationals alone.
[[nodiscard]] ShaftBallReference refer_in_rationals(const scene::ShaftBallCase& c);

/// The truth of one case: the exact predicate that the exact tier hands its undecided cases to.
[[nodiscard]] scene::Category classify(const scene::ShaftBallCase& c);

/// True when the ball has a point in common with the shaft: the truth is not `outside`.
[[nodiscard]] bool meets(const scene::ShaftBallCase& c);

/// The gap to a boundary, a squared length. Outside: d^2 - r^2, d the distance from the centre to the shaft.
/// Inside: the maximum over extent sides and planes of -(v^2 / |n|^2 - r^2) where v <= 0, and v^2 / |n|^2 +
/// r^2 where v > 0.
[[nodiscard]] Gap gap(const scene::ShaftBallCase& c, Boundary boundary);

/// An upper bound on |gap|, from intervals: infinity where they overflow.
[[nodiscard]] double gap_bound(const scene::ShaftBallCase& c, Boundary boundary);

/// The answer of the exact plane test after the radius has grown by `growth` >= 0, exactly.
[[nodiscard]] scene::Category classify_grown(const scene::ShaftBallCase& c, double growth);

}  // namespace gnomon::exact
