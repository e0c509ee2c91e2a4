// SPDX-License-Identifier: MIT
// The constants of a Hierarchy's error bounds; the derivations stand where they are used. Internal to
// fast/hierarchy*.
#pragma once

#include "fast/strict_float.h"

namespace gnomon::fast {

/// The domain of the certified tier: floats of at most this magnitude. Products of three differences, summed
/// up, stay below 2^128 (fast/hierarchy_triangles_inl.h).
inline constexpr float kMostMagnitude = 0x1p40f;

/// How far origins are moved, and directions below which nothing is divided (fast/hierarchy_beam.h).
inline constexpr float kOriginShift = 0x1p-80f, kLeastDirection = 0x1p-81f;
/// What far planes' inverses are widened by.
inline constexpr float kFarFactor = 1 + 12 * Rounding<float>::u;

/// Rounded operations in an edge value, in a product with a normal, and in the third edge value as a multiple
/// of the first two's bound; underflow in all of them (fast/hierarchy_triangles_inl.h).
inline constexpr double kEdgeOperations = 8, kNormalOperations = 5;
inline constexpr float kThirdEdge = 2.6f, kTriangleUnderflow = 0x1p-104f;

/// Underflow, and the least d . d for which t0 means anything (fast/hierarchy_balls_inl.h).
inline constexpr float kBallUnderflow = 0x1p-100f, kLeastSquare = 0x1p-100f;
/// Underflow of a ray's parameter (both files).
inline constexpr float kParameterUnderflow = 0x1p-120f;
/// The box test of fast/hierarchy_beam.h says that a box which holds a point at parameter t is entered at
/// most at t (1 + u)^4.
inline constexpr float kLimitFactor = 1 + 8 * Rounding<float>::u;
/// Of an own ball's direction (fast/hierarchy_query.cpp).
inline constexpr float kBallWay = 5.2f * Rounding<float>::u;

}  // namespace gnomon::fast
