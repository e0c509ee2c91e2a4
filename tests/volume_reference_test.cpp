// SPDX-License-Identifier: GPL-3.0-or-later
// exact/shaft_slabs, shaft_oriented_box and shaft_ellipsoid against the definitions in rationals.
#include <gtest/gtest.h>

#include "fuzz/campaign.h"
#include "fuzz/volume_questions.h"
#include "scene/corpus.h"
#include "tests/volume_definition.h"

namespace gnomon::tests {
namespace {

using scene::Category;
using scene::ShaftEllipsoidCase;
using scene::ShaftOrientedBoxCase;
using scene::ShaftSlabsCase;

const std::array<const char*, 10> kDistributions{"uniform",  "offset",     "integer-grid", "near-touch",
                                                 "nested",   "degenerate", "thin",         "mixed-magnitude",
                                                 "denormal", "huge"};

int wanted_cases(int few) {
  const char* const more = std::getenv("GNOMON_REFERENCE_CASES");
  return more == nullptr ? few : std::max(few, std::atoi(more) / 10);
}

/// Calls check(case) for some cases of each distribution and scalar.
template <class Q, class Check>
void for_cases(int few, const Check& check) {
  for (const char* name : kDistributions) {
    for (const scene::Scalar scalar : {scene::Scalar::f32, scene::Scalar::f64}) {
      const auto generator = fuzz::make_generator<typename Q::Case>(fuzz::parse_distribution(name), scalar);
      for (int i = 0; i < wanted_cases(few) && !testing::Test::HasFailure(); ++i) {
        fuzz::CaseRandom random(99, fuzz::stream_of(name), static_cast<std::uint64_t>(i));
        const typename Q::Case c = generator->make(random);
        SCOPED_TRACE(std::string(name) + ": " + scene::corpus_text(Q::id, fuzz::numbers_of(c), ""));
        ASSERT_FALSE(fuzz::objection(c));
        check(c);
      }
    }
  }
}

template <class Case>
exact::VolumeReference reference_of(const Case& c) {
  exact::VolumeReference reference;
  exact::refer(std::span(&c, 1), std::span(&reference, 1));
  return reference;
}

/// What holds of every reference, whatever the volume.
template <class Case>
void expect_consistent(const Case& c, const exact::VolumeReference& r) {
  EXPECT_EQ(r, exact::refer_in_rationals(c));
  EXPECT_EQ(exact::classify(c), r.truth);
  const exact::Gap outside = exact::gap(c, exact::Boundary::outside),
                   inside = exact::gap(c, exact::Boundary::inside);
  EXPECT_EQ(outside > 0, r.truth == Category::outside);
  EXPECT_EQ(inside > 0, r.truth != Category::inside);
  EXPECT_EQ(inside == 0, r.touches_inside) << inside.get_str();
  EXPECT_GE(exact::gap_bound(c, exact::Boundary::outside), std::fabs(outside.get_d()) * (1 - 0x1p-50));
  EXPECT_GE(exact::gap_bound(c, exact::Boundary::inside), std::fabs(inside.get_d()) * (1 - 0x1p-50));
  EXPECT_EQ(exact::classify_grown(c, 0), r.planes);
  // Each test tells more than the one before, and nothing false.
  EXPECT_TRUE(r.planes != Category::outside || r.separating == Category::outside);
  EXPECT_TRUE(r.separating != Category::outside || r.truth == Category::outside);
}

TEST(VolumeReference, OrientedBoxes) {
  std::array<int, 3> counts{};
  int missed_by_planes = 0, missed_by_usual_axes = 0, touching = 0;
  for_cases<fuzz::ShaftOrientedBoxQuestion>(20, [&](const ShaftOrientedBoxCase& c) {
    const exact::VolumeReference r = reference_of(c);
    EXPECT_EQ(r.truth, truth_of(c.a, c.b, vertices_of(c.t)));
    expect_consistent(c, r);
    EXPECT_EQ(exact::gap(c, exact::Boundary::outside) == 0, r.touches_outside);
    ++counts[static_cast<std::size_t>(r.truth)];
    missed_by_planes += r.truth == Category::outside && r.planes != r.truth;
    missed_by_usual_axes += r.truth == Category::outside && r.separating != r.truth;
    touching += r.touches_outside;
  });
  for (const int count : counts) EXPECT_GE(count, 25);
  EXPECT_GE(missed_by_planes, 3);
  EXPECT_GE(missed_by_usual_axes, 1);
  EXPECT_GE(touching, 10);
}

TEST(VolumeReference, SlabSets) {
  std::array<int, 3> counts{};
  int missed_by_planes = 0, touching = 0;
  for_cases<fuzz::ShaftSlabsQuestion>(5, [&](const ShaftSlabsCase& c) {
    const exact::VolumeReference r = reference_of(c);
    const std::vector<PointQ> vertices = vertices_of(c.t);
    ASSERT_FALSE(vertices.empty());
    EXPECT_EQ(r.truth, truth_of(c.a, c.b, vertices));
    expect_consistent(c, r);
    EXPECT_EQ(exact::gap(c, exact::Boundary::outside) == 0, r.touches_outside);
    ++counts[static_cast<std::size_t>(r.truth)];
    missed_by_planes += r.truth == Category::outside && r.planes != r.truth;
    touching += r.touches_outside;
  });
  for (const int count : counts) EXPECT_GE(count, 8);
  EXPECT_GE(touching, 5);
}

TEST(VolumeReference, Ellipsoids) {
  std::array<int, 3> counts{};
  int missed_by_planes = 0, singular = 0;
  for_cases<fuzz::ShaftEllipsoidQuestion>(10, [&](const ShaftEllipsoidCase& c) {
    const exact::VolumeReference r = reference_of(c);
    expect_consistent(c, r);
    ++counts[static_cast<std::size_t>(r.truth)];
    missed_by_planes += r.truth == Category::outside && r.planes != r.truth;
    const std::optional<int> sign = reach_sign(c);
    singular += !sign;
    if (!sign) return;
    EXPECT_EQ(*sign > 0, r.truth == Category::outside);
    EXPECT_EQ(*sign == 0, r.touches_outside);
  });
  for (const int count : counts) EXPECT_GE(count, 15);
  EXPECT_GE(missed_by_planes, 1);
  EXPECT_GE(singular, 3);
}

/// Singular ellipsoids of rank two, by their planes.
TEST(VolumeReference, FlatEllipsoids) {
  int flat = 0, meeting = 0, touching_across = 0;
  for_cases<fuzz::ShaftEllipsoidQuestion>(5, [&](ShaftEllipsoidCase c) {
    const bool twice = flat % 2 == 0;
    c.t.axes[2] = twice ? c.t.axes[0] : std::array<double, 3>{0, 0, 0};
    if (flat / 2 % 2 == 0) {  // in the plane of a side
      const std::size_t across = static_cast<std::size_t>(flat / 4 % 3);
      for (auto& axis : c.t.axes) axis[across] = 0;
      c.t.centre[across] = std::max(c.a.c[across + 3], c.b.c[across + 3]);
    }
    const auto &x = c.t.axes[0], &y = c.t.axes[1];
    bool independent = false;
    for (std::size_t i = 0; i < 3; ++i) {
      independent = independent || Q(x[i]) * Q(y[(i + 1) % 3]) != Q(x[(i + 1) % 3]) * Q(y[i]);
    }
    if (!independent) return;
    ++flat;
    const FlatAnswer expected = flat_answer(c);
    const exact::VolumeReference r = reference_of(c);
    EXPECT_EQ(r.truth != Category::outside, expected.meets);
    EXPECT_EQ(r.touches_outside, expected.touches);
    expect_consistent(c, r);
    meeting += expected.meets;
    touching_across += expected.touches && exact::gap(c, exact::Boundary::outside) != 0;
  });
  EXPECT_GE(meeting, 25);
  EXPECT_GE(flat - meeting, 25);
  EXPECT_GE(touching_across, 10);
}

/// A singular ellipsoid of rank one is the segment that an oriented box is; of rank zero both are points.
TEST(VolumeReference, SegmentsAndPointsAreOrientedBoxesAndEllipsoids) {
  int touching = 0, meeting = 0;
  for_cases<fuzz::ShaftOrientedBoxQuestion>(30, [&](ShaftOrientedBoxCase c) {
    for (int rank = 1; rank >= 0; --rank) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (static_cast<int>(i) >= rank) c.t.axes[i] = {0, 0, 0};
      }
      const ShaftEllipsoidCase e{c.a, c.b, {c.t.centre, c.t.axes}};
      const exact::VolumeReference of_box = reference_of(c), of_ellipsoid = reference_of(e);
      EXPECT_EQ(of_box.truth, of_ellipsoid.truth);
      EXPECT_EQ(of_box.touches_outside, of_ellipsoid.touches_outside);
      EXPECT_EQ(of_box.touches_inside, of_ellipsoid.touches_inside);
      touching += of_box.touches_outside;
      meeting += of_box.truth != Category::outside;
    }
  });
  EXPECT_GE(touching, 30);
  EXPECT_GE(meeting, 100);
}

