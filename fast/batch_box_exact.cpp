// SPDX-License-Identifier: MIT
//
// STAGE 1, in the precision F, by s instead of planes. A box t that meets the extent box misses the shaft
// exactly when F > T, F the largest s that t's near sides ask for on faces where b is extreme ("from"), T the
// least on faces where a is ("to"): s = (x - a_f) / (b_f - a_f). (Helly; the two lists of the paper, whose
// pairs are its planes. Pairs on one axis can't fail, as lo <= hi.) Each s takes a difference and a product,
// where each plane takes four operations, and its error is relative:
//     |fl(s) - s| <= ((1 + u)^3 / (1 - u) - 1) |s| + eta <= 4.1 u |s| + eta
// (difference, b_f - a_f, its inverse, product; the inverse must be a normal number: has_filter). Where t
// meets the extent box every from-s is at most 1 and every to-s at least 0, exactly, so F > 1 or T < 0 don't
// occur; and F <= 0 or T >= 1 mean "meets" whatever the errors, as signs are never wrong and s >= 1 is
// computed >= 1 - 4.2 u. In between both errors are at most 4.2 u: fl(F - T) > 12 u proves F > T, and < -12 u
// proves F < T. Infinities from differences that overflow have the right sign and decide rightly. Inside: t
// within the extent box (exact) and s_from <= s_to of far sides for every plane, with the same bound.
//
// STAGE 2: plane values by error-free transforms (batch_error_free_inl.h).
#include "fast/batch_box.h"

#include <cmath>

#include "fast/batch_planes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/batch_box_exact.cpp"
#include <hwy/foreach_target.h>

#include "fast/batch_error_free_inl.h"
#include "fast/batch_vector_inl.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

template <class F>
struct ExactBoxKernel {
  static constexpr bool kLeavesOpen = true, kHasGrid = false;
  const ExactBoxShaft<F>& shaft;
  /// 12 u, or infinity, which nothing exceeds, when the filter may not decide.
  F margin = shaft.has_filter ? 12 * Rounding<F>::u : std::numeric_limits<F>::infinity();

  using D = hn::ScalableTag<F>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Side = typename ExactBoxShaft<F>::Side;

  static HWY_INLINE V s_of(const Side& side, const F* x) {
    const D d;
    return hn::Mul(hn::Sub(hn::LoadU(d, x), hn::Set(d, side.at)), hn::Set(d, side.inverse));
  }

