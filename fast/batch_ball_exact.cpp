// SPDX-License-Identifier: MIT
//
// STAGE 1, in the precision F, on the normals of form_certified_ball_shaft() (certified_shaft.cpp, "BALLS"),
// with d lowered by twice the outside threshold t_i. All v are computed; V is the largest lowered value v'_i.
// - Outside: V > r. With d' = d - 2 t_i the derivation there gives, for a ball that meets S, v'_i <= r + t_i
// +
//   u (|d| + 2 t_i) - 2 t_i < r, as t_i > 3 u |d|; also when the squared distance to the extent box says so.
// - K = 4 (max t_i + max |inside threshold|). V <= -r - K: every v_i is at most V + 2 t_i + u (...), which is
// what
//   the certified inside test asks; with the sides, inside.
// - V <= -K and the centre within the extent box (signs of differences are exact): the centre is in S.
// - V > -r (1 - 20 u), or a side is nearer than r (1 - 4 u): not inside, for v'_i is no more than the true
// m.c + d,
//   and |m| >= 1 - 13 u.
//
// ON A GRID, between the stages: batch_ball_grid_inl.h.
//
// STAGE 2, in double precision with u = 2^-53. The centre lies beyond the side k of the box at s by p_k + q_k
// s (lower sides lo - c, upper sides c - hi); t_k is its computed positive part, at a computed s in [0, 1],
// and k_k = |p_k| + |q_k|. Differences have an error of u, so |p_k + q_k s - computed| <= 3.01 u k_k.
// - Meets: d^2 <= sum of squares at any s <= sum t_k^2 + 12 u sum t_k k_k + 28 u^2 sum k_k^2. (6.02 u t_k k_k
// from
//   the squares, 4 u t_k^2 from rounding them and their sum, t_k <= 1.01 k_k; 9.1 u^2 k_k^2 where the error
//   itself is squared or t_k is 0.) Or exactly: every t_k was computed without error and the sum is at most
//   r^2. Or the centre is in S, by the signs of planes.
// - Outside: whatever n is, d >= (n.c - max(h_A(n), h_B(n))) / |n|, h the support functions. With n = the sum
// of t_k
//   times the sides' outward normals, n.c - h_A(n) = sum t_k p_k (flat boxes, where both sides of an axis
//   have t_k > 0: at least that, as h is subadditive), and |n| <= sqrt(sum t_k^2). Both sums have an error of
//   at most 8 u sum t_k k_k.
// - Inside: sides by exact comparison (the difference as a sum high + low against r); planes by v <= 0 and -v
// >= r
//   |n|, with an error of 6 u (|n0 x| + |n1 y|) for v and 8 u r |n| for the other; r = 0 by the sign of v
//   alone.
// Underflow (doubles): what a comparison needs above it has 2^-1000 added or is asked to be at least 2^-900.
// Overflow makes NaN or infinities on the side that decides nothing.
#include "fast/batch_ball.h"

#include <cmath>

#include "fast/batch_planes.h"
#include "fast/certified_shaft.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/batch_ball_exact.cpp"
#include <hwy/foreach_target.h>

#include "fast/batch_ball_grid_inl.h"
#include "fast/batch_ball_stage2_inl.h"
#include "fast/batch_vector_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

template <class F>
struct ExactBallKernel {
  static constexpr bool kLeavesOpen = true, kHasGrid = true;
  const ExactBallShaft<F>& shaft;

  using D = hn::ScalableTag<F>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  struct Kept {
    std::uint64_t inside, open;
  };

