// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and shadow queries for timing the ray caster's tiers. All numbers are floats.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "fast/hierarchy.h"
#include "fuzz/random.h"
#include "fuzz/vectors.h"
#include "scene/scene.h"

namespace gnomon::bench {

struct TierScene {
  std::string name;
  scene::Scene scene;
};

inline double as_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

/// Adds a grid of quads, u and v from 0 to `side`, each cut in two.
template <class Place>
void add_sheet(scene::Scene& scene, int side, const Place& place) {
  const auto base = static_cast<std::uint32_t>(scene.points.size()),
             row = static_cast<std::uint32_t>(side + 1);
  for (int i = 0; i <= side; ++i) {
    for (int j = 0; j <= side; ++j) {
      scene.points.push_back(fuzz::as_floats(place(i, j)));
    }
  }
  for (std::uint32_t i = 0; i + 1 < row; ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = base + i * row + j, b = a + 1, c = a + row, d = c + 1;
      scene.triangles.push_back({a, c, b});
      scene.triangles.push_back({b, c, d});
    }
  }
}

inline void close_scene(scene::Scene& scene) {
  scene.objects.resize(1);
  scene.objects[0].triangle_count = scene.triangles.size();
  scene.objects[0].ball_count = scene.balls.size();
}

/// 50 round bodies above a floor, all finely tessellated: mostly small triangles, many seen edge-on.
inline TierScene make_bodies(std::size_t faces) {
  TierScene made{"bodies", {}};
  const int side = std::max(2, static_cast<int>(std::sqrt(static_cast<double>(faces) / 102)));
  for (std::uint64_t body = 0; body < 50; ++body) {
    fuzz::CaseRandom random(5, 1, body);
    const double x = 10 * random.unit<double>(), y = 10 * random.unit<double>(),
                 z = 0.3 + 3 * random.unit<double>(), r = 0.3 + 0.7 * random.unit<double>();
    add_sheet(made.scene, side, [&](int i, int j) -> std::array<double, 3> {
      const double theta = std::numbers::pi * i / side, phi = 2 * std::numbers::pi * (j % side) / side;
      return {x + r * std::sin(theta) * std::cos(phi), y + r * std::sin(theta) * std::sin(phi),
              z + r * std::cos(theta)};
    });
  }
  add_sheet(made.scene, side, [&](int i, int j) -> std::array<double, 3> {
    return {10.0 * i / side, 10.0 * j / side, 0};
  });
  close_scene(made.scene);
  return made;
}

/// Hills, lit at a low angle: long walks along one surface.
inline TierScene make_hills(std::size_t faces) {
  TierScene made{"hills", {}};
  const int side = static_cast<int>(std::sqrt(static_cast<double>(faces) / 2));
  add_sheet(made.scene, side, [&](int i, int j) -> std::array<double, 3> {
    const double x = 10.0 * i / side, y = 10.0 * j / side;
    return {
        x, y,
        0.6 * std::sin(1.7 * x + 0.3 * y) * std::cos(1.3 * y) + 0.05 * std::sin(17 * x) * std::sin(23 * y)};
  });
  close_scene(made.scene);
  return made;
}

/// Small balls above a floor of triangles.
inline TierScene make_balls(std::size_t faces) {
  TierScene made{"balls", {}};
  const double radius = 3 / std::cbrt(static_cast<double>(faces));
  for (std::uint64_t i = 0; i < faces; ++i) {
    fuzz::CaseRandom random(5, 2, i);
    const double x = 10 * random.unit<double>(), y = 10 * random.unit<double>(),
                 z = 3 * random.unit<double>();
    made.scene.balls.push_back(
        {{as_float(x), as_float(y), as_float(z)}, as_float(radius * random.unit<double>())});
  }
  add_sheet(made.scene, 16, [&](int i, int j) -> std::array<double, 3> {
    return {10.0 * i / 16, 10.0 * j / 16, 0};
  });
  close_scene(made.scene);
  return made;
}

/// Where the rays of an image meet the scene, in the image's order, each with a light above.
inline std::vector<scene::ShadowQuery> queries_of(const scene::Scene& scene, const fast::Hierarchy& hierarchy,
                                                  int side) {
  std::vector<scene::ShadowQuery> queries;
  const std::array<double, 3> eye{5, -6, 8};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      scene::RayQuery ray{eye, {as_float(10.0 * x / side - 5), as_float(12.0 * y / side + 5), -8}};
      const std::uint32_t face = hierarchy.first_hit(fast::Hierarchy::Tier::naive, ray);
      if (face == scene::kNoFace) continue;
      const auto& d = ray.direction;
      double t = 0;
      if (face < scene.triangles.size()) {
        const auto &a = scene.corner(face, 0), &b = scene.corner(face, 1), &c = scene.corner(face, 2);
        double top = 0, bottom = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
          const double n = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
          top += n * (a[k] - eye[k]);
          bottom += n * d[k];
        }
        t = top / bottom;
      } else {
        const auto& ball = scene.balls[face - scene.triangles.size()];
        double dd = 0, md = 0, mm = -ball.radius * ball.radius;
        for (std::size_t k = 0; k < 3; ++k) {
          const double m = ball.centre[k] - eye[k];
          dd += d[k] * d[k];
          md += m * d[k];
          mm += m * m;
        }
        t = (md - std::sqrt(std::max(0.0, md * md - dd * mm))) / dd;
      }
      scene::ShadowQuery query{{}, {-4, 2, 9}, face};
      for (std::size_t k = 0; k < 3; ++k) query.point[k] = as_float(eye[k] + t * d[k]);
      queries.push_back(query);
    }
  }
  return queries;
}

}  // namespace gnomon::bench
