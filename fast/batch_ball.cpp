// SPDX-License-Identifier: MIT
#include "fast/batch_ball.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/batch_ball.cpp"
#include <hwy/foreach_target.h>

#include "fast/batch_vector_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// classify() of fast/shaft_ball.cpp, operation by operation.
template <class F>
struct BallKernel {
  static constexpr bool kLeavesOpen = false;
  const BatchBallShaft<F>& shaft;

  using D = hn::ScalableTag<F>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  static HWY_INLINE V value(const typename BatchBallShaft<F>::Plane& plane, const F* x, const F* y) {
    const D d;
    const V n0x = hn::Mul(hn::Set(d, plane.n0), hn::LoadU(d, x));
    const V n1y = hn::Mul(hn::Set(d, plane.n1), hn::LoadU(d, y));
    return hn::Add(hn::Add(n0x, n1y), hn::Set(d, plane.d));
  }

  /// Which of the lanes in `kept` are inside.
  HWY_INLINE std::uint64_t inside(const F* const* c, std::size_t at, M kept) const {
    const D d;
    const V radius = hn::LoadU(d, c[3] + at);
    const V reach = hn::Mul(radius, hn::Set(d, shaft.slack.inside_factor));
    M result = hn::And(kept, hn::Le(radius, hn::Set(d, shaft.slack.largest_radius)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const V x = hn::LoadU(d, c[axis] + at);
      const M lo = hn::Ge(hn::Sub(x, hn::Set(d, shaft.extent.c[axis])), reach);
      const M hi = hn::Ge(hn::Sub(hn::Set(d, shaft.extent.c[axis + 3]), x), reach);
      result = hn::And(result, hn::And(lo, hi));
    }
    if (hn::AllFalse(d, result)) return 0;
    for (std::size_t i = 0; i < shaft.plane_count; ++i) {
      const auto& plane = shaft.planes[i];
      const V v = value(plane, c[plane.axis0] + at, c[plane.axis1] + at);
      result = hn::And(result, hn::Le(v, hn::Sub(hn::Set(d, plane.inside_threshold), radius)));
    }
    return bits_of(d, result);
  }

  template <bool kThreeWay>
  HWY_INLINE BatchWord word(const F* const* c, std::size_t first) const {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    BatchWord answers;
    for (std::size_t offset = 0; offset < 64; offset += kSideBySide * lanes) {
      const std::size_t at = first + offset;
      V radius[kSideBySide], sum[kSideBySide];
      M before_planes[kSideBySide];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const V lo = hn::Set(d, shaft.extent.c[axis]), hi = hn::Set(d, shaft.extent.c[axis + 3]);
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          const V apart = positive_part_of_larger(lo, hn::LoadU(d, c[axis] + at + j * lanes), hi);
          const V square = hn::Mul(apart, apart);
          sum[j] = axis == 0 ? square : hn::Add(sum[j], square);
        }
      }
      for (std::size_t j = 0; j < kSideBySide; ++j) {
        radius[j] = hn::LoadU(d, c[3] + at + j * lanes);
        before_planes[j] = hn::FirstN(d, lanes);
      }
      for (std::size_t i = 0; i < shaft.plane_count; ++i) {
        const auto& plane = shaft.planes[i];
        const F* x = c[plane.axis0] + at;
        const F* y = c[plane.axis1] + at;
        const V threshold = hn::Set(d, plane.outside_threshold);
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          const V v = value(plane, x + j * lanes, y + j * lanes);
          before_planes[j] = and_not_gt(before_planes[j], v, hn::Add(radius[j], threshold));
        }
      }
      const V factor = hn::Set(d, shaft.slack.square_factor), add = hn::Set(d, shaft.slack.square_offset);
      const V largest = hn::Set(d, shaft.slack.largest_radius);
      for (std::size_t j = 0; j < kSideBySide; ++j) {
        const V bound = hn::Add(hn::Mul(hn::Mul(radius[j], radius[j]), factor), add);
        const M near_planes = hn::Or(before_planes[j], hn::Not(hn::Le(radius[j], largest)));
        const M kept = and_not_gt(near_planes, sum[j], bound);
        answers.kept |= bits_of(d, kept) << (offset + j * lanes);
        if (kThreeWay && !hn::AllFalse(d, kept)) {
          answers.inside |= inside(c, at + j * lanes, kept) << (offset + j * lanes);
        }
      }
    }
    return answers;
  }
};

template <class F>
void run_balls(const BatchBallShaft<F>& shaft, const BallsSoA<F>& balls, const BatchOutput& out) {
  const BallKernel<F> kernel{shaft};
  const std::array<const F*, 4> arrays{balls.centre[0], balls.centre[1], balls.centre[2], balls.radius};
  const auto left_open = [](std::size_t, std::uint64_t) {};
  if (out.asks_three_way()) {
    run_words<true>(kernel, arrays, balls.count, out, left_open);
  } else {
    run_words<false>(kernel, arrays, balls.count, out, left_open);
  }
}

void run_balls_f32(const BatchBallShaft<float>& shaft, const BallsSoA<float>& balls, const BatchOutput& out) {
  run_balls(shaft, balls, out);
}
void run_balls_f64(const BatchBallShaft<double>& shaft, const BallsSoA<double>& balls,
                   const BatchOutput& out) {
  run_balls(shaft, balls, out);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gnomon::fast {

namespace {

HWY_EXPORT(run_balls_f32);
HWY_EXPORT(run_balls_f64);

void run(const BatchBallShaft<float>& shaft, const BallsSoA<float>& balls, const BatchOutput& out) {
  HWY_DYNAMIC_DISPATCH(run_balls_f32)(shaft, balls, out);
}
void run(const BatchBallShaft<double>& shaft, const BallsSoA<double>& balls, const BatchOutput& out) {
  HWY_DYNAMIC_DISPATCH(run_balls_f64)(shaft, balls, out);
}

}  // namespace

template <class F>
BatchBallShaft<F>::BatchBallShaft(const Shaft<F>& shaft)
    : extent(shaft.extent), planes{}, plane_count(shaft.plane_count), slack(shaft.slack) {
  for (std::size_t i = 0; i < plane_count; ++i) {
    const ShaftPlane<F>& plane = shaft.plane_set[i];
    planes[i] = {plane.n0,
                 plane.n1,
                 plane.d,
                 plane.outside_threshold,
                 plane.inside_threshold,
                 static_cast<std::uint8_t>(axis_of(plane.far0)),
                 static_cast<std::uint8_t>(axis_of(plane.far1))};
  }
}

template <class F>
void classify_balls(const BatchBallShaft<F>& shaft, const BallsSoA<F>& balls,
                    std::span<std::uint8_t> answers) {
  run(shaft, balls, {answers.data(), {}});
}

template <class F>
void classify_balls(const BatchBallShaft<F>& shaft, const BallsSoA<F>& balls, BitPlanes answers) {
  run(shaft, balls, {nullptr, answers});
}

template class BatchBallShaft<float>;
template class BatchBallShaft<double>;
template void classify_balls(const BatchBallShaft<float>&, const BallsSoA<float>&, std::span<std::uint8_t>);
template void classify_balls(const BatchBallShaft<double>&, const BallsSoA<double>&, std::span<std::uint8_t>);
template void classify_balls(const BatchBallShaft<float>&, const BallsSoA<float>&, BitPlanes);
template void classify_balls(const BatchBallShaft<double>&, const BallsSoA<double>&, BitPlanes);

}  // namespace gnomon::fast
#endif  // HWY_ONCE
