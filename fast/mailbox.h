// SPDX-License-Identifier: MIT
// Marks on items that are all taken off at once (Arnaldi, Priol, Bouatouch 1987, for rays and objects).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fast/strict_float.h"

namespace gnomon::fast {

/// A number for each item, and an identifier: the item is marked when both are equal. A new identifier takes
/// off all marks in constant time.
class Mailbox {
 public:
  /// Takes off all marks; `items` are numbered from 0. Allocates only when there are more than ever before.
  void begin(std::size_t items) {
    if (stamps_.size() < items) stamps_.resize(items, 0);
    any_ = false;
    if (++identifier_ == 0) {
      std::fill(stamps_.begin(), stamps_.end(), 0);
      identifier_ = 1;
    }
  }
  void mark(std::uint32_t item) {
    stamps_[item] = identifier_;
    any_ = true;
  }
  [[nodiscard]] bool is_marked(std::uint32_t item) const { return any_ && stamps_[item] == identifier_; }
  [[nodiscard]] bool any() const { return any_; }

 private:
  std::vector<std::uint32_t> stamps_;
  std::uint32_t identifier_ = 0;
  bool any_ = false;
};

}  // namespace gnomon::fast
