// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `shaft-candidates` and `patch-pair` that fast::PairCaster answers.
#pragma once

#include <span>

#include "fuzz/pair_method.h"

namespace gnomon::fuzz {

[[nodiscard]] std::span<const CandidateMethod> caster_candidate_rows();
[[nodiscard]] std::span<const PairMethod> caster_pair_rows();

}  // namespace gnomon::fuzz
