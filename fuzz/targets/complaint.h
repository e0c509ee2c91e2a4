// SPDX-License-Identifier: GPL-3.0-or-later
// What every complaint about an input has to look like.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace gnomon::fuzz {

/// Aborts unless the message is one printable line of moderate length that begins with the input's name.
inline void expect_complaint(std::string_view message, std::string_view name) {
  bool good = message.starts_with(name) && message.size() < 1000;
  for (const char c : message) good &= c >= 0x20 && c <= 0x7e;
  if (good) return;
  std::fprintf(stderr, "no complaint about \"%.*s\": %.*s\n", static_cast<int>(name.size()), name.data(),
               static_cast<int>(message.size()), message.data());
  std::abort();
}

}  // namespace gnomon::fuzz
