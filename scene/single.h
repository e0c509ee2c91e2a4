// SPDX-License-Identifier: MIT
// A scene whose numbers are floats.
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace gnomon::scene {

/// A scene and what became of its numbers when they were rounded to floats.
struct SingleScene {
  Scene scene;
  std::size_t moved = 0;   ///< points, balls and lights' positions or corners that were no floats
  std::size_t merged = 0;  ///< points that became equal to an earlier one: their index is gone
};

/// The scene with every coordinate and radius rounded to the nearest float, ties to even, so that methods in
/// single precision, in double precision and exact ones are asked about the same numbers. Faces, objects and
/// lights keep their numbers; points that become equal share an index again, and faces may degenerate. The
/// view is left as it is: it makes rays, and is no part of the geometry. The scene must be is_valid().
///
/// Throws std::runtime_error, with one line, when a number rounds to no finite float, or a ball's least or
/// greatest coordinate is beyond the range of floats.
[[nodiscard]] SingleScene rounded_to_floats(const Scene& scene);

}  // namespace gnomon::scene
