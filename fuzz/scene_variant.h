// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes moved and scaled: the same picture, other bits.
#pragma once

#include <span>
#include <string_view>

#include "scene/scene.h"

namespace gnomon::fuzz {

struct SceneVariant {
  std::string_view name;
  std::string_view description;
  double scale, offset;  ///< each coordinate c becomes c scale + offset
};

/// given, moved, scaled-up, scaled-down.
[[nodiscard]] std::span<const SceneVariant> scene_variants();

/// The variant of that name. Throws std::runtime_error, naming the known ones.
[[nodiscard]] const SceneVariant& scene_variant(std::string_view name);

/// The scene with points, balls, lights and view moved and scaled in doubles; not rounded to floats yet.
[[nodiscard]] scene::Scene transformed(const scene::Scene& scene, const SceneVariant& variant);

}  // namespace gnomon::fuzz
