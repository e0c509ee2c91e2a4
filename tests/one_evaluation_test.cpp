// SPDX-License-Identifier: GPL-3.0-or-later
// Claim S8: one evaluation of a plane serves the tests for outside and for inside. Exactly, the inside test
// compares (T - r) + 2 r with 0; in floats that sum rounds, and only comparing T itself with both bounds is
// right.
#include <gtest/gtest.h>

#include "exact/shaft_ball.h"
#include "fast/shaft_ball.h"
#include "fuzz/generator.h"
#include "fuzz/shaft_questions.h"
#include "scene/corpus.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {
namespace {

using scene::Category;

/// The paper's shortcut: the outside test's difference plus the diameter, against 0; the extent box as usual.
bool inside_by_difference(const scene::ShaftBallCaseOf<float>& c) {
  const fast::Shaft<float> shaft = fast::form_shaft(c.a, c.b, fast::Normals::unit);
  bool inside = true;
  for (int axis = 0; axis < 3; ++axis) {
    const float x = c.t.centre[static_cast<std::size_t>(axis)];
    inside = inside && x - shaft.extent.lo(axis) >= c.t.radius && shaft.extent.hi(axis) - x >= c.t.radius;
  }
  for (const fast::ShaftPlane<float>& plane : shaft.planes()) {
    const float outside_difference = plane.value_at(c.t.centre) - c.t.radius;
    inside = inside && outside_difference + 2 * c.t.radius <= 0;
  }
  return inside;
}

bool inside_by_value(const scene::ShaftBallCaseOf<float>& c) {
  return fast::classify(fast::form_shaft(c.a, c.b, fast::Normals::unit), c.t).answer == Category::inside;
}

TEST(OneEvaluation, AddingTheDiameterSaysInsideOfABallThatSticksOut) {
  const auto corpus = scene::read_corpus(GNOMON_SOURCE_DIR "/proofs/witnesses/S8-diameter-rounds.txt");
  ASSERT_EQ(corpus.size(), 1u);
  const auto c = fuzz::case_of<scene::ShaftBallCase>(corpus[0].numbers(16));
  EXPECT_EQ(exact::classify(c), Category::overlap);
  const auto in_floats = scene::converted<float>(c);
  EXPECT_FALSE(inside_by_value(in_floats));
  EXPECT_TRUE(inside_by_difference(in_floats));
}

/// Near the boundary both ways of comparing err, each where the other is right: a hundred thousand cases
/// count 69 for the difference, 44 for the value.
TEST(OneEvaluation, TheDifferenceAndTheValueErrInDifferentCases) {
  int only_difference_errs = 0, only_value_errs = 0;
  const auto generator =
      fuzz::make_generator<scene::ShaftBallCase>(fuzz::parse_distribution("near-touch"), scene::Scalar::f32);
  const std::uint64_t trials = static_cast<std::uint64_t>(affordable(100000));
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    fuzz::CaseRandom random(8, 0, trial);
    const scene::ShaftBallCase c = generator->make(random);
    const auto in_floats = scene::converted<float>(c);
    const bool by_value = inside_by_value(in_floats), by_difference = inside_by_difference(in_floats);
    if (by_value == by_difference) continue;
    const bool inside = exact::classify(c) == Category::inside;
    ++(inside == by_value ? only_difference_errs : only_value_errs);
  }
  EXPECT_GE(only_difference_errs, affordable(24));
  EXPECT_GE(only_value_errs, affordable(24));
  if (!kSanitized) {  // the very cases, so the very counts
    EXPECT_EQ(only_difference_errs, 69);
    EXPECT_EQ(only_value_errs, 44);
  }
}

}  // namespace
}  // namespace gnomon::tests
