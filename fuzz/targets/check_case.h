// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that must hold of one shaft case; what does not is printed as a line of the text corpus.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/shaft_questions.h"
#include "fuzz/trial_block.h"
#include "scene/corpus.h"

namespace gnomon::fuzz {

template <class Q>
class CaseCheck {
 public:
  using Case = typename Q::Case;

  CaseCheck(const Case& c, scene::Scalar scalar) : case_(c), scalar_(scalar) {}

  /// Aborts when something does not hold.
  void run() const {
    expect(!objection(case_), "the decoder made no valid case");
    expect(scalar_ == scene::Scalar::f64 || is_single(case_), "the decoder made doubles for floats");
    const typename Q::Reference truth = references();
    gaps(truth);
    for (const Method<Q>& method : methods<Q>()) promises(method);
  }

 private:
  class Same final : public Generator<Case> {
   public:
    explicit Same(const Case& c) : case_(c) {}
    [[nodiscard]] Case make(CaseRandom&) const override { return case_; }

   private:
    const Case& case_;
  };

  void expect(bool holds, const std::string& what) const {
    if (holds) return;
    std::fprintf(stderr, "%s (%s):\n%s\n", what.c_str(), std::string(name_of(scalar_)).c_str(),
                 scene::corpus_text(Q::id, numbers_of(case_), "").c_str());
    std::abort();
  }

  /// Filtered and in rationals, and with A and B exchanged: all the same.
  [[nodiscard]] typename Q::Reference references() const {
    typename Q::Reference filtered, swapped;
    exact::refer(std::span(&case_, 1), std::span(&filtered, 1));
    const typename Q::Reference rational = exact::refer_in_rationals(case_);
    expect(filtered.truth == rational.truth && filtered.planes == rational.planes &&
               filtered.printed == rational.printed && filtered.touches_outside == rational.touches_outside &&
               filtered.touches_inside == rational.touches_inside,
           "the filtered reference differs from the rational one");
    expect(exact::classify(case_) == rational.truth, "classify() differs from refer()");
    const Case exchanged{case_.b, case_.a, case_.t};
    exact::refer(std::span(&exchanged, 1), std::span(&swapped, 1));
    expect(swapped.truth == rational.truth && swapped.planes == rational.planes &&
               swapped.touches_outside == rational.touches_outside &&
               swapped.touches_inside == rational.touches_inside,
           "the shaft from B to A differs from the one from A to B");
    if constexpr (std::is_same_v<Q, ShaftBoxQuestion>) {
      expect(rational.truth == rational.planes, "the planes differ from the slabs: the theorem fails");
    } else {
      expect(rational.planes == rational.truth || rational.planes == scene::Category::overlap,
             "the exact plane test of a ball is unsound");
    }
    return rational;
  }

  /// The gaps have the signs that the truth says, and lie within their bounds.
  void gaps(const typename Q::Reference& truth) const {
    const exact::Gap outside = exact::gap(case_, exact::Boundary::outside);
    const exact::Gap inside = exact::gap(case_, exact::Boundary::inside);
    expect((outside > 0) == (truth.truth == scene::Category::outside), "the outside gap has the wrong sign");
    expect((inside <= 0) == (truth.truth == scene::Category::inside), "the inside gap has the wrong sign");
    expect(!truth.touches_inside || inside == 0, "touches from within at a gap that is not 0");
    // A ball of radius 0 anywhere within the shaft has d^2 - r^2 = 0.
    const bool point_within = Q::id == "shaft-sphere" && numbers_of(case_).back() == 0;
    expect(outside != 0 || truth.touches_outside || point_within, "touches from outside and does not say so");
    for (const exact::Boundary boundary : {exact::Boundary::outside, exact::Boundary::inside}) {
      const exact::Gap& gap = boundary == exact::Boundary::outside ? outside : inside;
      const double bound = exact::gap_bound(case_, boundary), length = gap_length(case_, gap, boundary);
      expect(std::isinf(bound) || exact::Gap(abs(gap)) <= exact::Gap(bound), "the gap exceeds its bound");
      // Lengths below the least double vanish.
      expect(!std::isnan(length) && (gap <= 0 || length >= 0) && (gap >= 0 || length <= 0),
             "the gap's length has another sign");
    }
  }

  /// The trial loop itself, on a block of this one case.
  void promises(const Method<Q>& method) const {
    static TrialBlock<Q> singles(0, 0, 1, scene::Scalar::f32, 1), doubles(0, 0, 1, scene::Scalar::f64, 1);
    TrialBlock<Q>& block = scalar_ == scene::Scalar::f32 ? singles : doubles;
    block.fill(Same(case_), 0, 1);
    Tally tally;
    block.run(method, tally);
    RowResult row;
    row.promise = name_of(method.promise);
    row.matrix = tally.matrix;
    row.threshold_exceeded = tally.threshold_exceeded;
    expect(!row.promise_broken(), std::string(method.name) + " breaks its promise");
    expect(row.count(Verdict::undecided) == 0, std::string(method.name) + " does not decide");
    expect(row.count(Verdict::rejected) == 0 || !method.has(scalar_),
           std::string(method.name) + " rejects a case of its scalar");
  }

  const Case& case_;
  scene::Scalar scalar_;
};

}  // namespace gnomon::fuzz
