// SPDX-License-Identifier: MIT
// Oriented boxes against a shaft (Haines, Wallace name them as future work).
#pragma once

#include "fast/banded.h"
#include "fast/support_shaft.h"
#include "scene/oriented_box.h"

namespace gnomon::fast {

/// Oriented box `t` against the closed shaft by the shaft's sides and planes: near value n.c + d - sum
/// |n.u_i|, far value with +. In real arithmetic it has no false culls and is exact for inside; it keeps
/// boxes that only an axis across an edge of each, or a face of the box, tells from the shaft.
template <class F>
[[nodiscard]] Banded classify(const SupportShaft<F>& shaft, const scene::OrientedBox<F>& t, Rigour rigour);

/// Which further axes a test of separating axes takes.
enum class FurtherAxes : std::uint8_t {
  faces_and_box_edges,  ///< the box's face normals and u_i x e_j: the usual test for boxes
  all,                  ///< also u_i x (edge between both reference boxes): exact in real arithmetic
};

/// The same with further axes, in rounded arithmetic that promises nothing.
template <class F>
[[nodiscard]] scene::Category classify_separating(const SupportShaft<F>& shaft,
                                                  const scene::OrientedBox<F>& t, FurtherAxes axes);

/// By how much t must grow on all sides for the exact test by planes to agree with the certified one.
template <class F>
[[nodiscard]] F stated_gap(const SupportShaft<F>& shaft, const scene::OrientedBox<F>& t);

}  // namespace gnomon::fast
