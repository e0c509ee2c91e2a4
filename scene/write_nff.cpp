// SPDX-License-Identifier: MIT
#include "scene/write_nff.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "scene/float_text.h"
#include "scene/printable.h"

namespace gnomon::scene {
namespace {

void append_numbers(std::string& text, const std::array<double, 3>& numbers) {
  for (const double number : numbers) text.append(" ").append(decimal_text(number));
}

void append_view(std::string& text, const View& view) {
  text += "v\nfrom";
  append_numbers(text, view.from);
  text += "\nat";
  append_numbers(text, view.at);
  text += "\nup";
  append_numbers(text, view.up);
  text += "\nangle " + decimal_text(view.angle) + "\nhither " + decimal_text(view.hither) + "\nresolution " +
          std::to_string(view.columns) + " " + std::to_string(view.rows) + "\n";
}

// A comment must stay on its line: names are printable().
void append_object(std::string& text, const Scene& scene, const Object& object) {
  text += "# " + printable(object.name) + "\nf 1 1 1 1 0 0 " + decimal_text(object.transmittance) + " 1\n";
  for (std::size_t t = object.first_triangle; t < object.first_triangle + object.triangle_count; ++t) {
    text += "p 3\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<double, 3>& p = scene.corner(t, k);
      text += decimal_text(p[0]) + " " + decimal_text(p[1]) + " " + decimal_text(p[2]) + "\n";
    }
  }
  for (std::size_t b = object.first_ball; b < object.first_ball + object.ball_count; ++b) {
    text += "s";
    append_numbers(text, scene.balls[b].centre);
    text += " " + decimal_text(scene.balls[b].radius) + "\n";
  }
}

/// Rounded, and within the extent of the corners even where their sum overflows.
std::array<double, 3> mean_of(const std::vector<std::array<double, 3>>& corners) {
  const auto count = static_cast<double>(corners.size());
  std::array<double, 3> mean{};
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0, sum_of_parts = 0, lo = corners[0][k], hi = lo;
    for (const std::array<double, 3>& p : corners) {
      sum += p[k];
      sum_of_parts += p[k] / count;
      lo = std::min(lo, p[k]);
      hi = std::max(hi, p[k]);
    }
    mean[k] = std::clamp(std::isfinite(sum) ? sum / count : sum_of_parts, lo, hi);
  }
  return mean;
}

}  // namespace

std::string nff_text(const Scene& scene) {
  std::string text;
  if (scene.view) append_view(text, *scene.view);
  for (const PointLight& light : scene.point_lights) {
    text += "l";
    append_numbers(text, light.position);
    text += "\n";
  }
  for (const PolygonLight& polygon : scene.polygon_lights) {
    const PointLight light{mean_of(polygon.corners)};
    if (std::ranges::find(scene.point_lights, light) != scene.point_lights.end()) {
      text += "# a polygon light: the light at the mean of its corners is among the above\n";
      continue;
    }
    text += "# a polygon light, as a point at the mean of its corners\nl";
    append_numbers(text, light.position);
    text += "\n";
  }
  for (const Object& object : scene.objects) append_object(text, scene, object);
  return text;
}

}  // namespace gnomon::scene
