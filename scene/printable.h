// SPDX-License-Identifier: MIT
// Text of unknown make, as a part of one printable line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gnomon::scene {

/// What an input says, for a message: control characters and bytes beyond ASCII become \xNN, and what is
/// longer than a message may be is cut. The result is one printable line whatever the input holds.
[[nodiscard]] inline std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 800;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string result;
  for (const char c : text) {
    if (result.size() > kLongest) return result + "...";
    if (c >= 0x20 && c <= 0x7e) {
      result += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      result += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return result;
}

}  // namespace gnomon::scene
