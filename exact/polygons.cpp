// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/polygons.h"

#include <array>
#include <cstdint>
#include <optional>

#include "exact/side_of_face.h"
#include "exact/vector.h"

namespace gnomon::exact {

namespace {

using scene::FaceRun;
using scene::Scene;
using Point = std::array<double, 3>;

/// The sign of twice the area of a b c, seen along the axis that is left out.
int turn(const Point& a, const Point& b, const Point& c, std::size_t left_out) {
  const std::size_t i = (left_out + 1) % 3, j = (left_out + 2) % 3;
  const auto sign_with = [&](auto number) {
    using FT = decltype(number);
    const Vector<FT> u = between<FT>(a, b), v = between<FT>(a, c);
    return sign_of(FT(u[i] * v[j] - u[j] * v[i]));
  };
  {
    const CGAL::Interval_nt<false>::Protector upward;
    const Sign sign = sign_with(FilterKernel::FT());
    if (sign != Sign::unknown) return static_cast<int>(sign);
  }
  return static_cast<int>(sign_with(ExactFloat()));
}

/// A fan that grows by triangles, whatever their object.
class Fan {
 public:
  Fan(const Scene& scene, std::uint32_t first)
      : scene_(scene), first_(first), corners_(scene.triangles[first]), last_(corners_[2]) {
    before_last_ = corners_[1];
    for (std::size_t axis = 0; axis < 3 && turn_ == 0; ++axis) {
      axis_ = axis;
      turn_ = turn(point(corners_[0]), point(corners_[1]), point(corners_[2]), axis);
    }
  }

  /// Adds the triangle when the fan stays a convex polygon. One that has no normal has no turn to share, and
  /// takes none in.
  bool take(std::uint32_t triangle) {
    const auto& next = scene_.triangles[triangle];
    if (turn_ == 0 || next[0] != corners_[0] || next[1] != last_) return false;
    const Point &hub = point(corners_[0]), &end = point(next[2]);
    if (side_of_face(scene_, first_, end) != 0) return false;
    // Each triangle has less than half a turn at the hub, so that the whole fan can't pass a full one unseen.
    if (turn(hub, point(last_), end, axis_) != turn_) return false;
    if (turn(point(before_last_), point(last_), end, axis_) == -turn_) return false;
    if (turn(hub, point(corners_[1]), end, axis_) == -turn_) return false;
    before_last_ = last_;
    last_ = next[2];
    return true;
  }

 private:
  [[nodiscard]] const Point& point(std::uint32_t index) const { return scene_.points[index]; }

  const Scene& scene_;
  std::uint32_t first_;
  std::array<std::uint32_t, 3> corners_;  ///< of the first triangle
  std::uint32_t before_last_ = 0, last_;
  std::size_t axis_ = 0;  ///< the plane does not hold it: seen along it, turns are those within the plane
  int turn_ = 0;          ///< of the first triangle
};

}  // namespace

std::vector<FaceRun> polygons_of(const Scene& scene) {
  std::vector<FaceRun> runs;
  for (const scene::Object& object : scene.objects) {
    const auto begin = static_cast<std::uint32_t>(object.first_triangle);
    const auto end = begin + static_cast<std::uint32_t>(object.triangle_count);
    for (std::uint32_t first = begin; first < end;) {
      Fan fan(scene, first);
      std::uint32_t next = first + 1;
      while (next < end && fan.take(next)) ++next;
      runs.push_back({first, next - first});
      first = next;
    }
  }
  const auto triangles = static_cast<std::uint32_t>(scene.triangles.size());
  for (std::uint32_t ball = 0; ball < scene.balls.size(); ++ball) runs.push_back({triangles + ball, 1});
  return runs;
}

}  // namespace gnomon::exact
