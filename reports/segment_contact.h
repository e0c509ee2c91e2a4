// SPDX-License-Identifier: GPL-3.0-or-later
// Where exactly a segment meets a face: rationals, as people are shown them.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>

#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::reports {

/// The t at which point + t * (light - point) lies in the plane of the triangle; nothing when the segment is
/// parallel to it, or the triangle or the segment degenerate.
[[nodiscard]] std::optional<mpq_class> plane_parameter(const scene::Scene& scene, std::uint32_t triangle,
                                                       const scene::ShadowQuery& query);

/// Where the closed segment comes nearest to a ball's centre.
struct NearestToCentre {
  mpq_class parameter;    ///< 0 to 1; 0 for equal point and light
  mpq_class squared_gap;  ///< the squared distance there, less the squared radius
};
[[nodiscard]] NearestToCentre nearest_to_centre(const scene::Ball<double>& ball,
                                                const scene::ShadowQuery& query);

}  // namespace gnomon::reports
