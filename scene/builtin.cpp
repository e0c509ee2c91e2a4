// SPDX-License-Identifier: MIT
#include "scene/builtin.h"

#include <array>
#include <string>

#include "scene/builtin_list.h"
#include "scene/input_error.h"
#include "scene/parse_number.h"

namespace gnomon::scene {

std::span<const BuiltinScene> builtin_scenes() {
  static const std::array kScenes{office_scene(), office_fine_scene(), sphereflake_scene(), tetra_scene(),
                                  tree_scene(),   gears_scene(),       chessboard_scene(),  cards_scene(),
                                  gazebo_scene(), living_room_scene(), classroom_scene(),   floor_scene(),
                                  temple_scene(), city_scene()};
  return kScenes;
}

std::optional<SizedScene> find_builtin(std::string_view word) {
  const std::size_t colon = word.find(':');
  const std::string_view name = word.substr(0, colon);
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (scene.name != name) continue;
    if (colon == std::string_view::npos) return SizedScene{&scene, scene.default_size};
    const std::string_view text = word.substr(colon + 1);
    const std::optional<std::int64_t> size = parse_integer(text);
    if (!size || *size < 1 || *size > scene.largest_size) {
      throw InputError(word, 0,
                       "expected a size from 1 to " + std::to_string(scene.largest_size) + " after \"" +
                           std::string(name) + ":\", found \"" + std::string(text) + "\"");
    }
    return SizedScene{&scene, static_cast<std::uint32_t>(*size)};
  }
  return std::nullopt;
}

std::string_view builtin_names() {
  static const std::string kNames = [] {
    std::string names;
    for (const BuiltinScene& scene : builtin_scenes()) {
      names.append(names.empty() ? "" : ", ").append(scene.name);
    }
    return names;
  }();
  return kNames;
}

}  // namespace gnomon::scene
