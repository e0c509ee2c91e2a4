// SPDX-License-Identifier: GPL-3.0-or-later
// What the ledger says of candidate lists (S11 to S14, S16, S20), on the lists themselves:
// proofs/Candidate*.v prove what is tested on small integers here, where floats calculate exactly; and for
// each claim that floats or the claim itself break, the case that breaks it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fast/box_relation.h"
#include "fast/shaft_box.h"
#include "tests/candidate_cases.h"

namespace gnomon::tests {
namespace {

/// S16, and that lists hold whatever exactly blocks a segment.
TEST(CandidateClaims, EveryStrategyAnswersAsTheHierarchy) {
  Random random(16);
  int blocked = 0, rays = 0, shorter = 0;
  for (int i = 0; i < affordable(4000); ++i) {
    const scene::Scene scene = grid_scene(random, random.between(1, 24), 9);
    const ItemTree tree = tree_of(scene, random.bits());
    const Box a = box_of(grid_point(random, 9), grid_point(random, 9)),
              b = box_of(grid_point(random, 9), grid_point(random, 9));
    const Made made(tree, scene, random_options(random), a, b);
    const std::vector<std::uint32_t> faces = faces_of(tree, made.list);
    shorter += faces.size() < scene.face_count() ? 1 : 0;
    for (int k = 0; k < 4; ++k) {
      const Point from = corner_within(random, b), to = corner_within(random, a);
      const bool whole = hits(tree, made.builder.root_list(), from, to);
      EXPECT_EQ(hits(tree, made.list, from, to), whole) << i;
      ++rays;
      blocked += whole ? 1 : 0;
      for (std::uint32_t f = 0; f < scene.face_count(); ++f) {
        if (exact::blocks(scene, f, query_of(from, to))) {
          EXPECT_TRUE(std::ranges::binary_search(faces, f)) << i << ' ' << f;
        }
      }
    }
  }
  EXPECT_GT(blocked, rays / 10);
  EXPECT_LT(blocked, rays * 9 / 10);
  EXPECT_GT(shorter, affordable(4000) / 4);
}

/// S16 in floats: the naive shaft from a point to a point culls a triangle that reaches far across the
/// segment.
TEST(CandidateClaims, NaiveShaftLosesABlocker) {
  const Point p{1002.8F, 1002.5F, 1000.6F}, q{1000.2F, 1002, 1002};
  const scene::Scene scene =
      scene_of({{{Point{1001.49982F, 1002.25F, 1001.30017F}, Point{1001.49982F, 1002.25F, 1000.30017F},
                  Point{1002.49982F, 1002.25F, 1001.30017F}}}});
  ASSERT_TRUE(is_blocked_exactly(scene, q, p));
  const ItemTree tree = tree_of(scene);
  for (const Strategy strategy : kStrategies) {
    ListOptions options;
    options.strategy = strategy;
    for (const Arithmetic arithmetic : {Arithmetic::naive, Arithmetic::certified}) {
      options.arithmetic = arithmetic;
      const Made made(tree, scene, options, box_of(p, p), box_of(q, q));
      EXPECT_TRUE(hits(tree, made.builder.root_list(), q, p));
      EXPECT_EQ(hits(tree, made.list, q, p), arithmetic == Arithmetic::certified);
    }
  }
}

/// S12: item by item, in any arithmetic.
TEST(CandidateClaims, RatioOneIsOverlapOpen) {
  Random random(12);
  int opened = 0, other = 0;
  for (int i = 0; i < affordable(2000); ++i) {
    const scene::Scene scene = grid_scene(random, random.between(2, 30), 9);
    const ItemTree tree = tree_of(scene, random.bits());
    const Box a = box_of(grid_point(random, 9), grid_point(random, 9)),
              b = box_of(grid_point(random, 9), grid_point(random, 9));
    ListOptions options = random_options(random);
    options.strategy = Strategy::overlap_open;
    const Made overlap(tree, scene, options, a, b);
    options.strategy = Strategy::ratio_open;
    options.ratio = 1;
    const Made ratio(tree, scene, options, a, b);
    EXPECT_EQ(ratio.list.items, overlap.list.items) << i;
    EXPECT_FALSE(ratio.list.marks.any());
    opened += overlap.list.items.size() > 1 ? 1 : 0;
    options.ratio = 0.99F;
    other += Made(tree, scene, options, a, b).list.items != overlap.list.items ? 1 : 0;
  }
  EXPECT_GT(opened, affordable(2000) / 4);
  EXPECT_GT(other, affordable(2000) / 20);
}

/// S13 with one strategy: from smaller reference boxes come no other faces.
TEST(CandidateClaims, SubShaftsHaveNoOtherFaces) {
  Random random(13);
  int smaller = 0;
  for (int i = 0; i < affordable(4000); ++i) {
    const scene::Scene scene = grid_scene(random, random.between(2, 30), 9);
    const ItemTree tree = tree_of(scene, random.bits());
    const Box a = box_of(grid_point(random, 9), grid_point(random, 9)),
              b = box_of(grid_point(random, 9), grid_point(random, 9));
    const Box in_a = box_of(corner_within(random, a), corner_within(random, a)),
              in_b = box_of(corner_within(random, b), corner_within(random, b));
    const ListOptions options = random_options(random);
    const Made parent(tree, scene, options, a, b), sub(tree, scene, options, in_a, in_b);
    const std::vector<std::uint32_t> all = faces_of(tree, parent.list), some = faces_of(tree, sub.list);
    EXPECT_TRUE(std::ranges::includes(all, some)) << i;
    smaller += some.size() < all.size() ? 1 : 0;
  }
  EXPECT_GT(smaller, affordable(4000) / 10);
}

/// Emitter [0, 1]^3, receiver [8, 9] x [0, 1]^2: the shaft is [0, 9] x [0, 1]^2.
constexpr Point kOrigin{0, 0, 0};
const Box kEmitter = box_of(kOrigin, {1, 1, 1}), kReceiver = box_of({8, 0, 0}, {9, 1, 1});

/// A triangle whose box is the one from p to q.
Triangle across(const Point& p, const Point& q) {
  return {p, q, Point{p[0], q[1], q[2]}};
}

/// S13 with two strategies, as chosen by the number of rays: what the parent's list opens and drops, the
/// sub-shaft's keeps closed. From the parent's list that can't happen.
TEST(CandidateClaims, SubShaftByAnotherStrategyHasOtherFaces) {
  const scene::Scene scene = scene_of({{across({2, 0, 0}, {3, 2, 1}), across({4, 2, 0}, {5, 3, 1})}});
  const ItemTree tree = tree_of(scene);
  ASSERT_EQ(tree.size(), 3U);
  ListOptions options;
  options.strategy = Strategy::overlap_open;
  options.open_from_rays = 10;
  ListBuilder builder(tree, scene, options);
  builder.begin_emitter(reference(kEmitter));
  CandidateList parent, sub, nested;
  builder.build(reference(kReceiver), 100, parent);
  builder.build(reference(box_of({8, 0, 0}, {9, 1, 0.5F})), 5, sub);
  builder.build(reference(box_of({8, 0, 0}, {9, 1, 0.5F})), 5, parent, nested);
  using Faces = std::vector<std::uint32_t>;
  EXPECT_EQ(faces_of(tree, parent), Faces{0});
  EXPECT_EQ(faces_of(tree, sub), (Faces{0, 1}));
  EXPECT_EQ(faces_of(tree, nested), Faces{0});
}

/// S13 in floats: proofs/witnesses/S13-sub-shaft-keeps-more.txt as lists.
TEST(CandidateClaims, NaiveSubShaftKeepsWhatItsParentCulls) {
  const scene::Scene scene = scene_of({{across({0x1.943332p+6F, 0x1.94ccccp+6F, 0x1.8f6668p+6F},
                                               {0x1.963332p+6F, 0x1.96ccccp+6F, 0x1.916668p+6F})}});
  const ItemTree tree = tree_of(scene);
  const Box a =
      box_of({0x1.95999ap+6F, 0x1.96p+6F, 0x1.91999ap+6F}, {0x1.96p+6F, 0x1.966666p+6F, 0x1.91999ap+6F});
  const Box in_a =
      box_of({0x1.95999cp+6F, 0x1.96p+6F, 0x1.91999ap+6F}, {0x1.95fffep+6F, 0x1.966666p+6F, 0x1.91999ap+6F});
  const Point b{0x1.96ccccp+6F, 0x1.97999ap+6F, 0x1.913334p+6F};
  ASSERT_TRUE(fast::contains(a, in_a));
  ListOptions options;
  options.arithmetic = Arithmetic::naive;
  EXPECT_EQ(Made(tree, scene, options, a, box_of(b, b)).list.items.size(), 0U);
  EXPECT_EQ(Made(tree, scene, options, in_a, box_of(b, b)).list.items.size(), 1U);
  options.arithmetic = Arithmetic::certified;
  EXPECT_EQ(Made(tree, scene, options, a, box_of(b, b)).list.items.size(), 1U);
}

/// S14 in floats: the naive planes take their offset from the first box's edge, and cull nothing that meets
/// that box; of what meets the other box they do.
TEST(CandidateClaims, NaivePlanesKeepWhatMeetsTheFirstBox) {
  Random random(14);
  int lost = 0, met = 0;
  const auto coordinate = [&] {
    return static_cast<float>(random.chance(50) ? 0 : 1000) + 0.1F * static_cast<float>(random.below(20));
  };
  const auto point = [&] { return Point{coordinate(), coordinate(), coordinate()}; };
  for (int i = 0; i < affordable(200000); ++i) {
    const Box a = box_of(point(), point());
    Box b = box_of(point(), point()), t = b;
    if (random.chance(50)) b = box_of(point(), corner_within(random, a));
    const Box& with = random.chance(50) ? a : b;
    t = box_of(corner_within(random, with), point());
    const bool outside =
        classify(fast::form_shaft(a, b, fast::Normals::as_formed), t).answer == scene::Category::outside;
    if (fast::meets(t, a)) {
      EXPECT_FALSE(outside) << i;
      ++met;
    } else if (fast::meets(t, b)) {
      lost += outside ? 1 : 0;
    }
  }
  EXPECT_GT(met, affordable(200000) / 4);
  EXPECT_GT(lost, 0);
}

/// The slab test without a widened far end.
bool plain_slabs_miss(const Box& box, const fast::Segment& s) {
  float near = 0, far = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const float one = (box.c[k] - s.from[k]) * s.inverse[k],
                other = (box.c[k + 3] - s.from[k]) * s.inverse[k];
    near = std::max(near, std::min(one, other));
    far = std::min(far, std::max(one, other));
  }
  return near > far;
}

/// S11 in floats: a box around a ray's start is never missed, whatever the ray; one around its end neither,
/// where no inverse of a component overflows or underflows.
TEST(CandidateClaims, BoxesAroundAnEndAreNotMissed) {
  Random random(11);
  const std::array<float, 12> numbers{0,      -0.0F,   1,      -1,    0.1F,   1000.1F,
                                      1e-45F, -1e-45F, 1e-39F, 1e38F, -3e38F, 3e38F};
  const auto wild = [&] { return numbers[static_cast<std::size_t>(random.below(12))]; };
  const auto tame = [&] {
    return (random.chance(50) ? 0.0F : 1000.0F) + static_cast<float>(random.unit() * 10);
  };
  const auto missed = [](const Point& from, const Point& to, const Point& around, const Point& far) {
    const scene::Scene scene = scene_of({{Triangle{around, far, around}}});
    return !meets_volume(tree_of(scene), 0, fast::Segment(from, to));
  };
  int missed_by_plain_slabs = 0;
  for (int i = 0; i < affordable(10000); ++i) {
    Point from{}, to{}, far{};
    for (Point* p : {&from, &to, &far}) std::ranges::generate(*p, wild);
    EXPECT_FALSE(missed(from, to, from, far)) << i;
    for (Point* p : {&from, &to, &far}) std::ranges::generate(*p, tame);
    EXPECT_FALSE(missed(from, to, to, far)) << i;
    for (std::size_t k = 0; k < 3; ++k) far[k] = random.chance(70) ? to[k] : far[k];
    EXPECT_FALSE(missed(from, to, to, far)) << i;
    missed_by_plain_slabs += plain_slabs_miss(box_of(to, far), fast::Segment(from, to)) ? 1 : 0;
  }
  EXPECT_GT(missed_by_plain_slabs, 0);
}

/// And where one overflows, the box around the end is missed.
TEST(CandidateClaims, BoxAroundTheEndIsMissedAfterOverflow) {
  const Point from{0, 0, 0}, to{1e-39F, 0, 1};
  const scene::Scene scene = scene_of({{Triangle{to, {2, 2, 2}, to}}});
  const ItemTree tree = tree_of(scene);
  ASSERT_TRUE(fast::contains(tree.item(0).box, box_of(to, to)));
  ASSERT_TRUE(std::isinf(fast::Segment(from, to).inverse[0]));
  EXPECT_FALSE(meets_volume(tree, 0, fast::Segment(from, to)));
  EXPECT_TRUE(meets_volume(tree, 0, fast::Segment(to, from)));
}

/// S20: by items refuted, by faces never.
TEST(CandidateClaims, SuperstructuredListsMayHaveMoreItems) {
  const scene::Scene beside = scene_of({{across({2, 0, 0}, {3, 2, 1}), across({4, 0, 0}, {5, 3, 1})}});
  const scene::Scene around = scene_of({{across({6, 0, 0}, {7, 2, 1}), across({8, 0, 0}, {9, 1, 1})}});
  for (const Strategy strategy : kStrategies) {
    for (const scene::Scene* scene : {&beside, &around}) {
      const ItemTree tree = tree_of(*scene);
      ASSERT_EQ(tree.size(), 3U);
      ListOptions options;
      options.strategy = strategy;
      options.ratio = 1;
      const Made made(tree, *scene, options, kEmitter, kReceiver);
      EXPECT_EQ(made.builder.emitter_list().items.size(), 1U);
      const bool opens = scene == &around || strategy != Strategy::keep_closed;
      EXPECT_EQ(made.list.items.size(), opens ? 2U : 1U);
      EXPECT_TRUE(
          std::ranges::includes(faces_of(tree, made.builder.emitter_list()), faces_of(tree, made.list)));
      options.enclosure = false;
      if (strategy == Strategy::keep_closed) {
        EXPECT_EQ(Made(tree, *scene, options, kEmitter, kReceiver).list.items.size(), 1U);
      }
    }
  }
}

}  // namespace
}  // namespace gnomon::tests
