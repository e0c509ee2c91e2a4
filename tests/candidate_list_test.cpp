// SPDX-License-Identifier: GPL-3.0-or-later
// fast/list_builder.h: lists of certified arithmetic lose nothing; claims S12 to S14.
#include "fast/list_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "exact/patch_pair.h"
#include "exact/shaft_box.h"
#include "exact/shaft_candidates.h"
#include "exact/side_of_face.h"
#include "fast/box_relation.h"
#include "fuzz/list_candidates.h"
#include "fuzz/list_options_text.h"
#include "tests/list_trees.h"

namespace gnomon::tests {
namespace {

using fast::ListBuilder;
using scene::Category;

TEST(CandidateList, CertifiedListsLoseNoFaceThatMeetsTheShaftWhateverTheOptions) {
  std::size_t met = 0, kept = 0, marks = 0, parts = 0, longer = 0;
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
          // Nothing that the emitter's list does not have, but maybe in more items (claim S20).
          ASSERT_TRUE(includes(faces_of(tree, builder.emitter_list()), faces));
          longer += c.list.items.size() > builder.emitter_list().items.size();
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
  EXPECT_GT(met, least(10000));
  EXPECT_LT(met, kept);
  EXPECT_LT(parts, kept);
  EXPECT_GT(marks, least(100));
  EXPECT_GT(longer, least(100));
}

// The registry's rows: promises kept, by several threads at once.
TEST(CandidateList, RowsFindWhatTheyPromise) {
  std::size_t rows = 0;
  on_random_trees(9, affordable(30), [&](const Scene& scene, const ItemTree& tree, Random& random, bool) {
    const exact::ShaftCandidates reference(scene);
    std::vector<fuzz::BoxPair> pairs;
    for (int i = 0; i < 20; ++i)
      pairs.push_back({random_reference(random, tree, false), random_reference(random, tree, false)});
    for (const fuzz::CandidateMethod& row : fuzz::list_candidate_rows()) {
      const auto finder = row.make(scene);
      std::vector<Faces> found[2];
      const auto ask = [&](std::size_t who) {
        for (const fuzz::BoxPair& pair : pairs) {
          Faces faces{scene::kNoFace};  // to be replaced
          finder->faces(pair, faces);
          std::ranges::sort(faces);
          found[who].push_back(faces);
        }
      };
      { const std::jthread one(ask, 0), other(ask, 1); }
      EXPECT_EQ(found[0], found[1]);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        Faces truth;
        reference.faces(scene::converted<double>(pairs[i].a), scene::converted<double>(pairs[i].b), truth);
        const bool all = includes(found[0][i], truth);
        EXPECT_TRUE(all || row.promise == fuzz::Promise::none) << row.name;
      }
      ++rows;
    }
  });
  EXPECT_GE(rows, 30u);
}

// Claim S13 without any nesting: the list of a sub-shaft, made by itself, is among the parent's, where the
// cull test is exact. The sphere test is not: what is kept wrongly by the sub-shaft's planes may be outside
// of one of the parent's.
TEST(CandidateList, FacesOfASubShaftAreAmongItsParentsWhereVolumesAreBoxes) {
  std::size_t fewer = 0, more = 0;
  on_random_trees(2, affordable(1500), [&](const Scene& scene, const ItemTree& tree, Random& random, bool) {
    ListOptions options;
    options.strategy = Strategy::always_open;
    options.arithmetic = static_cast<Arithmetic>(random.below(2));
    ListBuilder builder(tree, scene, options);
    Lists c;
    c.emitter.box = random_reference(random, tree, true);
    c.receiver.box = random_reference(random, tree, true);
    for (std::size_t k = 0; k < 6; ++k) {  // all sums and products of small integers and halves are exact
      if (c.emitter.box.c[k] + c.receiver.box.c[k] != std::floor(c.emitter.box.c[k] + c.receiver.box.c[k]))
        return;
    }
    builder.begin_emitter(c.emitter);
    builder.build(c.receiver, 1, c.list);
    Reference part = c.receiver;
    for (int axis = 0; axis < 3; ++axis)
      part.box.lo(axis) = 0.5F * part.box.lo(axis) + 0.5F * part.box.hi(axis);
    builder.build(part, 1, c.part);
    const Faces all = faces_of(tree, c.list), some = faces_of(tree, c.part);
    EXPECT_TRUE(includes(all, some) || tree.volumes() == Volumes::spheres);
    more += !includes(all, some);
    fewer += some.size() < all.size();
  });
  EXPECT_GT(fewer, least(200));
  EXPECT_GE(more, least(8) / 8);
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
  EXPECT_GT(met, least(500));
  EXPECT_GT(outside, least(500));
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
  EXPECT_GT(volumes, kSanitized ? 0U : 50U);  // rare: no share of few trials is sure
  EXPECT_GT(items, least(1000));
  EXPECT_GT(others, least(100));
}

// Claim S14, and the emitter list's definition; up from the emitter or down from the root.
TEST(CandidateList, EmitterListIsWhatDoesNotEncloseTheEmitter) {
  std::size_t overlapping = 0, apart = 0, opened = 0;
  std::uint64_t known = 0, asked = 0;
  on_random_trees(
      5, affordable(300), [&](const Scene& scene, const ItemTree& tree, Random& random, bool grid) {
        if (tree.volumes() == Volumes::spheres) return;
        ListOptions options;
        options.arithmetic = Arithmetic::certified;
        options.strategy = Strategy::always_open;
        ListOptions without = options;
        without.emitter_overlap = false;
        ListBuilder builder(tree, scene, options), asking(tree, scene, without);
        const auto face = static_cast<std::uint32_t>(random.below(static_cast<int>(scene.face_count())));
        const std::uint32_t own = tree.primitive_of(face);
        Lists c;
        c.emitter.box = tree.item(own).box;
        builder.begin_emitter(c.emitter);
        std::vector<std::uint32_t> down = builder.emitter_list().items;
        c.emitter.own = {tree.item(own).first, tree.item(own).count()};
        builder.begin_emitter(c.emitter);
        asking.begin_emitter(c.emitter);
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
          // What is known need not be asked, and changes nothing.
          asking.build(c.receiver, 1, c.part);
          EXPECT_EQ(c.part.items, c.list.items);
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
        known += builder.counters().comparisons;
        asked += asking.counters().comparisons;
      });
  EXPECT_LT(known, asked);
  EXPECT_GT(overlapping, least(500));
  EXPECT_GT(apart, least(500));
  EXPECT_GT(opened, least(100));
}

// Patches that face each other, exactly: with their planes, lists still hold all faces that can block.
TEST(CandidateList, PatchPlanesLoseNoFaceThatCanBlock) {
  std::size_t blocking = 0, fewer = 0;
  on_placed_trees(
      7, affordable(1500), true,
      [&](const Scene& scene, const ItemTree& tree, Random& random, bool, const Placement&) {
        for (int pair = 0; pair < 10; ++pair) {
          scene::Patch patches[2];
          Reference references[2];
          for (std::size_t k = 0; k < 2; ++k) {
            const auto face =
                static_cast<std::uint32_t>(random.below(static_cast<int>(scene.triangles.size())));
            references[k] = {tree.item(tree.primitive_of(face)).box, {face, 1}, tree.triangle(face)};
            patches[k] = {{scene.corner(face, 0), scene.corner(face, 1), scene.corner(face, 2)}, face};
          }
          const auto faces_wholly = [&](std::size_t a, std::size_t b) {
            return std::all_of(patches[b].corners.begin(), patches[b].corners.end(),
                               [&](const auto& p) { return exact::side_of_face(patches[a].corners, p) > 0; });
          };
          if (!faces_wholly(0, 1) || !faces_wholly(1, 0)) continue;
          ListOptions options = random_options(random, Arithmetic::certified);
          Faces faces[2];
          for (const bool planes : {false, true}) {
            options.patch_planes = options.behind_emitter = planes;
            ListBuilder builder(tree, scene, options);
            CandidateList list;
            builder.begin_emitter(references[0]);
            builder.build(references[1], 5, list);
            faces[planes ? 1 : 0] = faces_of(tree, list);
          }
          for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
            const std::uint32_t item = tree.primitive_of(face);
            const bool own =
                item == tree.primitive_of(patches[0].face) || item == tree.primitive_of(patches[1].face);
            if (own || !exact::can_block(scene, face, {patches[0], patches[1]})) continue;
            ++blocking;
            ASSERT_TRUE(std::binary_search(faces[1].begin(), faces[1].end(), face))
                << fuzz::text_of({options, {}, tree.volumes(), 1});
          }
          fewer += faces[1].size() < faces[0].size();
        }
      });
  EXPECT_GT(blocking, least(1000));
  EXPECT_GT(fewer, least(100));
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
  EXPECT_GT(more, least(50));
}

}  // namespace
}  // namespace gnomon::tests
