// SPDX-License-Identifier: MIT
// Files that are whole or not there.
#pragma once

#include <filesystem>
#include <string_view>

namespace gnomon::scene {

/// Writes `contents` to a temporary name in the same folder, flushes it to the disk, and renames it to
/// `path`: a crash leaves the old file or the new one, never a part. Makes missing folders. Throws
/// std::runtime_error naming the path.
void write_whole_file(const std::filesystem::path& path, std::string_view contents);

/// Throws what write_whole_file(path, ...) would throw, before hours of work whose results can't be kept.
/// Leaves everything as it is: a file that is there, folders that are missing.
void require_writable(const std::filesystem::path& path);

}  // namespace gnomon::scene
