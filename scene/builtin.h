// SPDX-License-Identifier: MIT
// Scenes that are made, not read: one for each kind of scene that the papers measured on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace gnomon::scene {

/// A scene with a size. Whatever the size: it is_valid() and has a view; all coordinates are floats; no face
/// is degenerate; every object is closed, one-sided and turned outward, and declared convex only where it
/// is so exactly (which the tests decide). The same size gives the same bits everywhere.
struct BuiltinScene {
  std::string_view name;
  std::string_view summary;
  std::string_view size_means;               ///< what the size counts
  std::string_view stands_for;               ///< whose scene it stands for, and what that was measured with
  std::uint32_t default_size, largest_size;  ///< sizes are from 1 to the largest
  std::size_t (*faces)(std::uint32_t size);  ///< exactly how many faces make() makes
  Scene (*make)(std::uint32_t size);
};

/// All of them, in the order in which they are listed.
[[nodiscard]] std::span<const BuiltinScene> builtin_scenes();

/// A built-in scene and the size asked for.
struct SizedScene {
  const BuiltinScene* scene = nullptr;
  std::uint32_t size = 0;

  [[nodiscard]] std::size_t faces() const { return scene->faces(size); }
  [[nodiscard]] Scene make() const { return scene->make(size); }
};

/// The scene that NAME or NAME:SIZE asks for, of its default size without one; nothing when no scene has the
/// name. Throws InputError, with one line that names the word, for a size that is no whole number from 1 to
/// the largest.
[[nodiscard]] std::optional<SizedScene> find_builtin(std::string_view word);

/// The names, with commas between them: for complaints about unknown ones.
[[nodiscard]] std::string_view builtin_names();

}  // namespace gnomon::scene
