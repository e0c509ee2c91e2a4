// SPDX-License-Identifier: GPL-3.0-or-later
// Exact signs in the plane, and polygons cut into triangles that don't overlap.
#include "scene/triangulate.h"

#include <gtest/gtest.h>

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "scene/exact_sum.h"
#include "scene/orientation.h"

namespace gnomon::scene {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<double, 3>;
using Point2 = std::array<double, 2>;

Rational doubled_area(const Point2& a, const Point2& b, const Point2& c) {
  const Rational ax(a[0]), ay(a[1]);
  return (Rational(b[0]) - ax) * (Rational(c[1]) - ay) - (Rational(b[1]) - ay) * (Rational(c[0]) - ax);
}

Point2 along(std::size_t axis, const Point& p) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// Holds a triangulation against its contract: two triangles fewer than corners; along the axis none turned
/// over, and areas that add up to the polygon's. The areas say that points are covered once, as a simple
/// polygon's winding number is 1 within.
void expect_partition(const std::vector<Point>& polygon, std::size_t axis) {
  const Triangulation result = triangulate(polygon);
  EXPECT_FALSE(result.crossing);
  ASSERT_EQ(result.triangles.size(), polygon.size() - 2);
  Rational area = 0, sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    area += doubled_area(along(axis, polygon[0]), along(axis, polygon[i]), along(axis, polygon[i + 1]));
  for (const auto& [a, b, c] : result.triangles) {
    const Rational part =
        doubled_area(along(axis, polygon[a]), along(axis, polygon[b]), along(axis, polygon[c]));
    EXPECT_GE(part * area.sign(), 0) << a << " " << b << " " << c;
    sum += part;
  }
  EXPECT_NE(area, 0);
  EXPECT_EQ(sum, area);
}

/// A polygon of the plane in each of the three coordinate planes, in both directions, from each corner on.
void expect_partition_everywhere(const std::vector<Point2>& polygon) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t first = 0; first < polygon.size(); ++first) {
      std::vector<Point> turned;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2& p = polygon[(first + i) % polygon.size()];
        Point q{};
        q[(axis + 1) % 3] = p[0];
        q[(axis + 2) % 3] = p[1];
        turned.push_back(q);
      }
      expect_partition(turned, axis);
      expect_partition({turned.rbegin(), turned.rend()}, axis);
    }
  }
}

TEST(Orientation, AgreesWithRationalsOnTheWholeRange) {
  std::mt19937_64 random(1);
  const auto finite = [&random] {
    for (;;) {
      const double value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return value;
    }
  };
  std::size_t flat = 0;
  for (int i = 0; i < 3000; ++i) {
    Point2 a{finite(), finite()}, b{finite(), finite()}, c{finite(), finite()};
    if (i % 3 == 1) {  // nearly on one line: on the middle, which is rounded
      const double scale = std::ldexp(1.0, static_cast<int>(random() % 1900) - 1000);
      const auto unit = [&] { return static_cast<double>(random() >> 12) * 0x1p-52 * scale; };
      a = {unit(), unit()};
      b = {unit(), unit()};
      c = {a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2};
    } else if (i % 3 == 2) {  // on a small grid, of denormals or of ordinary numbers
      const double step = i % 2 == 0 ? std::numeric_limits<double>::denorm_min() : 0.1;
      for (Point2* p : {&a, &b, &c}) {
        *p = {static_cast<double>(random() % 5) * step, static_cast<double>(random() % 5) * step};
      }
    }
    const int exact = doubled_area(a, b, c).sign();
    flat += exact == 0 ? 1 : 0;
    ASSERT_EQ(orientation(a, b, c), exact) << i;
    ASSERT_EQ(orientation(b, c, a), exact) << i;
    ASSERT_EQ(orientation(b, a, c), -exact) << i;
  }
  EXPECT_GT(flat, 200u);
}

TEST(Orientation, IsRightWhereRoundedDeterminantsAreWrong) {
  // Kettner et al., "Classroom examples of robustness problems" (2008): a walk by ulps beside a line.
  std::size_t wrong = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Point2 a{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, b{12, 12}, c{24, 24};
      const double rounded = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      const int exact = doubled_area(a, b, c).sign();
      wrong += (rounded > 0) - (rounded < 0) != exact ? 1 : 0;
      ASSERT_EQ(orientation(a, b, c), exact) << i << " " << j;
      ASSERT_EQ(orientation(c, a, b), exact) << i << " " << j;
    }
  }
  EXPECT_GT(wrong, 100u);
}

