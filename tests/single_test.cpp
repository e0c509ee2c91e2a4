// SPDX-License-Identifier: MIT
// Scenes rounded to floats.
#include "scene/single.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/scalar.h"
#include "scene/scene_builder.h"
#include "tests/scene_checks.h"

namespace gnomon::scene {
namespace {

Scene one_triangle(const std::array<double, 3>& a, const std::array<double, 3>& b,
                   const std::array<double, 3>& c) {
  SceneBuilder builder;
  builder.add_triangle(a, b, c);
  return builder.finish();
}

TEST(SingleScene, LeavesFloatsAsTheyAre) {
  Scene scene = one_triangle({0, -0.0, 1}, {0x1p-149, 0, 0}, {1, 0x1.fffffep127, 0});
  scene.balls.push_back({{1, 2, 3}, 0.5});
  scene.objects[0].ball_count = 1;
  scene.objects[0].declared_convex = scene.objects[0].one_sided = true;
  scene.objects[0].transmittance = 0.1;  // no coordinate
  scene.point_lights.push_back({{1, 2, 3}});
  scene.polygon_lights.push_back({{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}});
  scene.view = View{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, 45, 1, 8, 8};
  const SingleScene single = rounded_to_floats(scene);
  EXPECT_EQ(single.scene, scene);
  EXPECT_EQ(single.moved, 0u);
  EXPECT_EQ(single.merged, 0u);
}

TEST(SingleScene, RoundsToNearestAndMergesWhatBecomesEqual) {
  const double near_one = 1 + 0x1p-30, tie = 1 + 0x1p-24;  // a tie goes to the even float, 1
  Scene scene = one_triangle({near_one, 0, 0}, {tie, 0, 0}, {1, 0.1, 0});
  scene.balls.push_back({{0.1, 0, 0}, 0.25});
  scene.objects[0].ball_count = 1;
  scene.point_lights.push_back({{0.1, 0, 0}});
  scene.polygon_lights.push_back({{{0, 0, 0.1}, {1, 0, 1}, {0, 1, 0.1}}});
  const SingleScene single = rounded_to_floats(scene);
  EXPECT_EQ(single.moved, 3u + 1 + 1 + 2);
  EXPECT_EQ(single.merged, 1u);
  ASSERT_EQ(single.scene.triangles.size(), 1u);
  EXPECT_EQ(single.scene.triangles[0], (std::array<std::uint32_t, 3>{0, 0, 1}));
  EXPECT_EQ(single.scene.points[0], (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(single.scene.points[1][1], static_cast<double>(0.1F));
  EXPECT_EQ(single.scene.balls[0].centre[0], static_cast<double>(0.1F));
  EXPECT_EQ(single.scene.polygon_lights[0].corners[2][2], static_cast<double>(0.1F));
  EXPECT_TRUE(is_valid(single.scene));
}

TEST(SingleScene, KeepsTheNumbersOfFacesAndObjects) {
  const Scene scene = read_nff_text("f 1 1 1 1 0 0 0 1\n" + kTrianglePolygon + "s 0 0 0 0.1\n" +
                                    "f 1 1 1 1 0 0 0.5 1\ns 0.3 0 0 0.2\np 3\n0 0 0.3\n1 0 0.7\n0 1 0\n")
                          .scene;
  const Scene single = rounded_to_floats(scene).scene;
  EXPECT_EQ(single.objects, scene.objects);
  EXPECT_EQ(single.triangles, scene.triangles);
  ASSERT_EQ(single.balls.size(), 2u);
  EXPECT_EQ(single.balls[1].radius, static_cast<double>(0.2F));
}

TEST(SingleScene, RefusesWhatIsBeyondTheRange) {
  const double largest = std::numeric_limits<float>::max(), half_ulp = 0x1p103;
  EXPECT_NO_THROW((void)rounded_to_floats(
      one_triangle({std::nextafter(largest + half_ulp, 0), 0, 0}, {0, 0, 0}, {0, 1, 0})));
  EXPECT_THROW((void)rounded_to_floats(one_triangle({-(largest + half_ulp), 0, 0}, {0, 0, 0}, {0, 1, 0})),
               std::runtime_error);
  Scene scene = one_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  scene.balls.push_back({{largest, 0, 0}, largest});  // its centre and radius are floats, its end is none
  scene.objects[0].ball_count = 1;
  EXPECT_THROW((void)rounded_to_floats(scene), std::runtime_error);
  scene.balls[0] = {{0, 0, 0}, 1e300};
  EXPECT_THROW((void)rounded_to_floats(scene), std::runtime_error);
  scene.balls[0] = {{0, 0, 0}, 1};
  EXPECT_NO_THROW((void)rounded_to_floats(scene));
  scene.point_lights.push_back({{0, 0, 1e39}});
  EXPECT_THROW((void)rounded_to_floats(scene), std::runtime_error);
}

}  // namespace
}  // namespace gnomon::scene
