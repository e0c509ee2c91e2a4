// SPDX-License-Identifier: GPL-3.0-or-later
// What the registry rows of the three volume questions have in common.
#pragma once

#include "fast/support_shaft.h"
#include "fuzz/volume_questions.h"

namespace gnomon::fuzz {

inline Answer to_answer(scene::Category category) {
  return static_cast<Answer>(category);
}

/// Rows of the question Q; Form makes the fast shaft of two boxes.
template <class Q, class Form>
struct VolumeRows {
  template <class F>
  using Case = typename Q::template CaseOf<F>;
  template <class F>
  using Cases = std::span<const Case<F>>;
  using Answers = std::span<Answer>;

  template <class F>
  static void trivial(Cases<F> cases, Answers answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) answers[i] = to_answer(scene::Category::overlap);
  }

  template <class F, fast::Rigour kRigour>
  static void by_planes(Cases<F> cases, Answers answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      answers[i] = to_answer(fast::classify(Form::make(cases[i].a, cases[i].b), cases[i].t, kRigour).answer);
    }
  }

  template <class F>
  static double stated_gap(const Case<F>& c) {
    return static_cast<double>(fast::stated_gap(Form::make(c.a, c.b), c.t));
  }

  template <class F>
  static void exact_tier(Cases<F> cases, Answers answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const auto shaft = Form::make(cases[i].a, cases[i].b);
      const fast::Banded banded = fast::classify(shaft, cases[i].t, fast::Rigour::certified);
      answers[i] =
          to_answer(banded.certain ? banded.answer : exact::classify(scene::converted<double>(cases[i])));
    }
  }
};

struct FormSupportShaft {
  template <class F>
  static fast::SupportShaft<F> make(const scene::Box<F>& a, const scene::Box<F>& b) {
    return fast::form_support_shaft(a, b);
  }
};

inline constexpr std::string_view kAllFloats = "all finite floats", kAllDoubles = "all finite doubles";

}  // namespace gnomon::fuzz
