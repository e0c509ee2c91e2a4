// SPDX-License-Identifier: MIT
// Numbers that make one house unlike the next. Internal to scene/.
#pragma once

#include <cstdint>

namespace gnomon::scene {

/// A number of 32 bits that looks random and depends on `index` alone: SplitMix64 (Steele, Lea and Flood
/// 2014).
[[nodiscard]] inline std::uint32_t scrambled(std::uint64_t index) {
  std::uint64_t z = (index + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<std::uint32_t>((z ^ (z >> 31U)) >> 32U);
}

/// One of the multiples of 1/256 from 0 to below 1.
[[nodiscard]] inline double varied(std::uint64_t index) {
  return (scrambled(index) & 255U) / 256.0;
}

}  // namespace gnomon::scene
