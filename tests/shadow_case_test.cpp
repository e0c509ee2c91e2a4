// SPDX-License-Identifier: GPL-3.0-or-later
// Text lines of the question `shadow`: reading, writing, complaints, and a corpus with stated answers.
#include "scene/shadow_case.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "exact/hierarchy.h"
#include "exact/shadow.h"
#include "scene/input_error.h"
#include "tests/scene_cases.h"

namespace gnomon::tests {
namespace {

using scene::CorpusLine;
using scene::Shadow;
using scene::ShadowCase;

CorpusLine line_of(const std::string& text) {
  std::istringstream in("\n" + text + "\n");
  return scene::read_corpus(in, "f").at(0);
}

std::string complaint(const std::string& text) {
  try {
    const CorpusLine line = line_of(text);
    (void)scene::read_shadow_case(line);
    (void)scene::stated_shadow(line);
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(ShadowCase, ReadsFacesInAnyOrder) {
  const ShadowCase c = scene::read_shadow_case(
      line_of("shadow 0 0 0x1p-1 4 5 6  2 4  ball 1 2 3 0  tri 0 0 0 1 0 0 0 1 0  ball 7 8 9 1  "
              "tri 0 0 0 0 1 0 0 0 1"));
  EXPECT_EQ(c.query, (scene::ShadowQuery{{0, 0, 0.5}, {4, 5, 6}, 3}));
  EXPECT_TRUE(is_valid(c.scene));
  EXPECT_EQ(c.scene.triangles.size(), 2u);
  EXPECT_EQ(c.scene.points.size(), 4u);
  ASSERT_EQ(c.scene.balls.size(), 2u);
  EXPECT_EQ(c.scene.balls[1], (scene::Ball<double>{{7, 8, 9}, 1}));
  EXPECT_EQ(scene::read_shadow_case(line_of("shadow 0 0 0 1 1 1 -1 0")).scene.face_count(), 0u);
  EXPECT_EQ(
      scene::read_shadow_case(line_of("shadow 0 0 0 1 1 1 1 2 ball 0 0 0 1 tri 0 0 0 0 0 0 0 0 0")).query.own,
      0u);
}

TEST(ShadowCase, WhatIsWrittenReadsBack) {
  Random random(13);
  for (int trial = 0; trial < 300; ++trial) {
    const Placement& place = kPlacements[static_cast<std::size_t>(trial) % kPlacements.size()];
    const scene::Scene scene = random_scene(random, {random.below(5), random.below(4), true}, place);
    const ShadowCase c{scene, random_query(random, scene, true, place)};
    const CorpusLine line = line_of(scene::corpus_text(c, "facing"));
    EXPECT_EQ(scene::stated_shadow(line), Shadow::facing);
    const ShadowCase back = scene::read_shadow_case(line);
    EXPECT_EQ(back.query, c.query);
    EXPECT_EQ(back.scene.points, c.scene.points);
    EXPECT_EQ(back.scene.triangles, c.scene.triangles);
    EXPECT_EQ(back.scene.balls, c.scene.balls);
    EXPECT_EQ(scene::corpus_text(back, "facing"), scene::corpus_text(c, "facing"));
  }
}

TEST(ShadowCase, ComplainsInOneLine) {
  const std::string ends = "shadow 0 0 0 1 1 1 ";
  EXPECT_EQ(complaint("shadow 0 0 0 1 1"),
            "f:2: expected three numbers for the light, found the end of the line");
  EXPECT_EQ(complaint("shadow 0 0 x 1 1 1 -1 0"), "f:2: expected three numbers for the point, found 'x'");
  EXPECT_EQ(complaint("shadow 0 0 1e999 1 1 1 -1 0"),
            "f:2: expected a number within the range of a double, found '1e999'");
  EXPECT_EQ(complaint(ends + "0 0"), "f:2: expected the number of the point's face below 0, found 0");
  EXPECT_EQ(complaint(ends + "-2 0"), "f:2: expected the number of the point's face, or -1, found '-2'");
  EXPECT_EQ(complaint(ends + "0.5 1"), "f:2: expected the number of the point's face, or -1, found '0.5'");
  EXPECT_EQ(complaint(ends + "-1 99999999999999999999"),
            "f:2: expected how many faces there are, found '99999999999999999999'");
  EXPECT_EQ(complaint(ends + "-1 1 cone 0 0 0 1"),
            "f:2: expected \"tri\" or \"ball\" for face 0, found 'cone'");
  EXPECT_EQ(complaint(ends + "-1 2 ball 0 0 0 1"),
            "f:2: expected \"tri\" or \"ball\" for face 1, found the end of the line");
  EXPECT_EQ(complaint(ends + "-1 1 tri 0 0 0 1 1 1 2 2"),
            "f:2: expected nine numbers for a triangle, found the end of the line");
  EXPECT_EQ(complaint(ends + "-1 1 ball 0 0 0 -1"),
            "f:2: expected a radius that is not negative, found -0x1p+0");
  EXPECT_EQ(complaint(ends + "-1 1 ball 1.7e308 0 0 1.7e308"),
            "f:2: expected a ball within the range of a double, found one that reaches beyond it");
  EXPECT_EQ(complaint(ends + "-1 1 ball 0 0 0 1 2"),
            "f:2: expected the end of the line after the last face, found '2'");
  EXPECT_EQ(complaint(ends + "-1 0 -> outside"),
            "f:2: expected lit, shadowed or facing after \"->\", found 'outside'");
}

TEST(ShadowCase, TheCorpusStatesExactAnswers) {
  std::set<Shadow> seen;
  std::size_t touching = 0;
  for (const CorpusLine& line :
       scene::read_corpus(std::string(GNOMON_SOURCE_DIR) + "/tests/corpus/shadow.txt")) {
    const ShadowCase c = scene::read_shadow_case(line);
    const exact::ShadowTruth truth = exact::shadow_by_all_faces(c.scene, c.query);
    EXPECT_EQ(scene::stated_shadow(line), truth.answer) << line.file << ':' << line.line;
    EXPECT_EQ(exact::Hierarchy(c.scene).shadow(c.query), truth);
    seen.insert(truth.answer);
    touching += truth.touching;
  }
  EXPECT_EQ(seen.size(), 2u);  // no line can say that an object is one-sided
  EXPECT_GE(touching, 5u);
}

}  // namespace
}  // namespace gnomon::tests
