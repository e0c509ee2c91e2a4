// SPDX-License-Identifier: GPL-3.0-or-later
// exact::is_convex against the definition, on bodies, nearly bodies, and what only looks like one.
#include "exact/convexity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <random>

#include "scene/scene_builder.h"
#include "tests/convexity_reference.h"

namespace gnomon::tests {
namespace {

using Point = std::array<double, 3>;
using Faces = std::vector<std::array<Point, 3>>;

scene::Scene scene_of(const Faces& faces) {
  scene::SceneBuilder builder;
  for (const auto& [a, b, c] : faces) builder.add_triangle(a, b, c);
  return builder.finish();
}

/// What both say; they must say the same.
bool convex(const Faces& faces) {
  const scene::Scene scene = scene_of(faces);
  const bool answer = exact::is_convex(scene, scene.objects.front());
  EXPECT_EQ(answer, is_convex_by_definition(scene, scene.objects.front()));
  return answer;
}

/// A polygon as a fan around its first corner.
void add_fan(Faces& faces, const std::vector<Point>& polygon) {
  for (std::size_t k = 2; k < polygon.size(); ++k) faces.push_back({polygon[0], polygon[k - 1], polygon[k]});
}

using Point2 = std::array<double, 2>;

/// The prism on lines in the plane z = 0, each counterclockwise from above, whose caps are fans around
/// points.
Faces prism_on(const std::vector<std::array<Point2, 2>>& lines, const Point2& middle) {
  Faces faces;
  for (const auto& [p, q] : lines) {
    const Point a{p[0], p[1], 0}, b{q[0], q[1], 0}, c{q[0], q[1], 1}, d{p[0], p[1], 1};
    add_fan(faces, {a, b, c, d});
    faces.push_back({Point{middle[0], middle[1], 1}, d, c});
    faces.push_back({Point{middle[0], middle[1], 0}, b, a});
  }
  return faces;
}

Faces prism(const std::vector<Point2>& outline, const Point2& middle) {
  std::vector<std::array<Point2, 2>> lines;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    lines.push_back({outline[i], outline[(i + 1) % outline.size()]});
  }
  return prism_on(lines, middle);
}

/// All coordinates times factors: for numbers whose products no double holds.
Faces scaled(Faces faces, const Point& factors) {
  for (auto& face : faces) {
    for (Point& p : face) {
      for (std::size_t k = 0; k < 3; ++k) p[k] *= factors[k];
    }
  }
  return faces;
}

Faces box(const Point& lo, const Point& hi) {
  Faces faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool upper : {false, true}) {
      std::vector<Point> polygon;
      for (const auto& [du, dv] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
        Point p;
        p[axis] = upper ? hi[axis] : lo[axis];
        p[u] = du != 0 ? hi[u] : lo[u];
        p[v] = dv != 0 ? hi[v] : lo[v];
        polygon.push_back(p);
      }
      if (!upper) std::ranges::reverse(polygon);
      add_fan(faces, polygon);
    }
  }
  return faces;
}

Faces turned_over(Faces faces) {
  for (auto& face : faces) std::swap(face[1], face[2]);
  return faces;
}

