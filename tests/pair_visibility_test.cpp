// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/pair_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/convexity.h"
#include "exact/first_hit.h"
#include "exact/hierarchy.h"
#include "exact/shadow.h"
#include "exact/shaft_candidates.h"
#include "exact/side_of_face.h"
#include "fuzz/float_faces.h"
#include "fuzz/radiosity.h"
#include "scene/builtin.h"
#include "scene/single.h"
#include "tests/batch_cases.h"
#include "tests/hard_scenes.h"

namespace gnomon::tests {

using fast::PairCaster;
using fast::PairResult;
using fast::PairScratch;
using fast::RayBatch;
using fast::ShadowAnswer;
using scene::FaceRun;
using scene::PairVisibility;

namespace {

using Points = std::vector<std::array<float, 3>>;
using Answers = std::vector<ShadowAnswer>;

const fast::ExactFaces kExactFaces{exact::blocks, exact::faces_away, exact::meets, exact::compare_hits};

/// A batch with its points.
struct Case {
  Points from, to;
  FaceRun own_from, own_to;

  [[nodiscard]] RayBatch batch() const { return {from, to, own_from, own_to}; }
  [[nodiscard]] std::size_t rays() const { return from.size() * to.size(); }
  [[nodiscard]] scene::ShadowQuery query(std::size_t i) const {
    scene::ShadowQuery query;
    for (std::size_t k = 0; k < 3; ++k) {
      query.point[k] = static_cast<double>(from[i / to.size()][k]);
      query.light[k] = static_cast<double>(to[i % to.size()][k]);
    }
    return query;
  }
};

/// Points on two triangles, on their edges or anywhere; every other time so that the rays leave the first one
/// on its front, exactly: what lies behind is then left out.
Case hard_case(HardKind kind, const scene::Scene& scene, Random& random) {
  HardPoints points(kind, random);
  constexpr int kSizes[] = {1, 2, 3, 4, 5, 8, 9, 16, 17, 20};
  const auto triangle = [&] {
    return static_cast<std::uint32_t>(random.below(static_cast<int>(scene.triangles.size())));
  };
  const std::uint32_t first = triangle(), second = triangle();
  const bool leaves_front = random.chance(50);
  Case made;
  const auto fill = [&](Points& list, std::uint32_t face, FaceRun& own, int least_side) {
    if (leaves_front || random.chance(70)) own = {face, random.chance(80) ? 1u : 2u};
    const int count = kSizes[random.below(10)];
    const bool on_corners = random.chance(25), anywhere = random.chance(20);
    for (int tries = 0; static_cast<int>(list.size()) < count; ++tries) {
      Point3 p = on_corners                      ? scene.corner(face, list.size() % 3)
                 : anywhere || random.chance(10) ? points.point()
                                                 : points.on(scene, face);
      // Moved by a few ulps; now and then it stays where it is.
      for (int step = 0; leaves_front && step < 4 && exact::side_of_face(scene, first, p) < least_side;
           ++step) {
        double& x = p[static_cast<std::size_t>(random.below(3))];
        x = as_float(x + (random.chance(50) ? 1 : -1) * std::abs(x) * 0x1p-22);
      }
      if (leaves_front && tries < 400 && exact::side_of_face(scene, first, p) < least_side) continue;
      list.push_back(fuzz::to_floats(p));
    }
  };
  fill(made.from, first, made.own_from, 0);
  fill(made.to, second, made.own_to, 1);
  if (random.chance(5)) made.to[0] = made.from[0];
  if (random.chance(50)) {
    std::swap(made.from, made.to);
    std::swap(made.own_from, made.own_to);
  }
  return made;
}

/// What happened in many cases: guards against tests that never test.
struct Tally {
  long rays = 0, shadowed = 0, undecided = 0, naive_wrong = 0, pairs = 0, all = 0, none = 0, listed = 0;
};

/// The truth by the definition, face by face; also that no face that blocks is missing in the list.
Answers truth_of(const scene::Scene& scene, const Case& c, const std::vector<std::uint32_t>& list) {
  std::vector<bool> listed(scene.face_count());
  for (const std::uint32_t face : list) {
    EXPECT_FALSE(listed[face]) << "twice in the list";
    listed[face] = true;
  }
  Answers truth(c.rays(), ShadowAnswer::lit);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
      if (c.own_from.contains(face) || c.own_to.contains(face)) continue;
      if (!exact::blocks(scene, face, c.query(i))) continue;
      truth[i] = ShadowAnswer::shadowed;
      EXPECT_TRUE(listed[face]) << "face " << face << " blocks ray " << i << " and is not in the list";
    }
  }
  return truth;
}

void check_result(const PairResult& result, const scene::Scene& scene, const Case& c, const Answers& truth) {
  if (result.visibility == PairVisibility::all) {
    EXPECT_EQ(std::count(truth.begin(), truth.end(), ShadowAnswer::lit), static_cast<long>(truth.size()));
  } else if (result.visibility == PairVisibility::none) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ASSERT_TRUE(exact::blocks(scene, result.blocker, c.query(i))) << "ray " << i;
    }
  }
}

