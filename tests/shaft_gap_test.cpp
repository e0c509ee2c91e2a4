// SPDX-License-Identifier: GPL-3.0-or-later
// What the gap means: grown or shrunk by exactly the gap, a box touches; a ball's gap is a squared distance.
#include <gtest/gtest.h>

#include <optional>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "tests/shaft_generator.h"
#include "tests/shaft_rational_reference.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using exact::Boundary;
using exact::Gap;
using scene::Category;
using scene::ShaftBallCase;
using scene::ShaftBoxCase;

const std::vector<Numbers> kKinds{Numbers::coarse, Numbers::grid, Numbers::pool, Numbers::unit,
                                  Numbers::mixed};

/// The scaled integers' unit as a rational: 2^exponent.
Gap power_of_two(int exponent) {
  Gap power(1);
  if (exponent < 0) {
    mpq_div_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  } else {
    mpq_mul_2exp(power.get_mpq_t(), power.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  }
  return power;
}

/// The brute-force answer after t has grown by a rational on all sides; empty when t would turn inside out.
std::optional<ReferenceAnswer> refer_grown(const ShaftBoxCase& c, const Gap& growth) {
  const ScaledIntegers n = scaled(c);
  const Gap in_units = growth / power_of_two(n.exponent());
  const mpz_class &p = in_units.get_num(), &q = in_units.get_den();
  std::array<mpz_class, 6> a = n.take<mpz_class, 6>(0), b = n.take<mpz_class, 6>(6);
  std::array<mpz_class, 6> t = n.take<mpz_class, 6>(12);
  for (std::size_t i = 0; i < 6; ++i) {
    a[i] *= q;
    b[i] *= q;
    t[i] = i < 3 ? mpz_class(t[i] * q - p) : mpz_class(t[i] * q + p);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (t[i] > t[i + 3]) return std::nullopt;
  }
  return refer_by_brute_force(BruteHull<mpz_class>(a, b), t);
}

TEST(ShaftGap, ABoxGrownByItTouches) {
  CaseGenerator<double> generator(11, kKinds);
  int outside = 0, shrunk_to_touch = 0, shrunk_inside = 0, inside = 0;
  for (int i = 0; i < affordable(2500); ++i) {
    const ShaftBoxCase c = generator.box_case();
    const Gap out = exact::gap(c, Boundary::outside), in = exact::gap(c, Boundary::inside);
    if (const std::optional<ReferenceAnswer> at = refer_grown(c, out)) {
      ++(out > 0 ? outside : shrunk_to_touch);
      EXPECT_NE(at->truth, Category::outside) << text_of(c);
      EXPECT_TRUE(at->touches_outside) << text_of(c);
    }
    if (const std::optional<ReferenceAnswer> at = refer_grown(c, -in)) {
      ++(in > 0 ? shrunk_inside : inside);
      EXPECT_EQ(at->truth, Category::inside) << text_of(c);
      EXPECT_TRUE(at->touches_inside) << text_of(c);
    }
    // Halfway there it still lies as before: the gap is the least such growth.
    if (out > 0) {
      EXPECT_EQ(refer_grown(c, out / 2)->truth, Category::outside) << text_of(c);
    }
  }
  EXPECT_GE(outside, affordable(250));
  EXPECT_GE(shrunk_to_touch, affordable(100));
  EXPECT_GE(shrunk_inside, affordable(100));
  EXPECT_GE(inside, affordable(250));
}

TEST(ShaftGap, ClassifyGrownIsTheAnswerOfTheGrownBox) {
  CaseGenerator<double> generator(12, kKinds);
  int changed = 0;
  for (int i = 0; i < affordable(2500); ++i) {
    const ShaftBoxCase c = generator.box_case();
    const double growth = i % 4 == 0 ? std::fabs(exact::gap(c, Boundary::outside).get_d())
                          : i % 4 == 1
                              ? std::fabs(exact::gap(c, Boundary::inside).get_d())
                              : std::ldexp(generator.random().unit(), generator.random().between(-6, 3));
    const Category grown = refer_grown(c, Gap(growth))->truth;
    EXPECT_EQ(exact::classify_grown(c, growth), grown) << text_of(c) << " grown by" << hex_text(growth);
    EXPECT_EQ(exact::classify_grown(c, 0), exact::classify(c)) << text_of(c);
    changed += grown != exact::classify(c);
  }
  EXPECT_GE(changed, affordable(100));
  EXPECT_EQ(exact::classify_grown(generator.box_case(), HUGE_VAL), Category::overlap);
}

/// Growth of a few ulps around the gap itself, for numbers that are scaled before they are filtered, too.
TEST(ShaftGap, ClassifyGrownIsRightAroundTheGap) {
  CaseGenerator<double> generator(15, {Numbers::denormal, Numbers::huge, Numbers::mixed, Numbers::grid});
  std::array<int, 3> seen{};
  for (int i = 0; i < affordable(600); ++i) {
    const ShaftBoxCase c = generator.box_case();
    const Boundary boundary = i % 2 == 0 ? Boundary::outside : Boundary::inside;
    const double at = std::fabs(exact::gap(c, boundary).get_d());
    for (const double growth : {std::nextafter(at, 0.0), at, std::nextafter(at, HUGE_VAL)}) {
      if (std::isinf(growth)) continue;
      const Category grown = refer_grown(c, Gap(growth))->truth;
      ++seen[static_cast<std::size_t>(grown)];
      EXPECT_EQ(exact::classify_grown(c, growth), grown) << text_of(c) << " grown by" << hex_text(growth);
    }
    EXPECT_GE(exact::gap_bound(c, boundary), at) << text_of(c);
  }
  EXPECT_GE(*std::min_element(seen.begin(), seen.end()), affordable(40));
}

/// The ball's gap from the brute-force hull: the least squared distance, and the signed squares of supports.
Gap brute_gap(const ShaftBallCase& c, Boundary boundary) {
  const ScaledIntegers n = scaled(c);
  const BruteHull<mpz_class> hull = hull_of<mpz_class>(n);
  const Point<mpz_class> p = n.take<mpz_class, 3>(12);
  const mpz_class r = n.take<mpz_class, 1>(15)[0];
  const Gap square(r * r), unit = power_of_two(n.exponent());
  std::optional<Gap> gap;
  if (boundary == Boundary::outside) {
    hull.visit_squared_distances(p, [&](const mpz_class& num, const mpz_class& den) {
      Gap distance(num, den);
      distance.canonicalize();
      if (!gap || distance < *gap) gap = distance;
    });
    return (*gap - square) * unit * unit;
  }
  for (const Support<mpz_class>& s : hull.supports()) {
    const mpz_class v = dot(s.normal, p) - s.offset;
    Gap reach(v * v, dot(s.normal, s.normal));
    reach.canonicalize();
    if (v <= 0) reach = -reach;
    if (!gap || reach + square > *gap) gap = reach + square;
  }
  return *gap * unit * unit;
}

TEST(ShaftGap, ABallsGapIsASquaredDistance) {
  std::vector<Numbers> kinds = kKinds;
  kinds.insert(kinds.end(), {Numbers::denormal, Numbers::huge});
  CaseGenerator<double> generator(13, kinds);
  for (int i = 0; i < affordable(2500); ++i) {
    const ShaftBallCase c = generator.ball_case();
    EXPECT_EQ(exact::gap(c, Boundary::outside), brute_gap(c, Boundary::outside)) << text_of(c);
    EXPECT_EQ(exact::gap(c, Boundary::inside), brute_gap(c, Boundary::inside)) << text_of(c);
  }
}

TEST(ShaftGap, ClassifyGrownBallIsThePlaneTestOfTheGrownBall) {
  CaseGenerator<double> generator(14, {Numbers::coarse, Numbers::grid});
  std::array<int, 3> seen{};
  for (int i = 0; i < affordable(20000); ++i) {
    ShaftBallCase c = generator.ball_case();
    const double growth = generator.random().below(16) / 4.0;  // exact: radii are small multiples of 1/16
    const Category grown = exact::classify_grown(c, growth);
    ++seen[static_cast<std::size_t>(grown)];
    EXPECT_EQ(exact::classify_grown(c, 0), exact::refer_in_rationals(c).planes) << text_of(c);
    EXPECT_EQ(exact::classify_grown(c, HUGE_VAL), Category::overlap);
    c.t.radius += growth;
    EXPECT_EQ(grown, exact::refer_in_rationals(c).planes) << text_of(c);
  }
  EXPECT_GE(*std::min_element(seen.begin(), seen.end()), affordable(500));
}

/// Points so near a plane that intervals can't tell on which side: the bound has to allow for both.
TEST(ShaftGap, BoundHoldsForPointsAboutOnAPlane) {
  Random random(16);
  int beyond = 0;
  for (int i = 0; i < affordable(2000); ++i) {
    const double x = random.unit() + 1e6, y = random.unit() - 1e6, s = random.unit();
    // The plane of the edges (x + 1, y) and (x, y + 1.1), and a point between them, rounded.
    const ShaftBallCase c{
        {{x - 9, y - 9, 0, x + 1, y, 1}},
        {{x - 9, y - 9, 0, x, y + 1.1, 1}},
        {{(1 - s) * (x + 1) + s * x, (1 - s) * y + s * (y + 1.1), 0.5}, i % 2 == 0 ? 0 : 1e-9}};
    const Gap gap = exact::gap(c, Boundary::inside);
    beyond += gap > 0;
    EXPECT_GE(Gap(exact::gap_bound(c, Boundary::inside)), abs(gap)) << text_of(c);
  }
  EXPECT_GE(beyond, affordable(500));
}

TEST(ShaftGap, BoundIsInfiniteOnlyWhereIntervalsOverflow) {
  const ShaftBoxCase c{{{0, 0, 0, 1, 1, 1}}, {{2, 3, 0, 4, 5, 1}}, {{1, 4, 0, 2, 7, 1}}};
  EXPECT_NEAR(exact::gap_bound(c, Boundary::outside), std::fabs(exact::gap(c, Boundary::outside).get_d()),
              1e-12);
  ShaftBoxCase far = c;
  far.b.hi(0) = 1e300;
  far.t.lo(2) = 5e-324;  // with the former beyond what one power of two can bring near 1
  EXPECT_EQ(exact::gap_bound(far, Boundary::outside), HUGE_VAL);
  const ShaftBallCase ball{c.a, c.b, {{1, 4, 0}, 0.25}};
  EXPECT_LE(exact::gap_bound(ball, Boundary::outside), 20);
  ShaftBallCase far_ball = ball;
  far_ball.b.hi(0) = 1e300;
  far_ball.t.centre[2] = 5e-324;
  EXPECT_EQ(exact::gap_bound(far_ball, Boundary::outside), HUGE_VAL);
  EXPECT_EQ(exact::gap_bound(far_ball, Boundary::inside), HUGE_VAL);
}

}  // namespace
}  // namespace gnomon::tests
