// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes and balls about a pair, and faces made of them. Internal to fuzz/*_drafts.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "fuzz/generator.h"
#include "fuzz/pair_drafts.h"

namespace gnomon::fuzz::drafts {

using Box = scene::Box<double>;
using Point = std::array<double, 3>;
using Corners = std::array<Point, 3>;

/// The boxes and balls of one trial: a shaft, and what lies about it.
struct Shapes {
  Box a, b;
  std::vector<Box> boxes;
  std::vector<scene::Ball<double>> balls;
};

/// The shapes of one trial, each from a sequence of its own.
[[nodiscard]] Shapes draw_shapes(const ShaftStyle& style, const TrialId& id, std::size_t boxes,
                                 std::size_t balls);
/// The trial's other draws: what is made of the shapes.
[[nodiscard]] CaseRandom own_random(const TrialId& id);

/// The nearest float; of what lies beyond all, the last.
[[nodiscard]] double to_float(double x);
/// Corner number `which` of 0 .. 7.
[[nodiscard]] Point corner_of(const Box& box, int which);
/// A point of floats in the box.
[[nodiscard]] Point point_in(CaseRandom& random, const Box& box);
/// Three different corners of the box.
[[nodiscard]] Corners three_corners(CaseRandom& random, const Box& box);
/// A triangle of box number j, or from it to others.
[[nodiscard]] Corners face_of(CaseRandom& random, const ShaftStyle& style, const Shapes& shapes,
                              std::size_t j);

}  // namespace gnomon::fuzz::drafts
