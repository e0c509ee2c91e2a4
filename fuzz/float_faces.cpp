// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/float_faces.h"

#include <algorithm>

namespace gnomon::fuzz {

FloatFaces::FloatFaces(const scene::Scene& scene) : triangles(scene.triangles), one_sided(triangles.size()) {
  points.reserve(scene.points.size());
  for (const std::array<double, 3>& point : scene.points) points.push_back(to_floats(point));
  balls.reserve(scene.balls.size());
  for (const scene::Ball<double>& ball : scene.balls) balls.push_back(scene::converted<float>(ball));
  for (const scene::Object& object : scene.objects) {
    if (!object.one_sided) continue;
    const auto first = one_sided.begin() + static_cast<std::ptrdiff_t>(object.first_triangle);
    std::fill(first, first + static_cast<std::ptrdiff_t>(object.triangle_count), std::uint8_t{1});
  }
}

}  // namespace gnomon::fuzz
