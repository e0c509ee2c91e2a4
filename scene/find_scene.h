// SPDX-License-Identifier: MIT
// Scenes by what a user calls them: a file, or one that is made.
#pragma once

#include <optional>
#include <string>

#include "scene/builtin.h"
#include "scene/loaded_scene.h"

namespace gnomon::scene {

struct FoundScene {
  LoadedScene loaded;
  std::optional<SizedScene> builtin;  ///< which one it is; nothing for a file's scene
};

/// The scene of the file of that name, when there is one (folders don't count), as read_scene() reads it;
/// else the built-in scene NAME or NAME:SIZE. Throws InputError, with one line, for what is neither, a bad
/// size, and what read_scene() refuses.
[[nodiscard]] FoundScene find_scene(const std::string& word);

}  // namespace gnomon::scene