  /// t within the extent box; exact.
  template <class DAny>
  static HWY_INLINE hn::Mask<DAny> within(DAny d, const scene::Box<F>& extent, const F* const* c,
                                          std::size_t at) {
    hn::Mask<DAny> result = hn::FirstN(d, hn::Lanes(d));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto lo = hn::Ge(hn::LoadU(d, c[axis] + at), hn::Set(d, extent.c[axis]));
      const auto hi = hn::Le(hn::LoadU(d, c[axis + 3] + at), hn::Set(d, extent.c[axis + 3]));
      result = hn::And(result, hn::And(lo, hi));
    }
    return result;
  }

  struct Inside {
    std::uint64_t inside, open;
  };

  HWY_INLINE Inside inside(const F* const* c, std::size_t at, M kept) const {
    const D d;
    const M contained = hn::And(kept, within(d, shaft.extent, c, at));
    if (hn::AllFalse(d, contained)) return {0, 0};
    HWY_ALIGN_MAX F to[6 * HWY_MAX_BYTES / sizeof(F)], from[6 * HWY_MAX_BYTES / sizeof(F)];
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t i = 0; i < shaft.to_count; ++i) {
      hn::Store(s_of(shaft.to[i], c[shaft.to[i].face] + at), d, to + i * lanes);
    }
    for (std::size_t i = 0; i < shaft.from_count; ++i) {
      hn::Store(s_of(shaft.from[i], c[shaft.from[i].face] + at), d, from + i * lanes);
    }
    V most = hn::Set(d, -std::numeric_limits<F>::infinity());
    for (std::size_t i = 0; i < shaft.plane_count; ++i) {
      const auto& plane = shaft.planes[i];
      most =
          hn::Max(most, hn::Sub(hn::Load(d, from + plane.from * lanes), hn::Load(d, to + plane.to * lanes)));
    }
    const M surely = hn::And(contained, hn::Lt(most, hn::Set(d, -margin)));
    const M open = hn::AndNot(hn::Or(surely, hn::Gt(most, hn::Set(d, margin))), contained);
    return {bits_of(d, surely), bits_of(d, open)};
  }

  template <bool kThreeWay>
  HWY_INLINE BatchWord word(const F* const* c, std::size_t first) const {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    BatchWord answers;
    for (std::size_t offset = 0; offset < 64; offset += kSideBySide * lanes) {
      const std::size_t at = first + offset;
      M kept[kSideBySide];
      V from[kSideBySide], to[kSideBySide];
      for (std::size_t j = 0; j < kSideBySide; ++j) {
        kept[j] = hn::FirstN(d, lanes);
        from[j] = hn::Set(d, -std::numeric_limits<F>::infinity());
        to[j] = hn::Set(d, std::numeric_limits<F>::infinity());
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const V extent_lo = hn::Set(d, shaft.extent.c[axis]),
                extent_hi = hn::Set(d, shaft.extent.c[axis + 3]);
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          kept[j] = and_le(kept[j], hn::LoadU(d, c[axis] + at + j * lanes), extent_hi);
          kept[j] = and_le(kept[j], extent_lo, hn::LoadU(d, c[axis + 3] + at + j * lanes));
        }
      }
      for (std::size_t i = 0; i < shaft.from_count; ++i) {
        const F* x = c[opposite(shaft.from[i].face)] + at;
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          from[j] = hn::Max(from[j], s_of(shaft.from[i], x + j * lanes));
        }
      }
      for (std::size_t i = 0; i < shaft.to_count; ++i) {
        const F* x = c[opposite(shaft.to[i].face)] + at;
        for (std::size_t j = 0; j < kSideBySide; ++j) {
          to[j] = hn::Min(to[j], s_of(shaft.to[i], x + j * lanes));
        }
      }
      for (std::size_t j = 0; j < kSideBySide; ++j) {
        const V apart = hn::Sub(from[j], to[j]);
        kept[j] = and_not_gt(kept[j], apart, hn::Set(d, margin));
        const M open = hn::AndNot(hn::Lt(apart, hn::Set(d, -margin)), kept[j]);
        const std::size_t shift = offset + j * lanes;
        answers.kept |= bits_of(d, kept[j]) << shift;
        answers.open |= bits_of(d, open) << shift;
        if (kThreeWay && !hn::AllFalse(d, kept[j])) {
          const Inside far = inside(c, at + j * lanes, kept[j]);
          answers.inside |= far.inside << shift;
          // What is inside meets the shaft for certain, whatever the near sides' margin says.
          answers.open = (answers.open | far.open << shift) & ~(far.inside << shift);
        }
      }
    }
    return answers;
  }

  /// The differences of t's sides to those of a, for the faces that planes use.
  struct Differences {
    TwoDoubles of[6];
    MDouble usable;
  };

  HWY_INLINE Differences differences(const F* const* c, bool near) const {
    const Doubles d;
    Differences result;
    result.usable = hn::Not(no_lanes(d));
    const auto take = [&](const Side& side) {
      const VDouble x = load_double(d, c[near ? opposite(side.face) : side.face]);
      const TwoDoubles difference = two_difference(x, hn::Set(d, static_cast<double>(side.at)));
      // Floats can't leave the range.
      if (sizeof(F) == 8) result.usable = hn::And(result.usable, in_range_or_zero(difference.high));
      result.of[side.face] = difference;
    };
    for (std::size_t i = 0; i < shaft.to_count; ++i) take(shaft.to[i]);
    for (std::size_t i = 0; i < shaft.from_count; ++i) take(shaft.from[i]);
    return result;
  }

  /// Which lanes have a positive plane for certain, and which an unknown one.
  struct Positive {
    MDouble certain, unknown;
  };

  HWY_INLINE Positive positive(const F* const* c, bool near) const {
    const Doubles d;
    const Differences x = differences(c, near);
    MDouble positive = no_lanes(d), known = hn::Not(positive);
    for (std::size_t i = 0; i < shaft.plane_count; ++i) {
      const auto& plane = shaft.planes[i];
      const VectorSign sign = sign_of_plane(plane, x.of[plane.far0], x.of[plane.far1]);
      positive = hn::Or(positive, hn::And(sign.certain, hn::Gt(sign.value, hn::Zero(d))));
      known = hn::And(known, sign.certain);
    }
    return {hn::And(positive, x.usable), hn::Not(hn::And(known, x.usable))};
  }

  /// Stage 2 for items that meet the extent box: as many as a vector of doubles holds.
  template <bool kThreeWay>
  HWY_INLINE BatchWord resolve(const F* const* c) const {
    const Doubles d;
    const hn::Rebind<F, Doubles> d_narrow;
    const std::uint64_t all = (std::uint64_t{1} << hn::Lanes(d)) - 1;
    const Positive near = positive(c, true);
    BatchWord answers;
    answers.kept = all & ~bits_of(d, near.certain);
    answers.open = answers.kept & bits_of(d, near.unknown);
    if (!kThreeWay) return answers;
    const std::uint64_t contained = bits_of(d_narrow, within(d_narrow, shaft.extent, c, 0)) & answers.kept;
    if (contained == 0) return answers;
    const Positive far = positive(c, false);
    const std::uint64_t not_beyond = contained & ~bits_of(d, far.certain), unknown = bits_of(d, far.unknown);
    answers.inside = not_beyond & ~unknown;  // and so it meets, whatever the near sides say
    answers.open = (answers.open & ~answers.inside) | (not_beyond & unknown);
    return answers;
  }
};

