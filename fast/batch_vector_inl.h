// SPDX-License-Identifier: MIT
// What all batch kernels share, compiled once for each instruction set (hence the toggled guard): items in
// words of 64, the store of answers, and the queue of undecided items. Internal to fast/batch_*.cpp.
#if defined(GNOMON_FAST_BATCH_VECTOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GNOMON_FAST_BATCH_VECTOR_INL_H_
#undef GNOMON_FAST_BATCH_VECTOR_INL_H_
#else
#define GNOMON_FAST_BATCH_VECTOR_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "fast/batch_output.h"

HWY_BEFORE_NAMESPACE();
namespace gnomon::fast {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Vectors that are worked on side by side, to hide latencies; AVX-512 has twice as many registers.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
inline constexpr std::size_t kSideBySide = 4;
#else
inline constexpr std::size_t kSideBySide = 2;
#endif

/// mask and a <= b; mask and not a > b (which a NaN passes). AVX-512 compares under a mask: no operation of
/// its own for the `and`, on a port that the arithmetic needs.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
HWY_INLINE hn::Mask512<float> and_le(hn::Mask512<float> mask, hn::Vec512<float> a, hn::Vec512<float> b) {
  return {_mm512_mask_cmp_ps_mask(mask.raw, a.raw, b.raw, _CMP_LE_OQ)};
}
HWY_INLINE hn::Mask512<double> and_le(hn::Mask512<double> mask, hn::Vec512<double> a, hn::Vec512<double> b) {
  return {_mm512_mask_cmp_pd_mask(mask.raw, a.raw, b.raw, _CMP_LE_OQ)};
}
HWY_INLINE hn::Mask512<float> and_not_gt(hn::Mask512<float> mask, hn::Vec512<float> a, hn::Vec512<float> b) {
  return {_mm512_mask_cmp_ps_mask(mask.raw, a.raw, b.raw, _CMP_NGT_UQ)};
}
HWY_INLINE hn::Mask512<double> and_not_gt(hn::Mask512<double> mask, hn::Vec512<double> a,
                                          hn::Vec512<double> b) {
  return {_mm512_mask_cmp_pd_mask(mask.raw, a.raw, b.raw, _CMP_NGT_UQ)};
}
/// Writes a vector: the numbers whose bits are set, then zeros; reads no others. (Highway's Compress copies a
/// table to the stack for doubles.)
HWY_INLINE void compress(const float* from, std::uint64_t bits, float* to) {
  const auto mask = static_cast<__mmask16>(bits);
  _mm512_storeu_ps(to, _mm512_maskz_compress_ps(mask, _mm512_maskz_loadu_ps(mask, from)));
}
HWY_INLINE void compress(const double* from, std::uint64_t bits, double* to) {
  const auto mask = static_cast<__mmask8>(bits);
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(mask, _mm512_maskz_loadu_pd(mask, from)));
}
#else
template <class M, class V>
HWY_INLINE M and_le(M mask, V a, V b) {
  return hn::And(mask, hn::Le(a, b));
}
template <class M, class V>
HWY_INLINE M and_not_gt(M mask, V a, V b) {
  return hn::AndNot(hn::Gt(a, b), mask);
}
#endif

template <class D>
HWY_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
  // Read back no more than was written: a wider load would wait for the store to reach the cache.
  using Word = std::conditional_t<hn::MaxLanes(D()) <= 8, std::uint8_t, std::uint16_t>;
  static_assert(hn::MaxLanes(D()) <= 16);
  std::uint8_t bytes[8];  // as many as StoreMaskBits may write
  hn::StoreMaskBits(d, mask, bytes);
  Word word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

/// std::max(std::max(lo - x, x - hi), 0), NaN included: std::max(p, q) is q only where p < q, and so is x86's
/// maximum with its operands the other way round.
template <class V>
HWY_INLINE V positive_part_of_larger(V lo, V x, V hi) {
  const auto std_max = [](V p, V q) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
    return hn::Max(q, p);
#else
    return hn::IfThenElse(hn::Lt(p, q), q, p);
#endif
  };
  return std_max(std_max(hn::Sub(lo, x), hn::Sub(x, hi)), hn::Zero(hn::DFromV<V>()));
}

