// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes to small scenes with a query and a ray: every byte string is valid, and short ones reach shared
// vertices, ties, degenerate faces, contacts with borders, one-sided and own faces.
#pragma once

#include <algorithm>
#include <cmath>

#include "fuzz/targets/decode_case.h"
#include "scene/ray_query.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::fuzz {

struct SmallScene {
  scene::Scene scene;
  scene::ShadowQuery shadow;
  scene::RayQuery ray;
  int shift = 0;  ///< all numbers times 2^shift are another case of the same answers
};

class SceneDecoder {
 public:
  using Point = std::array<double, 3>;

  explicit SceneDecoder(Bytes bytes) : bytes_(bytes) {}

  [[nodiscard]] SmallScene decode() {
    SmallScene result;
    scene::Scene& scene = result.scene;
    scene = decode_scene();
    const unsigned owner = bytes_.next();
    const auto faces = static_cast<std::uint32_t>(scene.face_count());
    const std::uint32_t own = owner % 2 == 0 ? scene::kNoFace : owner / 2 % faces;
    result.shadow = {end(), end(), own};
    result.ray = {result.shadow.point, {}, own};
    for (std::size_t k = 0; k < 3; ++k) {
      result.ray.direction[k] = rounded(result.shadow.light[k] - result.shadow.point[k]);
    }
    if (result.ray.direction == Point{0, 0, 0}) result.ray.direction = {0, 0, 1};
    result.shift = bytes_.small() % 41;
    return result;
  }

 protected:
  [[nodiscard]] scene::Scene decode_scene() {
    const unsigned kind = bytes_.next();
    grid_ = kind % 4 != 0;
    doubles_ = kind % 4 == 3;
    const unsigned count = 1 + bytes_.next() % 12;
    for (unsigned i = 0; i < count; ++i) add_face(bytes_.next());
    scene::Scene scene;
    scene.points = points_;
    scene.triangles = triangles_;
    scene.balls = balls_;
    scene::Object object;
    object.triangle_count = static_cast<std::uint32_t>(triangles_.size());
    object.ball_count = static_cast<std::uint32_t>(balls_.size());
    object.one_sided = (kind & 4u) != 0;
    scene.objects.push_back(object);
    return scene;
  }

  [[nodiscard]] double rounded(double x) const {
    if (doubles_) return x;
    const volatile float y = static_cast<float>(std::clamp(x, -0x1p127, 0x1p127));
    return static_cast<double>(y);
  }

  [[nodiscard]] double number() {
    if (grid_) return rounded(static_cast<double>(bytes_.small() % 8) * (doubles_ ? 0.1 : 1.0));
    const float x = std::bit_cast<float>(static_cast<std::uint32_t>(bytes_.word(4)));
    // Within the certified tier's range, and far from overflow in everybody's doubles.
    return std::isfinite(x) ? std::clamp(static_cast<double>(x), -0x1p40, 0x1p40) : 0;
  }
  [[nodiscard]] Point point() {
    const double x = number(), y = number();
    return {x, y, number()};
  }

  /// A new point's number, or an earlier one's.
  [[nodiscard]] std::uint32_t corner() {
    const unsigned how = bytes_.next();
    if (how % 3 == 0 && !points_.empty()) return static_cast<std::uint32_t>(how / 3 % points_.size());
    const Point p = point();
    const auto same = std::find(points_.begin(), points_.end(), p);  // equal points share an index
    const auto index = static_cast<std::uint32_t>(same - points_.begin());
    if (index == points_.size()) points_.push_back(p);
    return index;
  }

  void add_face(unsigned how) {
    if (how % 8 == 0) {
      const Point centre = point();
      balls_.push_back({centre, std::fabs(number())});
      return;
    }
    const std::uint32_t a = corner(), b = corner();
    triangles_.push_back({a, b, corner()});
  }

  /// An end of the path: anywhere, a corner, beside one, or through the middle of an edge from the other end.
  [[nodiscard]] Point end() {
    const unsigned how = bytes_.next();
    if (how % 4 == 0 || points_.empty()) return point();
    Point p = points_[how / 4 % points_.size()];
    if (how % 4 == 1) return p;
    const Point other = how % 4 == 2 ? point() : points_[bytes_.next() % points_.size()];
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = rounded(how % 4 == 2 ? 2 * p[k] - other[k] : (p[k] + other[k]) / 2);
    return p;
  }

  Bytes bytes_;
  bool grid_ = false, doubles_ = false;
  std::vector<Point> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<scene::Ball<double>> balls_;
};

}  // namespace gnomon::fuzz
