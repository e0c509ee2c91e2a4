// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/radiosity_patch.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "exact/polygons.h"
#include "exact/side_of_face.h"
#include "fuzz/triangle_sample.h"

namespace gnomon::fuzz {
namespace {

using Corners = std::vector<Vector3>;

Vector3 normal_of(const Vector3& a, const Vector3& b, const Vector3& c) {
  return cross_product(minus(b, a), minus(c, a));
}

Corners corners_of(const scene::Scene& scene, scene::FaceRun fan) {
  Corners corners{scene.corner(fan.first, 0), scene.corner(fan.first, 1)};
  for (std::uint32_t t = fan.first; t < fan.first + fan.count; ++t) corners.push_back(scene.corner(t, 2));
  return corners;
}

/// What follows from the corners; an area of 0 where they lie on one line.
RadiosityPatch patch_of(Corners corners, scene::FaceRun own) {
  RadiosityPatch patch;
  patch.own = own;
  patch.corners = std::move(corners);
  const Corners& c = patch.corners;
  double largest = 0;
  for (std::size_t k = 1; k + 1 < c.size(); ++k) {
    const double area = 0.5 * length_of(normal_of(c[0], c[k], c[k + 1]));
    patch.area += area;
    patch.middle = along(patch.middle, plus(plus(c[0], c[k]), c[k + 1]), area / 3);
    if (area > largest) patch.plane = {c[0], c[k], c[k + 1]};
    largest = std::max(largest, area);
  }
  if (!(patch.area > 0) || !std::isfinite(patch.area)) return {};
  patch.middle = times(patch.middle, 1 / patch.area);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lo, hi] = std::minmax_element(
        c.begin(), c.end(), [axis](const Vector3& a, const Vector3& b) { return a[axis] < b[axis]; });
    patch.box.lo(static_cast<int>(axis)) = (*lo)[axis];
    patch.box.hi(static_cast<int>(axis)) = (*hi)[axis];
  }
  return patch;
}

/// Twice the area of the scene's triangles in front of the plane, less that of those behind.
double surface_in_front(const scene::Scene& scene, const RadiosityPatch& patch) {
  const Vector3 normal = normal_of(patch.plane[0], patch.plane[1], patch.plane[2]);
  double sum = 0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const Vector3 &a = scene.corner(t, 0), &b = scene.corner(t, 1), &c = scene.corner(t, 2);
    const double height = dot_product(normal, minus(times(plus(plus(a, b), c), 1.0 / 3), patch.plane[0]));
    const double area = length_of(normal_of(a, b, c));
    sum += height > 0 ? area : height < 0 ? -area : 0;
  }
  return sum;
}

/// Coordinates in the patch's plane, from its middle.
struct PlaneFrame {
  Vector3 origin, u, v;

  explicit PlaneFrame(const RadiosityPatch& patch) : origin(patch.middle) {
    const Corners& c = patch.corners;
    Vector3 longest{};
    for (std::size_t k = 0; k < c.size(); ++k) {
      const Vector3 edge = minus(c[(k + 1) % c.size()], c[k]);
      // A clear winner alone replaces the edge before: sides of a square differ by rounding.
      if (dot_product(edge, edge) > 1.0001 * dot_product(longest, longest)) longest = edge;
    }
    u = unit_of(longest);
    v = unit_of(cross_product(normal_of(patch.plane[0], patch.plane[1], patch.plane[2]), u));
  }

  [[nodiscard]] std::array<double, 2> to(const Vector3& p) const {
    const Vector3 from = minus(p, origin);
    return {dot_product(from, u), dot_product(from, v)};
  }
  [[nodiscard]] Vector3 at(double x, double y) const { return along(along(origin, u, x), v, y); }
};

using Flat = std::vector<std::array<double, 2>>;

bool holds(const Flat& polygon, double x, double y) {
  bool left = true, right = true;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double turn = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    left &= turn >= 0;
    right &= turn <= 0;
  }
  return left || right;
}

}  // namespace

std::vector<RadiosityPatch> patches_of(const scene::Scene& scene) {
  std::vector<RadiosityPatch> patches;
  std::size_t object = 0;
  for (const scene::FaceRun& run : exact::polygons_of(scene)) {
    if (run.first >= scene.triangles.size()) break;
    const auto beyond = [&](const scene::Object& o) {
      return run.first >= o.first_triangle + o.triangle_count;
    };
    while (beyond(scene.objects[object])) ++object;
    RadiosityPatch patch = patch_of(corners_of(scene, run), run);
    if (!(patch.area > 0)) continue;
    patch.one_sided = scene.objects[object].one_sided;
    patches.push_back(std::move(patch));
  }
  return patches;
}

std::vector<RadiosityPatch> light_patches_of(const scene::Scene& scene) {
  std::vector<RadiosityPatch> patches;
  for (const scene::PolygonLight& light : scene.polygon_lights) {
    RadiosityPatch patch = patch_of(light.corners, {});
    if (!(patch.area > 0)) continue;
    if (surface_in_front(scene, patch) < 0) std::swap(patch.plane[1], patch.plane[2]);
    patches.push_back(std::move(patch));
  }
  return patches;
}

