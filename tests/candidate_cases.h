// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes, their item trees and the lists between two boxes, for what the ledger says of candidate
// lists.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "exact/shadow.h"
#include "fast/list_builder.h"
#include "fast/list_caster.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {

using fast::Arithmetic;
using fast::CandidateList;
using fast::ItemTree;
using fast::kNoItem;
using fast::ListBuilder;
using fast::ListCaster;
using fast::ListOptions;
using fast::Reference;
using fast::Strategy;
using Box = scene::Box<float>;
using Point = std::array<float, 3>;
using Triangle = std::array<Point, 3>;
using Solid = std::vector<Triangle>;

inline constexpr std::array<Strategy, 4> kStrategies{Strategy::keep_closed, Strategy::always_open,
                                                     Strategy::overlap_open, Strategy::ratio_open};

/// One object for each solid; equal corners become one point.
inline scene::Scene scene_of(const std::vector<Solid>& solids, bool one_sided = false) {
  scene::Scene scene;
  for (const Solid& solid : solids) {
    scene::Object& object = scene.objects.emplace_back();
    object.first_triangle = scene.triangles.size();
    object.triangle_count = solid.size();
    object.one_sided = one_sided;
    for (const Triangle& triangle : solid) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array<double, 3> p{triangle[k][0], triangle[k][1], triangle[k][2]};
        const auto at = std::ranges::find(scene.points, p);
        corners[k] = static_cast<std::uint32_t>(at - scene.points.begin());
        if (at == scene.points.end()) scene.points.push_back(p);
      }
      scene.triangles.push_back(corners);
    }
  }
  return scene;
}

/// Every face a primitive of its own.
inline ItemTree tree_of(const scene::Scene& scene, std::uint64_t seed = 1) {
  std::vector<scene::FaceRun> runs;
  for (std::uint32_t f = 0; f < scene.face_count(); ++f) runs.push_back({f, 1});
  return {scene, runs, fast::TreeBuild::goldsmith_salmon, fast::Volumes::boxes, seed};
}

inline Box box_of(const Point& p, const Point& q) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    box.lo(axis) = std::min(p[k], q[k]);
    box.hi(axis) = std::max(p[k], q[k]);
  }
  return box;
}
inline Reference reference(const Box& box) {
  Reference item;
  item.box = box;
  return item;
}

inline Point grid_point(Random& random, int size) {
  return {static_cast<float>(random.below(size)), static_cast<float>(random.below(size)),
          static_cast<float>(random.below(size))};
}
/// A corner of a box within the box.
inline Point corner_within(Random& random, const Box& box) {
  Point p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = box.c[k + (random.chance(50) ? 3U : 0U)];
  return p;
}
inline scene::Scene grid_scene(Random& random, int triangles, int size) {
  Solid all;
  for (int t = 0; t < triangles; ++t) {
    const Point p = grid_point(random, size);
    Triangle triangle{p, p, p};
    for (std::size_t k = 1; k < 3; ++k) {
      for (float& x : triangle[k]) x += static_cast<float>(random.between(-2, 3));
    }
    all.push_back(triangle);
  }
  return scene_of({all});
}

inline std::vector<std::uint32_t> faces_of(const ItemTree& tree, const CandidateList& list) {
  std::vector<std::uint32_t> faces;
  append_faces(tree, list, faces);
  std::ranges::sort(faces);
  return faces;
}
inline bool hits(const ItemTree& tree, const CandidateList& list, const Point& from, const Point& to) {
  return ListCaster(tree).cast(list, fast::Segment(from, to), kNoItem, kNoItem).primitive != kNoItem;
}
inline scene::ShadowQuery query_of(const Point& from, const Point& to) {
  return {{from[0], from[1], from[2]}, {to[0], to[1], to[2]}, scene::kNoFace};
}
inline bool is_blocked_exactly(const scene::Scene& scene, const Point& from, const Point& to) {
  for (std::uint32_t f = 0; f < scene.face_count(); ++f) {
    if (exact::blocks(scene, f, query_of(from, to))) return true;
  }
  return false;
}

inline ListOptions random_options(Random& random) {
  ListOptions options;
  options.strategy = kStrategies[static_cast<std::size_t>(random.below(4))];
  options.ratio = static_cast<float>(random.below(6)) * 0.2F;
  options.discard_single = random.chance(50);
  options.enclosure = random.chance(70);
  options.emitter_list = random.chance(70);
  options.emitter_overlap = random.chance(50);
  options.mailbox = random.chance(70);
  options.arithmetic = random.chance(50) ? Arithmetic::naive : Arithmetic::certified;
  return options;
}

/// The list between two boxes.
struct Made {
  ListBuilder builder;
  CandidateList list;

  Made(const ItemTree& tree, const scene::Scene& scene, const ListOptions& options, const Box& emitter,
       const Box& receiver, std::span<const std::uint8_t> convex = {})
      : builder(tree, scene, options, convex) {
    builder.begin_emitter(reference(emitter));
    builder.build(reference(receiver), 1, list);
  }
  Made(const Made&) = delete;
};

}  // namespace gnomon::tests
