// SPDX-License-Identifier: GPL-3.0-or-later
// The thresholds as numbers: what their derivation asks for, in rationals, and how much of them errors use
// up.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "fast/certified_shaft.h"
#include "tests/certified_shaft_climb.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using fast::Shaft;
using fast::ShaftPlane;
using scene::Box;

template <class F>
class CertifiedShaftBound : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(CertifiedShaftBound, Scalars);

template <class F>
const mpq_class kU = rational(fast::Rounding<F>::u);
template <class F>
const mpq_class kEta = rational(fast::Rounding<F>::two_eta) / 2;

/// |T - exact| <= 4.000002 u S + 5 eta in the extent box, S = |N0| (X + |a0|) + |N1| (Y + |a1|); the
/// threshold is at least that and at most 5.001 u S and the ones it adds for underflow.
TYPED_TEST(CertifiedShaftBound, BoxThresholdsAreTheDerivedOnes) {
  using F = TypeParam;
  CaseGenerator<F> generator(71, kHardNumbers);
  int planes = 0, disarmed = 0;
  for (int i = 0; i < affordable(12000) && !this->HasFailure(); ++i) {
    Box<F> a, b;
    generator.boxes(a, b);
    const Shaft<F> shaft = fast::form_certified_box_shaft(a, b);
    mpq_class widest = 0;
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      const ExactPlane<F> exact(shaft, plane);
      const mpq_class sum =
          abs(exact.n0) * (exact.most0 + abs(exact.a0)) + abs(exact.n1) * (exact.most1 + abs(exact.a1));
      if (std::isinf(plane.outside_threshold)) {
        ++disarmed;
        EXPECT_GT(sum, rational(std::numeric_limits<F>::max()) / 257) << text_of(a) << text_of(b);
        continue;
      }
      ++planes;
      const mpq_class threshold = rational(plane.outside_threshold);
      EXPECT_GE(threshold, mpq_class(4.000002) * kU<F> * sum + 5 * kEta<F>) << text_of(a) << text_of(b);
      EXPECT_LE(threshold, mpq_class(5.001) * kU<F> * sum + 1200 * kEta<F>) << text_of(a) << text_of(b);
      EXPECT_EQ(plane.inside_threshold, -plane.outside_threshold);
      const mpq_class gap = 2 * threshold / (abs(exact.n0) + abs(exact.n1));
      if (gap > widest) widest = gap;
    }
    if (std::isinf(shaft.stated_gap.base)) continue;
    EXPECT_GE(rational(shaft.stated_gap.base), widest) << text_of(a) << text_of(b);
    EXPECT_LE(rational(shaft.stated_gap.base), widest * mpq_class(1.00001) + 4 * kEta<F>)
        << text_of(a) << text_of(b);
    EXPECT_EQ(shaft.stated_gap.per_radius, 0);
  }
  EXPECT_GT(planes, affordable(20000));
  EXPECT_GT(disarmed, affordable(1000));
}

/// Outside (3.001 P + 3.001 D + 2.001 B) u, inside (7.011 P + 3.001 D) u, P, D, B of the shortened normal,
/// and what underflow costs; at most a hundredth and some ones more.
TYPED_TEST(CertifiedShaftBound, BallThresholdsAreTheDerivedOnes) {
  using F = TypeParam;
  CaseGenerator<F> generator(72, kHardNumbers);
  int planes = 0, disarmed = 0;
  for (int i = 0; i < affordable(12000) && !this->HasFailure(); ++i) {
    Box<F> a, b;
    generator.boxes(a, b);
    const Shaft<F> shaft = fast::form_certified_ball_shaft(a, b);
    mpq_class widest = 0;
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      if (std::isinf(plane.outside_threshold)) {
        ++disarmed;
        EXPECT_TRUE(std::isnan(plane.inside_threshold));
        EXPECT_TRUE(std::isinf(shaft.stated_gap.at(F(0))));
        continue;
      }
      ++planes;
      const ExactPlane<F> exact(shaft, plane);
      const F a0 = a.c[plane.far0], a1 = a.c[plane.far1];  // the edge that D is taken from
      EXPECT_EQ(plane.d, -(plane.n0 * a0 + plane.n1 * a1)) << text_of(a) << text_of(b);
      const mpq_class m0 = abs(rational(plane.n0)), m1 = abs(rational(plane.n1));
      const mpq_class p = m0 * exact.most0 + m1 * exact.most1, d = m0 * abs(exact.a0) + m1 * abs(exact.a1);
      const mpq_class across = m0 * abs(exact.b0 - exact.a0) + m1 * abs(exact.b1 - exact.a1);
      const mpq_class underflow = kEta<F> * (4 * (exact.most0 + exact.most1) + 5);
      // The set-up pays with the smallest normal number instead of eta.
      const mpq_class for_underflow =
          rational(std::numeric_limits<F>::min()) * (1 + exact.most0 + exact.most1);
      const mpq_class outside =
          kU<F> * (mpq_class(3.001) * p + mpq_class(3.001) * d + mpq_class(2.001) * across);
      const mpq_class inside = kU<F> * (mpq_class(7.011) * p + mpq_class(3.001) * d);
      EXPECT_GE(rational(plane.outside_threshold), outside + underflow) << text_of(a) << text_of(b);
      EXPECT_GE(-rational(plane.inside_threshold), inside + underflow) << text_of(a) << text_of(b);
      EXPECT_LE(rational(plane.outside_threshold), outside * mpq_class(1.01) + 2 * for_underflow)
          << text_of(a) << text_of(b);
      EXPECT_LE(-rational(plane.inside_threshold), inside * mpq_class(1.02) + 2 * for_underflow)
          << text_of(a) << text_of(b);
      // A wrong keep's exact distance: the threshold, the error of T again, and the shortening of 2 P.
      const mpq_class keep = std::max(outside, inside) + underflow + kU<F> * 20 * p;
      if (keep > widest) widest = keep;
    }
    if (std::isinf(shaft.stated_gap.base)) continue;
    EXPECT_GE(rational(shaft.stated_gap.base), widest) << text_of(a) << text_of(b);
    EXPECT_EQ(rational(shaft.stated_gap.per_radius), 32 * kU<F>);
  }
  EXPECT_GT(planes, affordable(20000));
  EXPECT_GT(disarmed, 0);
}

