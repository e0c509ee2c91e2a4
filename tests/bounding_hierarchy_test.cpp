// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding hierarchy: exact boxes, balls that hold their points (checked in exact integers), and a tree
// that ends.
#include "scene/bounding_hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace gnomon::scene {
namespace {

using Integer = boost::multiprecision::cpp_int;

/// c * 2^1074, which is an integer for every finite double c.
Integer scaled(double c) {
  int exponent = 0;
  const double fraction =
      std::frexp(c, &exponent);  // c = fraction * 2^exponent, fraction * 2^53 is an integer
  Integer value = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + 1074;
  // A denormal's fraction ends in zeros, so nothing is lost to the right.
  return shift >= 0 ? Integer(value << shift) : Integer(value / (Integer(1) << -shift));
}

template <class F>
Integer square_of_distance(const std::array<F, 3>& a, const std::array<F, 3>& b) {
  Integer sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Integer d = scaled(static_cast<double>(a[axis])) - scaled(static_cast<double>(b[axis]));
    sum += d * d;
  }
  return sum;
}

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers everywhere.
struct Random {
  std::uint64_t state;
  std::uint64_t next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// Uniform in [-1, 1).
  double real() { return static_cast<double>(static_cast<std::int64_t>(next()) >> 11) * 0x1p-52; }
};

void add_face(Mesh& mesh, std::initializer_list<std::array<double, 3>> points) {
  for (const auto& p : points) {
    mesh.corners.push_back(static_cast<std::uint32_t>(mesh.points.size()));
    mesh.points.push_back(p);
  }
  mesh.end_face();
}

/// Small random triangles and quads; `size` scales the whole, of over 2^`octaves` different magnitudes.
Mesh random_mesh(std::uint64_t seed, int faces, double size, int octaves) {
  Random random{seed};
  Mesh mesh;
  for (int f = 0; f < faces; ++f) {
    const double s = std::ldexp(size, -static_cast<int>(random.next() % static_cast<unsigned>(octaves + 1)));
    const auto point = [&] {
      return std::array<double, 3>{s * random.real(), s * random.real(), s * random.real()};
    };
    if (f % 3 == 0) {
      add_face(mesh, {point(), point(), point(), point()});
    } else {
      add_face(mesh, {point(), point(), point()});
    }
  }
  return mesh;
}

/// Everything the header promises of a tree, in exact terms.
template <class F>
void check(const Mesh& mesh, const BoundingHierarchy<F>& tree) {
  ASSERT_EQ(tree.size(), 2 * mesh.face_count() - 1);
  ASSERT_EQ(tree.points().size(), mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(tree.points()[i][axis], static_cast<F>(mesh.points[i][axis]));
    }
  }
  std::vector<int> seen(mesh.face_count());
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const HierarchyNode<F>& node = tree.node(i);
    const auto faces = tree.faces(node);
    ASSERT_GE(faces.size(), 1u);
    ASSERT_TRUE(is_valid(node.box) && is_valid(node.ball));
    ASSERT_EQ(node.is_leaf(), faces.size() == 1);
    ASSERT_EQ(node.parent == HierarchyNode<F>::kNone, i == 0);
    ASSERT_LE(node.depth, std::bit_width(mesh.face_count() - 1));
    if (node.is_leaf()) {
      ++seen[faces[0]];
    } else {
      std::vector<std::uint32_t> below;
      for (const std::uint32_t c : node.children) {
        ASSERT_TRUE(c > i && c < tree.size());
        const HierarchyNode<F>& child = tree.node(c);
        ASSERT_EQ(child.parent, i);
        ASSERT_EQ(child.depth, node.depth + 1);
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_TRUE(node.box.lo(axis) <= child.box.lo(axis) && child.box.hi(axis) <= node.box.hi(axis));
        }
        const auto part = tree.faces(child);
        below.insert(below.end(), part.begin(), part.end());
      }
      ASSERT_TRUE(std::ranges::equal(below, faces));
    }
    Box<F> box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.c[axis] = std::numeric_limits<F>::max();
      box.c[axis + 3] = std::numeric_limits<F>::lowest();
    }
    Integer furthest = 0;
    for (const std::uint32_t f : faces) {
      for (const std::uint32_t corner : mesh.face(f)) {
        const auto& p = tree.points()[corner];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box.c[axis] = std::min(box.c[axis], p[axis]);
          box.c[axis + 3] = std::max(box.c[axis + 3], p[axis]);
        }
        furthest = std::max(furthest, square_of_distance(p, node.ball.centre));
      }
    }
    ASSERT_EQ(node.box, box);
    const Integer radius = scaled(static_cast<double>(node.ball.radius));
    ASSERT_GE(radius * radius, furthest) << "the ball of node " << i << " misses a point";
    // From the other side: the next radius but 20 below must be too small, unless it is none.
    F less = node.ball.radius;
    for (int ulps = 0; ulps < 20 && less > 0; ++ulps) less = std::nextafter(less, F(0));
    const Integer lower = scaled(static_cast<double>(less));
    ASSERT_TRUE(lower * lower < furthest || furthest == 0) << "the ball of node " << i << " is too large";
    ASSERT_TRUE(furthest != 0 || node.ball.radius == 0);
  }
  EXPECT_TRUE(std::ranges::all_of(seen, [](int times) { return times == 1; }));
}

