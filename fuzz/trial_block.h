// SPDX-License-Identifier: GPL-3.0-or-later
// One block of trials: made, referred, answered, judged. Each thread has a block of its own; nothing is
// allocated per trial.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "fuzz/generator.h"
#include "fuzz/shaft_questions.h"
#include "fuzz/tally.h"
#include "fuzz/thread_time.h"
#include "fuzz/volume_questions.h"

namespace gnomon::fuzz {

template <class Q>
class TrialBlock {
 public:
  static constexpr std::size_t kSize = 1024;
  using Case = typename Q::Case;

  TrialBlock(std::uint64_t seed, std::uint32_t stream, std::uint64_t per_shaft, scene::Scalar scalar,
             std::size_t keep)
      : seed_(seed),
        stream_(stream),
        per_shaft_(per_shaft),
        scalar_(scalar),
        keep_(keep),
        cases_(kSize),
        narrow_(kSize),
        references_(kSize),
        answers_(kSize) {}

  /// Makes and refers the trials first .. first+count-1.
  void fill(const Generator<Case>& generator, std::uint64_t first, std::size_t count) {
    first_ = first;
    count_ = count;
    for (std::size_t i = 0; i < count; ++i) {
      CaseRandom random(seed_, stream_, first + i, per_shaft_);
      cases_[i] = generator.make(random);
    }
    if (scalar_ == scene::Scalar::f32) {
      for (std::size_t i = 0; i < count; ++i) narrow_[i] = scene::converted<float>(cases_[i]);
    }
    const double start = thread_ns();
    in_rationals_ += exact::refer(std::span(cases_).first(count), std::span(references_).first(count));
    reference_ns_ += thread_ns() - start;
  }

  /// Runs one method on the block and adds what comes of it.
  void run(const Method<Q>& method, Tally& tally) {
    const double start = thread_ns();
    const double elsewhere = answer(method);
    // Of a method in a process of its own, handing over cases and answers does not count.
    tally.ns += elsewhere > 0 ? elsewhere : thread_ns() - start;
    elsewhere_ns_ += elsewhere;
    tally.trials += count_;
    for (std::size_t i = 0; i < count_; ++i) judge(method, i, tally);
  }

  [[nodiscard]] double reference_ns() const { return reference_ns_; }
  /// Processor time of methods that run in other processes.
  [[nodiscard]] double elsewhere_ns() const { return elsewhere_ns_; }
  [[nodiscard]] std::uint64_t in_rationals() const { return in_rationals_; }

 private:
  /// Returns the processor time that was spent in other processes.
  double answer(const Method<Q>& method) {
    double elsewhere = 0;
    const std::span<Answer> answers = std::span(answers_).first(count_);
    if (method.has(scalar_)) {
      if (scalar_ == scene::Scalar::f32) {
        elsewhere = method.run_f32(std::span(narrow_).first(count_), answers);
      } else {
        elsewhere = method.run_f64(std::span(cases_).first(count_), answers);
      }
    } else if (method.run_f64 != nullptr) {  // floats are doubles
      elsewhere = method.run_f64(std::span(cases_).first(count_), answers);
    } else {  // doubles that are floats; others are outside of the method's domain
      for (std::size_t i = 0; i < count_; ++i) {
        answers[i] = kRejected;
        if (!is_single(cases_[i])) continue;
        narrow_[i] = scene::converted<float>(cases_[i]);
        elsewhere += method.run_f32(std::span(narrow_).subspan(i, 1), answers.subspan(i, 1));
      }
    }
    return elsewhere;
  }

  void judge(const Method<Q>& method, std::size_t i, Tally& tally) {
    const typename Q::Reference& reference = references_[i];
    const Answer given = answers_[i];
    ++tally.matrix[static_cast<std::size_t>(reference.truth)][given];
    tally.touching_outside += reference.touches_outside;
    tally.touching_inside += reference.touches_inside;
    if (given >= kTruths) return;  // undecided, rejected: no answer to compare
    const scene::Category twin = answer_of(method.twin, reference);
    const bool rounded = given != static_cast<Answer>(twin), modelled = twin != reference.truth;
    const bool known = method.twin != Twin::unknown;
    tally.rounding += known && rounded && !modelled;
    tally.model += known && modelled && !rounded;
    tally.rounding_and_model += known && rounded && modelled;
    if (rounded) check_threshold(method, i, twin, given, tally);
    if (given != static_cast<Answer>(reference.truth)) record(i, given, tally);
  }

  void record(std::size_t i, Answer given, Tally& tally) {
    const typename Q::Reference& reference = references_[i];
    const Fault fault = Q::fault(reference.truth, given);
    const bool unsound = Q::judge(reference.truth, given) == Verdict::unsound;
    tally.unsound_touching += unsound && (reference.touches_outside || reference.touches_inside);
    tally.faults[static_cast<std::size_t>(fault)].offer(first_ + i, keep_);
    const exact::Boundary boundary = Q::boundary(fault);
    if (tally.largest.may_exceed(exact::gap_bound(cases_[i], boundary))) {
      tally.largest.offer(exact::gap(cases_[i], boundary), first_ + i);
    }
  }

  /// A certified method may say overlap where its twin knows better, but only within its stated threshold.
  void check_threshold(const Method<Q>& method, std::size_t i, scene::Category twin, Answer given,
                       Tally& tally) {
    if (method.stated_gap_f32 == nullptr && method.stated_gap_f64 == nullptr) return;
    if (given != static_cast<Answer>(scene::Category::overlap)) return;
    const double growth = method.stated_gap_f32 != nullptr
                              ? method.stated_gap_f32(scene::converted<float>(cases_[i]))
                              : method.stated_gap_f64(cases_[i]);
    ++tally.threshold_checked;
    tally.threshold_exceeded += exact::classify_grown(cases_[i], growth) == twin;
  }

  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t per_shaft_;
  scene::Scalar scalar_;
  std::size_t keep_;
  std::vector<Case> cases_;
  std::vector<typename Q::template CaseOf<float>> narrow_;
  std::vector<typename Q::Reference> references_;
  std::vector<Answer> answers_;
  std::uint64_t first_ = 0;
  std::size_t count_ = 0;
  double reference_ns_ = 0, elsewhere_ns_ = 0;
  std::uint64_t in_rationals_ = 0;
};

}  // namespace gnomon::fuzz
