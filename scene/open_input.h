// SPDX-License-Identifier: MIT
// Files for reading.
#pragma once

#include <filesystem>
#include <fstream>

namespace gnomon::scene {

/// The file, opened for reading its bytes. Throws InputError when there is none, it is a folder, or it can't
/// be opened.
[[nodiscard]] std::ifstream open_input(const std::filesystem::path& path);

}  // namespace gnomon::scene
