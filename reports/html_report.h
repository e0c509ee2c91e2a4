// SPDX-License-Identifier: GPL-3.0-or-later
// From result files to one self-contained page.
#pragma once

#include <filesystem>

namespace gnomon::reports {

/// Reads every result file (*.json, sorted by name) of `dir` and writes one HTML page to `out`: speed against
/// error, counts with their 95 % bounds, witnesses with pictures, environment. The page loads nothing from
/// anywhere, is complete without scripting and in print, and depends on nothing but the result files: the
/// same input gives the same bytes. It appears under `out` whole or not at all.
///
/// Throws scene::InputError as read_result_folder() does, std::runtime_error when `out` can't be written.
void write_html_report(const std::filesystem::path& dir, const std::filesystem::path& out);

}  // namespace gnomon::reports
