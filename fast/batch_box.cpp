// SPDX-License-Identifier: MIT
#include "fast/batch_box.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/batch_box.cpp"
#include <hwy/foreach_target.h>

#include "fast/batch_vector_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

/// classify() of fast/shaft_box.cpp, operation by operation.
template <class F>
struct BoxKernel {
  static constexpr bool kLeavesOpen = false;
  const BatchBoxShaft<F>& shaft;

  using D = hn::ScalableTag<F>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  static HWY_INLINE V value(const typename BatchBoxShaft<F>::Plane& plane, const F* x, const F* y) {
    const D d;
    const V n0x = hn::Mul(hn::Set(d, plane.n0), hn::LoadU(d, x));
    const V n1y = hn::Mul(hn::Set(d, plane.n1), hn::LoadU(d, y));
    return hn::Add(hn::Add(n0x, n1y), hn::Set(d, plane.d));
  }

  HWY_INLINE M within(const F* const* c, std::size_t at) const {
    const D d;
    M result = hn::FirstN(d, hn::Lanes(d));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const M lo = hn::Ge(hn::LoadU(d, c[axis] + at), hn::Set(d, shaft.extent.c[axis]));
      const M hi = hn::Le(hn::LoadU(d, c[axis + 3] + at), hn::Set(d, shaft.extent.c[axis + 3]));
      result = hn::And(result, hn::And(lo, hi));
    }
    return result;
  }

  /// Which of the lanes in `kept` are inside.
  HWY_INLINE std::uint64_t inside(const F* const* c, std::size_t at, M kept) const {
    const D d;
    M result = hn::And(kept, within(c, at));
    if (hn::AllFalse(d, result)) return 0;
    for (std::size_t i = 0; i < shaft.plane_count; ++i) {
      const auto& plane = shaft.planes[i];
      const V v = value(plane, c[plane.far0] + at, c[plane.far1] + at);
      result = hn::And(result, hn::Le(v, hn::Set(d, plane.inside_threshold)));
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
      M kept[kSideBySide];
      for (std::size_t j = 0; j < kSideBySide; ++j) kept[j] = hn::FirstN(d, lanes);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const V extent_lo = hn::Set(d, shaft.extent.c[axis]),
                extent_hi = hn::Set(d, shaft.extent.c[axis + 3]);
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          kept[j] = and_le(kept[j], hn::LoadU(d, c[axis] + at + j * lanes), extent_hi);
          kept[j] = and_le(kept[j], extent_lo, hn::LoadU(d, c[axis + 3] + at + j * lanes));
        }
      }
      for (std::size_t i = 0; i < shaft.plane_count; ++i) {
        const auto& plane = shaft.planes[i];
        const F* x = c[opposite(plane.far0)] + at;
        const F* y = c[opposite(plane.far1)] + at;
        const V threshold = hn::Set(d, plane.outside_threshold);
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          const V v = value(plane, x + j * lanes, y + j * lanes);
          kept[j] = and_not_gt(kept[j], v, threshold);  // a NaN keeps
        }
      }
      for (std::size_t j = 0; j < kSideBySide; ++j) {
        answers.kept |= bits_of(d, kept[j]) << (offset + j * lanes);
        if (kThreeWay && !hn::AllFalse(d, kept[j])) {
          answers.inside |= inside(c, at + j * lanes, kept[j]) << (offset + j * lanes);
        }
      }
    }
    return answers;
  }
};

template <class F>
void run_boxes(const BatchBoxShaft<F>& shaft, const BoxesSoA<F>& boxes, const BatchOutput& out) {
  const BoxKernel<F> kernel{shaft};
  const std::array<const F*, 6> arrays{boxes.lo[0], boxes.lo[1], boxes.lo[2],
                                       boxes.hi[0], boxes.hi[1], boxes.hi[2]};
  const auto left_open = [](std::size_t, std::uint64_t) {};
  if (out.asks_three_way()) {
    run_words<true>(kernel, arrays, boxes.count, out, left_open);
  } else {
    run_words<false>(kernel, arrays, boxes.count, out, left_open);
  }
}

const char* instruction_set() {
  return hwy::TargetName(HWY_TARGET);
}

void run_boxes_f32(const BatchBoxShaft<float>& shaft, const BoxesSoA<float>& boxes, const BatchOutput& out) {
  run_boxes(shaft, boxes, out);
}
void run_boxes_f64(const BatchBoxShaft<double>& shaft, const BoxesSoA<double>& boxes,
                   const BatchOutput& out) {
  run_boxes(shaft, boxes, out);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gnomon::fast {

namespace {

HWY_EXPORT(instruction_set);
HWY_EXPORT(run_boxes_f32);
HWY_EXPORT(run_boxes_f64);

void run(const BatchBoxShaft<float>& shaft, const BoxesSoA<float>& boxes, const BatchOutput& out) {
  HWY_DYNAMIC_DISPATCH(run_boxes_f32)(shaft, boxes, out);
}
void run(const BatchBoxShaft<double>& shaft, const BoxesSoA<double>& boxes, const BatchOutput& out) {
  HWY_DYNAMIC_DISPATCH(run_boxes_f64)(shaft, boxes, out);
}

}  // namespace

const char* batch_instruction_set() {
  return HWY_DYNAMIC_DISPATCH(instruction_set)();
}

template <class F>
BatchBoxShaft<F>::BatchBoxShaft(const Shaft<F>& shaft)
    : extent(shaft.extent), planes{}, plane_count(shaft.plane_count) {
  for (std::size_t i = 0; i < plane_count; ++i) {
    const ShaftPlane<F>& plane = shaft.plane_set[i];
    planes[i] = {plane.n0,   plane.n1,  plane.d, plane.outside_threshold, plane.inside_threshold,
                 plane.far0, plane.far1};
  }
}

template <class F>
void classify_boxes(const BatchBoxShaft<F>& shaft, const BoxesSoA<F>& boxes,
                    std::span<std::uint8_t> answers) {
  run(shaft, boxes, {answers.data(), {}});
}

template <class F>
void classify_boxes(const BatchBoxShaft<F>& shaft, const BoxesSoA<F>& boxes, BitPlanes answers) {
  run(shaft, boxes, {nullptr, answers});
}

template class BatchBoxShaft<float>;
template class BatchBoxShaft<double>;
template void classify_boxes(const BatchBoxShaft<float>&, const BoxesSoA<float>&, std::span<std::uint8_t>);
template void classify_boxes(const BatchBoxShaft<double>&, const BoxesSoA<double>&, std::span<std::uint8_t>);
template void classify_boxes(const BatchBoxShaft<float>&, const BoxesSoA<float>&, BitPlanes);
template void classify_boxes(const BatchBoxShaft<double>&, const BoxesSoA<double>&, BitPlanes);

}  // namespace gnomon::fast
#endif  // HWY_ONCE
