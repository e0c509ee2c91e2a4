// SPDX-License-Identifier: GPL-3.0-or-later
// The formation of the shaft: lists, extent box, plane set.
#include "fast/shaft.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "fast/certified_shaft.h"
#include "tests/shaft_generator.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using fast::Normals;
using fast::Shaft;
using fast::ShaftPlane;
using scene::Box;

/// The paper's Figure 1, with a z that both boxes share: the emitter is b, the receiver a.
TEST(FastShaft, ListsAndPlanesOfFigure1) {
  const Box<float> receiver{{0, 0, 0, 10, 2, 1}}, emitter{{4, 5, 0, 7, 8, 1}};
  const fast::ExtremeLists lists = fast::extreme_lists(receiver, emitter);
  ASSERT_EQ(lists.count_a, 3);
  EXPECT_EQ(lists.of_a[0], 0);  // MIN_X
  EXPECT_EQ(lists.of_a[1], 1);  // MIN_Y
  EXPECT_EQ(lists.of_a[2], 3);  // MAX_X
  ASSERT_EQ(lists.count_b, 1);
  EXPECT_EQ(lists.of_b[0], 4);  // MAX_Y; equal z on neither list

  const Shaft<float> shaft = fast::form_shaft(receiver, emitter, Normals::as_formed);
  EXPECT_EQ(shaft.extent, (Box<float>{{0, 0, 0, 10, 8, 1}}));
  ASSERT_EQ(shaft.plane_count, 2);  // MAX_Y--MIN_Y matches in direction and is left out
  const ShaftPlane<float>& plane = shaft.plane_set[0];
  // X = Receiver.hi.y - Emitter.hi.y, Y = Emitter.lo.x - Receiver.lo.x up to the sign that turns it outwards.
  EXPECT_EQ(plane.n0, 2.0f - 8.0f);
  EXPECT_EQ(plane.n1, 4.0f - 0.0f);
  EXPECT_EQ(plane.d, -8.0f);
  EXPECT_EQ(plane.outside_threshold, 0.0f);
  EXPECT_EQ(plane.inside_threshold, 0.0f);
}

/// Everything that the paper says about one shaft of small integers, where floats are exact.
void check_formation(const Box<float>& a, const Box<float>& b) {
  const Shaft<float> shaft = fast::form_shaft(a, b, Normals::as_formed);
  const fast::ExtremeLists lists = fast::extreme_lists(a, b);
  bool tie = false, a_in_b = true, b_in_a = true;
  for (int face = 0; face < 6; ++face) {
    const std::size_t i = static_cast<std::size_t>(face);
    const bool max = face >= 3;
    EXPECT_EQ(shaft.extent.c[i], max ? std::max(a.c[i], b.c[i]) : std::min(a.c[i], b.c[i]));
    tie |= a.c[i] == b.c[i];
    a_in_b &= max ? a.c[i] <= b.c[i] : a.c[i] >= b.c[i];
    b_in_a &= max ? b.c[i] <= a.c[i] : b.c[i] >= a.c[i];
  }
  EXPECT_EQ(shaft.a, a);
  EXPECT_EQ(shaft.b, b);

  // One plane for each pair of entries of different directions.
  std::set<std::pair<int, int>> pairs, formed;
  int on_lists = 0;
  for (int i = 0; i < lists.count_a; ++i) {
    for (int j = 0; j < lists.count_b; ++j) {
      const int f = lists.of_a[static_cast<std::size_t>(i)], g = lists.of_b[static_cast<std::size_t>(j)];
      if (f % 3 != g % 3) pairs.insert({f, g});
    }
  }
  for (std::size_t face = 0; face < 6; ++face) on_lists += a.c[face] != b.c[face];
  EXPECT_EQ(lists.count_a + lists.count_b, on_lists);
  for (const ShaftPlane<float>& plane : shaft.planes()) formed.insert({plane.far0, plane.far1});
  EXPECT_EQ(formed, pairs);
  EXPECT_EQ(formed.size(), shaft.plane_count);

  EXPECT_LE(shaft.plane_count, 8);
  EXPECT_NE(shaft.plane_count, 7);
  if (!tie) {
    EXPECT_TRUE(shaft.plane_count % 2 == 0 && shaft.plane_count != 2);
  }
  if (a_in_b || b_in_a) {
    EXPECT_EQ(shaft.plane_count, 0);
  }
  for (const ShaftPlane<float>& plane : shaft.planes()) {
    // The far corner is by the sign of the normal, near = (far + 3) mod 6 (claim S5).
    EXPECT_EQ(fast::is_max(plane.far0), plane.n0 > 0);
    EXPECT_EQ(fast::is_max(plane.far1), plane.n1 > 0);
    EXPECT_NE(plane.n0, 0);
    EXPECT_NE(plane.n1, 0);
    EXPECT_EQ(fast::opposite(plane.far0), (plane.far0 + 3) % 6);
    EXPECT_NE(fast::axis_of(plane.far0), fast::axis_of(plane.far1));
    // Both edges lie in the plane, and as they are the boxes' farthest, both boxes lie behind it.
    EXPECT_EQ(plane.far_value(a), 0);
    EXPECT_EQ(plane.far_value(b), 0);
    // It cuts its edge off the extent box: the edge lies strictly beyond.
    EXPECT_GT(plane.far_value(shaft.extent), 0);
    for (const Box<float>* box : {&a, &b, &shaft.extent}) {
      float least = std::numeric_limits<float>::max(), largest = std::numeric_limits<float>::lowest();
      for (int corner = 0; corner < 8; ++corner) {
        const std::array<float, 3> p{box->c[corner & 1 ? 3 : 0], box->c[corner & 2 ? 4 : 1],
                                     box->c[corner & 4 ? 5 : 2]};
        least = std::min(least, plane.value_at(p));
        largest = std::max(largest, plane.value_at(p));
      }
      EXPECT_EQ(plane.near_value(*box), least);
      EXPECT_EQ(plane.far_value(*box), largest);
    }
  }
}

