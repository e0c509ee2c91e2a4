// SPDX-License-Identifier: MIT
// Boxes that are not axis-aligned.
#pragma once

#include <array>

#include "scene/centre_and_axes.h"

namespace gnomon::scene {

/// The closed set of all points centre + t0 axes[0] + t1 axes[1] + t2 axes[2] with |t_i| <= 1. The axes are
/// half edges as they are: neither orthogonal nor independent, so that parallelepipeds, parallelograms,
/// segments and points are oriented boxes too.
template <class F>
struct OrientedBox {
  std::array<F, 3> centre{};
  std::array<std::array<F, 3>, 3> axes{};

  friend bool operator==(const OrientedBox&, const OrientedBox&) = default;
};

}  // namespace gnomon::scene
