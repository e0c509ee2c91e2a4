// SPDX-License-Identifier: GPL-3.0-or-later
// Disagreements about pairs, shrunk.
#pragma once

#include <cstddef>

#include "fuzz/pair_question.h"
#include "fuzz/pair_source.h"
#include "fuzz/row_result.h"

namespace gnomon::fuzz {

/// One trial outside of a campaign: the scene's own structures, made for it alone.
template <class Q>
[[nodiscard]] PairJudgement try_pair(const typename Q::Method& method, const scene::Scene& scene,
                                     const typename Q::Query& query);

/// Shrinks a case on which the method has the fault of that number (of the question's words): leaves out
/// every face that can go, then makes the numbers simpler as shrink() does; all stay floats, and the method
/// keeps the fault. The faces become one object. Name, distribution, seed and trial are left for the caller
/// to fill in. Throws MethodFailure when the method does not have the fault on the case so.
template <class Q>
[[nodiscard]] Witness make_pair_witness(const typename Q::Method& method, const scene::Scene& scene,
                                        const typename Q::Query& query, std::size_t fault);

}  // namespace gnomon::fuzz