Faces joined(Faces a, const Faces& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::vector<Point2> kPentagon{{4, 0}, {1, 4}, {-3, 2}, {-3, -2}, {1, -4}};

TEST(Convexity, KnowsBodies) {
  EXPECT_TRUE(convex(box({0, 0, 0}, {1, 2, 3})));
  EXPECT_TRUE(convex(prism(kPentagon, {0, 0})));
  EXPECT_TRUE(convex({{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
                      {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}},
                      {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                      {{{0, 1, 0}, {0, 0, 0}, {0, 0, 1}}}}));
}

TEST(Convexity, KnowsObjectsOfOneFaceAndOfBalls) {
  EXPECT_TRUE(convex({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}));
  EXPECT_TRUE(convex({{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}}));
  scene::SceneBuilder builder;
  builder.begin_object("one", 0, false);
  builder.add_ball({{0, 0, 0}, 1});
  builder.begin_object("two", 0, false);
  builder.add_ball({{0, 0, 0}, 1});
  builder.add_ball({{0, 0, 0}, 1});
  builder.begin_object("mixed", 0, false);
  for (const auto& [a, b, c] : box({0, 0, 0}, {1, 1, 1})) builder.add_triangle(a, b, c);
  builder.add_ball({{0.5, 0.5, 0.5}, 0.125});
  builder.begin_object("point", 0, false);
  builder.add_ball({{0, 0, 0}, 0});
  const scene::Scene scene = builder.finish();
  std::vector<bool> said;
  for (const scene::Object& object : scene.objects) said.push_back(exact::is_convex(scene, object));
  EXPECT_EQ(said, (std::vector<bool>{true, false, false, true}));
}

TEST(Convexity, RefusesWhatIsFlatOpenDegenerateOrTurnedOver) {
  const Faces cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(convex(turned_over(cube)));
  Faces open = cube;
  open.pop_back();
  EXPECT_FALSE(convex(open));
  Faces one_turned = cube;
  std::swap(one_turned[5][0], one_turned[5][1]);
  EXPECT_FALSE(convex(one_turned));
  EXPECT_FALSE(convex(joined(cube, cube)));
  Faces flat;
  add_fan(flat, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  EXPECT_FALSE(convex(flat));
  EXPECT_FALSE(convex(joined(flat, turned_over(flat))));
  // A flat triangle fills a side from (0,0,0) to (2,0,0) whose middle a neighbour uses: as a set, a body.
  const Point a{0, 0, 0}, m{1, 0, 0}, b{2, 0, 0}, c{0, 2, 0}, d{0, 0, 2};
  const Faces filled{{{a, b, d}}, {{b, c, d}}, {{c, a, d}}, {{c, m, a}}, {{c, b, m}}, {{a, m, b}}};
  EXPECT_FALSE(convex(filled));
  // The same corners without it: closed only as a set.
  EXPECT_FALSE(convex(Faces(filled.begin(), filled.end() - 1)));
  // With it split in truth.
  EXPECT_TRUE(convex({{{a, m, d}}, {{m, b, d}}, {{b, c, d}}, {{c, a, d}}, {{c, m, a}}, {{c, b, m}}}));
}

TEST(Convexity, RefusesSeveralBodies) {
  const Faces cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(convex(joined(cube, box({2, 0, 0}, {3, 1, 1}))));
  EXPECT_FALSE(convex(joined(cube, box({-1, -1, -1}, {2, 2, 2}))));
  EXPECT_FALSE(convex(joined(cube, box({1, 1, 1}, {2, 2, 2}))));  // they share a corner
  EXPECT_FALSE(convex(joined(cube, box({1, 1, 0}, {2, 2, 1}))));  // and an edge
  EXPECT_FALSE(convex(joined(cube, box({1, 0, 0}, {2, 1, 1}))));  // and a side
}

/// Whichever face comes first, on which the ray and its origin depend.
void expect_refused_from_every_face(Faces faces) {
  for (std::size_t k = 0; k < 2 * faces.size(); ++k) {
    std::rotate(faces.begin(), faces.begin() + 1, faces.end());
    if (k == faces.size()) std::ranges::reverse(faces);
    EXPECT_FALSE(convex(faces)) << k;
  }
}

TEST(Convexity, RefusesPentagramsThatWindTwice) {
  std::vector<Point2> star;
  for (std::size_t k = 0; k < 5; ++k) star.push_back(kPentagon[2 * k % 5]);
  // Every edge is convex and every triangle faces outward: only the count along a ray tells.
  expect_refused_from_every_face(prism(star, {0, 0}));
  Faces pyramid;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto &p = star[i], &q = star[(i + 1) % 5];
    pyramid.push_back({Point{p[0], p[1], 0}, Point{q[0], q[1], 0}, Point{0, 0, 1}});
    pyramid.push_back({Point{q[0], q[1], 0}, Point{p[0], p[1], 0}, Point{0, 0, -1}});
  }
  expect_refused_from_every_face(pyramid);
}

TEST(Convexity, CountsTouchingAlongTheRay) {
  // A loop within a loop, as of a snail's shell. From the mean of (3, 3, 0), (-3, 3, 0), (-3, 3, 1) and
  // (-1, 1, 1) the ray through the first three meets the outer loop on the edge at (-1, 3.5) exactly.
  const std::vector<Point2> snail{{3, 3},    {-3, 3},    {-3, -2},   {10, -10}, {10, 3.5},
                                  {-1, 3.5}, {-10, 3.5}, {-10, -10}, {3, -4}};
  const Faces faces = prism(snail, {-1, 1});
  EXPECT_FALSE(convex(faces));
  // Sheared, so that no coordinate is 0 along the ray, and with products that no double holds.
  Faces sheared = faces;
  for (auto& face : sheared) {
    for (Point& p : face) p[0] += p[1];
  }
  EXPECT_FALSE(convex(scaled(sheared, {0x1.23456789abcp+0, 0x1.fedcba98765p+0, 0x1.3579bdf0246p+0})));
  expect_refused_from_every_face(faces);
}

TEST(Convexity, RefusesFolds) {
  // Along the upper right the boundary runs to (2, 6), back to (2, 3), and on: three times over, and each
  // part faces outward.
  const std::vector<std::array<Point2, 2>> lines{
      {{{-4, 2}, {-4, -4}}}, {{{-4, -4}, {4, -4}}}, {{{4, -4}, {4, 2}}}, {{{4, 2}, {2, 6}}},
      {{{2, 3}, {2, 6}}},    {{{2, 3}, {-1, 3}}},   {{{-1, 3}, {-4, 2}}}};
  expect_refused_from_every_face(prism_on(lines, {0, 0}));
}

TEST(Convexity, KnowsFlatTrianglesWhoseProductsAreRounded) {
  const Point a{0, 0, 0}, m{0.1, 0.3, 0.7}, b{0.2, 0.6, 1.4}, c{1, 0, 0}, d{0, 1, 0};
  const Faces filled{{{a, d, b}}, {{d, c, b}}, {{d, a, c}}, {{c, a, m}}, {{c, m, b}}, {{a, b, m}}};
  EXPECT_FALSE(convex(filled));
  EXPECT_FALSE(convex(turned_over(filled)));
  const Faces split{{{a, d, m}}, {{m, d, b}}, {{d, c, b}}, {{d, a, c}}, {{c, a, m}}, {{c, m, b}}};
  EXPECT_NE(convex(split), convex(turned_over(split)));
}

TEST(Convexity, SeesADentOfOneUlp) {
  // A box whose top has a point in the middle, on it, above it or below it.
  const auto dented = [](double height, double scale) {
    Faces faces = box({0, 0, 0}, {scale, scale, scale});
    std::erase_if(faces, [scale](const std::array<Point, 3>& face) {
      return std::ranges::all_of(face, [scale](const Point& p) { return p[2] == scale; });
    });
    const Point m{scale / 2, scale / 2, height};
    const std::array<Point, 4> top{
        {{0, 0, scale}, {scale, 0, scale}, {scale, scale, scale}, {0, scale, scale}}};
    for (std::size_t k = 0; k < 4; ++k) faces.push_back({top[k], top[(k + 1) % 4], m});
    return faces;
  };
  for (const double scale : {1.0, 0x1p-1000, 0x1p-1060, 0x1p-1073, 0x1p1000, 0x1p1023}) {
    EXPECT_TRUE(convex(dented(scale, scale))) << scale;
    EXPECT_TRUE(convex(dented(std::nextafter(scale, INFINITY), scale))) << scale;
    EXPECT_FALSE(convex(dented(std::nextafter(scale, 0), scale))) << scale;
  }
}

TEST(Convexity, RestoresTheRoundingMode) {
  const scene::Scene scene = scene_of(box({0, 0, 0}, {1, 1, 1}));
  (void)exact::is_convex(scene, scene.objects.front());
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

/// The hull of random points by brute force: each three points with all others strictly on one side.
Faces hull_of(const std::vector<Point>& points) {
  const auto rational = [](const Point& p) { return RationalPoint{p[0], p[1], p[2]}; };
  Faces faces;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) {
        if (i >= j || i >= k || j == k) continue;
        bool outer = true;
        for (std::size_t l = 0; l < n && outer; ++l) {
          if (l == i || l == j || l == k) continue;
          outer = six_volumes(rational(points[i]), rational(points[j]), rational(points[k]),
                              rational(points[l])) > 0;
        }
        if (outer) faces.push_back({points[i], points[j], points[k]});
      }
    }
  }
  return faces;
}

