// SPDX-License-Identifier: GPL-3.0-or-later
// gnomon scene: what it says of a scene and what it writes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli_run.h"

namespace gnomon::tests {
namespace {

using nlohmann::json;

const std::string kScene =
    "v\nfrom 2 1 1\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 8 6\nb 0 0 1\nl 4 3 2\n"
    "f 1 1 1 1 0 0 0 1\np 4\n0 0 0\n4 0 0\n1 1 0\n0 4 0\nc\n0 0 0 1\n0 0 1 0\n"
    "f 1 1 1 1 0 0 0.5 1\ns 0 0 0 0.1\ns 0 0 0 0.1\n";

TEST(CommandLineScene, DescribesAScene) {
  const Folder folder;
  folder.write("s.nff", kScene);
  const Outcome run = run_gnomon({"scene", "s.nff"}, folder.path());
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out,
            "s.nff: 36 faces\n"
            "  triangles   34 on 37 points\n"
            "              from 1 polygon of four or more corners\n"
            "              from 1 cone or cylinder of 32 sides each\n"
            "  balls       2\n"
            "  degenerate  0\n"
            "  duplicate   1\n"
            "  objects     2: 1 closed, 1 open\n"
            "  convex      0 declared, 0 exactly\n"
            "  lights      1 point, 0 polygons\n"
            "  extent      from (-1, -1, -0.1) to (4, 4, 1)\n"
            "  view        from (2, 1, 1) at (0, 0, 0), 45 degrees, 8 x 6\n");
}

TEST(CommandLineScene, SaysWhatIsUnusual) {
  const Folder folder;
  folder.write("s.nff", "p 4\n0 0 0\n2 2 0\n2 0 0\n0 1 0\np 3\n0 0 0\n1 1 1\n2 2 2\ns 1 1 1 0\n");
  const std::vector<std::string> lines = lines_of(run_gnomon({"scene", "s.nff"}, folder.path()).out);
  ASSERT_GT(lines.size(), 4u);
  EXPECT_EQ(lines[2], "              from 1 polygon of four or more corners; self-crossing: 1");
  EXPECT_EQ(lines[4], "  degenerate  2");
  EXPECT_EQ(lines.back(), "  view        none");
}

TEST(CommandLineScene, WritesNffThatSaysTheSame) {
  const Folder folder;
  folder.write("s.nff", kScene);
  const Outcome first = run_gnomon({"scene", "s.nff", "-o", "new/t.nff", "--json"}, folder.path());
  const Outcome second = run_gnomon({"scene", "new/t.nff", "-o", "u.nff", "--json"}, folder.path());
  ASSERT_EQ(first.status, 0) << first.err;
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(contents_of(folder / "new/t.nff"), contents_of(folder / "u.nff"));
  json before = json::parse(first.out), after = json::parse(second.out);
  EXPECT_EQ(before.at("kind"), "scene");
  EXPECT_EQ(before.at("triangles"), 34);
  EXPECT_EQ(before.at("cones"), 1);
  EXPECT_EQ(before.at("cone_sides"), 32);
  EXPECT_EQ(before.at("objects").at(1).at("transmittance"), 0.5);
  EXPECT_EQ(before.at("objects").at(0).at("closed"), false);
  EXPECT_EQ(before.at("point_lights"), json::parse("[[4, 3, 2]]"));
  EXPECT_EQ(before.at("view").at("resolution"), json::parse("[8, 6]"));
  EXPECT_EQ(after.at("polygons"), 0);
  for (json* description : {&before, &after}) {
    for (const char* changed : {"file", "polygons", "cones"}) description->erase(changed);
  }
  EXPECT_EQ(before, after);
}

TEST(CommandLineScene, DescribesABuiltInScene) {
  const Folder folder;
  const Outcome text = run_gnomon({"scene", "gears:1"}, folder.path());
  EXPECT_EQ(text.status, 0);
  EXPECT_EQ(text.err, "");
  EXPECT_EQ(text.out,
            "gears:1: 360 faces\n"
            "  built in    layers of toothed wheels in mesh: concave polygons\n"
            "              size 1: gears along each of three axes\n"
            "              stands for: no paper's scene: concave objects\n"
            "  triangles   360 on 184 points\n"
            "  balls       0\n"
            "  degenerate  0\n"
            "  duplicate   0\n"
            "  objects     2: 2 closed, 0 open\n"
            "  convex      1 declared, 1 exactly\n"
            "  lights      3 points, 0 polygons\n"
            "  extent      from (-1.06177, -1.06177, 0) to (1.06177, 1.06177, 1)\n"
            "  view        from (-1.25, -2, 3) at (0.875, 0.75, 0.25), 45 degrees, 512 x 512\n");
  const json described = json::parse(run_gnomon({"scene", "office", "--json"}, folder.path()).out);
  EXPECT_EQ(described.at("file"), "office");
  EXPECT_EQ(described.at("builtin").at("name"), "office");
  EXPECT_EQ(described.at("builtin").at("size"), 2);
  std::size_t declared = 0, exact = 0;
  for (const json& object : described.at("objects")) {
    declared += object.at("declared_convex").get<bool>() ? 1 : 0;
    exact += object.at("convex").get<bool>() ? 1 : 0;
  }
  EXPECT_EQ(described.at("convex"),
            (json{{"declared", declared}, {"declared_wrongly", 0}, {"exact", exact}}));
  EXPECT_GT(exact, 100u);
  EXPECT_LT(exact, described.at("objects").size());
}

TEST(CommandLineScene, ListsBuiltInScenes) {
  const Folder folder;
  const std::string text = run_gnomon({"list"}).out;
  const json listed = json::parse(run_gnomon({"list", "--json"}).out);
  EXPECT_GE(listed.at("scenes").size(), 14u);
  for (const json& scene : listed.at("scenes")) {
    const std::string name = scene.at("name");
    EXPECT_NE(text.find("\n  " + name + " "), std::string::npos) << name;
    EXPECT_NE(text.find(" " + std::to_string(scene.at("faces").get<std::size_t>()) + " faces at size " +
                        std::to_string(scene.at("default_size").get<int>()) + ","),
              std::string::npos)
        << name;
    for (const char* key : {"summary", "stands_for", "size_means"}) {
      EXPECT_NE(text.find(scene.at(key).get<std::string>()), std::string::npos) << name;
    }
  }
  // The number listed is the number described.
  const json described = json::parse(run_gnomon({"scene", "tree", "--json"}, folder.path()).out);
  for (const json& scene : listed.at("scenes")) {
    if (scene.at("name") == "tree") {
      EXPECT_EQ(scene.at("faces"), described.at("faces"));
    }
  }
}

TEST(CommandLineScene, WritesABuiltInSceneAndSaysWhatBecomesOfItsLights) {
  const Folder folder;
  const Outcome first = run_gnomon({"scene", "office:1", "-o", "o.nff", "--json"}, folder.path());
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(first.err,
            "gnomon: NFF has no polygon lights: 10 became point lights at the mean of the corners\n");
  const Outcome second = run_gnomon({"scene", "o.nff", "--json"}, folder.path());
  EXPECT_EQ(second.err, "");
  const json before = json::parse(first.out), after = json::parse(second.out);
  EXPECT_EQ(before.at("polygon_lights").size(), 10u);
  EXPECT_TRUE(after.at("polygon_lights").empty());
  // A point light stands at each mean already: none is written twice.
  EXPECT_EQ(before.at("point_lights"), after.at("point_lights"));
  for (const char* key : {"faces", "points", "degenerate", "duplicate", "extent", "view"}) {
    EXPECT_EQ(before.at(key), after.at(key)) << key;
  }
  EXPECT_EQ(before.at("convex").at("exact"), after.at("convex").at("exact"));
  EXPECT_EQ(after.at("convex").at("declared"), 0);
  EXPECT_TRUE(after.at("builtin").is_null());
}

TEST(CommandLineScene, TakesAFileBeforeABuiltInScene) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "city");
  EXPECT_EQ(run_gnomon({"scene", "city:1"}, folder.path()).status, 0);
  EXPECT_EQ(run_gnomon({"scene", "city"}, folder.path()).out.rfind("city: ", 0), 0u);
  folder.write("office:2.nff", "s 0 0 0 1\n");
  EXPECT_EQ(run_gnomon({"scene", "office:2.nff"}, folder.path()).out.rfind("office:2.nff: 1 face\n", 0), 0u);
  folder.write("tree", "s 0 0 0 1\n");
  const Outcome hidden = run_gnomon({"scene", "tree"}, folder.path());
  EXPECT_EQ(hidden.status, 2);
  EXPECT_EQ(
      hidden.err,
      "gnomon: tree: expected the extension .nff, .off, .obj, .ply or .stl, found none: this file hides "
      "the built-in scene of that name\n");
}