/// Growing an outside polytope on all sides by its gap makes it touch: oriented boxes along the axes are
/// boxes.
TEST(VolumeReference, BoxesAlongTheAxesAreBoxes) {
  const auto generator =
      fuzz::make_generator<scene::ShaftBoxCase>(fuzz::parse_distribution("integer-grid"), scene::Scalar::f64);
  for (std::uint64_t i = 0; i < 300; ++i) {
    fuzz::CaseRandom random(5, 6, i);
    const scene::ShaftBoxCase c = generator->make(random);
    ShaftOrientedBoxCase o{c.a, c.b, {}};
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t j = static_cast<std::size_t>(axis);
      o.t.centre[j] = (c.t.lo(axis) + c.t.hi(axis)) / 2;
      o.t.axes[j][j] = (c.t.hi(axis) - c.t.lo(axis)) / 2;
    }
    exact::ShaftBoxReference box;
    exact::refer(std::span(&c, 1), std::span(&box, 1));
    const exact::VolumeReference r = reference_of(o);
    EXPECT_EQ(r.truth, box.truth);
    EXPECT_EQ(r.planes, box.planes);
    EXPECT_EQ(r.touches_outside, box.touches_outside);
    EXPECT_EQ(r.touches_inside, box.touches_inside);
    EXPECT_EQ(exact::gap(o, exact::Boundary::inside), exact::gap(c, exact::Boundary::inside));
    if (box.truth == Category::outside) {
      EXPECT_EQ(exact::gap(o, exact::Boundary::outside), exact::gap(c, exact::Boundary::outside));
    }
  }
}

TEST(VolumeReference, EmptySlabSets) {
  scene::SlabSet<double> t{{0, 0, 0, 0, -1, -2, -1}, {1, 1, 1, 3, 2, 1, 2}};
  EXPECT_FALSE(exact::is_empty(t));
  t.lo[3] = 3;  // the corner (1, 1, 1) is left
  EXPECT_FALSE(exact::is_empty(t));
  t.lo[3] = t.hi[3] = std::nextafter(3.0, 4.0);
  EXPECT_TRUE(is_valid(t));
  EXPECT_TRUE(exact::is_empty(t));
  int empty = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    fuzz::CaseRandom random(7, 8, i);
    for (std::size_t k = 0; k < 7; ++k) {
      t.lo[k] = random.integer(-3, 3);
      t.hi[k] = t.lo[k] + random.below(9);
    }
    EXPECT_EQ(exact::is_empty(t), vertices_of(t).empty());
    empty += exact::is_empty(t);
  }
  EXPECT_GE(empty, 10);
  EXPECT_LE(empty, 55);
}

}  // namespace
}  // namespace gnomon::tests
