// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of `shaft-candidates` that are the paper's candidate lists.
#pragma once

#include <memory>
#include <span>

#include "fuzz/list_options_text.h"
#include "fuzz/pair_method.h"

namespace gnomon::fuzz {

/// Finds the faces of the list between the two boxes, the first being the emitter's, by the setup's tree over
/// the scene's polygons (exact::polygons_of()). Nothing is known of polygons that send or receive, so no
/// planes, back faces or own faces are left out. The scene must be of floats. Throws std::runtime_error for
/// balls that reach beyond floats.
[[nodiscard]] std::unique_ptr<CandidateFinder> make_list_finder(const scene::Scene& scene,
                                                                const ListSetup& setup);

/// A naive and a certified row for each strategy, and for spheres as bounding volumes.
[[nodiscard]] std::span<const CandidateMethod> list_candidate_rows();

}  // namespace gnomon::fuzz
