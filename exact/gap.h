// SPDX-License-Identifier: GPL-3.0-or-later
// How far a case is from a decision boundary, as an exact rational.
#pragma once

#include <gmpxx.h>

#include <cstdint>

namespace gnomon::exact {

/// The two decision boundaries of the shaft questions: between outside and overlap, and between overlap and
/// inside.
enum class Boundary : std::uint8_t { outside, inside };

/// Positive on the far side of the boundary (outside; not inside), zero when touching, else negative. For
/// boxes a length: by how much t must grow (positive outside gap) or shrink on all sides to touch. For balls
/// a length squared.
using Gap = mpq_class;

}  // namespace gnomon::exact