/// Writes 64 answers: 0, 1 where kept, 2 where inside too.
HWY_INLINE void store_bytes(std::uint64_t kept, std::uint64_t inside, std::uint8_t* answers) {
#if HWY_TARGET == HWY_SCALAR
  for (int byte = 0; byte < 8; ++byte) {
    const auto spread = [byte](std::uint64_t word) {
      const std::uint64_t bits = ((word >> (8 * byte)) & 0xff) * 0x0101010101010101u & 0x8040201008040201u;
      return (bits + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
    };
    const std::uint64_t eight = spread(kept) + spread(inside);
    std::memcpy(answers + 8 * byte, &eight, 8);
  }
#else
  const hn::ScalableTag<std::uint8_t> d;
  const auto one = hn::Set(d, std::uint8_t{1});
  for (std::size_t i = 0; i < 64; i += hn::Lanes(d)) {
    const std::uint64_t kept_here = kept >> i, inside_here = inside >> i;
    std::uint8_t kept_bytes[8], inside_bytes[8];
    std::memcpy(kept_bytes, &kept_here, 8);
    std::memcpy(inside_bytes, &inside_here, 8);
    const auto at_least_one = hn::IfThenElseZero(hn::LoadMaskBits(d, kept_bytes), one);
    const auto at_least_two = hn::IfThenElseZero(hn::LoadMaskBits(d, inside_bytes), one);
    hn::StoreU(hn::Add(at_least_one, at_least_two), d, answers + i);
  }
#endif
}

/// Stores the first `count` <= 64 answers of a word.
HWY_INLINE void store_word(const BatchOutput& out, std::size_t word, std::size_t count, std::uint64_t kept,
                           std::uint64_t inside) {
  if (count < 64) {
    kept &= (std::uint64_t{1} << count) - 1;
    inside &= (std::uint64_t{1} << count) - 1;
  }
  if (out.bytes != nullptr) {
    if (count == 64) {
      store_bytes(kept, inside, out.bytes + 64 * word);
    } else {
      std::uint8_t answers[64];
      store_bytes(kept, inside, answers);
      std::memcpy(out.bytes + 64 * word, answers, count);
    }
  } else {
    out.planes.kept[word] = kept;
    if (out.planes.inside != nullptr) out.planes.inside[word] = inside;
  }
}

/// Runs a kernel over all words of 64 items that consist of kArrays numbers each. The last word is copied
/// when it is not full, so that nothing is read out of bounds. `left_open(item, open)` is told of words with
/// undecided items, after their answers were stored.
template <bool kThreeWay, std::size_t kArrays, class F, class Kernel, class LeftOpen>
HWY_INLINE void run_words(const Kernel& kernel, const std::array<const F*, kArrays>& arrays,
                          std::size_t count, const BatchOutput& out, LeftOpen left_open) {
  const std::size_t full = count / 64;
  for (std::size_t word = 0; word < full; ++word) {
    const BatchWord answers = kernel.template word<kThreeWay>(arrays.data(), 64 * word);
    store_word(out, word, 64, answers.kept, answers.inside);
    if (Kernel::kLeavesOpen && HWY_UNLIKELY(answers.open != 0)) left_open(64 * word, answers.open);
  }
  const std::size_t rest = count % 64;
  if (rest == 0) return;
  F copy[kArrays][64];
  std::array<const F*, kArrays> copies;
  for (std::size_t i = 0; i < kArrays; ++i) {
    std::memcpy(copy[i], arrays[i] + 64 * full, rest * sizeof(F));
    std::memset(copy[i] + rest, 0, (64 - rest) * sizeof(F));  // zeros: no work on denormals or NaN
    copies[i] = copy[i];
  }
  const BatchWord answers = kernel.template word<kThreeWay>(copies.data(), 0);
  store_word(out, full, rest, answers.kept, answers.inside);
  const std::uint64_t open = answers.open & ((std::uint64_t{1} << rest) - 1);
  if (Kernel::kLeavesOpen && open != 0) left_open(64 * full, open);
}

/// Undecided items, collected until there are enough to fill vectors.
template <std::size_t kArrays, class F>
struct OpenItems {
  static constexpr std::size_t kEnough = 192;
  static constexpr std::size_t kMost = kEnough + 64;         // what a word may add
  HWY_ALIGN_MAX F numbers[kArrays][kMost + 64 / sizeof(F)];  // and what compress() writes beyond
  std::size_t index[kMost];
  std::size_t count = 0;

  HWY_INLINE void add(const std::array<const F*, kArrays>& arrays, std::size_t first, std::uint64_t open) {
    const std::size_t before = count;
    for (std::uint64_t rest = open; rest != 0; rest &= rest - 1) {
      index[count++] = first + static_cast<std::size_t>(std::countr_zero(rest));
    }
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
    constexpr std::size_t kLanes = 64 / sizeof(F);
    std::size_t to = before;
    for (std::size_t offset = 0; offset < 64; offset += kLanes) {
      const std::uint64_t here = open >> offset & ((std::uint64_t{1} << kLanes) - 1);
      if (here == 0) continue;
      for (std::size_t i = 0; i < kArrays; ++i) compress(arrays[i] + first + offset, here, numbers[i] + to);
      to += static_cast<std::size_t>(std::popcount(here));
    }
#else
    for (std::size_t i = 0; i < kArrays; ++i) {
      for (std::size_t to = before; to < count; ++to) numbers[i][to] = arrays[i][index[to]];
    }
#endif
  }

  HWY_INLINE void move(std::size_t from, std::size_t to) {
    for (auto& array : numbers) array[to] = array[from];
    index[to] = index[from];
  }

  HWY_INLINE std::array<const F*, kArrays> at(std::size_t first) const {
    std::array<const F*, kArrays> arrays;
    for (std::size_t i = 0; i < kArrays; ++i) arrays[i] = numbers[i] + first;
    return arrays;
  }

  /// Repeats the last item until vectors are full.
  HWY_INLINE void pad(std::size_t lanes) {
    for (std::size_t i = count; count != 0 && i % lanes != 0; ++i) {
      for (auto& array : numbers) array[i] = array[count - 1];
    }
  }
};

/// Numbers as doubles.
template <class D>
HWY_INLINE hn::Vec<D> load_double(D d, const double* from) {
  return hn::LoadU(d, from);
}
template <class D>
HWY_INLINE hn::Vec<D> load_double(D d, const float* from) {
  return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D>(), from));
}

