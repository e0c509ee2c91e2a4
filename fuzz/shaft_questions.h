// SPDX-License-Identifier: GPL-3.0-or-later
// The questions shaft-box and shaft-sphere, as the trial loop sees them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "fuzz/method.h"
#include "scene/shaft_case.h"

namespace gnomon::fuzz {

/// What both shaft questions have in common: three answers, and what it means to be wrong.
struct ShaftAnswers {
  static constexpr std::array<std::string_view, 3> answers{"outside", "overlap", "inside"};

  [[nodiscard]] static Verdict judge(scene::Category truth, Answer answer);
  /// The way in which an answer that is waste or unsound is wrong.
  [[nodiscard]] static Fault fault(scene::Category truth, Answer answer);
  /// The boundary that a fault is on the wrong side of.
  [[nodiscard]] static exact::Boundary boundary(Fault fault);
};

struct ShaftBoxQuestion : ShaftAnswers {
  template <class F>
  using CaseOf = scene::ShaftBoxCaseOf<F>;
  using Case = scene::ShaftBoxCase;
  using Reference = exact::ShaftBoxReference;
  static constexpr std::string_view id = "shaft-box";
  static constexpr std::size_t number_count = 18;
};

struct ShaftBallQuestion : ShaftAnswers {
  template <class F>
  using CaseOf = scene::ShaftBallCaseOf<F>;
  using Case = scene::ShaftBallCase;
  using Reference = exact::ShaftBallReference;
  static constexpr std::string_view id = "shaft-sphere";
  static constexpr std::size_t number_count = 16;
};

/// The numbers of a case in the order of the text corpus, and back.
[[nodiscard]] std::vector<double> numbers_of(const scene::ShaftBoxCase& c);
[[nodiscard]] std::vector<double> numbers_of(const scene::ShaftBallCase& c);
template <class Case>
[[nodiscard]] Case case_of(std::span<const double> numbers);

/// Why a case is no instance of its question ("A: lo.x > hi.x"), or nothing when it is one.
[[nodiscard]] std::optional<std::string_view> objection(const scene::ShaftBoxCase& c);
[[nodiscard]] std::optional<std::string_view> objection(const scene::ShaftBallCase& c);

/// True when all numbers are floats.
[[nodiscard]] bool is_single(const scene::ShaftBoxCase& c);
[[nodiscard]] bool is_single(const scene::ShaftBallCase& c);

/// The largest magnitude among the numbers, whose ulp the gap is told in.
[[nodiscard]] double largest_number(const scene::ShaftBoxCase& c);
[[nodiscard]] double largest_number(const scene::ShaftBallCase& c);

/// The gap to a boundary as a length: of boxes it is one; of balls it is made of squares. Outside, d^2 - r^2
/// tells the length d - r. Inside, r^2 - x^2 tells r - x for a centre that keeps x from the deciding side,
/// and r^2 + x^2 tells r + x for one that lies x beyond it.
[[nodiscard]] double gap_length(const scene::ShaftBoxCase& c, const exact::Gap& gap,
                                exact::Boundary boundary);
[[nodiscard]] double gap_length(const scene::ShaftBallCase& c, const exact::Gap& gap,
                                exact::Boundary boundary);

/// The answer of a twin, which the reference knows; a twin that a question's rows do not have is the truth.
template <class Reference>
[[nodiscard]] scene::Category answer_of(Twin twin, const Reference& reference) {
  switch (twin) {
    case Twin::always_overlap:
      return scene::Category::overlap;
    case Twin::printed:
      if constexpr (requires { reference.printed; }) return reference.printed;
      break;
    case Twin::planes:
      return reference.planes;
    case Twin::separating:
      if constexpr (requires { reference.separating; }) return reference.separating;
      break;
    case Twin::truth:
    case Twin::unknown:
      return reference.truth;
  }
  return reference.truth;
}

}  // namespace gnomon::fuzz