void check_case(const scene::Scene& scene, const PairCaster& caster, PairScratch& scratch, const Case& c,
                Tally& tally) {
  std::vector<std::uint32_t> list;
  caster.candidates(caster.prepare(c.from, c.own_from), caster.prepare(c.to, c.own_to), list);
  const Answers truth = truth_of(scene, c, list);
  Answers first_naive, first_certified;
  PairResult first_result;
  for_each_target([&](const std::string& target) {
    const bool is_first = first_naive.empty();
    Answers naive(c.rays(), ShadowAnswer{77}), certified = naive, exact = naive;
    (void)caster.shadows_naive(c.batch(), scratch, naive);
    check_result(caster.shadows_certified(c.batch(), scratch, certified), scene, c, truth);
    const PairResult result = caster.shadows_exact(kExactFaces, c.batch(), scratch, exact);
    check_result(result, scene, c, truth);
    ASSERT_EQ(exact, truth) << target;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (certified[i] == ShadowAnswer::undecided) continue;
      ASSERT_EQ(certified[i], truth[i]) << target << " " << i;
    }
    if (is_first) {
      first_naive = naive;
      first_certified = certified;
      ++tally.pairs;
      tally.all += result.visibility == PairVisibility::all;
      tally.none += result.visibility == PairVisibility::none;
      tally.listed += static_cast<long>(list.size());
      for (std::size_t i = 0; i < truth.size(); ++i) {
        ++tally.rays;
        tally.shadowed += truth[i] == ShadowAnswer::shadowed;
        tally.undecided += certified[i] == ShadowAnswer::undecided;
        tally.naive_wrong += naive[i] != truth[i];
      }
    }
    ASSERT_EQ(naive, first_naive) << target;
    ASSERT_EQ(certified, first_certified) << target;
    // The same from prepared patches and without a memory of blockers, which decides what is noticed.
    PairScratch fresh;
    const PairResult alone = caster.shadows_certified(caster.prepare(c.from, c.own_from),
                                                      caster.prepare(c.to, c.own_to), fresh, certified);
    if (is_first) first_result = alone;
    ASSERT_EQ(alone.visibility, first_result.visibility) << target;
    ASSERT_EQ(alone.blocker, first_result.blocker) << target;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (certified[i] == ShadowAnswer::undecided) continue;
      ASSERT_EQ(certified[i], truth[i]) << target << " " << i;
    }
  });
}

}  // namespace

TEST(PairVisibility, HardScenesAreAnsweredAsTheDefinitionSays) {
  Tally total;
  for (const HardKind kind : kHardKinds) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, seed % 2 == 0 ? 10 : 50, seed % 3 == 0 ? 6 : 0);
      const PairCaster caster(scene);
      ASSERT_TRUE(caster.in_domain());
      PairScratch scratch;
      Random random(seed * 977 + static_cast<std::uint64_t>(kind));
      for (int i = affordable(12); i > 0; --i) {
        SCOPED_TRACE(name_of(kind) + " " + std::to_string(seed) + " " + std::to_string(i));
        check_case(scene, caster, scratch, hard_case(kind, scene, random), tally);
        if (HasFailure()) return;
      }
    }
    std::printf(
        "%-10s of %ld rays: shadowed %ld, undecided %ld, naive wrong %ld; of %ld pairs: all %ld, none %ld\n",
        name_of(kind).c_str(), tally.rays, tally.shadowed, tally.undecided, tally.naive_wrong, tally.pairs,
        tally.all, tally.none);
    EXPECT_LT(tally.undecided, tally.rays * 9 / 10) << name_of(kind);
    EXPECT_GT(tally.shadowed, 0) << name_of(kind);
    EXPECT_LT(tally.shadowed, tally.rays) << name_of(kind);
    total.naive_wrong += tally.naive_wrong;
    total.all += tally.all;
    total.none += tally.none;
  }
  EXPECT_GT(total.naive_wrong, 0);
  if (kSanitized) return;  // too few cases for each kind of pair to be among them
  EXPECT_GT(total.all, 0);
  EXPECT_GT(total.none, 0);
}

