// SPDX-License-Identifier: MIT
#include "fast/shaft_ellipsoid.h"

#include "fast/shaft_spanned_inl.h"

namespace gnomon::fast {

using scene::Ellipsoid;

template <class F>
Banded classify(const SupportShaft<F>& shaft, const Ellipsoid<F>& t, Rigour rigour) {
  return rigour == Rigour::naive ? classify_spanned<EllipsoidReach, Rigour::naive>(shaft, t)
                                 : classify_spanned<EllipsoidReach, Rigour::certified>(shaft, t);
}

template <class F>
F stated_gap(const SupportShaft<F>& shaft, const Ellipsoid<F>& t) {
  // Squares that overflow make the reach infinite: nothing is stated there.
  const std::array<F, 3> magnitudes = magnitudes_of(t);
  const F sum = 2 * (magnitudes[0] + magnitudes[1] + magnitudes[2]);
  F longest = 1;
  for (const SupportPlane<F>& plane : shaft.planes()) longest = std::max(longest, plane.length);
  if (!(sum * longest * (sum * longest) < kLargestSafeSum<F>)) return std::numeric_limits<F>::infinity();
  return stated_gap_of<EllipsoidReach>(shaft, t);
}

template Banded classify(const SupportShaft<float>&, const Ellipsoid<float>&, Rigour);
template Banded classify(const SupportShaft<double>&, const Ellipsoid<double>&, Rigour);
template float stated_gap(const SupportShaft<float>&, const Ellipsoid<float>&);
template double stated_gap(const SupportShaft<double>&, const Ellipsoid<double>&);

}  // namespace gnomon::fast
