// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/blocked_range.h"

#include <array>

#include "exact/segments_over_s.h"
#include "exact/triangle_over_s.h"

namespace gnomon::exact {

namespace {

using FT = RationalKernel::FT;

std::array<std::array<double, 3>, 3> corners_of(const scene::Scene& scene, std::uint32_t triangle) {
  return {scene.corner(triangle, 0), scene.corner(triangle, 1), scene.corner(triangle, 2)};
}

/// Where the inequality turns into an equation.
mpq_class root_of(const LinearInS<FT>& f) {
  return mpq_class(FT(f.at0 / (f.at0 - f.at1)).mpq());
}

BlockedRange found(const RangeOfS<FT>& range) {
  return {range.lower() ? root_of(*range.lower()) : mpq_class(0),
          range.upper() ? root_of(*range.upper()) : mpq_class(1)};
}

}  // namespace

std::optional<BlockedRange> blocked_range(const scene::Scene& scene, std::uint32_t triangle,
                                          const scene::Box<double>& a, const scene::Box<double>& b) {
  RangeOfS<FT> range(Ends::closed);
  const auto add = [&](LinearInS<FT> f) { return range.add(std::move(f)); };
  if (!triangle_over_s<FT>(corners_of(scene, triangle), a, b, add)) return std::nullopt;
  return found(range);
}

std::optional<BlockedRange> blocked_range(const scene::Scene& scene, std::uint32_t triangle,
                                          const scene::PatchPair& pair) {
  RangeOfS<FT> range(Ends::open);
  const auto add = [&](LinearInS<FT> f) { return range.add(std::move(f)); };
  const SegmentsOverS<FT> segments(three<FT>(pair.a.corners), three<FT>(pair.b.corners),
                                   three<FT>(corners_of(scene, triangle)));
  if (!segments.for_each(add)) return std::nullopt;
  return found(range);
}

}  // namespace gnomon::exact
