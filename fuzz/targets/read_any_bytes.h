// SPDX-License-Identifier: GPL-3.0-or-later
// What the targets of mesh and scene readers have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <istream>
#include <sstream>
#include <string>
#include <string_view>

#include "scene/input_error.h"

namespace gnomon::fuzz {

/// Aborts unless the reader makes a valid mesh or scene of the bytes or throws an InputError whose message is
/// one printable line that begins with the input's name; other exceptions end the process as well.
template <class T>
void read_any_bytes(T (*read)(std::istream&, std::string_view), const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(data, data + size));
  try {
    if (!is_valid(read(in, "input"))) std::abort();
  } catch (const scene::InputError& error) {
    const std::string_view message = error.what();
    if (!message.starts_with("input:")) std::abort();
    for (const char c : message) {
      if (c < 0x20 || c > 0x7e) std::abort();
    }
  }
}

}  // namespace gnomon::fuzz
