// SPDX-License-Identifier: GPL-3.0-or-later
// Random trees, reference boxes and options of lists: what the tests of candidate lists draw from.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "exact/polygons.h"
#include "fast/list_builder.h"
#include "tests/scene_cases.h"

namespace gnomon::tests {

using fast::Arithmetic;
using fast::CandidateList;
using fast::ItemTree;
using fast::ListOptions;
using fast::Reference;
using fast::Strategy;
using fast::TreeBuild;
using fast::Volumes;
using scene::Scene;

using FloatBox = scene::Box<float>;
using Faces = std::vector<std::uint32_t>;

/// What so many trials find at least; sanitized builds run fewer of them.
inline std::size_t least(int count) {
  return static_cast<std::size_t>(affordable(count));
}

/// A box of the grid or of floats about the scene's unit; sometimes flat, a point, or a face's own.
inline FloatBox random_reference(Random& random, const ItemTree& tree, bool grid,
                                 const Placement& place = {}) {
  if (random.chance(25))
    return tree.item(static_cast<std::uint32_t>(random.below(static_cast<int>(tree.size())))).box;
  FloatBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double start = grid ? grid_point(random)[0] : float_point(random)[0];
    const auto x = static_cast<float>(place.place(start));
    float y = x;
    if (grid && random.chance(60)) y = static_cast<float>(place.place(start + 1));
    if (!grid && random.chance(80)) y = x + static_cast<float>(random.unit() * random.unit() * 0.5);
    box.c[axis] = x;
    box.c[axis + 3] = y;
  }
  return box;
}

inline Faces faces_of(const ItemTree& tree, const CandidateList& list) {
  Faces faces;
  fast::append_faces(tree, list, faces);
  std::ranges::sort(faces);
  EXPECT_EQ(std::adjacent_find(faces.begin(), faces.end()), faces.end()) << "a face twice";
  return faces;
}

inline bool includes(const Faces& all, const Faces& some) {
  return std::ranges::includes(all, some);
}

inline ListOptions random_options(Random& random, Arithmetic arithmetic) {
  ListOptions options;
  options.arithmetic = arithmetic;
  options.strategy = static_cast<Strategy>(random.below(4));
  options.ratio = static_cast<float>(random.below(6)) / 5;
  options.discard_single = random.chance(50);
  options.enclosure = random.chance(50);
  options.emitter_list = random.chance(50);
  options.emitter_overlap = random.chance(50);
  options.mailbox = random.chance(70);
  options.sorting = static_cast<fast::Sorting>(random.below(4));
  options.sort_planes = random.chance(30);
  options.weak_planes = random.chance(30) ? 0.1F : 0;
  options.open_from_rays = random.chance(20) ? 10 : 0;
  return options;
}

struct Lists {
  Reference emitter, receiver;
  CandidateList list, part;
};

/// Grids of floats that are denormal, whose products underflow, far away, and near the largest float.
constexpr Placement kFloatGrids[] = {{0, 0}, {-149, 0}, {-70, 0}, {0, 1e5}, {-3, -4096}, {124, 0}};

/// Makes trees over random scenes, and calls check(scene, tree, random, grid, place) on each.
template <class Check>
void on_placed_trees(std::uint64_t seed, int scenes, bool placed, Check check) {
  Random random(seed);
  for (int trial = 0; trial < scenes && !testing::Test::HasFailure(); ++trial) {
    const bool grid = trial % 3 == 0;
    const Placement place = placed && grid ? kFloatGrids[random.below(6)] : Placement();
    const Scene scene = random_scene(random, {random.between(1, 60), random.between(0, 20), grid}, place);
    const ItemTree tree(scene, exact::polygons_of(scene),
                        random.chance(50) ? TreeBuild::goldsmith_salmon : TreeBuild::sah,
                        random.chance(50) ? Volumes::boxes : Volumes::spheres, random.bits());
    check(scene, tree, random, grid, place);
  }
}

template <class Check>
void on_random_trees(std::uint64_t seed, int scenes, Check check) {
  on_placed_trees(seed, scenes, false,
                  [&](const Scene& scene, const ItemTree& tree, Random& random, bool grid, const Placement&) {
                    check(scene, tree, random, grid);
                  });
}

}  // namespace gnomon::tests
