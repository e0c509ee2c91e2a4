// SPDX-License-Identifier: GPL-3.0-or-later
// Cases as the batch kernels of fast/ take them: consecutive ones that share a shaft, as arrays.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "fast/batch_ball.h"
#include "fast/batch_box.h"
#include "fuzz/verdict.h"
#include "scene/shaft_case.h"

namespace gnomon::fuzz {

/// The tiers that fast/batch_box.h and fast/batch_ball.h have.
enum class BatchTier : std::uint8_t { naive, certified, exact };

/// The boxes of consecutive cases, coordinate by coordinate.
template <class F>
class BoxRun {
 public:
  static constexpr std::size_t kMost = 256;  ///< 6 or 12 kB: they stay in the first-level cache

  void assign(std::span<const scene::ShaftBoxCaseOf<F>> cases) {
    count_ = cases.size();
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t i = 0; i < count_; ++i) numbers_[k][i] = cases[i].t.c[k];
    }
  }
  [[nodiscard]] fast::BoxesSoA<F> view() const {
    const auto& n = numbers_;
    return {{n[0].data(), n[1].data(), n[2].data()}, {n[3].data(), n[4].data(), n[5].data()}, count_};
  }

 private:
  std::array<std::array<F, kMost>, 6> numbers_;
  std::size_t count_ = 0;
};

/// The balls of consecutive cases, as BoxRun.
template <class F>
class BallRun {
 public:
  static constexpr std::size_t kMost = 256;

  void assign(std::span<const scene::ShaftBallCaseOf<F>> cases) {
    count_ = cases.size();
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t k = 0; k < 3; ++k) numbers_[k][i] = cases[i].t.centre[k];
      numbers_[3][i] = cases[i].t.radius;
    }
  }
  [[nodiscard]] fast::BallsSoA<F> view() const {
    const auto& n = numbers_;
    return {{n[0].data(), n[1].data(), n[2].data()}, n[3].data(), count_};
  }

 private:
  std::array<std::array<F, kMost>, 4> numbers_;
  std::size_t count_ = 0;
};

/// Cuts the cases into runs of equal shafts and calls answer(a, b, view, answers) for each. -0 equals 0: the
/// shaft is the same set.
template <class Run, class Case, class Answering>
void answer_in_runs(std::span<const Case> cases, std::span<Answer> answers, const Answering& answer) {
  Run run;
  for (std::size_t first = 0, end = 0; first < cases.size(); first = end) {
    const Case& head = cases[first];
    const std::size_t most = std::min(cases.size(), first + Run::kMost);
    for (end = first + 1; end < most && cases[end].a.c == head.a.c && cases[end].b.c == head.b.c;) ++end;
    run.assign(cases.subspan(first, end - first));
    answer(head.a, head.b, run.view(), answers.subspan(first, end - first));
  }
}

}  // namespace gnomon::fuzz