/// All pairs of boxes with corners in {0, 1, 2, 3}^3: they hold every order and every tie of the coordinates.
TEST(FastShaft, EveryPairOfSmallBoxes) {
  std::vector<std::array<float, 2>> intervals;
  for (int lo = 0; lo < 4; ++lo) {
    for (int hi = lo; hi < 4; ++hi) intervals.push_back({float(lo), float(hi)});
  }
  const int n = static_cast<int>(intervals.size());
  const int per_axis = n * n, all = per_axis * per_axis * per_axis;
  std::array<int, 9> counts{};
  for (int i = 0; i < all && !HasFailure(); i += kSanitized ? 7 : 1) {
    Box<float> a, b;
    int rest = i;
    for (int axis = 0; axis < 3; ++axis, rest /= per_axis) {
      const auto& of_a = intervals[static_cast<std::size_t>(rest % n)];
      const auto& of_b = intervals[static_cast<std::size_t>(rest / n % n)];
      a.lo(axis) = of_a[0];
      a.hi(axis) = of_a[1];
      b.lo(axis) = of_b[0];
      b.hi(axis) = of_b[1];
    }
    check_formation(a, b);
    ++counts[fast::form_shaft(a, b, Normals::as_formed).plane_count];
  }
  for (int planes = 0; planes <= 8; ++planes) {
    RecordProperty("planes_" + std::to_string(planes), counts[static_cast<std::size_t>(planes)]);
    EXPECT_EQ(counts[static_cast<std::size_t>(planes)] > 0, planes != 7) << planes;
  }
}

TEST(FastShaft, NoPlanesWhenNestedOrSideBySide) {
  const Box<double> a{{0, 0, 0, 9, 9, 9}};
  EXPECT_EQ(fast::form_shaft(a, {{1, 2, 3, 4, 5, 6}}, Normals::as_formed).plane_count, 0);
  EXPECT_EQ(fast::form_shaft(a, a, Normals::as_formed).plane_count, 0);
  EXPECT_EQ(fast::form_shaft(a, {{20, 0, 0, 29, 9, 9}}, Normals::as_formed).plane_count, 0);
  EXPECT_EQ(fast::form_shaft(a, {{20, 1, 0, 29, 8, 9}}, Normals::as_formed).plane_count, 2);
}