template <class F>
class BoundingHierarchyOf : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BoundingHierarchyOf, Scalars);

TYPED_TEST(BoundingHierarchyOf, HoldsItsPromisesOnRandomMeshesOfMixedMagnitudes) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Mesh mesh = random_mesh(seed, 1 + static_cast<int>(seed * 7), 1.0, seed % 2 == 0 ? 0 : 60);
    check(mesh, BoundingHierarchy<TypeParam>(mesh));
  }
}

TYPED_TEST(BoundingHierarchyOf, HoldsItsPromisesNearOverflowAndInDenormals) {
  const auto most = static_cast<double>(std::numeric_limits<TypeParam>::max());
  const auto least = static_cast<double>(std::numeric_limits<TypeParam>::denorm_min());
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const double size : {most / 2, least * 1e3, least * 3, least * 1e10}) {
      const Mesh mesh = random_mesh(seed, 40, size, 0);
      check(mesh, BoundingHierarchy<TypeParam>(mesh));
    }
  }
}

TYPED_TEST(BoundingHierarchyOf, HasOneNodeForOneFace) {
  Mesh mesh;
  add_face(mesh, {{0, 0, 0}, {2, 0, 0}, {0, 4, -2}});
  const BoundingHierarchy<TypeParam> tree(mesh);
  ASSERT_EQ(tree.size(), 1u);
  EXPECT_EQ(tree.node(0).box, (Box<TypeParam>{{0, 0, -2, 2, 4, 0}}));
  EXPECT_EQ(tree.node(0).ball.centre, (std::array<TypeParam, 3>{1, 2, -1}));
  check(mesh, tree);
}

TYPED_TEST(BoundingHierarchyOf, SplitsAtTheMedianOfTheWidestAxis) {
  Mesh mesh;
  for (const double y : {30.0, 0.0, 20.0, 10.0}) add_face(mesh, {{0, y, 0}, {1, y, 0}, {5, y + 1, y / 4}});
  const BoundingHierarchy<TypeParam> tree(mesh);
  const auto lesser = tree.faces(tree.node(tree.node(0).children[0]));
  EXPECT_EQ(std::vector<std::uint32_t>(lesser.begin(), lesser.end()), (std::vector<std::uint32_t>{1, 3}));
  check(mesh, tree);
}

TYPED_TEST(BoundingHierarchyOf, EndsWhenAllCentresAreEqualAndThenSplitsByFaceNumber) {
  Mesh points;
  Mesh equal;
  for (int f = 0; f < 1000; ++f) {
    add_face(points, {{7, 7, 7}, {7, 7, 7}, {7, 7, 7}});
    add_face(equal, {{-1.0 * f, 0, 0}, {1.0 * f, 0, 0}, {0, 0, 0}});
  }
  check(points, BoundingHierarchy<TypeParam>(points));
  const BoundingHierarchy<TypeParam> tree(equal);
  check(equal, tree);
  EXPECT_TRUE(std::ranges::is_sorted(tree.faces(tree.node(0))));
}

TYPED_TEST(BoundingHierarchyOf, RefusesWhatItCanNotHold) {
  const auto refusal = [](const Mesh& mesh) -> std::string {
    try {
      const BoundingHierarchy<TypeParam> tree(mesh);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(0, 35);
    }
    return "none";
  };
  EXPECT_EQ(refusal(Mesh{}), "expected a valid mesh of at least o");
  Mesh mesh;
  add_face(mesh, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(refusal(mesh), "none");
  mesh.corners[1] = 3;
  EXPECT_EQ(refusal(mesh), "expected a valid mesh of at least o");
  const auto most = static_cast<double>(std::numeric_limits<TypeParam>::max());
  Mesh large;
  add_face(large, {{-most, -most, -most}, {most, most, most}, {0, 1, 0}});
  EXPECT_EQ(refusal(large), "expected a mesh within a ball of fi");
}

TEST(BoundingHierarchy, OfFloatsRefusesDoublesBeyondThem) {
  Mesh mesh;
  add_face(mesh, {{0, 0, 0}, {1, 0, 0}, {0, -4e38, 0}});
  EXPECT_THROW(BoundingHierarchy<float>{mesh}, std::runtime_error);
  check(mesh, BoundingHierarchy<double>(mesh));
}

}  // namespace
}  // namespace gnomon::scene