  /// What can be said of the lanes that are not surely outside.
  HWY_INLINE Kept judge_kept(const F* const* c, std::size_t at, M kept, V most) const {
    const D d;
    const V radius = hn::LoadU(d, c[3] + at);
    V least = hn::Set(d, std::numeric_limits<F>::infinity());  // the distance to the nearest side, inwards
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const V x = hn::LoadU(d, c[axis] + at);
      least = hn::Min(least, hn::Min(hn::Sub(x, hn::Set(d, shaft.extent.c[axis])),
                                     hn::Sub(hn::Set(d, shaft.extent.c[axis + 3]), x)));
    }
    constexpr F u = Rounding<F>::u;
    const V margin = hn::Set(d, shaft.inner_margin), zero = hn::Zero(d);
    const M usable = hn::And(kept, hn::Le(radius, hn::Set(d, shaft.slack.largest_radius)));
    const M centre_in = hn::And(hn::Le(most, hn::Sub(zero, margin)), hn::Ge(least, zero));
    const M not_inside = hn::Or(hn::Gt(most, hn::Mul(radius, hn::Set(d, -(1 - 20 * u)))),
                                hn::Lt(least, hn::Mul(radius, hn::Set(d, 1 - 4 * u))));
    const M within_sides = hn::Ge(least, hn::Mul(radius, hn::Set(d, shaft.slack.inside_factor)));
    const M inside =
        hn::And(hn::And(usable, within_sides), hn::Le(most, hn::Sub(hn::Sub(zero, radius), margin)));
    const M overlap = hn::And(usable, hn::And(centre_in, not_inside));
    return {bits_of(d, inside), bits_of(d, hn::AndNot(hn::Or(inside, overlap), kept))};
  }

  template <bool kThreeWay>
  HWY_INLINE BatchWord word(const F* const* c, std::size_t first) const {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    BatchWord answers;
    for (std::size_t offset = 0; offset < 64; offset += kSideBySide * lanes) {
      const std::size_t at = first + offset;
      V sum[kSideBySide], most[kSideBySide];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const V lo = hn::Set(d, shaft.extent.c[axis]), hi = hn::Set(d, shaft.extent.c[axis + 3]);
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          const V apart = positive_part_of_larger(lo, hn::LoadU(d, c[axis] + at + j * lanes), hi);
          const V square = hn::Mul(apart, apart);
          sum[j] = axis == 0 ? square : hn::Add(sum[j], square);
        }
      }
      for (V& value : most) value = hn::Set(d, -std::numeric_limits<F>::infinity());
      for (std::size_t i = 0; i < shaft.plane_count; ++i) {
        const auto& filter = shaft.filters[i];
        const F* x = c[filter.axis0] + at;
        const F* y = c[filter.axis1] + at;
        const V n0 = hn::Set(d, filter.n0), n1 = hn::Set(d, filter.n1), offset_d = hn::Set(d, filter.d);
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          const V n0x = hn::Mul(n0, hn::LoadU(d, x + j * lanes)),
                  n1y = hn::Mul(n1, hn::LoadU(d, y + j * lanes));
          most[j] = hn::Max(most[j], hn::Add(hn::Add(n0x, n1y), offset_d));
        }
      }
      const V factor = hn::Set(d, shaft.slack.square_factor), add = hn::Set(d, shaft.slack.square_offset);
      const V largest = hn::Set(d, shaft.slack.largest_radius);
      for (std::size_t j = 0; j < kSideBySide; ++j) {
        const V radius = hn::LoadU(d, c[3] + at + j * lanes);
        const V bound = hn::Add(hn::Mul(hn::Mul(radius, radius), factor), add);
        const M beyond_plane = hn::And(hn::Gt(most[j], radius), hn::Le(radius, largest));
        const M kept = hn::Not(hn::Or(hn::Gt(sum[j], bound), beyond_plane));
        if (hn::AllFalse(d, kept)) continue;
        const std::size_t shift = offset + j * lanes;
        const Kept judged = judge_kept(c, at + j * lanes, kept, most[j]);
        answers.kept |= bits_of(d, kept) << shift;
        answers.inside |= judged.inside << shift;
        answers.open |= judged.open << shift;
      }
    }
    return answers;
  }

  template <bool kThreeWay, Effort kEffort>
  HWY_INLINE BatchWord resolve_on_grid(const F* const* c) const {
    return BallGridStage<F>(shaft, c).template resolve<kThreeWay, kEffort>();
  }

  template <bool kThreeWay>
  HWY_INLINE BatchWord resolve(const F* const* c) const {
    return BallStage2<F>(shaft, c).template resolve<kThreeWay>();
  }
};

