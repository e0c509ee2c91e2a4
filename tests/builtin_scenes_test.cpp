// SPDX-License-Identifier: GPL-3.0-or-later
// Built-in scenes: that they are what they say, the same everywhere, and no nonsense.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <ostream>
#include <set>

#include "exact/convexity.h"
#include "scene/builtin.h"
#include "scene/input_error.h"
#include "scene/scene_facts.h"
#include "scene/turn.h"

namespace gnomon::scene {

/// For the names of tests.
static void PrintTo(const BuiltinScene& scene, std::ostream* out) {
  *out << scene.name;
}

namespace {

using Point = std::array<double, 3>;

/// FNV-1a over the bits of all numbers, in order.
class Hash {
 public:
  void add(std::uint64_t bits) {
    for (int k = 0; k < 8; ++k) {
      value_ = (value_ ^ (bits & 255U)) * 0x100000001b3U;
      bits >>= 8U;
    }
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const Point& p) {
    for (const double x : p) add(x);
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

std::uint64_t hash_of(const Scene& scene) {
  Hash hash;
  for (const Point& p : scene.points) hash.add(p);
  for (const auto& corners : scene.triangles) {
    for (const std::uint32_t c : corners) hash.add(std::uint64_t{c});
  }
  for (const Ball<double>& ball : scene.balls) {
    hash.add(ball.centre);
    hash.add(ball.radius);
  }
  for (const PointLight& light : scene.point_lights) hash.add(light.position);
  for (const PolygonLight& light : scene.polygon_lights) {
    for (const Point& p : light.corners) hash.add(p);
  }
  hash.add(scene.view->from);
  hash.add(scene.view->at);
  return hash.value();
}

/// All that must be floats.
std::vector<double> numbers_of(const Scene& scene) {
  std::vector<double> numbers;
  const auto add = [&numbers](const Point& p) { numbers.insert(numbers.end(), p.begin(), p.end()); };
  for (const Point& p : scene.points) add(p);
  for (const Ball<double>& ball : scene.balls) {
    add(ball.centre);
    numbers.push_back(ball.radius);
  }
  for (const PointLight& light : scene.point_lights) add(light.position);
  for (const PolygonLight& light : scene.polygon_lights) {
    for (const Point& p : light.corners) add(p);
  }
  add(scene.view->from);
  add(scene.view->at);
  return numbers;
}

Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
double dot(const Point& p, const Point& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
double determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Six times the signed volume that the object's triangles enclose.
double six_volumes(const Scene& scene, const Object& object) {
  double total = 0;
  const Point& base = scene.corner(object.first_triangle, 0);
  for (std::size_t t = object.first_triangle; t < object.first_triangle + object.triangle_count; ++t) {
    total += determinant(minus(scene.corner(t, 0), base), minus(scene.corner(t, 1), base),
                         minus(scene.corner(t, 2), base));
  }
  return total;
}

/// True when the point is within an object: a ball, or triangles that a ray from it crosses an odd number of
/// times. In doubles; the ray's direction has nothing in common with the scenes'.
bool is_within(const Scene& scene, const Object& object, const Point& point) {
  for (std::size_t b = object.first_ball; b < object.first_ball + object.ball_count; ++b) {
    const Point d = minus(scene.balls[b].centre, point);
    if (dot(d, d) < scene.balls[b].radius * scene.balls[b].radius) return true;
  }
  const Point direction{0.2384791, 0.5419237, 0.8058731};
  bool odd = false;
  for (std::size_t t = object.first_triangle; t < object.first_triangle + object.triangle_count; ++t) {
    const Point a = minus(scene.corner(t, 0), point), b = minus(scene.corner(t, 1), point),
                c = minus(scene.corner(t, 2), point);
    const double u = determinant(direction, a, b), v = determinant(direction, b, c),
                 w = determinant(direction, c, a);
    const bool crosses = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
    const double height = determinant(a, b, c);  // of the sign of u when the triangle is ahead
    if (crosses && (height > 0) == (u > 0)) odd = !odd;
  }
  return odd;
}

struct Extent {
  Point lo{1e9, 1e9, 1e9}, hi{-1e9, -1e9, -1e9};
  friend bool operator==(const Extent&, const Extent&) = default;
};

Extent extent_of(const Scene& scene, const Object& object) {
  Extent extent;
  const auto add = [&extent](const Point& p, double r) {
    for (std::size_t k = 0; k < 3; ++k) {
      extent.lo[k] = std::min(extent.lo[k], p[k] - r);
      extent.hi[k] = std::max(extent.hi[k], p[k] + r);
    }
  };
  for (std::size_t t = object.first_triangle; t < object.first_triangle + object.triangle_count; ++t) {
    for (std::size_t k = 0; k < 3; ++k) add(scene.corner(t, k), 0);
  }
  for (std::size_t b = object.first_ball; b < object.first_ball + object.ball_count; ++b) {
    add(scene.balls[b].centre, scene.balls[b].radius);
  }
  return extent;
}

class BuiltinScenes : public testing::TestWithParam<BuiltinScene> {
 protected:
  /// The default size, the least, and one above the default where that is quick.
  [[nodiscard]] static std::set<std::uint32_t> sizes() {
    const BuiltinScene& row = GetParam();
    std::set<std::uint32_t> sizes{1, row.default_size};
    if (row.faces(row.default_size + 1) < 80'000) sizes.insert(row.default_size + 1);
    return sizes;
  }
};

TEST_P(BuiltinScenes, AreWhatTheySay) {
  const BuiltinScene& row = GetParam();
  for (const std::uint32_t size : sizes()) {
    SCOPED_TRACE(size);
    const Scene scene = row.make(size);
    ASSERT_TRUE(is_valid(scene));
    EXPECT_EQ(scene.face_count(), row.faces(size));
    EXPECT_TRUE(scene.view.has_value());
    EXPECT_FALSE(scene.point_lights.empty());
    const std::vector<double> numbers = numbers_of(scene);
    EXPECT_TRUE(std::ranges::all_of(numbers, [](double x) {
      return x == static_cast<double>(static_cast<float>(x)) && !(x == 0 && std::signbit(x));
    }));
    const SceneFacts facts = facts_of(scene);
    EXPECT_EQ(facts.degenerate, 0u);
    EXPECT_EQ(facts.duplicate, 0u);
    EXPECT_EQ(facts.closed_objects(), scene.objects.size());
    for (const Object& object : scene.objects) {
      EXPECT_TRUE(object.one_sided);
      EXPECT_EQ(object.declared_convex, exact::is_convex(scene, object)) << object.name;
      if (object.triangle_count > 0) {
        EXPECT_GT(six_volumes(scene, object), 0) << object.name;
      }
    }
  }
}

TEST_P(BuiltinScenes, ReachAMillionFaces) {
  EXPECT_GE(GetParam().faces(GetParam().largest_size), 1'000'000u);
  EXPECT_LE(GetParam().faces(GetParam().largest_size), 10'000'000u);
}

TEST_P(BuiltinScenes, HaveLightsAndEyeInTheOpen) {
  const Scene scene = GetParam().make(GetParam().default_size);
  std::vector<Point> open{scene.view->from};
  for (const PointLight& light : scene.point_lights) open.push_back(light.position);
  for (const PolygonLight& light : scene.polygon_lights) {
    open.insert(open.end(), light.corners.begin(), light.corners.end());
  }
  for (const Object& object : scene.objects) {
    for (const Point& point : open) {
      EXPECT_FALSE(is_within(scene, object, point)) << object.name << ": " << point[0] << " " << point[1];
    }
  }
  // The question can be answered yes: the middle of a convex object is within it.
  const auto solid = std::ranges::find_if(scene.objects, [](const Object& object) {
    return object.declared_convex && object.triangle_count > 0;
  });
  ASSERT_NE(solid, scene.objects.end());
  Point middle{};
  for (std::size_t t = solid->first_triangle; t < solid->first_triangle + solid->triangle_count; ++t) {
    for (std::size_t k = 0; k < 9; ++k) {
      middle[k % 3] += scene.corner(t, k / 3)[k % 3] / (3.0 * static_cast<double>(solid->triangle_count));
    }
  }
  EXPECT_TRUE(is_within(scene, *solid, middle));
}

TEST_P(BuiltinScenes, HaveTheSameBitsEverywhere) {
  const std::pair<std::string_view, std::uint64_t> pinned[] = {
      {"office", 0xa3145b0ea38732a4U},      {"office-fine", 0xc237b5d70903e537U},
      {"sphereflake", 0x737c3ae08e9b82e6U}, {"tetra", 0xf3d915c786da3456U},
      {"tree", 0xbc1b37ca1ea2b5bcU},        {"gears", 0x570cd4d545c92b0cU},
      {"chessboard", 0x1f4d0086e1b91672U},  {"cards", 0xc7e42dec6e755d07U},
      {"gazebo", 0x1563f804325c51b6U},      {"living-room", 0xcbb97d227fa8aec3U},
      {"classroom", 0x1e78bea77a89378eU},   {"floor", 0x74e7f879d57f9133U},
      {"temple", 0xb4bf53177f5f370eU},      {"city", 0x47130b5c8dce933dU}};
  const auto* const found =
      std::ranges::find(pinned, GetParam().name, &std::pair<std::string_view, std::uint64_t>::first);
  ASSERT_NE(found, std::end(pinned));
  EXPECT_EQ(hash_of(GetParam().make(GetParam().default_size)), found->second) << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinScenes,
                         testing::ValuesIn(builtin_scenes().begin(), builtin_scenes().end()),
                         [](const testing::TestParamInfo<BuiltinScene>& scene) {
                           std::string name(scene.param.name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(BuiltinOffice, IsTheSameInBothMeshings) {
  const Scene coarse = find_builtin("office")->make(), fine = find_builtin("office-fine")->make();
  EXPECT_GT(fine.face_count(), coarse.face_count());
  EXPECT_EQ(coarse.polygon_lights.size(), 10u);
  EXPECT_EQ(coarse.point_lights.size(), 10u);
  EXPECT_EQ(coarse.polygon_lights, fine.polygon_lights);
  EXPECT_EQ(coarse.point_lights, fine.point_lights);
  EXPECT_EQ(coarse.view, fine.view);
  ASSERT_EQ(coarse.objects.size(), fine.objects.size());
  std::size_t meshed = 0;
  for (std::size_t i = 0; i < coarse.objects.size(); ++i) {
    const Object &a = coarse.objects[i], &b = fine.objects[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(extent_of(coarse, a), extent_of(fine, b));
    if (a.triangle_count != b.triangle_count) {
      // Both are convex, and both are the box of their extent.
      ++meshed;
      const Extent e = extent_of(fine, b);
      const double volume = (e.hi[0] - e.lo[0]) * (e.hi[1] - e.lo[1]) * (e.hi[2] - e.lo[2]);
      EXPECT_NEAR(six_volumes(coarse, a) / 6, volume, 1e-9 * volume);
      EXPECT_NEAR(six_volumes(fine, b) / 6, volume, 1e-9 * volume);
      continue;
    }
    for (std::size_t t = 0; t < 3 * a.triangle_count; ++t) {
      ASSERT_EQ(coarse.corner(a.first_triangle + t / 3, t % 3), fine.corner(b.first_triangle + t / 3, t % 3));
    }
  }
  EXPECT_EQ(meshed, 6u);
}

TEST(BuiltinRooms, HoldTheirFurniture) {
  for (const char* name : {"office", "office-fine", "office:5", "classroom", "classroom:2", "living-room"}) {
    const Scene scene = find_builtin(name)->make();
    // Floor, ceiling, and the walls at the least and greatest x and y.
    const auto slab = [&scene](std::size_t i) { return extent_of(scene, scene.objects[i]); };
    const Point lo{slab(2).hi[0], slab(4).hi[1], slab(0).hi[2]},
        hi{slab(3).lo[0], slab(5).lo[1], slab(1).lo[2]};
    for (std::size_t i = 6; i < scene.objects.size(); ++i) {
      const Extent extent = extent_of(scene, scene.objects[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GE(extent.lo[k], lo[k]) << name << ": " << scene.objects[i].name;
        EXPECT_LE(extent.hi[k], hi[k]) << name << ": " << scene.objects[i].name;
      }
    }
  }
}

TEST(BuiltinGazebo, HasSevenLightsOfEightInACluster) {
  const Scene scene = find_builtin("gazebo")->make();
  ASSERT_EQ(scene.point_lights.size(), 8u);
  for (std::size_t k = 0; k < 7; ++k) {
    const Point d = minus(scene.point_lights[k].position, scene.point_lights[0].position);
    EXPECT_LT(dot(d, d), 0.25);
  }
}

TEST(FindBuiltin, TakesNamesWithAndWithoutASize) {
  for (const BuiltinScene& row : builtin_scenes()) {
    const auto plain = find_builtin(row.name);
    ASSERT_TRUE(plain.has_value());
    EXPECT_EQ(plain->scene, &row);
    EXPECT_EQ(plain->size, row.default_size);
    EXPECT_LE(row.default_size, row.largest_size);
    EXPECT_EQ(find_builtin(std::string(row.name) + ":1")->size, 1u);
    EXPECT_EQ(find_builtin(std::string(row.name) + ":" + std::to_string(row.largest_size))->size,
              row.largest_size);
    EXPECT_NE(builtin_names().find(row.name), std::string_view::npos);
  }
  for (const char* unknown : {"", "offices", "Office", "office ", ":2", "office.nff", "living room"}) {
    EXPECT_FALSE(find_builtin(unknown).has_value()) << unknown;
  }
}

TEST(FindBuiltin, RefusesBadSizesInOneLine) {
  const auto complaint = [](const std::string& word) -> std::string {
    try {
      (void)find_builtin(word);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  };
  for (const std::string size :
       {"", "0", "-1", "21", "1.5", "2x", " 2", "+2", "0x2", "99999999999999999999"}) {
    EXPECT_EQ(complaint("gears:" + size),
              "gears:" + size + ": expected a size from 1 to 20 after \"gears:\", found \"" + size + "\"");
  }
}

TEST(Turn, GoesAroundTheCircle) {
  for (const std::uint64_t steps : {1u, 4u, 8u, 7u, 12u, 360u, 1000u}) {
    for (std::uint64_t step = 0; step < 2 * steps; ++step) {
      const Direction d = turn(step, steps);
      const double angle =
          2 * std::numbers::pi * static_cast<double>(step % steps) / static_cast<double>(steps);
      EXPECT_NEAR(d.cos, std::cos(angle), 2e-15) << step << "/" << steps;
      EXPECT_NEAR(d.sin, std::sin(angle), 2e-15) << step << "/" << steps;
    }
  }
  EXPECT_EQ(turn(1, 4).cos, 0);
  EXPECT_EQ(turn(1, 4).sin, 1);
  EXPECT_EQ(turn(1, 2).cos, -1);
}

}  // namespace
}  // namespace gnomon::scene
