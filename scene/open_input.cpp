// SPDX-License-Identifier: MIT
#include "scene/open_input.h"

#include <system_error>

#include "scene/input_error.h"

namespace gnomon::scene {

std::ifstream open_input(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path.string(), 0, "expected a file, found none");
  if (std::filesystem::is_directory(status))
    throw InputError(path.string(), 0, "expected a file, found a directory");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path.string(), 0, "expected a readable file, found one that can't be opened");
  return in;
}

}  // namespace gnomon::scene
