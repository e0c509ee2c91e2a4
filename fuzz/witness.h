// SPDX-License-Identifier: GPL-3.0-or-later
// Witnesses: disagreements shrunk and saved so that anybody can replay them.
#pragma once

#include <string>

#include "fuzz/row_result.h"
#include "fuzz/volume_questions.h"

namespace gnomon::fuzz {

/// One trial outside of a campaign.
struct Trial {
  scene::Category truth;
  scene::Category twin;
  bool touches_outside, touches_inside;
  Answer answer;
  Verdict verdict;
};

/// Runs one method on one valid case, in the precision that fits: `scalar` says which numbers the case has.
template <class Q>
[[nodiscard]] Trial try_case(const Method<Q>& method, scene::Scalar scalar, const typename Q::Case& c);

enum class Shrinking : std::uint8_t { on, off };

/// Shrinks a case on which the method disagrees with the truth, keeping the fault, and whether the exact twin
/// shares it (model) or not (rounding). Name, distribution, seed and trial are left for the caller to fill
/// in. Throws MethodFailure when the method fails on the case or on a simpler one.
template <class Q>
[[nodiscard]] Witness make_witness(const Method<Q>& method, scene::Scalar scalar, const typename Q::Case& c,
                                   Shrinking shrinking = Shrinking::on);

/// "shaft-box.naive-f32.false-cull.offset.f32.1.123.txt": safe as a file name.
[[nodiscard]] std::string witness_name(const Witness& witness);

/// The witness as a file: comments in words, then its corpus line.
[[nodiscard]] std::string witness_text(const Witness& witness);

/// The name of an answer, also of undecided and rejected.
[[nodiscard]] std::string_view answer_name(Answer answer);

}  // namespace gnomon::fuzz
