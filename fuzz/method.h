// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the registry: a method, what it promises, and how to run it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fuzz/verdict.h"
#include "scene/scalar.h"

namespace gnomon::fuzz {

enum class Promise : std::uint8_t { none, never_unsound, always_agrees };

[[nodiscard]] constexpr std::string_view name_of(Promise promise) {
  switch (promise) {
    case Promise::none:
      return "none";
    case Promise::never_unsound:
      return "never unsound";
    case Promise::always_agrees:
      return "always agrees";
  }
  return "?";
}

/// The exact twin of a method: the same algorithm in exact arithmetic.
enum class Twin : std::uint8_t { always_overlap, printed, planes, truth };

/// A method for the question Q. It has a form for floats, for doubles, or both; each answers a batch of valid
/// cases.
template <class Q>
struct Method {
  template <class F>
  using Run = void (*)(std::span<const typename Q::template CaseOf<F>>, std::span<Answer>);
  template <class F>
  using StatedGap = double (*)(const typename Q::template CaseOf<F>&);

  std::string_view name;
  std::string_view tier;  ///< trivial, naive, certified, exact
  Promise promise;
  Twin twin;
  std::string_view domain;
  std::string_view summary;
  Run<float> run_f32 = nullptr;
  Run<double> run_f64 = nullptr;
  /// Certified methods only: growing t by this much must change the exact twin's answer wherever it was
  /// wasted.
  StatedGap<float> stated_gap_f32 = nullptr;
  StatedGap<double> stated_gap_f64 = nullptr;

  /// Does the method have a form in this precision?
  [[nodiscard]] bool has(scene::Scalar scalar) const {
    return scalar == scene::Scalar::f32 ? run_f32 != nullptr : run_f64 != nullptr;
  }
};

/// The registry of a question, in the order of reports.
template <class Q>
[[nodiscard]] std::span<const Method<Q>> methods();

}  // namespace gnomon::fuzz
