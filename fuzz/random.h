// SPDX-License-Identifier: GPL-3.0-or-later
// Counter-based random numbers: trial i of a seed is a pure function of (seed, stream, i).
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace gnomon::fuzz {

/// A 32-bit name for a stream of cases (FNV-1a), so that distributions and scalars do not share their
/// randomness.
[[nodiscard]] constexpr std::uint32_t stream_of(std::string_view name) {
  std::uint32_t hash = 2166136261u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash;
}

/// The parts of a case that are drawn apart when several cases share a shaft.
enum class Part : std::uint8_t { shaft, t };

/// The random numbers of one trial, from Philox 4x32-10 (Salmon et al., SC 2011; Random123) with the seed as
/// key and (trial, stream, block) as counter. Bits become floats by our own code: the standard's
/// distributions differ between libraries.
class CaseRandom {
 public:
  /// With `per_shaft` above 1, the trials k per_shaft .. (k+1) per_shaft - 1 draw the same numbers for
  /// Part::shaft, and each its own for Part::t.
  CaseRandom(std::uint64_t seed, std::uint32_t stream, std::uint64_t trial, std::uint64_t per_shaft = 1)
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
        now_(stream, trial - trial % per_shaft, 0),
        other_(stream, trial, 1u << 31),
        shares_(per_shaft > 1) {}

  /// Says what the next numbers are for; a case begins with its shaft. Where each trial has a shaft of its
  /// own, all numbers are one sequence and this does nothing.
  void part(Part part) {
    if (!shares_ || part == part_) return;
    std::swap(now_, other_);
    part_ = part;
  }

  [[nodiscard]] std::uint32_t bits() {
    if (now_.used == 4) {
      now_.block = r123::Philox4x32()(now_.counter, key_);
      ++now_.counter.v[3];
      now_.used = 0;
    }
    return now_.block.v[now_.used++];
  }

  /// Uniform on the multiples of u in [0, 1): every value is a number of the format, none is rounded to 1.
  template <class F>
  [[nodiscard]] F unit() {
    if constexpr (sizeof(F) == sizeof(float)) {
      return static_cast<F>(bits() >> 8) * F(0x1p-24);
    } else {
      const std::uint64_t high = bits(), low = bits();
      return static_cast<F>(((high << 32) | low) >> 11) * F(0x1p-53);
    }
  }

  template <class F>
  [[nodiscard]] F between(F from, F to) {
    return from + unit<F>() * (to - from);
  }

  /// Uniform on 0 .. count-1 up to a bias below count / 2^32.
  [[nodiscard]] int below(int count) {
    return static_cast<int>((static_cast<std::uint64_t>(bits()) * static_cast<std::uint64_t>(count)) >> 32);
  }
  /// Uniform on from .. to, both included.
  [[nodiscard]] int integer(int from, int to) { return from + below(to - from + 1); }
  [[nodiscard]] bool chance(double probability) { return unit<float>() < static_cast<float>(probability); }
  template <class F>
  [[nodiscard]] F sign() {
    return (bits() & 1u) != 0 ? F(1) : F(-1);
  }

 private:
  struct Sequence {
    Sequence(std::uint32_t stream, std::uint64_t trial, std::uint32_t first_block)
        : counter{{static_cast<std::uint32_t>(trial), static_cast<std::uint32_t>(trial >> 32), stream,
                   first_block}} {}
    r123::Philox4x32::ctr_type counter;
    r123::Philox4x32::ctr_type block{};
    unsigned used = 4;
  };

  r123::Philox4x32::key_type key_;
  Sequence now_, other_;
  bool shares_;
  Part part_ = Part::shaft;
};

}  // namespace gnomon::fuzz
