// SPDX-License-Identifier: MIT
// Numbers out of the bytes of binary files.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

namespace gnomon::scene {

/// The T stored at `bytes` (sizeof(T) of them, any alignment) in the given byte order.
template <class T>
[[nodiscard]] T load_bytes(const char* bytes, std::endian order) {
  static_assert(std::is_arithmetic_v<T>);
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

}  // namespace gnomon::scene
