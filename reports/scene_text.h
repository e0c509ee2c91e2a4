// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes in words and as JSON.
#pragma once

#include <string>
#include <string_view>

#include "scene/loaded_scene.h"

namespace gnomon::reports {

/// What `gnomon scene` prints: counts of faces by kind, objects, lights, extent, and what is unusual.
[[nodiscard]] std::string scene_text(const scene::LoadedScene& loaded, std::string_view file);

/// The same, object by object, for scripts.
[[nodiscard]] std::string scene_json(const scene::LoadedScene& loaded, std::string_view file);

}  // namespace gnomon::reports
