// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes from mesh files, and what is counted of scenes.
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "scene/read_mesh.h"
#include "scene/scene_facts.h"
#include "tests/cli_run.h"
#include "tests/mesh_readers_checks.h"
#include "tests/scene_checks.h"

namespace gnomon::scene {
namespace {

const std::string kCube =
    "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n"
    "4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

TEST(ReadScene, TakesEveryMeshFormatAndNff) {
  const tests::Folder folder;
  folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n");  // a point that no face uses
  folder.write(
      "a.PLY",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("a.stl",
               "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
               "endfacet\nendsolid\n");
  for (const char* name : {"a.off", "a.obj", "a.PLY", "a.stl"}) {
    Scene expected = read_nff_text(kTrianglePolygon).scene;
    expected.objects[0].name = "a";
    expected.objects[0].one_sided = false;
    const LoadedScene loaded = read_scene(folder / name);
    EXPECT_EQ(loaded.scene, expected) << name;
    EXPECT_TRUE(is_valid(loaded.scene)) << name;
    EXPECT_EQ(loaded.polygons, 0u) << name;
  }
  folder.write("a.Nff", kTrianglePolygon);
  EXPECT_EQ(read_scene(folder / "a.Nff").scene, read_nff_text(kTrianglePolygon).scene);
}

TEST(ReadScene, ComplainsAboutTheFileAsAWhole) {
  const tests::Folder folder;
  folder.write("a.gltf", "{}");
  folder.write("plain", "p 3\n");
  std::filesystem::create_directory(folder / "folder.nff");
  const auto complaint_about = [&folder](const std::string& name) -> std::string {
    try {
      (void)read_scene(folder / name);
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder / name).size());
    }
    return "no complaint";
  };
  EXPECT_EQ(complaint_about("none.nff"), ": expected a file, found none");
  EXPECT_EQ(complaint_about("folder.nff"), ": expected a file, found a directory");
  EXPECT_EQ(complaint_about("a.gltf"),
            ": expected the extension .nff, .off, .obj, .ply or .stl, found '.gltf'");
  EXPECT_EQ(complaint_about("plain"), ": expected the extension .nff, .off, .obj, .ply or .stl, found none");
}

TEST(SceneOf, TriangulatesPolygonsAndCountsThem) {
  const LoadedScene cube = scene_of(read(read_off, kCube), "cube");
  EXPECT_EQ(cube.scene.triangles.size(), 12u);
  EXPECT_EQ(cube.polygons, 6u);
  EXPECT_EQ(cube.scene.objects, (std::vector<Object>{{"cube", 0, 12, 0, 0, 0, false}}));
  // 100,000 corners at one point: degenerate triangles, in no time.
  std::string text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n100000";
  for (int i = 0; i < 100'000; ++i) text += " 2";
  const Scene point = scene_of(read(read_off, text), "point").scene;
  EXPECT_EQ(facts_of(point).degenerate, 99'998u);
  EXPECT_EQ(facts_of(point).duplicate, 99'997u);
}

TEST(SceneFacts, SaysWhichObjectsAreClosed) {
  const auto closed = [](const std::string& off) {
    return facts_of(scene_of(read(read_off, off), "m").scene).closed == std::vector<bool>{true};
  };
  EXPECT_TRUE(closed(kCube));
  std::string open = kCube;
  open.replace(open.find("8 6"), 3, "8 5").erase(open.find("4 3 0 4 7"));
  EXPECT_FALSE(closed(open));
  const std::string tetrahedron = "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n",
                    points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  EXPECT_TRUE(closed("OFF\n4 4 0\n" + points + tetrahedron));
  // Each edge twice more: of four triangles.
  EXPECT_FALSE(closed("OFF\n4 8 0\n" + points + tetrahedron + tetrahedron));
  EXPECT_FALSE(closed("OFF\n4 5 0\n" + points + tetrahedron + "3 0 1 2\n"));
  // Corners are joined by their coordinates, and a triangle that is an edge bounds nothing.
  EXPECT_TRUE(closed("OFF\n5 5 0\n" + points + "-0 -0 0\n3 4 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n3 1 1 2\n"));
  // An edge that misses the other by an ulp.
  EXPECT_FALSE(closed("OFF\n5 4 0\n" + points + "4.9e-324 0 0\n3 4 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n"));
}

TEST(SceneFacts, LooksAtEachObjectByItself) {
  const std::string f = "f 1 1 1 1 1 1 0 1\n", a = "0 0 0\n", b = "1 0 0\n", c = "0 1 0\n", d = "0 0 1\n";
  const Scene scene = read_nff_text(f + "p 3\n" + a + c + b + "p 3\n" + a + b + d + "p 3\n" + b + c + d +
                                    "p 3\n" + c + a + d + f + kTrianglePolygon + f + "s 0 0 0 1\n")
                          .scene;
  const SceneFacts facts = facts_of(scene);
  EXPECT_EQ(facts.closed, (std::vector<bool>{true, false, true}));
  EXPECT_EQ(facts.closed_objects(), 2u);
  EXPECT_EQ(facts.duplicate, 1u);  // turned over
  EXPECT_EQ(facts.degenerate, 0u);
}

TEST(SceneFacts, CountsDegenerateAndDuplicateFacesExactly) {
  const Scene scene =
      read_nff_text(kTrianglePolygon + "p 3\n0 1 0\n1 0 0\n-0 0 0\n" + "p 3\n0 0 0\n0 0 0\n1 0 0\n" +
                    // (0.1, 0.1, 0.3) and (0.2, 0.2, 0.6): doubles on one line; 0.3 + an ulp is off it
                    "p 3\n0 0 0\n.1 .1 .3\n.2 .2 .6\np 3\n0 0 0\n.1 .1 .30000000000000004\n.2 .2 .6\n" +
                    "s 1 2 3 0\ns 1 2 3 0\ns 1 2 3 4\ns 1 2 3 -4\ns 1 2 3 5\n")
          .scene;
  const SceneFacts facts = facts_of(scene);
  EXPECT_EQ(facts.degenerate, 4u);
  EXPECT_EQ(facts.duplicate, 3u);
  EXPECT_EQ(scene.face_count(), 10u);
}

TEST(SceneFacts, BoundsBallsOutwards) {
  const Scene scene = read_nff_text("s 0.1 -3 1e300 1e-20\ns 0 0 0 2\n" + kTrianglePolygon).scene;
  const Box<double> extent = facts_of(scene).extent;
  EXPECT_EQ(extent.c,
            (std::array<double, 6>{-2, std::nextafter(-3.0, -4.0), -2, 2, 2, std::nextafter(1e300, 2e300)}));
  const Box<double> alone = facts_of(read_nff_text("s 0.1 0 0 1e-20\n").scene).extent;
  EXPECT_EQ(alone.lo(0), std::nextafter(0.1, 0.0));
  EXPECT_EQ(alone.hi(0), std::nextafter(0.1, 1.0));
}

TEST(Scene, RefusesWhatIsNotValid) {
  const Scene good = read_nff_text("l 1 2 3\n" + kTrianglePolygon + "s 0 0 0 1\n").scene;
  const auto with = [&good](auto change) {
    Scene scene = good;
    change(scene);
    return is_valid(scene);
  };
  EXPECT_TRUE(is_valid(good));
  EXPECT_FALSE(is_valid(Scene{}));
  EXPECT_FALSE(with([](Scene& s) { s.points[1][2] = NAN; }));
  EXPECT_FALSE(with([](Scene& s) { s.triangles[0][1] = 3; }));
  EXPECT_FALSE(with([](Scene& s) { s.balls[0].radius = -1; }));
  EXPECT_FALSE(with([](Scene& s) { s.balls[0] = {{1e308, 0, 0}, 1e308}; }));
  EXPECT_FALSE(with([](Scene& s) { s.objects[0].triangle_count = 0; }));
  EXPECT_FALSE(with([](Scene& s) { s.objects[0].transmittance = 1.5; }));
  EXPECT_FALSE(with([](Scene& s) { s.objects.push_back({"empty", 1, 0, 1, 0, 0, false}); }));
  EXPECT_FALSE(with([](Scene& s) { s.point_lights[0].position[0] = INFINITY; }));
  EXPECT_FALSE(with([](Scene& s) { s.polygon_lights.push_back({{{0, 0, 0}, {1, 0, 0}}}); }));
  EXPECT_FALSE(with([](Scene& s) { s.view = View{}; }));
}

}  // namespace
}  // namespace gnomon::scene
