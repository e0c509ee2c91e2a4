// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/bench/shadow_truth.h"

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exact/hierarchy.h"
#include "fuzz/random.h"
#include "fuzz/vectors.h"
#include "reports/bench/paired.h"
#include "reports/peers/peers.h"
#include "scene/scene_builder.h"

namespace gnomon::bench {

namespace {

using scene::RayQuery;
using scene::Scene;
using scene::SceneBuilder;
using scene::ShadowQuery;
using Point = std::array<double, 3>;

/// Hills over the unit square, two triangles a cell. All coordinates are floats, as a renderer's are.
Scene hills(std::size_t triangles) {
  const int n = static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / 2)));
  const auto at = [n](int i, int j) {
    const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
    const double z = 0.08 * std::sin(17 * x) * std::cos(13 * y) + 0.03 * std::sin(61 * x + 40 * y) +
                     0.01 * std::sin(150 * y - 90 * x);
    return fuzz::as_floats({x, y, z});
  };
  SceneBuilder builder;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      builder.add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      builder.add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return builder.finish();
}

/// Tessellated spheres over a ground of two triangles.
Scene spheres(std::size_t triangles) {
  constexpr int kSpheres = 40;
  const int rows = static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / kSpheres / 4)));
  SceneBuilder builder;
  builder.add_triangle({-1, -1, 0}, {2, -1, 0}, {2, 2, 0});
  builder.add_triangle({-1, -1, 0}, {2, 2, 0}, {-1, 2, 0});
  for (int s = 0; s < kSpheres; ++s) {
    fuzz::CaseRandom random(5, 7, static_cast<std::uint64_t>(s));
    const double r = 0.03 + 0.05 * random.unit<double>(), cx = random.unit<double>(),
                 cy = random.unit<double>(), cz = r + 0.2 * random.unit<double>();
    const auto at = [&](int i, int j) {
      const double polar = M_PI * i / rows, around = M_PI * (j % (2 * rows)) / rows;
      return fuzz::as_floats({cx + r * std::sin(polar) * std::cos(around),
                              cy + r * std::sin(polar) * std::sin(around), cz + r * std::cos(polar)});
    };
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < 2 * rows; ++j) {
        if (i > 0) builder.add_triangle(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + 1 < rows) builder.add_triangle(at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
      }
    }
  }
  return builder.finish();
}

/// The points that a camera sees, pixel by pixel, towards a light; lifted a little off their faces, so that
/// there is no own face to leave out.
std::vector<ShadowQuery> image_queries(const Scene& scene, const exact::Hierarchy& hierarchy,
                                       std::size_t count) {
  const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count))));
  const Point eye = {0.5, -0.6, 0.9}, light = {1.4, 1.2, 0.8};
  std::vector<ShadowQuery> queries;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5) / side, y = (row + 0.5) / side;
      const RayQuery ray{eye, {x - eye[0], y - eye[1], 0.05 - eye[2]}, scene::kNoFace};
      const exact::FirstHit hit = hierarchy.first_hit(ray);
      if (hit.faces.empty()) continue;
      const Point &a = scene.corner(hit.faces[0], 0), &b = scene.corner(hit.faces[0], 1),
                  &c = scene.corner(hit.faces[0], 2);
      const auto e = [](const Point& p, const Point& q, std::size_t i) { return q[i] - p[i]; };
      Point n{};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = e(a, b, j) * e(a, c, k) - e(a, b, k) * e(a, c, j);
      }
      double above = 0, along = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        above += n[i] * (a[i] - eye[i]);
        along += n[i] * ray.direction[i];
      }
      const double t = above / along * (1 - 1e-5);
      queries.push_back({fuzz::as_floats({eye[0] + t * ray.direction[0], eye[1] + t * ray.direction[1],
                                          eye[2] + t * ray.direction[2]}),
                         light, scene::kNoFace});
    }
  }
  return queries;
}

void shuffle(std::vector<ShadowQuery>& queries) {
  for (std::size_t i = queries.size(); i > 1; --i) {
    fuzz::CaseRandom random(9, 1, i);
    std::swap(queries[i - 1],
              queries[static_cast<std::size_t>(random.unit<double>() * static_cast<double>(i))]);
  }
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_scene(const std::string& name, const Scene& scene, const ShadowTruthOptions& options) {
  std::unique_ptr<exact::Hierarchy> hierarchy;
  std::unique_ptr<fuzz::SceneCaster> tree;
  const double ours = seconds_of([&] { hierarchy = std::make_unique<exact::Hierarchy>(scene); });
  const double theirs =
      seconds_of([&] { tree = reports::choose_scene_methods({"cgal-epick"})[0]->make(scene); });
  std::vector<ShadowQuery> queries = image_queries(scene, *hierarchy, options.queries);
  std::size_t shadowed = 0, touching = 0, different = 0;
  exact::HierarchyCounters counters;
  std::vector<fuzz::Answer> answers(queries.size());
  tree->shadows(queries, answers);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const exact::ShadowTruth truth = hierarchy->shadow(queries[i], counters);
    shadowed += truth.answer == scene::Shadow::shadowed;
    touching += truth.touching;
    different += static_cast<fuzz::Answer>(truth.answer) != answers[i];
  }
  const auto per_query = [&](auto value) {
    return static_cast<double>(value) / static_cast<double>(queries.size());
  };
  std::printf(
      "%s, %zu triangles, %zu queries: shadowed %.3f, touching %zu, answers that differ %zu; tests a query: "
      "%.1f boxes, %.1f faces, %.2g exact; set-up %.2f s and %.2f s, %.0f bytes a triangle\n",
      name.c_str(), scene.triangles.size(), queries.size(), per_query(shadowed), touching, different,
      per_query(counters.box_tests), per_query(counters.face_tests), per_query(counters.exact_face_tests),
      ours, theirs, static_cast<double>(hierarchy->bytes()) / static_cast<double>(scene.triangles.size()));
  for (const char* order : {"image", "shuffled"}) {
    const std::vector<Contender> contenders = {
        {"hierarchy",
         [&](int) {
           std::size_t sum = 0;
           for (const ShadowQuery& query : queries)
             sum += static_cast<std::size_t>(hierarchy->shadow(query).answer);
           benchmark::DoNotOptimize(sum);
         }},
        {"AABB_tree", [&](int) {
           tree->shadows(queries, answers);
           benchmark::ClobberMemory();
         }}};
    const auto seconds = time_paired(contenders, options.rounds, 3, 1);
    const Median mine = median_of(seconds[0]), cgal = median_of(seconds[1]),
                 ratio = ratio_of(seconds[1], seconds[0]);
    std::printf("  %-9s hierarchy %7.3f us   AABB_tree %7.3f us   AABB_tree / hierarchy %.2f [%.2f, %.2f]\n",
                order, per_query(mine.value) * 1e6, per_query(cgal.value) * 1e6, ratio.value, ratio.low,
                ratio.high);
    std::fflush(stdout);
    shuffle(queries);
  }
}

}  // namespace

void print_shadow_truth(const ShadowTruthOptions& options) {
  std::printf("shadow queries, microseconds each, %d paired rounds; [95 %% interval of the median]\n",
              options.rounds);
  for (const std::size_t triangles : {std::size_t{10'000}, std::size_t{100'000}, std::size_t{1'000'000}}) {
    if (triangles > options.most) continue;
    print_scene("hills", hills(triangles), options);
    print_scene("spheres", spheres(triangles), options);
  }
}

}  // namespace gnomon::bench
