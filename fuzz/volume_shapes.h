// SPDX-License-Identifier: GPL-3.0-or-later
// Oriented boxes, ellipsoids and slab sets that take the place of a triple's third box. The rules of
// fuzz/shapes.h hold here, too.
#pragma once

#include "fuzz/shapes.h"
#include "scene/volume_case.h"

namespace gnomon::fuzz {

/// Which numbers a distribution wants its volumes to be made of.
enum class Flavour : std::uint8_t {
  rotated,     ///< t's half sides, turned; some sheared
  small_ints,  ///< integers
  degenerate,  ///< rotated or along the axes; axes that are 0, equal, parallel or coplanar
  mixed,       ///< each number a random share of t's half side
};

/// A centre and three axes.
template <class F>
struct Spanned {
  std::array<F, 3> centre{};
  std::array<std::array<F, 3>, 3> axes{};
};

/// The volume that takes t's place. Where t's numbers are multiples of `unit` > 0, so are the volume's.
template <class F>
[[nodiscard]] Spanned<F> spanned_about(CaseRandom& random, const scene::Box<F>& t, Flavour flavour, F unit);

/// The slab set around some points of t: its corners, those of a turned box, or four to six random ones.
/// Bounds are rounded outwards, so that the points lie in it exactly; now and then some slabs are wider than
/// the points.
template <class F>
[[nodiscard]] scene::SlabSet<F> slabs_about(CaseRandom& random, const scene::Box<F>& t, Flavour flavour,
                                            F unit);

}  // namespace gnomon::fuzz
