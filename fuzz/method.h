// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the registry: a method, what it promises, and how to run it.
#pragma once

#include <cstddef>
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

/// True when so many unsound answers, or so many cases without an answer, break the promise.
[[nodiscard]] constexpr bool is_broken(Promise promise, std::uint64_t unsound, std::uint64_t unanswered) {
  switch (promise) {
    case Promise::none:
      return false;
    case Promise::never_unsound:
      return unsound > 0;
    case Promise::always_agrees:
      return unsound > 0 || unanswered > 0;
  }
  return false;
}

/// The exact twin of a method: the same algorithm in exact arithmetic. A plug-in's is unknown: its errors are
/// not told apart into rounding and model.
enum class Twin : std::uint8_t { always_overlap, printed, planes, separating, truth, unknown };

/// A method that is more than a function: a plug-in's. Several threads may run it at once.
template <class Case>
class Runner {
 public:
  Runner() = default;
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;
  virtual ~Runner() = default;
  /// Answers each of the cases. Returns the nanoseconds of processor time that it took in other processes.
  /// Throws MethodFailure when there are no answers.
  virtual double run(std::span<const Case> cases, std::span<Answer> answers) const = 0;
};

/// How a row answers a batch: by a function, by a runner that outlives the row, or not at all (null).
template <class Case>
class Run {
 public:
  using Function = void (*)(std::span<const Case>, std::span<Answer>);
  constexpr Run(std::nullptr_t = nullptr) {}  // NOLINT(google-explicit-constructor): rows are tables
  constexpr Run(Function function) : function_(function) {}       // NOLINT(google-explicit-constructor)
  constexpr Run(const Runner<Case>* runner) : runner_(runner) {}  // NOLINT(google-explicit-constructor)

  /// Returns the nanoseconds that were spent elsewhere; a function's are spent here.
  double operator()(std::span<const Case> cases, std::span<Answer> answers) const {
    if (runner_ != nullptr) return runner_->run(cases, answers);
    function_(cases, answers);
    return 0;
  }
  friend constexpr bool operator==(const Run& run, std::nullptr_t) {
    return run.function_ == nullptr && run.runner_ == nullptr;
  }

 private:
  Function function_ = nullptr;
  const Runner<Case>* runner_ = nullptr;
};

/// A method for the question Q. It has a form for floats, for doubles, or both; each answers a batch of valid
/// cases.
template <class Q>
struct Method {
  template <class F>
  using RunOf = Run<typename Q::template CaseOf<F>>;
  template <class F>
  using StatedGap = double (*)(const typename Q::template CaseOf<F>&);

  std::string_view name;
  std::string_view tier;  ///< trivial, naive, certified, exact; plug-in
  Promise promise;
  Twin twin;
  std::string_view domain;
  std::string_view summary;
  RunOf<float> run_f32 = nullptr;
  RunOf<double> run_f64 = nullptr;
  /// Certified methods only: growing t by this much must change the exact twin's answer wherever it was
  /// wasted.
  StatedGap<float> stated_gap_f32 = nullptr;
  StatedGap<double> stated_gap_f64 = nullptr;
  /// Made for many cases a shaft: without --method, asked only about distributions with @K.
  bool in_batches = false;

  /// Does the method have a form in this precision?
  [[nodiscard]] bool has(scene::Scalar scalar) const {
    return scalar == scene::Scalar::f32 ? run_f32 != nullptr : run_f64 != nullptr;
  }
};

/// The registry of a question, in the order of reports.
template <class Q>
[[nodiscard]] std::span<const Method<Q>> methods();

}  // namespace gnomon::fuzz
