// SPDX-License-Identifier: GPL-3.0-or-later
// exact/ against the brute-force reference, class by class.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "tests/shaft_class_counts.h"
#include "tests/shaft_generator.h"
#include "tests/shaft_rational_reference.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using exact::Boundary;
using scene::Category;
using scene::ShaftBallCase;
using scene::ShaftBoxCase;

constexpr int kFewestInClass = affordable(2000);

const std::vector<Numbers> kEveryday{Numbers::coarse, Numbers::coarse, Numbers::grid,   Numbers::grid,
                                     Numbers::pool,   Numbers::unit,   Numbers::offset, Numbers::mixed};
const std::vector<Numbers> kExtreme{Numbers::denormal, Numbers::huge, Numbers::mixed};

int sign_of(const exact::Gap& gap) {
  return sgn(gap);
}

bool is_point(const ShaftBoxCase&) {
  return false;
}
bool is_point(const ShaftBallCase& c) {
  return c.t.radius == 0;
}

/// The gap's sign says on which side of the boundary a case is, and whether it touches.
template <class Case>
void expect_gap_signs(const Case& c, const ReferenceAnswer& answer) {
  const exact::Gap out = exact::gap(c, Boundary::outside), in = exact::gap(c, Boundary::inside);
  EXPECT_EQ(sign_of(out) > 0, answer.truth == Category::outside) << text_of(c);
  EXPECT_EQ(sign_of(in) <= 0, answer.truth == Category::inside) << text_of(c);
  // A point within the shaft has distance 0 = r wherever it lies: there the gap can't tell touching.
  if (!is_point(c)) {
    EXPECT_EQ(sign_of(out) == 0, answer.touches_outside) << text_of(c);
  }
  EXPECT_EQ(sign_of(in) == 0, answer.touches_inside) << text_of(c);
  EXPECT_GE(exact::gap_bound(c, Boundary::outside), std::fabs(out.get_d())) << text_of(c);
  EXPECT_GE(exact::gap_bound(c, Boundary::inside), std::fabs(in.get_d())) << text_of(c);
}

void expect_agreement(const ShaftBoxCase& c, const exact::ShaftBoxReference& r,
                      const ReferenceAnswer& answer) {
  EXPECT_EQ((ReferenceAnswer{r.truth, r.touches_outside, r.touches_inside}), answer) << text_of(c);
  EXPECT_EQ(r.planes, answer.truth) << text_of(c);  // the theorem: the plane test is exact
}

void expect_agreement(const ShaftBallCase& c, const exact::ShaftBallReference& r,
                      const ReferenceAnswer& answer) {
  EXPECT_EQ((ReferenceAnswer{r.truth, r.touches_outside, r.touches_inside}), answer) << text_of(c);
  // False positives are the only model error of the sphere test (claim S6).
  EXPECT_TRUE(r.planes == answer.truth ||
              (answer.truth == Category::outside && r.planes == Category::overlap))
      << text_of(c);
}

/// Compares `count` cases by intervals, by rationals and by brute force; returns the class counts.
template <class Case, class Reference, class Make>
ClassCounts compare(int count, Make make) {
  ClassCounts counts;
  std::vector<Case> cases;
  for (int i = 0; i < count; ++i) cases.push_back(make());
  std::vector<Reference> references(cases.size());
  counts.in_rationals = exact::refer(cases, references);
  for (std::size_t i = 0; i < cases.size() && !testing::Test::HasFailure(); ++i) {
    const Case& c = cases[i];
    const ReferenceAnswer answer = refer_by_brute_force(c);
    counts.add(answer);
    counts.false_positives += references[i].planes != references[i].truth;
    expect_agreement(c, references[i], answer);
    const Reference slow = exact::refer_in_rationals(c);
    expect_agreement(c, slow, answer);
    EXPECT_EQ(slow.planes, references[i].planes) << text_of(c);
    EXPECT_EQ(slow.printed, references[i].printed) << text_of(c);
    EXPECT_EQ(exact::classify(c), answer.truth) << text_of(c);
    if (i % 8 == 0) expect_gap_signs(c, answer);
  }
  return counts;
}

