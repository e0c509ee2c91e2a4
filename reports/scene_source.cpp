// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/scene_source.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "scene/find_scene.h"
#include "scene/input_error.h"
#include "scene/parse_number.h"

namespace gnomon::reports {

NamedScene load_scene(const std::string& word) {
  NamedScene named{word, scene::find_scene(word).loaded.scene};
  if (named.scene.face_count() == 0)
    throw scene::InputError(word, 0, "expected a scene with faces, found none");
  return named;
}

std::array<double, 3> parse_light(const std::string& text) {
  const auto fail = [&text] {
    throw std::runtime_error("--light: expected X,Y,Z, three numbers within the range of floats, found \"" +
                             scene::printable(text) + "\"");
  };
  std::array<double, 3> light{};
  std::string_view rest = text;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (k == 2)) fail();
    const std::optional<float> number = scene::parse_real<float>(rest.substr(0, comma));
    if (!number || !std::isfinite(*number)) fail();
    light[k] = *scene::parse_real<double>(rest.substr(0, comma));
    rest.remove_prefix(k == 2 ? rest.size() : comma + 1);
  }
  return light;
}

}  // namespace gnomon::reports
