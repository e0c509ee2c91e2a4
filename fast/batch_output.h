// SPDX-License-Identifier: MIT
// Where batch kernels put their answers. Internal to fast/batch_*.cpp.
#pragma once

#include "fast/batch_types.h"

namespace gnomon::fast {

/// The answers for 64 items.
struct BatchWord {
  std::uint64_t kept = 0, inside = 0;
  std::uint64_t open = 0;  ///< undecided: kept and inside mean nothing there
};

/// Bytes when `bytes` is set, else bit planes.
struct BatchOutput {
  std::uint8_t* bytes = nullptr;
  BitPlanes planes;

  [[nodiscard]] bool asks_three_way() const { return bytes != nullptr || planes.inside != nullptr; }

  void set(std::size_t item, scene::Category answer) const {
    if (bytes != nullptr) {
      bytes[item] = static_cast<std::uint8_t>(answer);
      return;
    }
    const std::uint64_t bit = std::uint64_t{1} << (item % 64);
    const auto write = [&](std::uint64_t* plane, bool on) {
      plane[item / 64] = on ? plane[item / 64] | bit : plane[item / 64] & ~bit;
    };
    write(planes.kept, answer != scene::Category::outside);
    if (planes.inside != nullptr) write(planes.inside, answer == scene::Category::inside);
  }
};

}  // namespace gnomon::fast
