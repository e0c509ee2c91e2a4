// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes in the report: picture, speed against error, and the numbers.
#pragma once

#include <filesystem>
#include <string>

namespace gnomon::reports {

/// A section for every result file of `gnomon measure` in the folder, sorted by name: for each scene its
/// picture, where a file SCENE.png (the last part of the scene's name) lies beside the result file, and for
/// each variant and workload the plots and a table. Empty when there are none. Throws scene::InputError for
/// files of that kind that are not what they should be.
[[nodiscard]] std::string measure_section(const std::filesystem::path& folder);

}  // namespace gnomon::reports