TEST(Convexity, AgreesWithTheDefinitionOnHullsAndTheirPerturbations) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int convex_ones = 0, others = 0;
  for (int trial = 0; trial < 150; ++trial) {
    std::vector<Point> points(4 + static_cast<std::size_t>(trial % 6));
    for (Point& p : points) {
      for (double& x : p) x = trial % 3 == 0 ? std::floor(4 * uniform(random)) : uniform(random);
    }
    Faces faces = hull_of(points);
    if (faces.size() < 4) continue;  // points of a plane
    ++(convex(faces) ? convex_ones : others);
    for (int change = 0; change < 4; ++change) {
      // One corner goes to another place, or by an ulp, everywhere it occurs; or a face is lost or turned.
      Faces changed = faces;
      const auto any = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
      const Point from = changed[any(changed.size())][any(3)];
      Point to = from;
      const std::size_t axis = any(3);
      if (change == 0) to[axis] += 0.25 * uniform(random);
      if (change == 1) to[axis] = std::nextafter(to[axis], 2);
      if (change == 2) to[axis] = -to[axis];
      for (auto& face : changed) std::ranges::replace(face, from, to);
      if (change == 3) std::swap(changed[0][0], changed[0][1]);
      ++(convex(changed) ? convex_ones : others);
    }
  }
  EXPECT_GT(convex_ones, 150);
  EXPECT_GT(others, 150);
}

TEST(Convexity, AgreesWithTheDefinitionNearCoplanarNeighbours) {
  // A square pyramid frustum of lattice points, each corner moved by at most an ulp.
  std::mt19937_64 random(11);
  int convex_ones = 0, others = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Faces faces = box({0.25, 0.25, 0.25}, {0.75, 1.25, 1.75});
    for (int moved = 0; moved < 2; ++moved) {
      const Point from = faces[random() % faces.size()][random() % 3];
      Point to = from;
      double& x = to[random() % 3];
      x = std::nextafter(x, random() % 2 == 0 ? 0.0 : 2.0);
      for (auto& face : faces) std::ranges::replace(face, from, to);
    }
    ++(convex(faces) ? convex_ones : others);
  }
  EXPECT_GT(convex_ones, 30);
  EXPECT_GT(others, 30);
}

}  // namespace
}  // namespace gnomon::tests
