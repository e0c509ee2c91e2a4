// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes in words and as JSON.
#pragma once

#include <string>
#include <string_view>

#include "scene/find_scene.h"

namespace gnomon::reports {

/// What `gnomon scene` prints: counts of faces by kind, objects, lights, extent, and what is unusual. `name`
/// is what the scene was asked for by.
[[nodiscard]] std::string scene_text(const scene::FoundScene& found, std::string_view name);

/// The same, object by object, for scripts.
[[nodiscard]] std::string scene_json(const scene::FoundScene& found, std::string_view name);

}  // namespace gnomon::reports