/// The error of boxes at the corners that decide, in every range of numbers.
TYPED_TEST(CertifiedShaftBound, BoxErrorsOfHardCasesAreWithinTheThreshold) {
  using F = TypeParam;
  double largest = 0;
  CaseGenerator<F> generator(52, kHardNumbers);
  int compared = 0;
  for (int i = 0; i < affordable(12000) && !this->HasFailure(); ++i) {
    const scene::ShaftBoxCaseOf<F> c = hard_box_case(generator);
    const Shaft<F> shaft = fast::form_certified_box_shaft(c.a, c.b);
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      if (std::isinf(plane.outside_threshold)) continue;
      for (const auto& [i0, i1] : {std::pair{plane.far0, plane.far1},
                                   std::pair{fast::opposite(plane.far0), fast::opposite(plane.far1)}}) {
        const auto kept = [&](fast::Face face) {
          return std::clamp(c.t.c[face], shaft.extent.c[face % 3u], shaft.extent.c[face % 3u + 3]);
        };
        const double share = share_of_threshold(Aim::error, shaft, plane, kept(i0), kept(i1));
        EXPECT_LE(share, 1) << text_of(c);
        largest = std::max(largest, share);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, affordable(12000));
  this->RecordProperty("largest_share_of_hard_cases", std::to_string(largest));
  EXPECT_GT(largest, 0.4);
}

template <class F>
double climb(Aim aim, Shaft<F> (*form)(const Box<F>&, const Box<F>&)) {
  double largest = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    largest = std::max(largest, largest_share<F>(aim, form, seed, affordable(100000)));
  }
  return largest;
}

TYPED_TEST(CertifiedShaftBound, BoxErrorsClimbNearTheThreshold) {
  using F = TypeParam;
  const double error = climb<F>(Aim::error, &fast::form_certified_box_shaft<F>);
  const double false_cull = climb<F>(Aim::false_cull, &fast::form_certified_box_shaft<F>);
  const double false_inside = climb<F>(Aim::false_inside, &fast::form_certified_box_shaft<F>);
  this->RecordProperty("largest_share", std::to_string(error));
  this->RecordProperty("largest_share_of_a_false_cull", std::to_string(false_cull));
  this->RecordProperty("largest_share_of_a_false_inside", std::to_string(false_inside));
  EXPECT_LE(std::max({error, false_cull, false_inside}), 1);
  EXPECT_GT(error, kSanitized ? 0.65 : 0.7);  // the bound is 4/5 of the threshold: half of it would not hold
  EXPECT_GT(false_cull, 0.2);                 // and with a fifth of it there are false culls
  EXPECT_GT(false_inside, 0.2);
}

/// Balls of radius 0, whose values have to pay for the turned and shortened normal as well.
TYPED_TEST(CertifiedShaftBound, BallErrorsClimbNearTheThreshold) {
  using F = TypeParam;
  const double false_cull = climb<F>(Aim::false_cull, &fast::form_certified_ball_shaft<F>);
  const double false_inside = climb<F>(Aim::false_inside, &fast::form_certified_ball_shaft<F>);
  this->RecordProperty("largest_share_of_a_false_cull", std::to_string(false_cull));
  this->RecordProperty("largest_share_of_a_false_inside", std::to_string(false_inside));
  EXPECT_LE(std::max(false_cull, false_inside), 1);
  EXPECT_GT(false_cull, 0.2);
  EXPECT_GT(false_inside, 0.1);
}

}  // namespace
}  // namespace gnomon::tests