template <class F>
BatchCounters run_exact(const ExactBoxShaft<F>& shaft, const BoxesSoA<F>& boxes, const BatchOutput& out,
                        const ExactPredicate<scene::Box<F>>& predicate) {
  const ExactBoxKernel<F> kernel{shaft};
  const std::array<const F*, 6> arrays{boxes.lo[0], boxes.lo[1], boxes.lo[2],
                                       boxes.hi[0], boxes.hi[1], boxes.hi[2]};
  return run_with_stages(kernel, arrays, boxes.count, out, shaft.has_error_free,
                         [&](std::size_t item) { return predicate(boxes[item]); });
}

BatchCounters run_exact_f32(const ExactBoxShaft<float>& shaft, const BoxesSoA<float>& boxes,
                            const BatchOutput& out, const ExactPredicate<scene::Box<float>>& predicate) {
  return run_exact(shaft, boxes, out, predicate);
}
BatchCounters run_exact_f64(const ExactBoxShaft<double>& shaft, const BoxesSoA<double>& boxes,
                            const BatchOutput& out, const ExactPredicate<scene::Box<double>>& predicate) {
  return run_exact(shaft, boxes, out, predicate);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gnomon::fast {

namespace {

HWY_EXPORT(run_exact_f32);
HWY_EXPORT(run_exact_f64);

BatchCounters run(const ExactBoxShaft<float>& shaft, const BoxesSoA<float>& boxes, const BatchOutput& out,
                  const ExactPredicate<scene::Box<float>>& predicate) {
  return HWY_DYNAMIC_DISPATCH(run_exact_f32)(shaft, boxes, out, predicate);
}
BatchCounters run(const ExactBoxShaft<double>& shaft, const BoxesSoA<double>& boxes, const BatchOutput& out,
                  const ExactPredicate<scene::Box<double>>& predicate) {
  return HWY_DYNAMIC_DISPATCH(run_exact_f64)(shaft, boxes, out, predicate);
}

}  // namespace

template <class F>
ExactBoxShaft<F>::ExactBoxShaft(const scene::Box<F>& a, const scene::Box<F>& b)
    : extent(extent_of(a, b)), to{}, from{}, planes{}, has_filter(true), has_error_free(true) {
  const ExtremeLists lists = extreme_lists(a, b);
  const auto side_on = [&](Face face) {
    const F run = b.c[face] - a.c[face], inverse = 1 / run;
    has_filter &= std::isnormal(run) && std::isnormal(inverse);
    return Side{a.c[face], inverse, face};
  };
  for (; to_count < lists.count_a; ++to_count) to[to_count] = side_on(lists.of_a[to_count]);
  for (; from_count < lists.count_b; ++from_count) from[from_count] = side_on(lists.of_b[from_count]);
  for (std::uint8_t i = 0; i < to_count; ++i) {
    for (std::uint8_t j = 0; j < from_count; ++j) {
      const Face f = to[i].face, g = from[j].face;
      if (axis_of(f) == axis_of(g)) continue;
      const ExactDifference n0 = outward_difference(b.c[g], a.c[g], is_max(f));
      const ExactDifference n1 = outward_difference(a.c[f], b.c[f], is_max(g));
      has_error_free &= n0.in_range() && n1.in_range();
      planes[plane_count++] = {n0.high, n0.low, n1.high, n1.low, f, g, i, j};
    }
  }
}

template <class F>
BatchCounters classify_boxes_exact(const ExactBoxShaft<F>& shaft, const BoxesSoA<F>& boxes,
                                   std::span<std::uint8_t> answers, ExactPredicate<scene::Box<F>> predicate) {
  return run(shaft, boxes, {answers.data(), {}}, predicate);
}

template <class F>
BatchCounters classify_boxes_exact(const ExactBoxShaft<F>& shaft, const BoxesSoA<F>& boxes, BitPlanes answers,
                                   ExactPredicate<scene::Box<F>> predicate) {
  return run(shaft, boxes, {nullptr, answers}, predicate);
}

template class ExactBoxShaft<float>;
template class ExactBoxShaft<double>;
template BatchCounters classify_boxes_exact(const ExactBoxShaft<float>&, const BoxesSoA<float>&,
                                            std::span<std::uint8_t>, ExactPredicate<scene::Box<float>>);
template BatchCounters classify_boxes_exact(const ExactBoxShaft<double>&, const BoxesSoA<double>&,
                                            std::span<std::uint8_t>, ExactPredicate<scene::Box<double>>);
template BatchCounters classify_boxes_exact(const ExactBoxShaft<float>&, const BoxesSoA<float>&, BitPlanes,
                                            ExactPredicate<scene::Box<float>>);
template BatchCounters classify_boxes_exact(const ExactBoxShaft<double>&, const BoxesSoA<double>&, BitPlanes,
                                            ExactPredicate<scene::Box<double>>);

}  // namespace gnomon::fast
#endif  // HWY_ONCE
