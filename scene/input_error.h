// SPDX-License-Identifier: MIT
// How bad input is reported: one line that names the file, the line and what was expected.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "scene/printable.h"

namespace gnomon::scene {

/// Thrown by every reader on input that it can't take. what() is the whole one-line message,
/// "FILE:LINE: expected ..., found ..." (":LINE" is left out when line is 0: the file as a whole). The
/// message is made printable(); the file's name stands as it is given.
class InputError : public std::runtime_error {
 public:
  InputError(std::string_view file, std::size_t line, std::string_view message)
      : std::runtime_error(std::string(file) + (line == 0 ? "" : ":" + std::to_string(line)) + ": " +
                           printable(message)) {}
};

}  // namespace gnomon::scene
