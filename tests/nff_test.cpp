// SPDX-License-Identifier: GPL-3.0-or-later
// NFF: every record, bad input by line, and scenes that read back bit for bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "scene/cone.h"
#include "scene/float_text.h"
#include "scene/scene_facts.h"
#include "scene/write_nff.h"
#include "tests/scene_checks.h"

namespace gnomon::scene {
namespace {

const std::string kView =
    "v\nfrom 2.1 1.3 1.7\nat 0 0 .5\nup 0 0 1\nangle 45\nhither .01\nresolution 512 256\n";
const std::string kFill = "f 1 0.75 0.33 0.8 0.2 3 0.25 1.1\n";

TEST(ReadNff, TakesEveryRecord) {
  const LoadedScene loaded = read_nff_text(
      "# a comment\n" + kView + "\nb 0.078 0.361 0.753\r\nl 4 3 2\nl 1 -4 4 1 .9 .8 # white\n" + kFill +
      "p 4\n12 12 -.5\n-12 12 -.5 # a corner\n\n-12 -12 -.5\n12 -12 -.5\ns 1 2 3 0.5\n"
      "f 1 .9 .7 .5 .5 45 0 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\ns 1 0 0 -2");
  const Scene& scene = loaded.scene;
  ASSERT_TRUE(scene.view);
  EXPECT_EQ(*scene.view, (View{{2.1, 1.3, 1.7}, {0, 0, .5}, {0, 0, 1}, 45, .01, 512, 256}));
  EXPECT_EQ(scene.point_lights, (std::vector<PointLight>{{{4, 3, 2}}, {{1, -4, 4}}}));
  EXPECT_EQ(scene.balls, (std::vector<Ball<double>>{{{1, 2, 3}, .5}, {{1, 0, 0}, 2}}));
  ASSERT_EQ(scene.triangles.size(), 3u);
  EXPECT_EQ(scene.corner(2, 0), (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(scene.corner(2, 2), (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(scene.points.size(), 7u);
  EXPECT_EQ(scene.objects, (std::vector<Object>{{"object 1", 0, 2, 0, 1, .25, false, true},
                                                {"object 2", 2, 1, 1, 1, 0, false, true}}));
  EXPECT_EQ(loaded.polygons, 1u);
  EXPECT_EQ(loaded.crossing_polygons, 0u);
}

TEST(ReadNff, DropsObjectsWithoutFacesAndTakesFacesBeforeAnyFill) {
  EXPECT_EQ(read_nff_text("s 0 0 0 1\n" + kFill + kFill + kTrianglePolygon + kFill).scene.objects,
            (std::vector<Object>{{"object 1", 0, 0, 0, 1, 0, false, true},
                                 {"object 2", 0, 1, 1, 0, .25, false, true}}));
}

TEST(ReadNff, TurnsConesIntoSidesThatShareTheirEdges) {
  struct Case {
    std::string ends;
    std::size_t triangles, points;
  };
  const Case cases[] = {{"0 0 0 2\n0 0 3 2\n", 2 * kConeSides, 2 * kConeSides},
                        {"0 0 0 2\n1 1 1 1\n", 2 * kConeSides, 2 * kConeSides},
                        {"0 0 0 2\n1 -1 3 0\n", kConeSides, kConeSides + 1},
                        {"5 5 5 0\n5 5 6 1\n", kConeSides, kConeSides + 1}};
  for (const Case& c : cases) {
    const LoadedScene loaded = read_nff_text("c\n" + c.ends);
    EXPECT_EQ(loaded.cones, 1u);
    EXPECT_EQ(loaded.scene.triangles.size(), c.triangles) << c.ends;
    EXPECT_EQ(loaded.scene.points.size(), c.points) << c.ends;
    EXPECT_EQ(facts_of(loaded.scene).degenerate, 0u) << c.ends;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
    for (const auto& t : loaded.scene.triangles) {
      for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : directed) {
      EXPECT_EQ(count, 1) << "two sides run along an edge in one direction";
      open += directed.contains({edge.second, edge.first}) ? 0 : 1;
    }
    const std::size_t rims = c.triangles / kConeSides;
    EXPECT_EQ(open, rims * kConeSides) << c.ends;
  }
}

TEST(ReadNff, PutsConesCornersOnTheConeFacingOutwards) {
  const double tilt = std::sqrt(0.5);  // the axis is (1, 0, 1)
  for (const bool inside_out : {false, true}) {
    const std::string sign = inside_out ? "-" : "";
    const Scene scene = read_nff_text("c\n1 1 1 " + sign + "2\n2 1 2 " + sign + "1\n").scene;
    for (const auto& p : scene.points) {
      const double x = p[0] - 1, y = p[1] - 1, z = p[2] - 1, along = (x + z) * tilt;
      const double radius = std::sqrt(x * x + y * y + z * z - along * along);
      EXPECT_NEAR(radius, 2 - along * tilt, 1e-12);
    }
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      std::array<double, 3> u{}, v{}, out{};
      double length = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        u[i] = scene.corner(t, 1)[i] - scene.corner(t, 0)[i];
        v[i] = scene.corner(t, 2)[i] - scene.corner(t, 0)[i];
        out[i] = (scene.corner(t, 0)[i] + scene.corner(t, 1)[i] + scene.corner(t, 2)[i]) / 3 - 1;
        length += i == 1 ? 0 : out[i] * tilt;
      }
      out[0] -= length * tilt;  // from the axis to the triangle's middle
      out[2] -= length * tilt;
      const double facing = (u[1] * v[2] - u[2] * v[1]) * out[0] + (u[2] * v[0] - u[0] * v[2]) * out[1] +
                            (u[0] * v[1] - u[1] * v[0]) * out[2];
      EXPECT_GT(inside_out ? -facing : facing, 0) << t;
    }
  }
}

TEST(ReadNff, TakesConesAtTheEndsOfTheRangeAndOfRadius0) {
  EXPECT_EQ(read_nff_text("c\n-1.7e308 0 0 1e300\n1.7e308 0 0 1\n").scene.triangles.size(), 2 * kConeSides);
  EXPECT_EQ(read_nff_text("c\n0 0 0 1\n0 0 4.9e-324 1\n").scene.triangles.size(), 2 * kConeSides);
  const Scene line = read_nff_text("c\n0 0 0 0\n0 0 1 0\n").scene;
  EXPECT_EQ(line.triangles.size(), kConeSides);
  EXPECT_EQ(facts_of(line).degenerate, kConeSides);
}

TEST(ReadNff, CountsPolygonsThatCrossThemselves) {
  const LoadedScene loaded =
      read_nff_text("p 4\n0 0 0\n2 2 0\n2 0 0\n0 1 0\np 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n");
  EXPECT_EQ(loaded.polygons, 2u);
  EXPECT_EQ(loaded.crossing_polygons, 1u);
  EXPECT_EQ(loaded.scene.triangles.size(), 4u);
}

TEST(ReadNff, NamesLineAndFaultOfBadInput) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "s: expected at least one face, found the end of the file"},
      {"# nothing\n", "s:1: expected at least one face, found the end of the file"},
      {kView + kFill, "s:8: expected at least one face, found the end of the file"},
      {"tt 3\n", "s:1: expected a record v, b, l, f, c, s, p or pp, found 'tt'"},
      {"P 3\n", "s:1: expected a record v, b, l, f, c, s, p or pp, found 'P'"},
      {"\x01\xff\n", "s:1: expected a record v, b, l, f, c, s, p or pp, found '\\x01\\xff'"},
      {kTrianglePolygon + "1 1 0\n", "s:5: expected a record v, b, l, f, c, s, p or pp, found '1'"},
      {kView + kView, "s:8: expected one viewpoint, found a second one"},
      {"v from 1 1 1\n", "s:1: expected the end of the line, found 'from'"},
      {"v\n", "s:1: expected from, found the end of the file"},
      {"v\nat 1 1 1\n", "s:2: expected from, found 'at'"},
      {"v\nfrom 1 1\n", "s:2: expected a finite number for z, found the end of the line"},
      {"v\nfrom 1 1 1\nat 0 0 0\nup 0 0 1\nangle 180\n",
       "s:5: expected an angle between 0 and 180 degrees, found '180'"},
      {"v\nfrom 1 1 1\nat 0 0 0\nup 0 0 1\nangle 9\nhither x\n",
       "s:6: expected a finite number for hither, found 'x'"},
      {"v\nfrom 1 1 1\nat 0 0 0\nup 0 0 1\nangle 9\nhither 1\nresolution 512\n",
       "s:7: expected a number of rows from 1 to 1000000, found the end of the line"},
      {"v\nfrom 1 1 1\nat 0 0 0\nup 0 0 1\nangle 9\nhither 1\nresolution 0 1\n",
       "s:7: expected a number of columns from 1 to 1000000, found '0'"},
      {"b 0 0\n", "s:1: expected a finite number for blue, found the end of the line"},
      {"b 0 0 0 0\n", "s:1: expected the end of the line, found '0'"},
      {"l 1 2\n", "s:1: expected a finite number for z, found the end of the line"},
      {"l 1 2 3 4\n", "s:1: expected a finite number for green, found the end of the line"},
      {"l 1 2 3 1 1 1 1\n", "s:1: expected the end of the line, found '1'"},
      {"f 1 1 1 1 1 1 1\n",
       "s:1: expected a finite number for the index of refraction, found the end of the line"},
      {"f 1 1 1 1 1 1 1.5 1\n", "s:1: expected a transmittance from 0 to 1, found '1.5'"},
      {"f 1 1 1 1 1 1 -1 1\n", "s:1: expected a transmittance from 0 to 1, found '-1'"},
      {"s 0 0 0\n", "s:1: expected a finite number for a radius, found the end of the line"},
      {"s 0 nan 0 1\n", "s:1: expected a finite number for y, found 'nan'"},
      {"s 0 0 -inf 1\n", "s:1: expected a finite number for z, found '-inf'"},
      {"s 0 0 0 1e309\n", "s:1: expected a finite number for a radius, found '1e309'"},
      {"s 0 0 0 0x1\n", "s:1: expected a finite number for a radius, found '0x1'"},
      {"s 0 0 0 1 1\n", "s:1: expected the end of the line, found '1'"},
      {"\ns 0 1e308 0 1e308\n", "s:2: expected a sphere within the range of doubles, found one beyond it"},
      {"c 0 0 0 1\n", "s:1: expected the end of the line, found '0'"},
      {"c\n", "s:1: expected the base of a cone, found the end of the file"},
      {"c\n0 0 0 1\n", "s:2: expected the apex of a cone, found the end of the file"},
      {"c\n0 0 0 1\n0 0 1\n", "s:3: expected a finite number for a radius, found the end of the line"},
      {"c\n0 0 0 1\n0 0 1 -1\n", "s:3: expected two radii of one sign, found a positive and a negative one"},
      {"c\n1 0 0 1\n1 -0 0 1\n", "s:3: expected an apex apart from the base, found the same point"},
      {"c\n1.7e308 0 0 1.7e308\n1.7e308 1 0 1\n",
       "s:3: expected a cone within the range of doubles, found one beyond it"},
      {"p\n", "s:1: expected a number of vertices from 3 to 4294967295, found the end of the line"},
      {"p 2\n0 0 0\n1 0 0\n", "s:1: expected a number of vertices from 3 to 4294967295, found '2'"},
      {"p 3.0\n", "s:1: expected a number of vertices from 3 to 4294967295, found '3.0'"},
      {"p 4294967296\n", "s:1: expected a number of vertices from 3 to 4294967295, found '4294967296'"},
      {"p 4294967295\n0 0 0\n", "s:2: expected vertex 2 of 4294967295, found the end of the file"},
      {"p 3 0 0 0\n", "s:1: expected the end of the line, found '0'"},
      {"p 4\n0 0 0\n1 0 0\n0 1 0\ns 0 0 0 1\n", "s:5: expected a finite number for x, found 's'"},
      {"p 3\n0 0 0\n1 0 0 0 0 1\n0 1 0\n", "s:3: expected the end of the line, found '0'"},
      {"pp 3\n0 0 0 0 0 1\n1 0 0\n",
       "s:3: expected a finite number for x of a normal, found the end of the line"},
      {"pp 3\n0 0 0 0 0 1 1\n", "s:2: expected the end of the line, found '1'"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(nff_complaint(text), expected) << text;
}

TEST(WriteNff, ReadsBackBitForBit) {
  std::mt19937_64 random(3);
  const auto number = [&random] {
    for (;;) {
      const double value = std::bit_cast<double>(random());
      if (std::fabs(value) < 1e307) return decimal_text(value);
    }
  };
  std::string text =
      "v\nfrom 0.1 -0 1e-320\nat 4.9e-324 2 3\nup 0 0.30000000000000004 1\nangle 44.999999999999993\n"
      "hither -1.1\nresolution 3 4\nl 0.1 0.2 0.3\ns 1 2 3 4\n";
  for (int i = 0; i < 200; ++i) {
    text += i % 20 == 0 ? "f 1 1 1 1 1 1 0." + std::to_string(i) + " 1\n" : "";
    text += i % 3 == 0 ? "s" : i % 3 == 1 ? "p 4" : "c";
    for (int corner = 0; corner < (i % 3 == 0 ? 1 : i % 3 == 1 ? 4 : 2); ++corner) {
      if (i % 3 != 0) text += "\n";
      for (int k = 0; k < 3; ++k) text += " " + number();
      if (i % 3 == 0) text += " " + number();
      if (i % 3 == 2) text += " 0.7";
    }
    text += "\n";
  }
  const Scene scene = read_nff_text(text).scene;
  const std::string written = nff_text(scene);
  const Scene again = read_nff_text(written).scene;
  EXPECT_EQ(again, scene);
  // == takes -0 for 0, the text doesn't.
  EXPECT_EQ(nff_text(again), written);
  EXPECT_TRUE(std::signbit(again.view->from[1]));
  EXPECT_GT(scene.triangles.size(), 60 * 2 * kConeSides);
}

TEST(WriteNff, KeepsObjectsOnTheirLines) {
  Scene scene = read_nff_text(kTrianglePolygon).scene;
  scene.objects[0].name = "two\nlines \xff";
  EXPECT_EQ(nff_text(scene), "# two\\x0alines \\xff\nf 1 1 1 1 0 0 0 1\n" + kTrianglePolygon);
}

TEST(WriteNff, MakesPointLightsOfPolygonLights) {
  Scene scene = read_nff_text(kTrianglePolygon).scene;
  scene.point_lights = {{{1, 2, 3}}};
  scene.polygon_lights.push_back({{{0, 0, 4}, {2, 0, 4}, {2, 2, 4}, {0, 2, 4}}});
  scene.polygon_lights.push_back({{{1, 2, 2}, {1, 2, 4}, {0, 1, 3}, {2, 3, 3}}});
  // Sums of corners overflow, their mean doesn't.
  constexpr double kHuge = std::numeric_limits<double>::max();
  scene.polygon_lights.push_back({{{kHuge, kHuge, 0}, {kHuge, -kHuge, 0}, {kHuge, kHuge, 0}}});
  ASSERT_TRUE(is_valid(scene));
  const std::string written = nff_text(scene);
  EXPECT_EQ(written.substr(0, written.find("# object")),
            "l 1 2 3\n"
            "# a polygon light, as a point at the mean of its corners\nl 1 1 4\n"
            "# a polygon light: the light at the mean of its corners is among the above\n"
            "# a polygon light, as a point at the mean of its corners\nl 1.7976931348623157e+308 "
            "5.992310449541053e+307 0\n");
  const Scene again = read_nff_text(written).scene;
  EXPECT_EQ(again.point_lights.size(), 3u);
  EXPECT_TRUE(again.polygon_lights.empty());
  EXPECT_EQ(again.triangles, scene.triangles);
}

TEST(ReadNff, TakesALargeFile) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) {
    const std::string x = std::to_string(i % 317) + ".5 ", y = std::to_string(i / 317) + ".25 ";
    text += "p 4\n" + x + y + "0\n" + x + y + "1\n" + x + y + "1.5\n" + x + "999 0\n";
  }
  const LoadedScene loaded = read_nff_text(text);
  EXPECT_EQ(loaded.scene.face_count(), 200'000u);
  EXPECT_EQ(loaded.polygons, 100'000u);
  EXPECT_EQ(facts_of(loaded.scene).duplicate, 0u);
}

}  // namespace
}  // namespace gnomon::scene
