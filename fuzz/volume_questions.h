// SPDX-License-Identifier: GPL-3.0-or-later
// The questions shaft-slabs, shaft-oriented-box and shaft-ellipsoid, as the trial loop sees them.
#pragma once

#include "exact/shaft_ellipsoid.h"
#include "exact/shaft_oriented_box.h"
#include "exact/shaft_slabs.h"
#include "fuzz/shaft_questions.h"
#include "scene/volume_case.h"

namespace gnomon::fuzz {

struct ShaftSlabsQuestion : ShaftAnswers {
  template <class F>
  using CaseOf = scene::ShaftSlabsCaseOf<F>;
  using Case = scene::ShaftSlabsCase;
  using Reference = exact::VolumeReference;
  static constexpr std::string_view id = "shaft-slabs";
  static constexpr std::size_t number_count = 26;
};

struct ShaftOrientedBoxQuestion : ShaftAnswers {
  template <class F>
  using CaseOf = scene::ShaftOrientedBoxCaseOf<F>;
  using Case = scene::ShaftOrientedBoxCase;
  using Reference = exact::VolumeReference;
  static constexpr std::string_view id = "shaft-oriented-box";
  static constexpr std::size_t number_count = 24;
};

struct ShaftEllipsoidQuestion : ShaftAnswers {
  template <class F>
  using CaseOf = scene::ShaftEllipsoidCaseOf<F>;
  using Case = scene::ShaftEllipsoidCase;
  using Reference = exact::VolumeReference;
  static constexpr std::string_view id = "shaft-ellipsoid";
  static constexpr std::size_t number_count = 24;
};

/// Calls `with` with a value of the question's type that has this id. Returns false when there is none.
template <class With>
bool for_volume_question(std::string_view id, const With& with) {
  if (id == ShaftSlabsQuestion::id) return with(ShaftSlabsQuestion{}), true;
  if (id == ShaftOrientedBoxQuestion::id) return with(ShaftOrientedBoxQuestion{}), true;
  if (id == ShaftEllipsoidQuestion::id) return with(ShaftEllipsoidQuestion{}), true;
  return false;
}

/// The numbers of a case in the order of the text corpus; case_of() goes back.
[[nodiscard]] std::vector<double> numbers_of(const scene::ShaftSlabsCase& c);
[[nodiscard]] std::vector<double> numbers_of(const scene::ShaftOrientedBoxCase& c);
[[nodiscard]] std::vector<double> numbers_of(const scene::ShaftEllipsoidCase& c);

/// Why a case is no instance of its question, or nothing when it is one. A slab set without a point is none.
[[nodiscard]] std::optional<std::string_view> objection(const scene::ShaftSlabsCase& c);
[[nodiscard]] std::optional<std::string_view> objection(const scene::ShaftOrientedBoxCase& c);
[[nodiscard]] std::optional<std::string_view> objection(const scene::ShaftEllipsoidCase& c);

/// True when all numbers are floats.
[[nodiscard]] bool is_single(const scene::ShaftSlabsCase& c);
[[nodiscard]] bool is_single(const scene::ShaftOrientedBoxCase& c);
[[nodiscard]] bool is_single(const scene::ShaftEllipsoidCase& c);

/// The largest magnitude among the numbers, whose ulp the gap is told in.
[[nodiscard]] double largest_number(const scene::ShaftSlabsCase& c);
[[nodiscard]] double largest_number(const scene::ShaftOrientedBoxCase& c);
[[nodiscard]] double largest_number(const scene::ShaftEllipsoidCase& c);

/// The gap as a length. Of polytopes it is one; of ellipsoids it is a pure number, told as that share of the
/// longest axis: near a boundary by how much that axis must grow or shrink to reach it.
[[nodiscard]] double gap_length(const scene::ShaftSlabsCase& c, const exact::Gap& gap,
                                exact::Boundary boundary);
[[nodiscard]] double gap_length(const scene::ShaftOrientedBoxCase& c, const exact::Gap& gap,
                                exact::Boundary boundary);
[[nodiscard]] double gap_length(const scene::ShaftEllipsoidCase& c, const exact::Gap& gap,
                                exact::Boundary boundary);

}  // namespace gnomon::fuzz
