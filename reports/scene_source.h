// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes as the command line names them.
#pragma once

#include <array>
#include <string>

#include "scene/scene.h"

namespace gnomon::reports {

struct NamedScene {
  std::string name;
  scene::Scene scene;
};

/// The scene that a word names: a built-in one as NAME or NAME:SIZE, or a file. Throws scene::InputError,
/// with one line, when it can't be read or made, or has no faces.
[[nodiscard]] NamedScene load_scene(const std::string& word);

/// The point that X,Y,Z says. Throws std::runtime_error, with one line, unless these are three finite numbers
/// within the range of floats.
[[nodiscard]] std::array<double, 3> parse_light(const std::string& text);

}  // namespace gnomon::reports
