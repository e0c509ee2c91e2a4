// SPDX-License-Identifier: MIT
// Kay and Kajiya's slab sets against a shaft (Haines, Wallace name them as future work).
#pragma once

#include "fast/banded.h"
#include "fast/support_shaft.h"
#include "scene/slab_set.h"

namespace gnomon::fast {

/// How often three of the seven normals are independent, padded to whole vectors by repeating one.
inline constexpr std::size_t kSlabBases = 32;

/// A shaft with, for each half-space, its normal as a combination of every three independent slab normals:
/// the greatest n.x over a slab set is the least of the bounds that the combinations give (duality of linear
/// programs). About 6 KB of floats, for shafts that are asked about many slab sets.
template <class F>
struct SlabShaft {
  SupportShaft<F> support;
  std::array<std::array<std::array<F, kSlabBases>, 3>, 14>
      weights;  ///< by half-space, place in the basis, basis
  std::array<F, 4> least{}, most{},
      magnitude{};  ///< the shaft's range along the diagonal normals; sum of |terms|
};

template <class F>
[[nodiscard]] SlabShaft<F> form_slab_shaft(const scene::Box<F>& a, const scene::Box<F>& b);

/// Slab set `t`, which must have a point, against the closed shaft: by the shaft's sides and planes, and by
/// t's own seven normals. In real arithmetic it has no false culls and is exact for inside; it keeps sets
/// that only an axis across an edge of each tells from the shaft. Naive: the answer alone means something;
/// certified: as for the other volumes.
template <class F>
[[nodiscard]] Banded classify(const SlabShaft<F>& shaft, const scene::SlabSet<F>& t, Rigour rigour);

/// By how much t must grow on all sides for the exact twin to agree with the certified test.
template <class F>
[[nodiscard]] F stated_gap(const SlabShaft<F>& shaft, const scene::SlabSet<F>& t);

}  // namespace gnomon::fast
