// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/shaft_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/shaft_ball.h"
#include "exact/shaft_walk.h"
#include "exact/triangle_over_s.h"

namespace gnomon::exact {

using scene::Box;
using scene::Scene;

namespace {

using Corners = std::array<std::array<double, 3>, 3>;

enum class Quick : std::uint8_t { no, yes, unknown };

template <std::size_t n>
bool are_in_range(const std::array<double, n>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::fabs(x) <= kLargestInIntervals; });
}

/// The box from lo to hi against the shaft, by doubles: differences of doubles have exact signs.
RangeFilter over_s(const std::array<double, 3>& lo, const std::array<double, 3>& hi, const Box<double>& a,
                   const Box<double>& b, bool& apart) {
  RangeFilter range(Ends::closed);
  apart = false;
  for (std::size_t i = 0; i < 3 && !apart; ++i) {
    const int axis = static_cast<int>(i);
    apart = !range.add(LinearInS<double>{hi[i] - a.lo(axis), hi[i] - b.lo(axis)}) ||
            !range.add(LinearInS<double>{a.hi(axis) - lo[i], b.hi(axis) - lo[i]});
  }
  return range;
}

bool holds(const std::array<double, 3>& p, const Box<double>& a, const Box<double>& b) {
  bool apart = false;
  return over_s(p, p, a, b, apart).has_some() && !apart;
}

/// Signs of inequalities at the one s at which an axis holds boxes and triangle in one plane. Two flat boxes
/// and a face between, all square to an axis, are common in buildings, and no range of s is left there whose
/// ends intervals could tell apart.
class PinnedFilter {
 public:
  using FT = FilterKernel::FT;

  /// The axis that leaves one s of the open range (0, 1), if any.
  static std::optional<std::size_t> axis_of(const std::array<double, 3>& lo, const std::array<double, 3>& hi,
                                            const Box<double>& a, const Box<double>& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool flat = lo[i] == hi[i] && a.c[i] == a.c[i + 3] && b.c[i] == b.c[i + 3];
      if (flat && ((a.c[i] < lo[i] && lo[i] < b.c[i]) || (b.c[i] < lo[i] && lo[i] < a.c[i]))) return i;
    }
    return std::nullopt;
  }

  PinnedFilter(std::size_t axis, double at, const Box<double>& a, const Box<double>& b)
      : axis_(axis), from_a_(CGAL::abs(FT(at) - FT(a.c[axis]))), from_b_(CGAL::abs(FT(b.c[axis]) - FT(at))) {}

  /// False when the inequality fails at that s, surely. The axis' own two hold: they are the equation.
  bool add(const LinearInS<FT>& f) {
    if (number_++ / 2 == axis_) return true;
    // s is from_a / (from_a + from_b).
    const FT value = from_b_ * f.at0 + from_a_ * f.at1;
    all_hold_ = all_hold_ && value.inf() >= 0;
    return !(value.sup() < 0);
  }
  [[nodiscard]] bool all_hold() const { return all_hold_; }

 private:
  std::size_t axis_, number_ = 0;
  FT from_a_, from_b_;
  bool all_hold_ = true;
};

Quick quick(const Corners& v, const Box<double>& a, const Box<double>& b) {
  std::array<double, 3> lo{}, hi{};
  for (std::size_t i = 0; i < 3; ++i) {
    lo[i] = std::min({v[0][i], v[1][i], v[2][i]});
    hi[i] = std::max({v[0][i], v[1][i], v[2][i]});
  }
  bool apart = false;
  over_s(lo, hi, a, b, apart);
  if (apart) return Quick::no;
  for (const auto& p : v) {
    if (holds(p, a, b)) return Quick::yes;
  }
  const CGAL::Interval_nt<false>::Protector upward;
  using FT = FilterKernel::FT;
  if (const std::optional<std::size_t> axis = PinnedFilter::axis_of(lo, hi, a, b)) {
    PinnedFilter pinned(*axis, lo[*axis], a, b);
    const auto add = [&](const LinearInS<FT>& f) { return pinned.add(f); };
    if (!triangle_over_s<FT>(v, a, b, add)) return Quick::no;
    return pinned.all_hold() ? Quick::yes : Quick::unknown;
  }
  RangeFilter range(Ends::closed);
  if (!triangle_over_s<FT>(v, a, b, [&](const LinearInS<FT>& f) { return range.add(f); })) return Quick::no;
  return range.has_some() ? Quick::yes : Quick::unknown;
}

