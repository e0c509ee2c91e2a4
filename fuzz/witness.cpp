// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/witness.h"

#include <array>

#include "fuzz/shrink.h"
#include "scene/corpus.h"
#include "scene/float_text.h"

namespace gnomon::fuzz {

namespace {

/// The shaft questions list coordinates as x y z x y z ...; the last number of a ball is its radius. The axes
/// of oriented boxes and ellipsoids are directions, and bounds of slabs mix coordinates: neither moves with
/// the boxes.
template <class Q>
int axis_of_number(std::size_t i) {
  if constexpr (std::is_same_v<Q, ShaftSlabsQuestion>) {
    // The bounds of the first three slabs are coordinates; those of the others hold the set together.
    return i < 15 ? static_cast<int>(i % 3) : i >= 19 && i < 22 ? static_cast<int>(i - 19) : -1;
  }
  if constexpr (Q::number_count == 24) return i < 15 ? static_cast<int>(i % 3) : -1;
  return i + 1 == Q::number_count && Q::number_count % 3 == 1 ? -1 : static_cast<int>(i % 3);
}

}  // namespace

std::string_view answer_name(Answer answer) {
  constexpr std::array<std::string_view, kColumns> names{"outside", "overlap", "inside", "undecided",
                                                         "rejected"};
  return names[answer];
}

template <class Q>
Trial try_case(const Method<Q>& method, scene::Scalar scalar, const typename Q::Case& c) {
  using Narrow = typename Q::template CaseOf<float>;
  typename Q::Reference reference;
  exact::refer(std::span(&c, 1), std::span(&reference, 1));
  Answer answer = kRejected;
  const bool as_float = method.run_f32 != nullptr && is_single(c) &&
                        (scalar == scene::Scalar::f32 || method.run_f64 == nullptr);
  if (as_float) {
    const Narrow narrow = scene::converted<float>(c);
    method.run_f32(std::span(&narrow, 1), std::span(&answer, 1));
  } else if (method.run_f64 != nullptr) {
    method.run_f64(std::span(&c, 1), std::span(&answer, 1));
  }
  return {
      reference.truth, answer_of(method.twin, reference), reference.touches_outside, reference.touches_inside,
      answer,          Q::judge(reference.truth, answer)};
}

template <class Q>
Witness make_witness(const Method<Q>& method, scene::Scalar scalar, const typename Q::Case& c,
                     Shrinking shrinking) {
  const Trial original = try_case(method, scalar, c);
  const Fault fault = Q::fault(original.truth, original.answer);
  const bool by_model = static_cast<Answer>(original.twin) == original.answer;
  const StillFails still_fails = [&](const std::vector<double>& numbers) {
    const typename Q::Case candidate = case_of<typename Q::Case>(numbers);
    if (objection(candidate)) return false;
    const Trial trial = try_case(method, scalar, candidate);
    return (trial.verdict == Verdict::unsound || trial.verdict == Verdict::waste) &&
           Q::fault(trial.truth, trial.answer) == fault &&
           (static_cast<Answer>(trial.twin) == trial.answer) == by_model;
  };
  const std::vector<double> numbers = shrinking == Shrinking::on
                                          ? shrink(numbers_of(c), scalar, axis_of_number<Q>, still_fails)
                                          : numbers_of(c);
  const typename Q::Case small = case_of<typename Q::Case>(numbers);
  const Trial trial = try_case(method, scalar, small);

  Witness witness;
  witness.question = Q::id;
  witness.method = method.name;
  witness.scalar = name_of(scalar);
  witness.verdict = name_of(fault);
  witness.answer = answer_name(trial.answer);
  witness.reference = name_of(trial.truth);
  witness.case_text = scene::corpus_text(Q::id, numbers, witness.reference);
  witness.original_text = scene::corpus_text(Q::id, numbers_of(c), name_of(original.truth));
  witness.gap = exact::gap(small, Q::boundary(fault));
  witness.gap_length = gap_length(small, witness.gap, Q::boundary(fault));
  witness.gap_ulps = witness.gap_length / scene::ulp_of(largest_number(small), scalar);
  return witness;
}

std::string witness_name(const Witness& witness) {
  std::string name = witness.question + "." + witness.method + "." + witness.verdict + "." +
                     witness.distribution + "." + witness.scalar + "." + std::to_string(witness.seed) + "." +
                     std::to_string(witness.trial) + ".txt";
  for (char& c : name) {
    const bool safe =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    if (!safe) c = '-';
  }
  return name;
}

std::string witness_text(const Witness& witness) {
  std::string text;
  text += "# gnomon witness: " + witness.verdict + " by " + witness.method + " on " + witness.question + "\n";
  text += "# method " + witness.method + " answers " + witness.answer + "; exactly it is " +
          witness.reference + "\n";
  text += "# scalar " + witness.scalar + ", distribution " + witness.distribution + ", seed " +
          std::to_string(witness.seed) + ", trial " + std::to_string(witness.trial) + "\n";
  if (witness.has_gap) {
    text += "# exact gap " + witness.gap.get_str() + " (length " + scene::decimal_text(witness.gap_length) +
            ", " + scene::decimal_text(witness.gap_ulps) + " ulps)\n";
  }
  // Of scenes the faces that matter alone.
  text += std::string(witness.has_gap ? "# as generated: " : "# before its numbers were made simpler: ") +
          witness.original_text + "\n";
  text += witness.case_text + "\n";
  return text;
}

template Trial try_case(const Method<ShaftBoxQuestion>&, scene::Scalar, const scene::ShaftBoxCase&);
template Trial try_case(const Method<ShaftBallQuestion>&, scene::Scalar, const scene::ShaftBallCase&);
template Trial try_case(const Method<ShaftSlabsQuestion>&, scene::Scalar, const scene::ShaftSlabsCase&);
template Trial try_case(const Method<ShaftOrientedBoxQuestion>&, scene::Scalar,
                        const scene::ShaftOrientedBoxCase&);
template Trial try_case(const Method<ShaftEllipsoidQuestion>&, scene::Scalar,
                        const scene::ShaftEllipsoidCase&);
template Witness make_witness(const Method<ShaftSlabsQuestion>&, scene::Scalar, const scene::ShaftSlabsCase&,
                              Shrinking);
template Witness make_witness(const Method<ShaftOrientedBoxQuestion>&, scene::Scalar,
                              const scene::ShaftOrientedBoxCase&, Shrinking);
template Witness make_witness(const Method<ShaftEllipsoidQuestion>&, scene::Scalar,
                              const scene::ShaftEllipsoidCase&, Shrinking);
template Witness make_witness(const Method<ShaftBoxQuestion>&, scene::Scalar, const scene::ShaftBoxCase&,
                              Shrinking);
template Witness make_witness(const Method<ShaftBallQuestion>&, scene::Scalar, const scene::ShaftBallCase&,
                              Shrinking);

}  // namespace gnomon::fuzz
