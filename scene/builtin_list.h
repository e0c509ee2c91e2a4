// SPDX-License-Identifier: MIT
// The rows of the built-in scenes, each made in a file of its own. Internal to scene/.
#pragma once

#include "scene/builtin.h"

namespace gnomon::scene {

[[nodiscard]] BuiltinScene cards_scene();
[[nodiscard]] BuiltinScene chessboard_scene();
[[nodiscard]] BuiltinScene city_scene();
[[nodiscard]] BuiltinScene classroom_scene();
[[nodiscard]] BuiltinScene floor_scene();
[[nodiscard]] BuiltinScene gazebo_scene();
[[nodiscard]] BuiltinScene gears_scene();
[[nodiscard]] BuiltinScene living_room_scene();
[[nodiscard]] BuiltinScene office_scene();
[[nodiscard]] BuiltinScene office_fine_scene();
[[nodiscard]] BuiltinScene sphereflake_scene();
[[nodiscard]] BuiltinScene temple_scene();
[[nodiscard]] BuiltinScene tetra_scene();
[[nodiscard]] BuiltinScene tree_scene();

}  // namespace gnomon::scene