int side_of(const RadiosityPatch& patch, const Vector3& point) {
  return exact::side_of_face(patch.plane, point);
}

Vector3 on_or_before(const RadiosityPatch& patch, const Vector3& point) {
  const Vector3 rounded = as_floats(point);
  const Vector3 normal = normal_of(patch.plane[0], patch.plane[1], patch.plane[2]);
  std::size_t axis = 0;
  for (const std::size_t other : {1, 2}) {
    if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
  }
  // Rounding has moved the point by at most half an ulp of its largest coordinate on each axis, so against
  // the normal by at most three of these along its largest axis: a few doublings are enough. An ulp of the
  // axis' own coordinate is smaller, and a float may have to be passed by.
  const double largest = std::max({std::abs(rounded[0]), std::abs(rounded[1]), std::abs(rounded[2])});
  double step = std::max(largest * 0x1p-24, 0x1p-149);
  Vector3 moved = rounded;
  for (int tries = 0; side_of(patch, moved) < 0 && tries < 64; ++tries, step *= 2) {
    moved[axis] = rounded[axis] + std::copysign(step, normal[axis]);
    moved = as_floats(moved);
  }
  return moved;
}

std::uint32_t face_of(const RadiosityPatch& patch, const Vector3& point) {
  if (patch.is_light()) return scene::kNoFace;
  const Corners& c = patch.corners;
  const Vector3 normal = normal_of(patch.plane[0], patch.plane[1], patch.plane[2]);
  const auto side_of_edge = [&](const Vector3& a, const Vector3& b) {
    return dot_product(normal, cross_product(minus(b, a), minus(point, a)));
  };
  // Beyond how many diagonals from the first corner?
  std::uint32_t k = 0;
  while (k + 1 < patch.own.count && side_of_edge(c[0], c[k + 2]) > 0) ++k;
  return patch.own.first + k;
}

Vector3 point_on(const RadiosityPatch& patch, CaseRandom& random) {
  const Corners& c = patch.corners;
  double left = random.unit<double>() * patch.area;
  std::size_t k = 1;
  for (; k + 2 < c.size(); ++k) {
    const double area = 0.5 * length_of(normal_of(c[0], c[k], c[k + 1]));
    if (left < area) break;
    left -= area;
  }
  return on_or_before(patch, point_in_triangle(c[0], c[k], c[k + 1], random));
}

std::vector<Vector3> mesh_of(const RadiosityPatch& patch, double spacing) {
  const PlaneFrame frame(patch);
  Flat flat;
  std::array<double, 2> lo{}, hi{};
  for (const Vector3& corner : patch.corners) {
    flat.push_back(frame.to(corner));
    for (std::size_t k = 0; k < 2; ++k) {
      lo[k] = std::min(lo[k], flat.back()[k]);
      hi[k] = std::max(hi[k], flat.back()[k]);
    }
  }
  // A side that rounding makes a little longer than so many cells takes no further one.
  const auto cells = [&](std::size_t k) {
    return std::max(1.0, std::min(std::ceil((hi[k] - lo[k]) / spacing * (1 - 1e-6)), 4096.0));
  };
  const double columns = cells(0), rows = cells(1);
  std::vector<Vector3> points;
  for (double row = 0.5; row < rows; ++row) {
    for (double column = 0.5; column < columns; ++column) {
      const double x = lo[0] + (hi[0] - lo[0]) * column / columns, y = lo[1] + (hi[1] - lo[1]) * row / rows;
      if (holds(flat, x, y)) points.push_back(on_or_before(patch, frame.at(x, y)));
    }
  }
  if (points.size() >= patch.corners.size()) return points;
  points.clear();
  for (const Vector3& corner : patch.corners) {
    points.push_back(on_or_before(patch, times(plus(corner, patch.middle), 0.5)));
  }
  return points;
}

std::vector<Vector3> samples_of(const RadiosityPatch& patch, std::size_t side) {
  if (side == 1) return {on_or_before(patch, patch.middle)};
  std::vector<Vector3> points;
  points.reserve(side * side);
  if (patch.corners.size() == 4) {
    const Corners& c = patch.corners;
    for (std::size_t row = 0; row < side; ++row) {
      for (std::size_t column = 0; column < side; ++column) {
        const double s = (static_cast<double>(column) + 0.5) / static_cast<double>(side);
        const double t = (static_cast<double>(row) + 0.5) / static_cast<double>(side);
        const Vector3 below = along(c[0], minus(c[1], c[0]), s), above = along(c[3], minus(c[2], c[3]), s);
        points.push_back(on_or_before(patch, along(below, minus(above, below), t)));
      }
    }
    return points;
  }
  for (std::size_t k = 0; k < side * side; ++k) {
    CaseRandom random(1, stream_of("emitter samples"), k);
    points.push_back(point_on(patch, random));
  }
  return points;
}

}  // namespace gnomon::fuzz