TEST(FastShaft, UnitNormalsHaveLengthOneAndTheSamePlane) {
  CaseGenerator<double> generator(31, {Numbers::unit, Numbers::grid, Numbers::offset});
  int planes = 0;
  for (int i = 0; i < affordable(5000); ++i) {
    Box<double> a, b;
    generator.boxes(a, b);
    const Shaft<double> formed = fast::form_shaft(a, b, Normals::as_formed);
    const Shaft<double> unit = fast::form_shaft(a, b, Normals::unit);
    ASSERT_EQ(formed.plane_count, unit.plane_count);
    for (std::size_t k = 0; k < unit.plane_count; ++k, ++planes) {
      const ShaftPlane<double>&u = unit.plane_set[k], &f = formed.plane_set[k];
      const double length = std::hypot(f.n0, f.n1);
      EXPECT_NEAR(std::hypot(u.n0, u.n1), 1, 1e-15) << text_of(a) << text_of(b);
      EXPECT_NEAR(u.n0, f.n0 / length, 1e-15);
      EXPECT_NEAR(u.n1, f.n1 / length, 1e-15);
      EXPECT_NEAR(u.d, f.d / length, 1e-15 * (1 + std::fabs(u.d)));
    }
  }
  EXPECT_GT(planes, affordable(5000));
}

/// The order ((n0 x) + (n1 y)) + d is what the error bounds are proved for: a value that shows it.
TEST(FastShaft, ValueIsEvaluatedInThePapersOrder) {
  ShaftPlane<float> plane{};
  plane.n0 = plane.n1 = 1;
  plane.d = -0x1p24f;
  EXPECT_EQ(plane.value(0x1p24f, 1), 0);  // any other order answers 1
  EXPECT_EQ(plane.value(1, 0x1p24f), 0);
}

TEST(FastShaft, RoundingConstants) {
  EXPECT_EQ(fast::Rounding<float>::u, 0x1p-24f);
  EXPECT_EQ(fast::Rounding<double>::u, 0x1p-53);
  EXPECT_EQ(fast::Rounding<float>::two_eta, 0x1p-149f);
  EXPECT_EQ(fast::Rounding<double>::two_eta, 0x1p-1074);
}

template <class F>
void expect_same_but_for_thresholds(const Shaft<F>& certified, const Shaft<F>& naive,
                                    const std::string& text) {
  ASSERT_EQ(certified.plane_count, naive.plane_count) << text;
  EXPECT_EQ(certified.extent, naive.extent) << text;
  EXPECT_EQ(certified.a, naive.a) << text;
  EXPECT_EQ(certified.b, naive.b) << text;
  for (std::size_t k = 0; k < naive.plane_count; ++k) {
    EXPECT_EQ(certified.plane_set[k].far0, naive.plane_set[k].far0) << text;
    EXPECT_EQ(certified.plane_set[k].far1, naive.plane_set[k].far1) << text;
    EXPECT_EQ(naive.plane_set[k].outside_threshold, 0) << text;
    EXPECT_EQ(naive.plane_set[k].inside_threshold, 0) << text;
    EXPECT_GT(certified.plane_set[k].outside_threshold, 0) << text;
    EXPECT_FALSE(certified.plane_set[k].inside_threshold >= 0) << text;  // negative, or NaN: never
  }
}

/// Certified shafts are naive ones with other thresholds; for balls with other, shorter normals too.
TEST(FastShaft, CertifiedShaftsDifferInDataAlone) {
  CaseGenerator<float> generator(32, {Numbers::unit, Numbers::grid, Numbers::mixed, Numbers::huge});
  for (int i = 0; i < affordable(20000) && !HasFailure(); ++i) {
    Box<float> a, b;
    generator.boxes(a, b);
    const Shaft<float> naive = fast::form_shaft(a, b, Normals::as_formed);
    const Shaft<float> boxes = fast::form_certified_box_shaft(a, b);
    const Shaft<float> balls = fast::form_certified_ball_shaft(a, b);
    const std::string text = text_of(a) + text_of(b);
    expect_same_but_for_thresholds(boxes, naive, text);
    expect_same_but_for_thresholds(balls, naive, text);
    for (std::size_t k = 0; k < naive.plane_count; ++k) {
      const auto same = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
      EXPECT_TRUE(same(boxes.plane_set[k].n0, naive.plane_set[k].n0)) << text;
      EXPECT_TRUE(same(boxes.plane_set[k].n1, naive.plane_set[k].n1)) << text;
      EXPECT_TRUE(same(boxes.plane_set[k].d, naive.plane_set[k].d)) << text;
    }
    EXPECT_EQ(boxes.slack.square_factor, 1);
    EXPECT_EQ(boxes.slack.inside_factor, 1);
  }
}

}  // namespace
}  // namespace gnomon::tests
