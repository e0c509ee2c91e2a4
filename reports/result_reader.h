// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and validates result files (schema 1).
#pragma once

#include <filesystem>
#include <vector>

#include "reports/result_set.h"

namespace gnomon::reports {

/// One result file. Fields that this reader does not know are left alone. Throws scene::InputError, which
/// names the file and what was expected, when it can't be read, is not JSON, has another schema, lacks a
/// field, has a field of the wrong type, or has counts that do not add up.
[[nodiscard]] ResultFile read_result_file(const std::filesystem::path& path);

/// Every *.json of `dir` (not of its subfolders), sorted by file name.
/// Throws scene::InputError as read_result_file() does, and when dir is not a folder or has no result file,
/// or when a file is the same run (kind, command, seed and shard) as another one: its cases would be counted
/// twice.
[[nodiscard]] std::vector<ResultFile> read_result_folder(const std::filesystem::path& dir);

}  // namespace gnomon::reports