TEST(ExactSum, CarriesAndBorrowsThroughManyWords) {
  ExactSum ones, power;
  for (int place = -512; place < 512; place += 32) ones.add(0x1p32 - 1, std::ldexp(1.0, place));
  power.add(0x1p256, 0x1p256);
  EXPECT_TRUE(power.exceeds(ones));  // by the last place alone
  EXPECT_FALSE(ones.exceeds(power));
  ExactSum difference = power;
  difference.subtract(0x1p-256, 0x1p-256);
  EXPECT_FALSE(difference.exceeds(ones));
  EXPECT_FALSE(ones.exceeds(difference));
  ones.add(0x1p-512, 1);
  EXPECT_FALSE(power.exceeds(ones));
  ones.subtract(0x1p512, 1);
  EXPECT_EQ(ones.sign(), 0);
  ones.subtract(0x1p-1074, 0x1p-1074);
  EXPECT_EQ(ones.sign(), -1);
  ones.add(std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
  EXPECT_EQ(ones.sign(), 1);
}

TEST(Orientation, SeesASpaceTriangleThatIsFlatInTwoProjections) {
  EXPECT_FALSE(are_collinear({0, 0, 5}, {1, 0, 5}, {0, 1, 5}));
  EXPECT_FALSE(are_collinear({5, 0, 0}, {5, 1, 0}, {5, 0, 0x1p-1074}));
  EXPECT_FALSE(are_collinear({0, 5, 0}, {1, 5, 0}, {0, 5, 1e308}));
  EXPECT_TRUE(are_collinear({0, 0, 0}, {1, 2, 3}, {-2, -4, -6}));
  EXPECT_TRUE(are_collinear({1, 2, 3}, {1, 2, 3}, {7, 8, 1}));
}

TEST(Triangulate, PartitionsConcavePolygons) {
  expect_partition_everywhere({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});                  // an arrowhead
  expect_partition_everywhere({{0, 0}, {4, 0}, {4, 4}, {3, 1}, {2, 4}, {1, 1}, {0, 4}});  // a comb
  expect_partition_everywhere({{0, 0},
                               {9, 0},
                               {9, 9},
                               {1, 9},
                               {1, 3},
                               {6, 3},
                               {6, 6},
                               {3, 6},
                               {3, 5},
                               {5, 5},
                               {5, 4},
                               {2, 4},
                               {2, 8},
                               {8, 8},
                               {8, 1},
                               {0, 1}});  // a spiral
}

TEST(Triangulate, TakesCornersOnEdgesRepeatedCornersSpikesAndBridgedHoles) {
  expect_partition_everywhere({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}});
  expect_partition_everywhere({{0, 0}, {0, 0}, {3, 0}, {3, 0}, {3, 0}, {0, 3}});
  expect_partition_everywhere({{0, 0}, {2, 0}, {5, 0}, {2, 0}, {2, 2}, {0, 2}});  // a spike outwards
  expect_partition_everywhere({{0, 0}, {4, 0}, {2, 1}, {4, 0}, {4, 4}, {0, 4}});  // a spike inwards
  expect_partition_everywhere(
      {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}});  // a frame
  // Two triangles that share a corner, and a hole that touches the outer polygon at one.
  expect_partition_everywhere({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}});
  expect_partition_everywhere({{0, 0}, {4, 0}, {2, 3}, {3, 1}, {1, 1}, {2, 3}});
  // A hole, bridged from the first corner, whose top touches the outer polygon's: no ear may cut through it.
  expect_partition_everywhere(
      {{0, 0}, {4, 0}, {3, 4}, {2, 6}, {1, 4}, {0, 0}, {1, 1}, {2, 6}, {3, 1}, {1, 1}});
}

TEST(Triangulate, PartitionsAStarOf144Corners) {
  std::vector<Point> star;
  for (int i = 0; i < 144; ++i) {
    const double angle = i * std::numbers::pi / 72, radius = i % 2 == 0 ? 10.0 : 3.0;
    star.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.25 * radius * std::cos(angle)});
  }
  expect_partition(star, 2);
}

TEST(Triangulate, PartitionsRandomStarsOnACoarseGridAndAtTheEndsOfTheRange) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    // Corners by angle around the origin, at most one in a direction: simple, with many on common lines.
    std::vector<Point2> corners;
    for (int i = 0; i < 24; ++i) {
      const double x = static_cast<double>(random() % 9) - 4, y = static_cast<double>(random() % 9) - 4;
      const bool fresh = std::ranges::none_of(
          corners, [&](const Point2& p) { return p[0] * y == p[1] * x && p[0] * x + p[1] * y >= 0; });
      if (fresh && (x != 0 || y != 0)) corners.push_back({x, y});
    }
    std::ranges::sort(corners, {}, [](const Point2& p) { return std::atan2(p[1], p[0]); });
    bool around = corners.size() > 3;  // no gap of half a turn or more, through which edges could cross
    for (std::size_t i = 0; i < corners.size(); ++i)
      around = around && orientation({0, 0}, corners[i], corners[(i + 1) % corners.size()]) > 0;
    if (!around) continue;
    const double scale = trial % 3 == 0 ? 1 : trial % 3 == 1 ? 0x1p1000 : 0x1p-1074;
    std::vector<Point> polygon;
    for (const Point2& p : corners) polygon.push_back({p[0] * scale, p[1] * scale, 0});
    expect_partition(polygon, 2);
  }
}

using Cell = std::array<int, 2>;

