// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes and queries on which floats err: ties on a grid, shared edges and corners, faces seen edge-on,
// skinny triangles, scenes far from the origin, very small and very large ones. All numbers are floats.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/ray_query.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {

enum class HardKind { grid, dense_grid, far_grid, far_mesh, mesh, skinny, tiny, huge, mixed, soup, stacked };
inline constexpr HardKind kHardKinds[] = {HardKind::grid,     HardKind::dense_grid, HardKind::far_grid,
                                          HardKind::far_mesh, HardKind::mesh,       HardKind::skinny,
                                          HardKind::tiny,     HardKind::huge,       HardKind::mixed,
                                          HardKind::soup,     HardKind::stacked};

inline std::string name_of(HardKind kind) {
  const char* const names[] = {"grid", "dense grid", "far grid", "far mesh", "mesh",   "skinny",
                               "tiny", "huge",       "mixed",    "soup",     "stacked"};
  return names[static_cast<std::size_t>(kind)];
}

using Point3 = std::array<double, 3>;

/// x rounded to a float. (Volatile: g++ 12 leaves conversions there and back out where it makes vectors.)
inline double as_float(double x) {
  const volatile float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

/// Points of the scenes of one kind.
class HardPoints {
 public:
  HardPoints(HardKind kind, Random& random) : kind_(kind), random_(random) {}

  double coordinate() {
    switch (kind_) {
      case HardKind::grid:
        return random_.below(6);
      case HardKind::dense_grid:
        return random_.below(3);
      case HardKind::far_grid:
        return as_float(1e5 + random_.below(6) * 0.0625);
      case HardKind::far_mesh:
        return as_float(1e5 + random_.unit() * 3);
      case HardKind::tiny:
        return as_float(random_.unit() * 0x1p-28);
      case HardKind::huge:
        return as_float((random_.unit() - 0.5) * 0x1p40);
      case HardKind::mixed:
        return random_.chance(20)
                   ? 0
                   : as_float((random_.unit() - 0.5) * std::ldexp(1.0, random_.between(-60, 20)));
      default:
        return as_float(random_.unit() * 4 - 2);
    }
  }
  Point3 point() { return {coordinate(), coordinate(), coordinate()}; }

  /// A point of the triangle or near it, rounded: a corner, on an edge, within, or on its plane outside.
  Point3 on(const scene::Scene& scene, std::size_t triangle) {
    double a = 0, b = 0;
    switch (random_.below(4)) {
      case 0:
        a = random_.below(2);
        break;
      case 1:
        a = random_.chance(50) ? 0.5 : random_.unit();
        b = random_.chance(50) ? 1 - a : 0;
        break;
      case 2:
        a = random_.unit();
        b = random_.unit() * (1 - a);
        break;
      default:
        a = random_.between(-2, 3) * 0.5;
        b = random_.between(-2, 3) * 0.5;
    }
    Point3 p;
    for (std::size_t k = 0; k < 3; ++k) {
      const double v0 = scene.corner(triangle, 0)[k];
      p[k] = as_float(v0 + a * (scene.corner(triangle, 1)[k] - v0) + b * (scene.corner(triangle, 2)[k] - v0));
    }
    return p;
  }

 private:
  HardKind kind_;
  Random& random_;
};

inline scene::Scene hard_scene(HardKind kind, std::uint64_t seed, int triangles, int balls) {
  Random random(seed * 64 + static_cast<std::uint64_t>(kind));
  HardPoints points(kind, random);
  scene::Scene scene;
  const auto add = [&](const Point3& p) {
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      if (scene.points[i] == p) return static_cast<std::uint32_t>(i);
    }
    scene.points.push_back(p);
    return static_cast<std::uint32_t>(scene.points.size() - 1);
  };
  if (kind == HardKind::mesh || kind == HardKind::far_mesh) {
    // A bumpy sheet whose triangles share corners.
    const int side = std::max(2, static_cast<int>(std::sqrt(triangles / 2.0)) + 1);
    const double far = kind == HardKind::far_mesh ? 1e5 : 0;
    const auto corner = [&](int x, int y) {
      const double height = (x * 7 + y * 3 + static_cast<int>(seed)) % 5 * 0.11;
      return add({as_float(far + x * 0.3), as_float(far + y * 0.3), as_float(far + height)});
    };
    for (int x = 0; x + 1 < side; ++x) {
      for (int y = 0; y + 1 < side; ++y) {
        const std::uint32_t a = corner(x, y), b = corner(x + 1, y), c = corner(x, y + 1),
                            d = corner(x + 1, y + 1);
        scene.triangles.push_back({a, b, d});
        scene.triangles.push_back({a, d, c});
      }
    }
  } else {
    while (static_cast<int>(scene.triangles.size()) < triangles) {
      const Point3 a = points.point(), b = points.point();
      Point3 c = points.point();
      if (kind == HardKind::skinny) {
        const double t = random.unit() * 1.5 - 0.25;
        for (std::size_t k = 0; k < 3; ++k) c[k] = as_float(a[k] + t * (b[k] - a[k]));
      }
      scene.triangles.push_back({add(a), add(b), add(c)});
      if (random.chance(10)) scene.triangles.push_back(scene.triangles.back());
      for (int copy = 0; kind == HardKind::stacked && copy < 3; ++copy) {
        // A few ulps off, so that a line meets them in one order or the other.
        const auto moved = [&](Point3 p) {
          for (double& x : p) x = as_float(x * (1 + random.between(-2, 2) * 0x1p-24));
          return add(p);
        };
        scene.triangles.push_back({moved(a), moved(b), moved(c)});
      }
    }
  }
  const double size = kind == HardKind::tiny       ? 0x1p-30
                      : kind == HardKind::huge     ? 0x1p37
                      : kind == HardKind::far_grid ? 0.0625
                                                   : 1;
  for (int i = 0; i < balls; ++i) {
    const double radius = random.chance(20) ? 0 : random.chance(50) ? 1 : random.unit() * 0.5;
    scene.balls.push_back({points.point(), as_float(radius * size)});
    if (kind == HardKind::stacked && i % 2 != 0) {
      scene.balls.back() = scene.balls[scene.balls.size() - 2];
      scene::Ball<double>& ball = scene.balls.back();
      for (double& x : ball.centre) x = as_float(x * (1 + random.between(-2, 2) * 0x1p-24));
      ball.radius = as_float(ball.radius * (1 + random.between(-2, 2) * 0x1p-24));
    }
  }
  const std::size_t half = scene.triangles.size() / 2;
  scene.objects.resize(2);
  scene.objects[0].triangle_count = half;
  scene.objects[0].one_sided = true;
  scene.objects[1].first_triangle = half;
  scene.objects[1].triangle_count = scene.triangles.size() - half;
  scene.objects[1].ball_count = scene.balls.size();
  return scene;
}

