// SPDX-License-Identifier: GPL-3.0-or-later
// Counter-based random numbers: trial i of a seed is a pure function of (seed, stream, i).
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace gnomon::fuzz {

/// A 32-bit name for a stream of cases (FNV-1a), so that distributions and scalars do not share their
/// randomness.
[[nodiscard]] constexpr std::uint32_t stream_of(std::string_view name) {
  std::uint32_t hash = 2166136261u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash;
}

/// The random numbers of one trial, from Philox 4x32-10 (Salmon et al., SC 2011; Random123) with the seed as
/// key and (trial, stream, block) as counter. Bits become floats by our own code: the standard's
/// distributions differ between libraries.
class CaseRandom {
 public:
  CaseRandom(std::uint64_t seed, std::uint32_t stream, std::uint64_t trial)
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
        counter_{{static_cast<std::uint32_t>(trial), static_cast<std::uint32_t>(trial >> 32), stream, 0}} {}

  [[nodiscard]] std::uint32_t bits() {
    if (used_ == 4) {
      block_ = r123::Philox4x32()(counter_, key_);
      ++counter_.v[3];
      used_ = 0;
    }
    return block_.v[used_++];
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
  r123::Philox4x32::key_type key_;
  r123::Philox4x32::ctr_type counter_;
  r123::Philox4x32::ctr_type block_{};
  unsigned used_ = 4;
};

}  // namespace gnomon::fuzz