int turn(const Cell& a, const Cell& b, const Cell& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool lies_between(const Cell& a, const Cell& b, const Cell& p) {
  return turn(a, b, p) == 0 && (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1]) <= 0;
}

/// True when edges meet in the corners that they share alone: straight from the definition, in integers.
bool is_simple(const std::vector<Cell>& polygon) {
  const std::size_t n = polygon.size();
  const auto at = [&](std::size_t i) -> const Cell& { return polygon[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      if (k != i && k != (i + 1) % n && lies_between(at(i), at(i + 1), at(k))) return false;
      if (k == i || (k + 1) % n == i || (i + 1) % n == k) continue;
      if ((turn(at(i), at(i + 1), at(k)) > 0) != (turn(at(i), at(i + 1), at(k + 1)) > 0) &&
          (turn(at(k), at(k + 1), at(i)) > 0) != (turn(at(k), at(k + 1), at(i + 1)) > 0))
        return false;
    }
  }
  return true;
}

TEST(Triangulate, PartitionsSimplePolygonsOfASmallGrid) {
  std::mt19937_64 random(11);
  std::size_t simple = 0, concave = 0;
  for (int trial = 0; trial < 400'000; ++trial) {
    std::vector<Cell> cells(4 + random() % 5);
    for (Cell& cell : cells) cell = {static_cast<int>(random() % 4), static_cast<int>(random() % 4)};
    if (!is_simple(cells)) continue;
    ++simple;
    std::vector<Point> polygon;
    bool left = false, right = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const int here = turn(cells[i], cells[(i + 1) % cells.size()], cells[(i + 2) % cells.size()]);
      left |= here > 0;
      right |= here < 0;
      polygon.push_back({static_cast<double>(cells[i][0]), static_cast<double>(cells[i][1]), 0});
    }
    concave += left && right ? 1 : 0;
    expect_partition(polygon, 2);
  }
  EXPECT_GT(simple, 5'000u);
  EXPECT_GT(concave, 3'000u);
}

TEST(Triangulate, ChoosesTheDominantAxisExactlyAndTheFirstOfEqualOnes) {
  // In the plane x + y + z = 0 all three projections have one area; seen along x it must be a partition.
  expect_partition({{0, 0, 0}, {1, -1, 0}, {1, 0, -1}, {0, 1, -1}}, 0);
  // Equal areas along x and y, where the two projections need different diagonals.
  expect_partition({{3, 1, 3}, {3, 4, 4}, {0, 4, 1}, {4, 3, 3}}, 0);
  // An ulp more along z than along x: the polygon is not flat, and along x it would cross itself.
  const double more = std::nextafter(1.0, 2.0);
  expect_partition({{0, 0, 0}, {more, 0, 0}, {more, 1, 1}, {0, 1, 1}}, 2);
  expect_partition({{0, 0, 0}, {1, 0, 1}, {1, more, 1}, {0, more, 0}}, 0);
}

TEST(Triangulate, SaysWhenAPolygonCrossesItself) {
  const std::vector<Point> crossing[] = {
      {{0, 3, 0},
       {2, -3, 0},
       {-3, 1, 0},
       {3, 1, 0},
       {-2, -3, 0}},  // a star in one stroke: all turns are left
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},  // twice
                                                                                                 // around
      {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}},                                              // no area
      {{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 2, 0}},
      {{0, 0, 0}, {8, 0, 0}, {8, 4, 0}, {6, -2, 0}, {4, 4, 0}, {2, -2, 0}, {0, 4, 0}},
  };
  for (const std::vector<Point>& polygon : crossing) {
    const Triangulation result = triangulate(polygon);
    EXPECT_TRUE(result.crossing) << polygon.size() << " " << polygon[0][1];
    EXPECT_EQ(result.triangles.size(), polygon.size() - 2);
  }
}

TEST(Triangulate, MakesDegenerateTrianglesOfPolygonsWithoutAnArea) {
  for (const std::vector<Point>& polygon :
       {std::vector<Point>(5, Point{1, 2, 3}), {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}, {1, 1, 1}}}) {
    const Triangulation result = triangulate(polygon);
    EXPECT_FALSE(result.crossing);
    EXPECT_EQ(result.triangles.size(), 3u);
  }
}

TEST(Triangulate, TakesLargeConvexAndConcavePolygonsInTime) {
  std::vector<Point> circle, comb;
  for (int i = 0; i < 50'000; ++i)
    circle.push_back({std::cos(i * std::numbers::pi / 25'000), std::sin(i * std::numbers::pi / 25'000), 0});
  EXPECT_EQ(triangulate(circle).triangles.size(), circle.size() - 2);
  for (int i = 0; i < 2'000; ++i) comb.push_back({2'000.0 - i, i % 2 == 0 ? 9.0 : 1.0, 0});
  comb.push_back({0, 0, 0});
  comb.push_back({2'000, 0, 0});
  const Triangulation cut = triangulate(comb);
  EXPECT_FALSE(cut.crossing);
  EXPECT_EQ(cut.triangles.size(), comb.size() - 2);
}

}  // namespace
}  // namespace gnomon::scene
