// SPDX-License-Identifier: MIT
// Ellipsoids.
#pragma once

#include <array>

#include "scene/centre_and_axes.h"

namespace gnomon::scene {

/// The closed set of all points centre + M u with |u| <= 1, where M has the columns axes[0], axes[1],
/// axes[2]. They need not be the principal axes, nor independent: flat ellipses, segments and points are
/// ellipsoids too.
template <class F>
struct Ellipsoid {
  std::array<F, 3> centre{};
  std::array<std::array<F, 3>, 3> axes{};

  friend bool operator==(const Ellipsoid&, const Ellipsoid&) = default;
};

}  // namespace gnomon::scene
