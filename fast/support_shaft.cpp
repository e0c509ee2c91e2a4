// SPDX-License-Identifier: MIT
#include "fast/support_shaft.h"

#include <cmath>

namespace gnomon::fast {

namespace {

/// n0 and n1 times a power of two, exactly, with the larger one in [1, 2); unchanged where the smaller would
/// lose digits.
template <class F>
void bring_near_one(F& n0, F& n1) {
  const F larger = std::max(std::fabs(n0), std::fabs(n1));
  if (!std::isfinite(larger) || larger == 0) return;
  const int exponent = -std::ilogb(larger);
  const F scaled0 = std::scalbn(n0, exponent), scaled1 = std::scalbn(n1, exponent);
  if (std::scalbn(scaled0, -exponent) != n0 || std::scalbn(scaled1, -exponent) != n1) return;
  n0 = scaled0;
  n1 = scaled1;
}

}  // namespace

template <class F>
SupportShaft<F> form_support_shaft(const scene::Box<F>& a, const scene::Box<F>& b) {
  const Shaft<F> shaft = form_shaft(a, b, Normals::as_formed);
  SupportShaft<F> result;
  result.a = a;
  result.b = b;
  for (std::size_t face = 0; face < 6; ++face) {
    SupportPlane<F>& side = result.plane_set[result.plane_count++];
    const F outward = face < 3 ? F(-1) : F(1), x = shaft.extent.c[face];
    side.n = {0, 0, 0};
    side.n[face % 3] = outward;
    side.d = -outward * x;
    side.base = std::fabs(x);
    side.length = 1;
  }
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    SupportPlane<F>& half_space = result.plane_set[result.plane_count++];
    F n0 = plane.n0, n1 = plane.n1;
    bring_near_one(n0, n1);
    const F x = n0 * a.c[plane.far0], y = n1 * a.c[plane.far1];
    half_space.n = {0, 0, 0};
    half_space.n[static_cast<std::size_t>(axis_of(plane.far0))] = n0;
    half_space.n[static_cast<std::size_t>(axis_of(plane.far1))] = n1;
    half_space.d = -(x + y);
    half_space.base = std::fabs(x) + std::fabs(y);
    half_space.length = std::fabs(n0) + std::fabs(n1);
  }
  return result;
}

template SupportShaft<float> form_support_shaft(const scene::Box<float>&, const scene::Box<float>&);
template SupportShaft<double> form_support_shaft(const scene::Box<double>&, const scene::Box<double>&);

}  // namespace gnomon::fast
