// SPDX-License-Identifier: MIT
// What the batch kernels read and write: structures of arrays, answers as bytes or bit planes, and the exact
// predicate that the exact tier is given.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "fast/strict_float.h"
#include "scene/ball.h"
#include "scene/box.h"
#include "scene/category.h"

namespace gnomon::fast {

/// A view of `count` boxes as six arrays. Nothing is asked of the arrays' alignment; nothing is read beyond
/// `count`.
template <class F>
struct BoxesSoA {
  std::array<const F*, 3> lo{}, hi{};
  std::size_t count = 0;

  [[nodiscard]] scene::Box<F> operator[](std::size_t i) const {
    return {{lo[0][i], lo[1][i], lo[2][i], hi[0][i], hi[1][i], hi[2][i]}};
  }
};

/// A view of `count` balls as four arrays, as BoxesSoA.
template <class F>
struct BallsSoA {
  std::array<const F*, 3> centre{};
  const F* radius = nullptr;
  std::size_t count = 0;

  [[nodiscard]] scene::Ball<F> operator[](std::size_t i) const {
    return {{centre[0][i], centre[1][i], centre[2][i]}, radius[i]};
  }
};

/// The number of 64-bit words in a bit plane for `count` items.
[[nodiscard]] constexpr std::size_t words_for(std::size_t count) {
  return (count + 63) / 64;
}

/// Answers as two bit planes of words_for(count) words each: bit i % 64 of word i / 64 belongs to item i,
/// bits beyond the last item are 0. `inside` may be null: then only outside or not is asked, which is
/// cheaper.
struct BitPlanes {
  std::uint64_t* kept = nullptr;    ///< 1: not outside
  std::uint64_t* inside = nullptr;  ///< 1: inside (never without `kept`)
};

/// The instruction set that batch kernels run on in this process now, in Highway's words ("AVX3" is AVX-512).
[[nodiscard]] const char* batch_instruction_set();

/// What the exact tier had to do beyond its first stage.
struct BatchCounters {
  std::uint64_t second_stage = 0;     ///< items that the first stage left open
  std::uint64_t on_grid = 0;          ///< those of them that were decided on a grid (balls only)
  std::uint64_t predicate_calls = 0;  ///< items that all stages left open

  friend bool operator==(const BatchCounters&, const BatchCounters&) = default;
};

/// A reference to a callable that decides one box or ball exactly: what the exact tier hands its last few
/// undecided items to. The callable must outlive the reference. It has to answer the exact category of every
/// valid item; it may throw, and the batch then ends with its answers unspecified.
template <class Item>
class ExactPredicate {
 public:
  template <class Callable>
  requires(!std::is_same_v<std::remove_cvref_t<Callable>, ExactPredicate> &&
           std::is_invocable_r_v<scene::Category, const Callable&, const Item&>)
      ExactPredicate(
          const Callable& callable)  // NOLINT(google-explicit-constructor): a reference, as a span is
      : context_(std::addressof(callable)), call_([](const void* context, const Item& item) {
          return static_cast<scene::Category>((*static_cast<const Callable*>(context))(item));
        }) {}

  [[nodiscard]] scene::Category operator()(const Item& item) const { return call_(context_, item); }

 private:
  const void* context_;
  scene::Category (*call_)(const void*, const Item&);
};

}  // namespace gnomon::fast