TEST(PairVisibility, RadiosityRaysAreThoseOfTheExactHierarchy) {
  Tally tally;
  std::uint64_t faces_with = 0, faces_without = 0;
  for (const char* name : {"office", "classroom:2", "gears", "city:4"}) {
    const scene::Scene scene = scene::rounded_to_floats(scene::find_builtin(name)->make()).scene;
    std::vector<std::uint8_t> convex;
    for (const scene::Object& object : scene.objects) convex.push_back(exact::is_convex(scene, object));
    const PairCaster caster(scene, convex), careful(scene);
    const exact::Hierarchy reference(scene);
    PairScratch scratch;
    for (const std::size_t rays : {16, 64, 400}) {
      const auto most = static_cast<std::size_t>(affordable(4000));
      for (const fuzz::RadiosityPair& pair : fuzz::record_pairs(scene, {rays, most, 7})) {
        Case c{{}, {}, pair.from.own, pair.to.own};
        for (const auto& p : pair.from.points) c.from.push_back(fuzz::to_floats(p));
        for (const auto& p : pair.to.points) c.to.push_back(fuzz::to_floats(p));
        Answers exact(c.rays()), certified = exact, unflagged = exact;
        fast::PairCounters with, without;
        const PairResult result = caster.shadows_exact(kExactFaces, c.batch(), scratch, exact, &with);
        (void)caster.shadows_certified(c.batch(), scratch, certified);
        PairScratch fresh;
        (void)careful.shadows_exact(kExactFaces, c.batch(), fresh, unflagged, &without);
        faces_with += with.faces;
        faces_without += without.faces;
        ++tally.pairs;
        tally.all += result.visibility == PairVisibility::all;
        tally.none += result.visibility == PairVisibility::none;
        for (std::size_t i = 0; i < exact.size(); ++i) {
          const auto truth = static_cast<ShadowAnswer>(reference.shadow(pair.query(i)).answer);
          ASSERT_EQ(exact[i], truth) << name;
          ASSERT_EQ(unflagged[i], truth) << name;
          ASSERT_TRUE(certified[i] == truth || certified[i] == ShadowAnswer::undecided) << name;
          ++tally.rays;
          tally.shadowed += truth == ShadowAnswer::shadowed;
          tally.undecided += certified[i] == ShadowAnswer::undecided;
        }
      }
    }
  }
  std::printf(
      "of %ld rays: shadowed %ld, undecided %ld; of %ld pairs: all %ld, none %ld; faces %d, without flags "
      "%d\n",
      tally.rays, tally.shadowed, tally.undecided, tally.pairs, tally.all, tally.none,
      static_cast<int>(faces_with), static_cast<int>(faces_without));
  EXPECT_GT(tally.pairs, 100);
  EXPECT_LT(tally.undecided, tally.rays / 200);
  EXPECT_GT(tally.all, tally.pairs / 20);
  EXPECT_GT(tally.none, tally.pairs / 50);
  EXPECT_LE(faces_with, faces_without);
}

TEST(PairVisibility, ShaftFacesAreThoseThatMeetTheShaftOrNear) {
  std::size_t listed = 0, met = 0, dropped = 0;
  for (const HardKind kind : kHardKinds) {
    for (std::uint64_t seed = 50; seed < 54; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, 40, 8);
      const PairCaster caster(scene);
      Random random(seed * 31 + static_cast<std::uint64_t>(kind));
      HardPoints points(kind, random);
      for (int i = affordable(40); i > 0; --i) {
        scene::Box<float> box[2];
        for (auto& b : box) {
          const Point3 p = points.point(), q = random.chance(40) ? p : points.point();
          for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            b.lo(k) = static_cast<float>(std::min(p[axis], q[axis]));
            b.hi(k) = static_cast<float>(std::max(p[axis], q[axis]));
          }
        }
        const std::vector<std::uint32_t> truth = exact::shaft_candidates_by_all_faces(
            scene, scene::converted<double>(box[0]), scene::converted<double>(box[1]));
        std::vector<std::uint32_t> first;
        for_each_target([&](const std::string& target) {
          std::vector<std::uint32_t> faces;
          caster.shaft_faces(box[0], box[1], faces);
          std::sort(faces.begin(), faces.end());
          ASSERT_TRUE(std::includes(faces.begin(), faces.end(), truth.begin(), truth.end()))
              << target << " " << name_of(kind);
          if (first.empty()) first = faces;
          ASSERT_EQ(faces, first) << target;
        });
        if (HasFatalFailure()) return;
        listed += first.size();
        met += truth.size();
        dropped += scene.face_count() - first.size();
      }
    }
  }
  std::printf("shafts: %zu faces listed, %zu met, %zu dropped\n", listed, met, dropped);
  EXPECT_GT(dropped, listed / 4);
  EXPECT_LT(listed, met + met / 4);
}

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
    Case c{{}, {}, {0, 1}, {}};
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

TEST(PairVisibility, CostsAreCountedAndDoNotDependOnTheInstructionSet) {
  const scene::Scene scene = hard_scene(HardKind::soup, 3, 200, 10);
  const PairCaster caster(scene);
  Random random(5);
  const Case c = hard_case(HardKind::soup, scene, random);
  fast::PairCounters first;
  for_each_target([&](const std::string& target) {
    PairScratch scratch;
    fast::PairCounters counters;
    Answers answers(c.rays());
    (void)caster.shadows_exact(kExactFaces, c.batch(), scratch, answers, &counters);
    EXPECT_EQ(counters.pairs, 1u);
    EXPECT_EQ(counters.rays, c.rays());
    EXPECT_GT(counters.nodes, 0u);
    if (first.pairs == 0) first = counters;
    EXPECT_EQ(counters, first) << target;
  });
}

}  // namespace gnomon::tests