Quick quick(const scene::Ball<double>& ball, const Box<double>& a, const Box<double>& b) {
  constexpr double kMost = std::numeric_limits<double>::max();
  std::array<double, 3> lo{}, hi{};
  for (std::size_t i = 0; i < 3; ++i) {
    lo[i] = std::nextafter(ball.centre[i] - ball.radius, -kMost);
    hi[i] = std::nextafter(ball.centre[i] + ball.radius, kMost);
  }
  bool apart = false;
  over_s(lo, hi, a, b, apart);
  if (apart) return Quick::no;
  return holds(ball.centre, a, b) ? Quick::yes : Quick::unknown;
}

}  // namespace

CandidateShaft::CandidateShaft(const Box<double>& a, const Box<double>& b)
    : a_(a), b_(b), in_range_(are_in_range(a.c) && are_in_range(b.c)) {}

bool CandidateShaft::meets(const Scene& scene, std::uint32_t face, CandidateCounters& counters) const {
  ++counters.faces;
  if (face >= scene.triangles.size()) {
    const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
    if (in_range_ && are_in_range(ball.centre) && ball.radius <= kLargestInIntervals) {
      const Quick answer = quick(ball, a_, b_);
      if (answer != Quick::unknown) return answer == Quick::yes;
    }
    ++counters.exact_faces;
    return exact::meets(scene::ShaftBallCase{a_, b_, ball});
  }
  const Corners v{scene.corner(face, 0), scene.corner(face, 1), scene.corner(face, 2)};
  if (in_range_ && std::ranges::all_of(v, [](const auto& p) { return are_in_range(p); })) {
    const Quick answer = quick(v, a_, b_);
    if (answer != Quick::unknown) return answer == Quick::yes;
  }
  ++counters.exact_faces;
  RangeOfS<ExactFloat> range(Ends::closed);
  return triangle_over_s<ExactFloat>(v, a_, b_,
                                     [&](LinearInS<ExactFloat> f) { return range.add(std::move(f)); });
}

bool CandidateShaft::meets(const Scene& scene, std::uint32_t face) const {
  CandidateCounters unused;
  return meets(scene, face, unused);
}

bool meets_shaft(const Scene& scene, std::uint32_t face, const Box<double>& a, const Box<double>& b) {
  return CandidateShaft(a, b).meets(scene, face);
}

std::vector<std::uint32_t> shaft_candidates_by_all_faces(const Scene& scene, const Box<double>& a,
                                                         const Box<double>& b) {
  const CandidateShaft shaft(a, b);
  std::vector<std::uint32_t> faces;
  const auto count = static_cast<std::uint32_t>(scene.face_count());
  for (std::uint32_t face = 0; face < count; ++face) {
    if (shaft.meets(scene, face)) faces.push_back(face);
  }
  return faces;
}

ShaftCandidates::ShaftCandidates(const Scene& scene)
    : scene_(scene), built_(std::make_unique<const BuiltHierarchy>(build_hierarchy(scene))) {}

ShaftCandidates::~ShaftCandidates() = default;

void ShaftCandidates::faces(const Box<double>& a, const Box<double>& b,
                            std::vector<std::uint32_t>& out) const {
  CandidateCounters unused;
  faces(a, b, out, unused);
}

void ShaftCandidates::faces(const Box<double>& a, const Box<double>& b, std::vector<std::uint32_t>& out,
                            CandidateCounters& counters) const {
  out.clear();
  const CandidateShaft shaft(a, b);
  ShaftWalk(*built_, a, b)
      .run(
          [&](std::uint32_t face) {
            if (shaft.meets(scene_, face, counters)) out.push_back(face);
            return false;
          },
          counters.nodes);
  std::sort(out.begin(), out.end());
}

}  // namespace gnomon::exact
