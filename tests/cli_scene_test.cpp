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