/// How hard resolve_on_grid() tries: a glance decides most items, and the few left are looked at together.
enum class Effort { glance, thorough };

/// All stages: the kernel's words; for what they leave open resolve_on_grid(), where there is one, and
/// resolve(); and `decide` for the rest.
template <class F, std::size_t kArrays, class Kernel, class Decide>
HWY_INLINE BatchCounters run_with_stages(const Kernel& kernel, const std::array<const F*, kArrays>& arrays,
                                         std::size_t count, const BatchOutput& out, bool has_second_stage,
                                         Decide decide) {
  BatchCounters counters;
  OpenItems<kArrays, F> items;
  const auto category_of = [](const BatchWord& answers, std::size_t lane) {
    return static_cast<scene::Category>((answers.kept >> lane & 1) + (answers.inside >> lane & 1));
  };
  // Moves what the grid leaves open to the front.
  const auto resolve_on_grid = [&]<bool kThreeWay, Effort kEffort>() {
    if constexpr (Kernel::kHasGrid) {  // here, as clang 14 looks into lambdas that are never called
      const std::size_t lanes = hn::Lanes(hn::ScalableTag<F>());
      items.pad(lanes);
      std::size_t left = 0;
      for (std::size_t first = 0; first < items.count; first += lanes) {
        const std::size_t many = std::min(lanes, items.count - first);
        const BatchWord answers = kernel.template resolve_on_grid<kThreeWay, kEffort>(items.at(first).data());
        for (std::size_t i = 0; i < many; ++i) {
          if (HWY_UNLIKELY((answers.open >> i & 1) != 0)) {
            items.move(first + i, left++);
          } else {
            out.set(items.index[first + i], category_of(answers, i));
          }
        }
      }
      counters.on_grid += items.count - left;
      items.count = left;
    }
  };
  const auto resolve_all = [&]<bool kThreeWay>() {
    counters.second_stage += items.count;
    if constexpr (Kernel::kHasGrid) {
      if (kernel.shaft.grid.is_usable) {
        resolve_on_grid.template operator()<kThreeWay, Effort::glance>();
        resolve_on_grid.template operator()<kThreeWay, Effort::thorough>();
      }
    }
    const std::size_t lanes = hn::Lanes(hn::ScalableTag<double>());
    items.pad(lanes);
    for (std::size_t first = 0; first < items.count; first += lanes) {
      const std::size_t many = std::min(lanes, items.count - first);
      BatchWord answers;
      answers.open = ~std::uint64_t{0};
      if (has_second_stage) answers = kernel.template resolve<kThreeWay>(items.at(first).data());
      for (std::size_t i = 0; i < many; ++i) {
        const std::size_t item = items.index[first + i];
        if ((answers.open >> i & 1) != 0) {
          ++counters.predicate_calls;
          out.set(item, decide(item));
        } else {
          out.set(item, category_of(answers, i));
        }
      }
    }
    items.count = 0;
  };
  const auto run = [&]<bool kThreeWay>() {
    const auto left_open = [&](std::size_t first, std::uint64_t open) {
      items.add(arrays, first, open);
      if (items.count >= items.kEnough) resolve_all.template operator()<kThreeWay>();
    };
    run_words<kThreeWay>(kernel, arrays, count, out, left_open);
    resolve_all.template operator()<kThreeWay>();
  };
  if (out.asks_three_way()) {
    run.template operator()<true>();
  } else {
    run.template operator()<false>();
  }
  return counters;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace gnomon::fast
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