/// From a face or anywhere, to a face, anywhere, or through a face to the same distance behind it.
inline std::vector<scene::ShadowQuery> hard_queries(HardKind kind, const scene::Scene& scene,
                                                    std::uint64_t seed, int count) {
  Random random(~seed * 64 + static_cast<std::uint64_t>(kind));
  HardPoints points(kind, random);
  const auto triangle = [&] {
    return static_cast<std::uint32_t>(random.below(static_cast<int>(scene.triangles.size())));
  };
  std::vector<scene::ShadowQuery> queries;
  for (int i = 0; i < count; ++i) {
    scene::ShadowQuery q;
    const int start = random.below(5);
    if (start == 0 && !scene.balls.empty()) {
      const auto b = static_cast<std::size_t>(random.below(static_cast<int>(scene.balls.size())));
      q.point = scene.balls[b].centre;
      const auto axis = static_cast<std::size_t>(random.below(3));
      q.point[axis] = as_float(q.point[axis] + (random.chance(50) ? 1 : -1) * scene.balls[b].radius);
      if (random.chance(80)) q.own = static_cast<std::uint32_t>(scene.triangles.size() + b);
    } else if (start <= 2) {
      const std::uint32_t own = triangle();
      q.point = points.on(scene, own);
      if (random.chance(80)) q.own = own;
    } else {
      q.point = points.point();
    }
    const int end = random.below(5);
    if (end == 0) {
      q.light = points.point();
    } else if (end == 1) {
      q.light = q.point;  // along an axis
      q.light[static_cast<std::size_t>(random.below(3))] = points.coordinate();
    } else {
      const Point3 target = points.on(scene, triangle());
      q.light = target;
      if (end > 2) {
        for (std::size_t k = 0; k < 3; ++k) q.light[k] = as_float(2 * target[k] - q.point[k]);
      }
    }
    if (q.own != scene::kNoFace && q.own >= scene.triangles.size() && random.chance(50)) {
      // Along the own ball's surface, but for roundings.
      const scene::Ball<double>& ball = scene.balls[q.own - scene.triangles.size()];
      const double a = 6.3 * random.unit(), b = 6.3 * random.unit();
      const Point3 out{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
      const Point3 along{-std::sin(a), std::cos(a), 0};
      for (std::size_t k = 0; k < 3; ++k) {
        q.point[k] = as_float(ball.centre[k] + ball.radius * out[k]);
        q.light[k] = as_float(q.point[k] + 3 * ball.radius * along[k]);
      }
    }
    queries.push_back(q);
  }
  return queries;
}

inline scene::RayQuery ray_of(const scene::ShadowQuery& query) {
  scene::RayQuery ray{query.point, {}, query.own};
  for (std::size_t k = 0; k < 3; ++k) ray.direction[k] = as_float(query.light[k] - query.point[k]);
  return ray;
}

}  // namespace gnomon::tests
