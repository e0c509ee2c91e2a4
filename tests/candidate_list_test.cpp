// SPDX-License-Identifier: GPL-3.0-or-later
// fast/list_builder.h: lists of certified arithmetic lose nothing, claims S12 to S14, and half-spaces.
#include "fast/list_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/polygons.h"
#include "exact/shaft_box.h"
#include "exact/shaft_candidates.h"
#include "exact/side_of_face.h"
#include "fast/box_relation.h"
#include "fuzz/list_options_text.h"
#include "fuzz/shapes.h"
#include "tests/bound_shares.h"
#include "tests/scene_cases.h"

namespace gnomon::tests {
namespace {

using fast::Arithmetic;
using fast::CandidateList;
using fast::FrontPlane;
using fast::Item;
using fast::ItemTree;
using fast::ListBuilder;
using fast::ListOptions;
using fast::Reference;
using fast::Strategy;
using fast::TreeBuild;
using fast::Volumes;
using scene::Category;
using scene::Scene;

using FloatBox = scene::Box<float>;
using Faces = std::vector<std::uint32_t>;

constexpr Strategy kStrategies[] = {Strategy::keep_closed, Strategy::always_open, Strategy::overlap_open,
                                    Strategy::ratio_open};

/// A box of the grid or of floats about the scene's unit; sometimes flat, a point, or a face's own.
FloatBox random_reference(Random& random, const ItemTree& tree, bool grid, const Placement& place = {}) {
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

Faces faces_of(const ItemTree& tree, const CandidateList& list) {
  Faces faces;
  fast::append_faces(tree, list, faces);
  std::sort(faces.begin(), faces.end());
  EXPECT_EQ(std::adjacent_find(faces.begin(), faces.end()), faces.end()) << "a face twice";
  return faces;
}

bool includes(const Faces& all, const Faces& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

ListOptions random_options(Random& random, Arithmetic arithmetic) {
  ListOptions options;
  options.arithmetic = arithmetic;
  options.strategy = kStrategies[random.below(4)];
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

TEST(CandidateList, CertifiedListsLoseNoFaceThatMeetsTheShaftWhateverTheOptions) {
  std::size_t met = 0, kept = 0, marks = 0, parts = 0;
  on_placed_trees(
      1, affordable(1500), true,
      [&](const Scene& scene, const ItemTree& tree, Random& random, bool grid, const Placement& place) {
        const exact::ShaftCandidates reference(scene);
        const ListOptions options = random_options(random, Arithmetic::certified);
        ListBuilder builder(tree, scene, options);
        for (int pair = 0; pair < 6; ++pair) {
          Lists c;
          c.emitter.box = random_reference(random, tree, grid, place);
          c.receiver.box = random_reference(random, tree, grid, place);
          builder.begin_emitter(c.emitter);
          builder.build(c.receiver, 5, c.list);
          Faces truth;
          const auto emitter = scene::converted<double>(c.emitter.box);
          reference.faces(emitter, scene::converted<double>(c.receiver.box), truth);
          const Faces faces = faces_of(tree, c.list);
          ASSERT_TRUE(includes(faces, truth)) << fuzz::text_of({options, {}, tree.volumes(), 1});
          met += truth.size();
          kept += faces.size();
          // A part of the receiver, from the receiver's list: nothing new (claim S13), and nothing lost.
          Reference part = c.receiver;
          for (int axis = 0; axis < 3; ++axis)
            part.box.lo(axis) = 0.5F * part.box.lo(axis) + 0.5F * part.box.hi(axis);
          builder.build(part, 5, c.list, c.part);
          const Faces of_part = faces_of(tree, c.part);
          reference.faces(emitter, scene::converted<double>(part.box), truth);
          ASSERT_TRUE(includes(of_part, truth)) << fuzz::text_of({options, {}, tree.volumes(), 1});
          ASSERT_TRUE(includes(faces, of_part));
          parts += of_part.size();
        }
        marks += builder.counters().marks;
      });
  EXPECT_GT(met, 10000u);
  EXPECT_LT(met, kept);
  EXPECT_LT(parts, kept);
  EXPECT_GT(marks, 100u);
}

// Claim S13 without any nesting: the list of a sub-shaft, made by itself, is among the parent's.
TEST(CandidateList, FacesOfASubShaftAreAmongItsParents) {
  std::size_t fewer = 0;
  for (const Arithmetic arithmetic : {Arithmetic::certified, Arithmetic::naive}) {
    on_random_trees(2, affordable(150), [&](const Scene& scene, const ItemTree& tree, Random& random, bool) {
      ListOptions options;
      options.strategy = Strategy::always_open;
      options.arithmetic = arithmetic;
      ListBuilder builder(tree, scene, options);
      Lists c;
      // On the grid all sums and products are exact, so the claim holds for floats as it does for numbers.
      c.emitter.box = random_reference(random, tree, true);
      c.receiver.box = random_reference(random, tree, true);
      for (const float x : c.emitter.box.c) {
        if (x != std::floor(x)) return;
      }
      builder.begin_emitter(c.emitter);
      builder.build(c.receiver, 1, c.list);
      Reference part = c.receiver;
      for (int axis = 0; axis < 3; ++axis)
        part.box.lo(axis) = 0.5F * part.box.lo(axis) + 0.5F * part.box.hi(axis);
      if (tree.volumes() == Volumes::spheres) return;
      builder.build(part, 1, c.part);
      const Faces all = faces_of(tree, c.list), some = faces_of(tree, c.part);
      EXPECT_TRUE(includes(all, some));
      fewer += some.size() < all.size();
    });
  }
  EXPECT_GT(fewer, 20u);
}

// Exact on the grid, where floats make no error: what is on the list is what meets the shaft, no more.
TEST(CandidateList, AlwaysOpenFindsThePrimitivesWhoseBoxesMeetTheShaft) {
  Random random(3);
  std::size_t met = 0, outside = 0;
  for (int trial = 0; trial < affordable(150) && !HasFailure(); ++trial) {
    const Scene scene = random_scene(random, {random.between(1, 40), 0, true}, Placement());
    const ItemTree tree(scene, exact::polygons_of(scene));
    ListOptions options;
    options.strategy = Strategy::always_open;
    options.emitter_list = random.chance(50);
    ListBuilder builder(tree, scene, options);
    Lists c;
    c.emitter.box = random_reference(random, tree, true);
    c.receiver.box = random_reference(random, tree, true);
    builder.begin_emitter(c.emitter);
    builder.build(c.receiver, 1, c.list);
    std::vector<std::uint32_t> expected, found = c.list.items;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
      if (!tree.item(i).is_primitive()) continue;
      const bool apart =
          exact::classify({scene::converted<double>(c.emitter.box), scene::converted<double>(c.receiver.box),
                           scene::converted<double>(tree.item(i).box)}) == Category::outside;
      if (!apart) expected.push_back(i);
      (apart ? outside : met) += 1;
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
  EXPECT_GT(met, 500u);
  EXPECT_GT(outside, 500u);
}

// Claim S12: the same items in the same order, on any tree, in either arithmetic.
TEST(CandidateList, RatioOneIsOverlapOpen) {
  std::size_t volumes = 0, items = 0, others = 0;
  on_random_trees(4, affordable(500),
                  [&](const Scene& scene, const ItemTree& tree, Random& random, bool grid) {
                    ListOptions ratio =
                        random_options(random, random.chance(50) ? Arithmetic::naive : Arithmetic::certified);
                    ratio.open_from_rays = 0;
                    ratio.sorting = fast::Sorting::none;
                    ratio.strategy = Strategy::ratio_open;
                    ListOptions overlap = ratio, half = ratio;
                    ratio.ratio = 1;
                    half.ratio = 0.4F;
                    overlap.strategy = Strategy::overlap_open;
                    ListBuilder by_ratio(tree, scene, ratio), by_overlap(tree, scene, overlap),
                        by_half(tree, scene, half);
                    Lists c;
                    c.emitter.box = random_reference(random, tree, grid);
                    c.receiver.box = random_reference(random, tree, grid);
                    for (ListBuilder* builder : {&by_ratio, &by_overlap, &by_half})
                      builder->begin_emitter(c.emitter);
                    by_ratio.build(c.receiver, 1, c.list);
                    by_overlap.build(c.receiver, 1, c.part);
                    EXPECT_EQ(c.list.items, c.part.items);
                    EXPECT_FALSE(c.list.marks.any());
                    for (const std::uint32_t i : c.list.items) volumes += !tree.item(i).is_primitive();
                    items += c.list.items.size();
                    by_half.build(c.receiver, 1, c.part);
                    others += c.part.items != c.list.items;
                  });
  EXPECT_GT(volumes, 50u);
  EXPECT_GT(items, 1000u);
  EXPECT_GT(others, 100u);
}

// Claim S14, and the emitter list's definition; up from the emitter or down from the root.
TEST(CandidateList, EmitterListIsWhatDoesNotEncloseTheEmitter) {
  std::size_t overlapping = 0, apart = 0, opened = 0;
  on_random_trees(
      5, affordable(300), [&](const Scene& scene, const ItemTree& tree, Random& random, bool grid) {
        if (tree.volumes() == Volumes::spheres) return;
        ListOptions options;
        options.arithmetic = Arithmetic::certified;
        options.strategy = Strategy::always_open;
        ListBuilder builder(tree, scene, options);
        const auto face = static_cast<std::uint32_t>(random.below(static_cast<int>(scene.face_count())));
        const std::uint32_t own = tree.primitive_of(face);
        Lists c;
        c.emitter.box = tree.item(own).box;
        builder.begin_emitter(c.emitter);
        std::vector<std::uint32_t> down = builder.emitter_list().items;
        c.emitter.own = {tree.item(own).first, tree.item(own).count()};
        builder.begin_emitter(c.emitter);
        const CandidateList& list = builder.emitter_list();
        std::vector<std::uint32_t> up = list.items;

        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < tree.size(); ++i) {
          const auto encloses = [&](std::uint32_t k) {
            return !tree.item(k).is_primitive() && fast::contains(tree.item(k).box, c.emitter.box);
          };
          bool all_above = true;
          for (std::uint32_t k = tree.parent(i); k != fast::kNoItem; k = tree.parent(k))
            all_above &= encloses(k);
          if (all_above && !encloses(i)) expected.push_back(i);
          opened += encloses(i);
        }
        std::sort(down.begin(), down.end());
        EXPECT_EQ(down, expected);
        std::erase(expected, own);
        std::sort(up.begin(), up.end());
        EXPECT_EQ(up, expected);

        for (int k = 0; k < 5; ++k) {
          c.receiver.box = random_reference(random, tree, grid);
          builder.build(c.receiver, 1, c.list);
          for (std::size_t i = 0; i < list.items.size(); ++i) {
            const FloatBox& box = tree.item(list.items[i]).box;
            ASSERT_EQ(list.meets_emitter[i] != 0, fast::meets(box, c.emitter.box));
            (list.meets_emitter[i] != 0 ? overlapping : apart) += 1;
            if (list.meets_emitter[i] != 0) {
              EXPECT_NE(
                  exact::classify({scene::converted<double>(c.emitter.box),
                                   scene::converted<double>(c.receiver.box), scene::converted<double>(box)}),
                  Category::outside);
            }
          }
        }
      });
  EXPECT_GT(overlapping, 500u);
  EXPECT_GT(apart, 500u);
  EXPECT_GT(opened, 100u);
}

// Weak planes that are left out only ever add, and sorted planes change nothing.
TEST(CandidateList, WeakPlanesOnlyAdd) {
  std::size_t more = 0;
  on_random_trees(6, affordable(200),
                  [&](const Scene& scene, const ItemTree& tree, Random& random, bool grid) {
                    ListOptions all;
                    all.strategy = Strategy::always_open;
                    ListOptions sorted = all, strong = all;
                    sorted.sort_planes = true;
                    strong.weak_planes = 0.2F;
                    Lists c;
                    c.emitter.box = random_reference(random, tree, grid);
                    c.receiver.box = random_reference(random, tree, grid);
                    Faces faces[3];
                    const ListOptions* options[] = {&all, &sorted, &strong};
                    for (std::size_t k = 0; k < 3; ++k) {
                      ListBuilder builder(tree, scene, *options[k]);
                      builder.begin_emitter(c.emitter);
                      builder.build(c.receiver, 1, c.list);
                      faces[k] = faces_of(tree, c.list);
                    }
                    EXPECT_EQ(faces[0], faces[1]);
                    EXPECT_TRUE(includes(faces[2], faces[0]));
                    more += faces[2].size() - faces[0].size();
                  });
  EXPECT_GT(more, 50u);
}

/// What the value of the plane errs by, over its threshold, at a point; in 113 bits.
double share_of_threshold(const fast::FrontCorners& corners, const FrontPlane& plane,
                          const std::array<float, 3>& p) {
  std::array<Quad, 3> e1{}, e2{}, q{}, normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    e1[k] = Quad(corners[1][k]) - Quad(corners[0][k]);
    e2[k] = Quad(corners[2][k]) - Quad(corners[0][k]);
    q[k] = Quad(p[k]) - Quad(corners[0][k]);
  }
  std::size_t largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    normal[k] = e1[(k + 1) % 3] * e2[(k + 2) % 3] - e1[(k + 2) % 3] * e2[(k + 1) % 3];
    if (magnitude(normal[k]) > magnitude(normal[largest])) largest = k;
  }
  const int exponent = std::ilogb(static_cast<double>(magnitude(normal[largest])));
  const Quad exact =
      (normal[0] * q[0] + normal[1] * q[1] + normal[2] * q[2]) * Quad(std::ldexp(1.0, -exponent));
  return static_cast<double>(magnitude(Quad(plane.value(p[0], p[1], p[2])) - exact) / Quad(plane.threshold));
}

/// Corners and points near their plane: floats about 1 of all precisions, slivers among them.
std::array<float, 3> plane_point(Random& random, const fast::FrontCorners& corners) {
  const double u = random.unit() * 3 - 1, v = random.unit() * 3 - 1;
  std::array<float, 3> p{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = static_cast<double>(corners[0][k]);
    p[k] = static_cast<float>(a + u * (static_cast<double>(corners[1][k]) - a) +
                              v * (static_cast<double>(corners[2][k]) - a));
    if (random.chance(20)) p[k] = fuzz::step_ulps(p[k], random.between(-2, 2));
  }
  return p;
}

FloatBox box_at(const std::array<float, 3>& p) {
  return {{p[0], p[1], p[2], p[0], p[1], p[2]}};
}

TEST(FrontPlane, CertifiedPlanesNeverCallWhatIsInFrontBehindAndAreNotMuchTooCareful) {
  Random random(7);
  double most = 0;
  std::size_t wrong = 0, culled = 0, behind = 0, near = 0;
  for (int trial = 0; trial < affordable(60000); ++trial) {
    fast::FrontCorners corners;
    const double size = std::ldexp(1.0, -random.below(24)),
                 offset = random.chance(50) ? random.unit() * 8 : 0;
    for (auto& corner : corners) {
      for (float& x : corner) x = static_cast<float>(offset + size * (random.unit() * 2 - 1));
    }
    if (random.chance(10)) corners[0][1] = corners[1][1] = corners[2][1];
    const std::array<float, 3> p = plane_point(random, corners);
    const FloatBox box = box_at(p);
    FloatBox region = box;
    for (std::size_t k = 0; k < 3; ++k) {
      if (random.chance(50)) region.c[k] = std::min(-p[k], p[k]);
    }
    const FrontPlane plane = fast::form_front_plane(corners, region, Arithmetic::certified);
    const FrontPlane naive = fast::form_front_plane(corners, region, Arithmetic::naive);
    std::array<std::array<double, 3>, 3> exact_corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k) exact_corners[c][k] = static_cast<double>(corners[c][k]);
    }
    const int side = exact::side_of_face(
        exact_corners, {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    if (side > 0) {
      EXPECT_FALSE(plane.none_in_front(box));
    }
    if (side < 0) {
      EXPECT_FALSE(plane.none_behind(box));
    }
    wrong += side > 0 && naive.none_in_front(box);
    behind += side <= 0;
    culled += plane.none_in_front(box);
    near += plane.none_in_front(box) && naive.none_in_front(box);
    if (plane.threshold > 0) most = std::max(most, share_of_threshold(corners, plane, p));
  }
  EXPECT_GT(wrong, 100u);   // naive planes do err on these
  EXPECT_GT(culled, 100u);  // and certified ones still cull
  EXPECT_EQ(culled, near);
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.2);  // what the bound gives away
}

TEST(FrontPlane, AcrossAnAxisTheTestIsExactAndDegeneratePlanesSayNothing) {
  const FloatBox region{{-9, -9, -9, 9, 9, 9}};
  const float z = 0.1F;
  const fast::FrontCorners up{{{0, 0, z}, {1, 0, z}, {0, 1, z}}}, down{{{0, 0, z}, {0, 1, z}, {1, 0, z}}};
  const float above = std::nextafter(z, 1.0F), below = std::nextafter(z, 0.0F);
  for (const Arithmetic arithmetic : {Arithmetic::naive, Arithmetic::certified}) {
    const FrontPlane plane = fast::form_front_plane(up, region, arithmetic);
    EXPECT_TRUE(plane.none_in_front({{-9, -9, -9, 9, 9, z}}));
    EXPECT_FALSE(plane.none_in_front({{-9, -9, -9, 9, 9, above}}));
    EXPECT_TRUE(plane.none_behind({{-9, -9, z, 9, 9, 9}}));
    EXPECT_FALSE(plane.none_behind({{-9, -9, below, 9, 9, 9}}));
    const FrontPlane turned = fast::form_front_plane(down, region, arithmetic);
    EXPECT_TRUE(turned.none_in_front({{-9, -9, z, 9, 9, 9}}));
    EXPECT_FALSE(turned.none_in_front({{-9, -9, below, 9, 9, 9}}));
    const FrontPlane line = fast::form_front_plane({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, region, arithmetic);
    EXPECT_FALSE(line.none_in_front(region));
    EXPECT_FALSE(line.none_behind(region));
    EXPECT_FALSE(line.none_in_front(box_at({5, 5, 5})));
  }
  // Where values may overflow, certified planes say nothing.
  constexpr float kMost = std::numeric_limits<float>::max();
  const FrontPlane far = fast::form_front_plane({{{0, 0, 0}, {1, 0, 1}, {0, 1, 0}}},
                                                {{-kMost, 0, 0, kMost, 0, 0}}, Arithmetic::certified);
  EXPECT_FALSE(far.none_in_front(box_at({1, 0, 0})));
}

}  // namespace
}  // namespace gnomon::tests