template <class F>
BatchCounters run_exact(const ExactBallShaft<F>& shaft, const BallsSoA<F>& balls, const BatchOutput& out,
                        const ExactPredicate<scene::Ball<F>>& predicate) {
  const ExactBallKernel<F> kernel{shaft};
  const std::array<const F*, 4> arrays{balls.centre[0], balls.centre[1], balls.centre[2], balls.radius};
  return run_with_stages(kernel, arrays, balls.count, out, shaft.has_error_free,
                         [&](std::size_t item) { return predicate(balls[item]); });
}

BatchCounters run_exact_balls_f32(const ExactBallShaft<float>& shaft, const BallsSoA<float>& balls,
                                  const BatchOutput& out,
                                  const ExactPredicate<scene::Ball<float>>& predicate) {
  return run_exact(shaft, balls, out, predicate);
}
BatchCounters run_exact_balls_f64(const ExactBallShaft<double>& shaft, const BallsSoA<double>& balls,
                                  const BatchOutput& out,
                                  const ExactPredicate<scene::Ball<double>>& predicate) {
  return run_exact(shaft, balls, out, predicate);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gnomon::fast {

namespace {

HWY_EXPORT(run_exact_balls_f32);
HWY_EXPORT(run_exact_balls_f64);

BatchCounters run(const ExactBallShaft<float>& shaft, const BallsSoA<float>& balls, const BatchOutput& out,
                  const ExactPredicate<scene::Ball<float>>& predicate) {
  return HWY_DYNAMIC_DISPATCH(run_exact_balls_f32)(shaft, balls, out, predicate);
}
BatchCounters run(const ExactBallShaft<double>& shaft, const BallsSoA<double>& balls, const BatchOutput& out,
                  const ExactPredicate<scene::Ball<double>>& predicate) {
  return HWY_DYNAMIC_DISPATCH(run_exact_balls_f64)(shaft, balls, out, predicate);
}

}  // namespace

template <class F>
ExactBallShaft<F>::ExactBallShaft(const scene::Box<F>& a_box, const scene::Box<F>& b_box)
    : a(a_box), b(b_box), extent(extent_of(a, b)), filters{}, planes{}, runs{}, has_error_free(true) {
  const Shaft<F> certified = form_certified_ball_shaft(a, b);
  slack = certified.slack;
  plane_count = certified.plane_count;
  F outside = 0, inside = 0, undecided = 0;
  for (std::size_t i = 0; i < plane_count; ++i) {
    const ShaftPlane<F>& plane = certified.plane_set[i];
    const Face f = plane.far0, g = plane.far1;
    filters[i] = {plane.n0, plane.n1, plane.d - 2 * plane.outside_threshold,
                  static_cast<std::uint8_t>(axis_of(f)), static_cast<std::uint8_t>(axis_of(g))};
    outside = std::max(outside, plane.outside_threshold);
    inside = std::max(inside, -plane.inside_threshold);
    // A plane that decides nothing proves nothing to be within it: nothing is below NaN.
    if (std::isnan(plane.inside_threshold)) undecided = std::numeric_limits<F>::quiet_NaN();
    const ExactDifference n0 = outward_difference(b.c[g], a.c[g], is_max(f));
    const ExactDifference n1 = outward_difference(a.c[f], b.c[f], is_max(g));
    has_error_free &= n0.in_range() && n1.in_range();
    planes[i] = {n0.high, n0.low, n1.high, n1.low, std::sqrt(n0.high * n0.high + n1.high * n1.high), f, g};
  }
  inner_margin = 4 * (outside + inside) + undecided;
  for (std::size_t face = 0; face < 6; ++face) {
    // Lower sides lie beyond the centre by lo - c, upper ones by c - hi.
    const ExactDifference q =
        face < 3 ? exact_difference(b.c[face], a.c[face]) : exact_difference(a.c[face], b.c[face]);
    runs[face] = {q.high, q.high != 0 ? 1 / q.high : 0, q.low == 0};
  }
  find_grid();
}

/// The finest grid that the extent box allows, so that balls may have more digits than the shaft.
template <class F>
void ExactBallShaft<F>::find_grid() {
  constexpr int digits = std::numeric_limits<F>::digits, m = (digits - 2) / 2;
  F width = 0, largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    width = std::max(width, extent.hi(axis) - extent.lo(axis));
    largest = std::max({largest, std::fabs(extent.lo(axis)), std::fabs(extent.hi(axis))});
  }
  if (!std::isnormal(width)) return;
  const int exponent = std::ilogb(width) + 1 - (m - 2);  // of g: width < 2^(m-2) g
  // Neither g^4 nor what is 2^(4m+4) times as much under- or overflows.
  if (std::abs(exponent) > (std::numeric_limits<F>::max_exponent - (4 * m + 4)) / 4) return;
  const F g = std::scalbn(F(1), exponent), limit = std::scalbn(g, m);
  if (!(largest <= std::scalbn(g, 2 * m - 1))) return;
  grid.rounder = F(1.5) * std::scalbn(g, digits - 1);
  for (std::size_t face = 0; face < 6; ++face) {
    for (const F x : {a.c[face], b.c[face]}) {
      if ((x + grid.rounder) - grid.rounder != x) return;
    }
    grid.q[face] = static_cast<F>(runs[face].q);
    grid.range.c[face] = face < 3 ? extent.c[face + 3] - limit : extent.c[face - 3] + limit;
  }
  for (std::size_t i = 0; i < plane_count; ++i) {
    // Outward normals times outward distances: no signs.
    const F n0 = static_cast<F>(std::fabs(planes[i].n0_high)),
            n1 = static_cast<F>(std::fabs(planes[i].n1_high));
    grid.planes[i] = {n0, n1, n0 * n0 + n1 * n1, planes[i].far0, planes[i].far1};
  }
  grid.is_usable = true;
}

template <class F>
BatchCounters classify_balls_exact(const ExactBallShaft<F>& shaft, const BallsSoA<F>& balls,
                                   std::span<std::uint8_t> answers,
                                   ExactPredicate<scene::Ball<F>> predicate) {
  return run(shaft, balls, {answers.data(), {}}, predicate);
}

template <class F>
BatchCounters classify_balls_exact(const ExactBallShaft<F>& shaft, const BallsSoA<F>& balls,
                                   BitPlanes answers, ExactPredicate<scene::Ball<F>> predicate) {
  return run(shaft, balls, {nullptr, answers}, predicate);
}

template class ExactBallShaft<float>;
template class ExactBallShaft<double>;
template BatchCounters classify_balls_exact(const ExactBallShaft<float>&, const BallsSoA<float>&,
                                            std::span<std::uint8_t>, ExactPredicate<scene::Ball<float>>);
template BatchCounters classify_balls_exact(const ExactBallShaft<double>&, const BallsSoA<double>&,
                                            std::span<std::uint8_t>, ExactPredicate<scene::Ball<double>>);
template BatchCounters classify_balls_exact(const ExactBallShaft<float>&, const BallsSoA<float>&, BitPlanes,
                                            ExactPredicate<scene::Ball<float>>);
template BatchCounters classify_balls_exact(const ExactBallShaft<double>&, const BallsSoA<double>&, BitPlanes,
                                            ExactPredicate<scene::Ball<double>>);

}  // namespace gnomon::fast
#endif  // HWY_ONCE