TEST(CommandLineScene, RefusesBadInputInOneLineAndWritesNothing) {
  const Folder folder;
  folder.write("bad.nff", "s 0 0 0 1\np 3\n0 0 0\n1 0 0\n");
  folder.write("good.nff", "s 0 0 0 1\n");
  const std::set<std::string> before = folder.entries();
  const std::pair<std::vector<std::string>, std::string> calls[] = {
      {{"scene", "bad.nff", "-o", "o.nff"},
       "gnomon: bad.nff:4: expected vertex 3 of 3, found the end of the file\n"},
      {{"scene", "none.nff"}, "gnomon: none.nff: expected a file, found none\n"},
      {{"scene", "good.nff", "-o", "o.off"},
       "gnomon: -o: expected a file name that ends in .nff, found \"o.off\"\n"},
      {{"scene", "office:0", "-o", "o.nff"},
       "gnomon: office:0: expected a size from 1 to 60 after \"office:\", found \"0\"\n"},
      {{"scene", "offices"},
       "gnomon: offices: expected a file or a built-in scene (office, office-fine, sphereflake, tetra, tree, "
       "gears, chessboard, cards, gazebo, living-room, classroom, floor, temple, city), found neither\n"},
      {{"scene", "good.nff", "-o", ""}, "gnomon: --out: expected a value, found \"\"; see gnomon --help\n"},
  };
  for (const auto& [arguments, said] : calls) {
    const Outcome run = run_gnomon(arguments, folder.path());
    EXPECT_EQ(run.status, 2) << said;
    EXPECT_EQ(run.out, "") << said;
    EXPECT_EQ(run.err, said);
    EXPECT_EQ(folder.entries(), before) << said;
  }
}

}  // namespace
}  // namespace gnomon::tests
