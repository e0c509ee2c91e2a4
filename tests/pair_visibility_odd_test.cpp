// SPDX-License-Identifier: GPL-3.0-or-later
// Batches whose answers are known beforehand: odd numbers, own faces within ulps, scratches that go around.
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "tests/pair_batches.h"

namespace gnomon::tests {

using fast::PairCaster;
using fast::PairResult;
using fast::PairScratch;
using scene::PairVisibility;

TEST(PairVisibility, OddBatchesAreDecidedOnPurpose) {
  scene::Scene scene;
  scene.points = {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
  scene.triangles = {{0, 1, 2}, {0, 1, 1}};  // the second one is a segment
  scene.objects.resize(1);
  scene.objects[0].triangle_count = 2;
  const PairCaster caster(scene);
  PairScratch scratch;
  const auto ask = [&](const Points& from, const Points& to, Answers expected_exact,
                       Answers expected_certified, FaceRun own = {}) {
    const RayBatch batch{from, to, own, {}};
    Answers answers(expected_exact.size(), ShadowAnswer{77});
    (void)caster.shadows_exact(kExactFaces, batch, scratch, answers);
    EXPECT_EQ(answers, expected_exact);
    (void)caster.shadows_certified(batch, scratch, answers);
    EXPECT_EQ(answers, expected_certified);
    (void)caster.shadows_naive(batch, scratch, answers);  // only: that it ends
  };
  constexpr auto kLit = ShadowAnswer::lit, kDark = ShadowAnswer::shadowed, kOpen = ShadowAnswer::undecided;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInfinity = std::numeric_limits<float>::infinity();
  const Points below{{1, 1, 0}};
  ask(below, {{1, 1, 2}}, {kDark}, {kDark});
  ask(below, {{1, 1, 2}}, {kLit}, {kLit}, {0, 1});   // the own face blocks nothing
  ask(below, {{1, 1, 1}}, {kLit}, {kOpen});          // ends on the face: open segments
  ask(below, {{1, 1, 0}}, {kLit}, {kLit});           // no segment at all
  ask({{1, 1, 1}}, {{1, 1, 1}}, {kLit}, {kLit});     // also on a face
  ask({{2, -1, 0}}, {{2, 1, 2}}, {kDark}, {kOpen});  // through an edge, and the segment
  ask(below, {{1, 1, kNan}, {1, 1, 2}}, {kOpen, kDark}, {kOpen, kOpen});
  ask(below, {{1, 1, kInfinity}, {1, 1, 2}}, {kOpen, kDark}, {kOpen, kOpen});
  ask(below, {{1, 1, 0x1p41f}, {1, 1, 0.5f}}, {kDark, kLit}, {kOpen, kOpen});  // beyond the domain
  ask({}, below, {}, {});
  ask(below, {}, {}, {});
  Answers none;
  EXPECT_EQ(caster.shadows_exact(kExactFaces, RayBatch{{}, below, {}, {}}, scratch, none).visibility,
            PairVisibility::all);
  const PairResult hidden =
      caster.shadows_certified(RayBatch{below, Points{{1, 1, 2}}, {}, {}}, scratch, none = Answers(1));
  EXPECT_EQ(hidden.visibility, PairVisibility::none);
  EXPECT_EQ(hidden.blocker, 0u);
}

TEST(PairVisibility, FacesAFewUlpsInFrontOfTheOwnOneBlock) {
  // Rays leave a triangle, and a copy of it whose corners were moved by ulps is just before it, behind it, or
  // both. Some lie nearly, but not quite, across an axis.
  long blocked = 0, free = 0, all = 0;
  Random random(77);
  for (int trial = affordable(8000); trial > 0; --trial) {
    const bool flat = random.chance(40);
    const auto moved = [&](Point3 p) {
      for (double& x : p) x = as_float(x * (1 + random.between(-2, 2) * 0x1p-23));
      return p;
    };
    scene::Scene scene;
    for (int i = 0; i < 3; ++i) {
      Point3 p{random.unit() * 4 + 1, random.unit() * 4 + 1, flat ? 3 : random.unit() * 4 + 1};
      for (double& x : p) x = as_float(x);
      scene.points.push_back(moved(p));
    }
    for (std::size_t i = 0; i < 3; ++i) scene.points.push_back(moved(scene.points[i]));
    scene.triangles = {{0, 1, 2}, {3, 4, 5}};
    scene.objects.resize(1);
    scene.objects[0].triangle_count = 2;
    BatchCase c{{}, {}, {0, 1}, {}};
    for (int tries = 0; c.from.size() < 4 && tries < 200; ++tries) {
      const double a = random.unit(), b = random.unit() * (1 - a);
      Point3 p;
      for (std::size_t k = 0; k < 3; ++k) {
        const double v = scene.points[0][k];
        p[k] = as_float(v + a * (scene.points[1][k] - v) + b * (scene.points[2][k] - v));
      }
      if (random.chance(40)) p = scene.points[static_cast<std::size_t>(random.below(3))];
      if (random.chance(90) && exact::side_of_face(scene, 0, p) < 0) p = moved(p);
      if (random.chance(90) && exact::side_of_face(scene, 0, p) < 0) continue;
      c.from.push_back(fuzz::to_floats(p));
    }
    for (int tries = 0; c.to.empty() && tries < 200; ++tries) {
      const Point3 q{as_float(random.unit() * 6), as_float(random.unit() * 6), as_float(random.unit() * 6)};
      if (exact::side_of_face(scene, 0, q) > 0) c.to.push_back(fuzz::to_floats(q));
    }
    if (c.rays() == 0) continue;
    const PairCaster caster(scene);
    PairScratch scratch;
    Answers answers(c.rays());
    all += caster.shadows_exact(kExactFaces, c.batch(), scratch, answers).visibility == PairVisibility::all;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const bool truth = exact::blocks(scene, 1, c.query(i));
      ASSERT_EQ(answers[i], truth ? ShadowAnswer::shadowed : ShadowAnswer::lit)
          << trial << (flat ? " flat" : "");
      ++(truth ? blocked : free);
    }
  }
  std::printf("a few ulps: blocked %ld, free %ld; all %ld\n", blocked, free, all);
  EXPECT_GT(blocked, free / 20);
  EXPECT_GT(free, blocked / 20);
}

TEST(PairVisibility, ScratchMayServeSeveralCastersAndScenesWithoutFaces) {
  scene::Scene wall, nothing;
  wall.points = {{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}};
  wall.triangles = {{0, 1, 2}};
  wall.objects.resize(1);
  wall.objects[0].triangle_count = 1;
  scene::Scene far = wall;
  for (auto& p : far.points) p[2] = 5;
  const PairCaster of_wall(wall), of_far(far), of_nothing(nothing);
  const PairCaster* const casters[] = {&of_wall, &of_far, &of_nothing};
  const Points from{{0, 0, 0}, {0.5f, 0, 0}}, to{{0, 0, 2}, {0.25f, 0, 3}};
  PairScratch scratch;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < 3; ++i) {
      Answers answers(4, ShadowAnswer{77});
      const PairResult result = casters[i]->shadows_certified(RayBatch{from, to, {}, {}}, scratch, answers);
      EXPECT_EQ(answers, Answers(4, i == 0 ? ShadowAnswer::shadowed : ShadowAnswer::lit));
      EXPECT_EQ(result.visibility, i == 0 ? PairVisibility::none : PairVisibility::all);
    }
  }
  // The blocker of one scene is nothing to another one.
  PairScratch fresh;
  fast::PairCounters of_fresh, of_used;
  Answers answers(4);
  (void)of_wall.shadows_certified(RayBatch{from, to, {}, {}}, scratch, answers);
  (void)of_far.shadows_certified(RayBatch{from, to, {}, {}}, scratch, answers, &of_used);
  (void)of_far.shadows_certified(RayBatch{from, to, {}, {}}, fresh, answers, &of_fresh);
  EXPECT_EQ(of_used, of_fresh);
}

}  // namespace gnomon::tests
