// SPDX-License-Identifier: MIT
#include "scene/find_scene.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "scene/input_error.h"
#include "scene/read_scene.h"

namespace gnomon::scene {
namespace {

bool names_builtin(const std::string& word) {
  const std::string name = word.substr(0, word.find(':'));
  return std::ranges::any_of(builtin_scenes(), [&](const BuiltinScene& scene) { return scene.name == name; });
}

/// A scene file's name has an extension, and a word for a built-in scene has none.
bool looks_like_a_file(const std::filesystem::path& path) {
  return path.has_extension() || path.has_parent_path();
}

}  // namespace

FoundScene find_scene(const std::string& word) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(word, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_directory(status)) {
    if (names_builtin(word) && !looks_like_a_file(word)) {
      throw InputError(word, 0,
                       "expected the extension .nff, .off, .obj, .ply or .stl, found none: this file hides "
                       "the built-in scene of that name");
    }
    return {read_scene(word), std::nullopt};
  }
  if (const std::optional<SizedScene> builtin = find_builtin(word)) {
    return {{builtin->make(), 0, 0, 0}, builtin};
  }
  if (looks_like_a_file(word) || std::filesystem::exists(status)) return {read_scene(word), std::nullopt};
  throw InputError(
      word, 0, "expected a file or a built-in scene (" + std::string(builtin_names()) + "), found neither");
}

}  // namespace gnomon::scene
