// SPDX-License-Identifier: GPL-3.0-or-later
// exact/ and the brute-force reference against CGAL's exact linear and quadratic programming solver.
#include <gtest/gtest.h>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "tests/shaft_class_counts.h"
#include "tests/shaft_generator.h"
#include "tests/shaft_lp_reference.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using scene::Category;
using scene::ShaftBallCase;
using scene::ShaftBoxCase;

const std::vector<Numbers> kKinds{Numbers::coarse, Numbers::coarse, Numbers::grid,  Numbers::pool,
                                  Numbers::unit,   Numbers::offset, Numbers::mixed, Numbers::denormal};

/// A solver that throws (a failing certificate) or hangs would be worse than none: exceptions fail the test.
TEST(ShaftPrograms, Boxes) {
  CaseGenerator<double> generator(21, kKinds);
  ClassCounts counts;
  const int wanted = reference_cases(affordable(1200));
  for (int i = 0; i < wanted && !HasFailure(); ++i) {
    const ShaftBoxCase c = generator.box_case();
    const ReferenceAnswer answer = refer_by_programs(c);
    counts.add(answer);
    const exact::ShaftBoxReference r = exact::refer_in_rationals(c);
    EXPECT_EQ((ReferenceAnswer{r.truth, r.touches_outside, r.touches_inside}), answer) << text_of(c);
    EXPECT_EQ(r.planes, answer.truth) << text_of(c);
    EXPECT_EQ(refer_by_brute_force(c), answer) << text_of(c);
    EXPECT_EQ(exact::classify(c), answer.truth) << text_of(c);
  }
  counts.record();
  counts.expect_at_least(wanted / 10);
}

TEST(ShaftPrograms, Balls) {
  CaseGenerator<double> generator(22, kKinds);
  ClassCounts counts;
  const int wanted = reference_cases(affordable(4000)) / (std::getenv("GNOMON_REFERENCE_CASES") ? 5 : 1);
  for (int i = 0; i < wanted && !HasFailure(); ++i) {
    const ShaftBallCase c = generator.ball_case();
    const int sign = distance_sign_by_program(c);
    const ReferenceAnswer brute = refer_by_brute_force(c);
    counts.add(brute);
    EXPECT_EQ(sign > 0, brute.truth == Category::outside) << text_of(c);
    const exact::ShaftBallReference r = exact::refer_in_rationals(c);
    EXPECT_EQ(sign > 0, r.truth == Category::outside) << text_of(c);
    if (c.t.radius > 0) {
      EXPECT_EQ(sign == 0, r.touches_outside) << text_of(c);
    }
    EXPECT_EQ(r.truth, brute.truth) << text_of(c);
    EXPECT_EQ(r.touches_inside, brute.touches_inside) << text_of(c);
    EXPECT_EQ(exact::classify(c), brute.truth) << text_of(c);
  }
  counts.record();
  counts.expect_at_least(wanted / 10);
}

/// A point is a flat box and a ball without radius: the two questions must agree on it, touching included.
TEST(ShaftPrograms, APointIsABoxAndABall) {
  CaseGenerator<double> generator(23, kKinds);
  int touching = 0;
  for (int i = 0; i < affordable(1000); ++i) {
    const ShaftBoxCase c = generator.box_case();
    const std::array<double, 3> p{c.t.lo(0), c.t.lo(1), c.t.hi(2)};
    const ShaftBoxCase box{c.a, c.b, {{p[0], p[1], p[2], p[0], p[1], p[2]}}};
    const ReferenceAnswer answer = refer_by_programs(box);
    const exact::ShaftBallReference ball = exact::refer_in_rationals(ShaftBallCase{c.a, c.b, {p, 0}});
    EXPECT_EQ((ReferenceAnswer{ball.truth, ball.touches_outside, ball.touches_inside}), answer)
        << text_of(box);
    touching += answer.touches_outside;
  }
  EXPECT_GE(touching, affordable(100));
}

}  // namespace
}  // namespace gnomon::tests
