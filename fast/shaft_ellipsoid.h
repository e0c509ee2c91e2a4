// SPDX-License-Identifier: MIT
// Ellipsoids against a shaft (Haines, Wallace name them as future work).
#pragma once

#include "fast/banded.h"
#include "fast/support_shaft.h"
#include "scene/ellipsoid.h"

namespace gnomon::fast {

/// Ellipsoid `t` against the closed shaft by the shaft's sides and planes: near value n.c + d - |M^T n|, far
/// value with +. In real arithmetic it has no false culls and is exact for inside; it keeps ellipsoids that
/// lie beyond an edge or a corner of the shaft and not beyond one plane.
template <class F>
[[nodiscard]] Banded classify(const SupportShaft<F>& shaft, const scene::Ellipsoid<F>& t, Rigour rigour);

/// By how much t must grow on all sides for the exact test by planes to agree with the certified one.
template <class F>
[[nodiscard]] F stated_gap(const SupportShaft<F>& shaft, const scene::Ellipsoid<F>& t);

}  // namespace gnomon::fast