TEST(ShaftRational, Boxes) {
  CaseGenerator<double> generator(1, kEveryday);
  const ClassCounts counts = compare<ShaftBoxCase, exact::ShaftBoxReference>(
      reference_cases(affordable(16000)), [&] { return generator.box_case(); });
  counts.record();
  counts.expect_at_least(kFewestInClass);
  EXPECT_GT(counts.in_rationals, 0u);
}

TEST(ShaftRational, Balls) {
  CaseGenerator<double> generator(2, kEveryday);
  const ClassCounts counts = compare<ShaftBallCase, exact::ShaftBallReference>(
      reference_cases(affordable(16000)), [&] { return generator.ball_case(); });
  counts.record();
  counts.expect_at_least(kFewestInClass);
  EXPECT_GT(counts.in_rationals, 0u);
  EXPECT_GT(counts.false_positives, affordable(100));  // claim S6: there are some
}

/// Balls between two far planes of a diagonal shaft, as large as the distance to the farther one, give or
/// take an ulp: what the filter can't tell decides "printed" there.
TEST(ShaftRational, FilteredAnswersOfNearTouchingBallsAreThoseOfRationals) {
  Random random(7);
  std::vector<ShaftBallCase> cases;
  for (int i = 0; i < affordable(4000); ++i) {
    const double w = random.unit() + 0.5;
    ShaftBallCase c{{{0, 0, 0, w, 1, 4}}, {{9, 9, 0, 10, 10, 4}}, {{5, 5 + random.unit() / 2, 2}, 0}};
    // Upper left and lower right plane of the edges at (0, 1), (9, 10) and (w, 0), (10, 9).
    const double x = c.t.centre[0], y = c.t.centre[1];
    const double upper = (1 + x - y) / std::sqrt(2.0),
                 lower = (9 * (w - x) + (10 - w) * y) / std::hypot(9, 10 - w);
    c.t.radius = std::max(upper, lower);
    for (int steps = random.between(-2, 2); steps != 0; steps += steps > 0 ? -1 : 1)
      c.t.radius = std::nextafter(c.t.radius, steps > 0 ? 9.0 : 0.0);
    cases.push_back(c);
  }
  std::vector<exact::ShaftBallReference> references(cases.size());
  exact::refer(cases, references);
  std::array<int, 3> printed{};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const exact::ShaftBallReference slow = exact::refer_in_rationals(cases[i]);
    EXPECT_EQ(references[i].truth, slow.truth) << text_of(cases[i]);
    EXPECT_EQ(references[i].planes, slow.planes) << text_of(cases[i]);
    EXPECT_EQ(references[i].printed, slow.printed) << text_of(cases[i]);
    ++printed[static_cast<std::size_t>(slow.printed)];
  }
  EXPECT_GE(printed[1], affordable(500));
  EXPECT_GE(printed[2], affordable(500));
}

TEST(ShaftRational, FloatBoxes) {
  CaseGenerator<float> generator(3, kEveryday);
  const ClassCounts counts = compare<ShaftBoxCase, exact::ShaftBoxReference>(
      affordable(6000), [&] { return as_double(generator.box_case()); });
  counts.record();
}

TEST(ShaftRational, FloatBalls) {
  CaseGenerator<float> generator(4, kEveryday);
  const ClassCounts counts = compare<ShaftBallCase, exact::ShaftBallReference>(
      affordable(6000), [&] { return as_double(generator.ball_case()); });
  counts.record();
}

TEST(ShaftRational, DenormalAndHugeBoxes) {
  CaseGenerator<double> generator(5, kExtreme);
  const ClassCounts counts =
      compare<ShaftBoxCase, exact::ShaftBoxReference>(affordable(1200), [&] { return generator.box_case(); });
  counts.record();
  counts.expect_at_least(20);
}

TEST(ShaftRational, DenormalAndHugeBalls) {
  CaseGenerator<double> generator(6, kExtreme);
  const ClassCounts counts = compare<ShaftBallCase, exact::ShaftBallReference>(
      affordable(1200), [&] { return generator.ball_case(); });
  counts.record();
  counts.expect_at_least(10);
}

}  // namespace
}  // namespace gnomon::tests
