// SPDX-License-Identifier: GPL-3.0-or-later
// Certified shafts for balls from both sides: shortened normals, thresholds and slacks.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "exact/shaft_ball.h"
#include "fast/certified_shaft.h"
#include "fast/shaft_ball.h"
#include "tests/certified_shaft_cases.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using fast::Banded;
using fast::Normals;
using fast::Shaft;
using fast::ShaftPlane;
using scene::Ball;
using scene::Box;
using scene::Category;

/// The mutant that forgets the shortening: normals of length one and a bit, all the rest certified.
template <class F>
Shaft<F> with_unshortened_normals(Shaft<F> shaft) {
  for (ShaftPlane<F>& plane : shaft.planes()) {
    const double length = std::hypot(double(plane.n0), double(plane.n1));
    const double scale = (1 + double(fast::Rounding<F>::u)) / length;
    plane.n0 = static_cast<F>(double(plane.n0) * scale);
    plane.n1 = static_cast<F>(double(plane.n1) * scale);
    plane.d = -(plane.n0 * shaft.a.c[plane.far0] + plane.n1 * shaft.a.c[plane.far1]);
  }
  return shaft;
}

template <class F>
Shaft<F> without_thresholds(Shaft<F> shaft) {
  for (ShaftPlane<F>& plane : shaft.planes()) plane.outside_threshold = plane.inside_threshold = 0;
  return shaft;
}

template <class F>
class CertifiedShaftBall : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(CertifiedShaftBall, Scalars);

TYPED_TEST(CertifiedShaftBall, NeverUnsoundAndWastesWithinTheStatedGap) {
  using F = TypeParam;
  CaseGenerator<F> generator(61, kHardNumbers);
  std::vector<scene::ShaftBallCaseOf<F>> cases;
  std::vector<scene::ShaftBallCase> wide;
  for (int i = 0; i < (sizeof(F) == 4 ? 150000 : 100000); ++i) {
    cases.push_back(hard_ball_case(generator));
    wide.push_back(as_double(cases.back()));
    if (!scene::is_valid(cases.back().t)) {
      cases.pop_back();
      wide.pop_back();
    }
  }
  std::vector<exact::ShaftBallReference> references(wide.size());
  exact::refer(wide, references);

  Tally certified, naive, unshortened, bare, slack_gone;
  double largest_gap = 0;
  for (std::size_t i = 0; i < cases.size() && !this->HasFailure(); ++i) {
    const auto& [a, b, t] = cases[i];
    const Category truth = references[i].truth;
    const Shaft<F> shaft = fast::form_certified_ball_shaft(a, b);
    const Banded banded = fast::classify(shaft, t);
    certified.add(banded.answer, truth);
    certified.undecided += !banded.certain;
    EXPECT_EQ(certified.unsound(), 0) << text_of(wide[i]) << " " << truth;
    EXPECT_EQ(banded.certain, banded.answer != Category::overlap) << text_of(wide[i]);
    if (banded.answer == Category::overlap && references[i].planes != Category::overlap) {
      const double gap = static_cast<double>(shaft.stated_gap.at(t.radius));
      EXPECT_NE(exact::classify_grown(wide[i], gap), references[i].planes)
          << text_of(wide[i]) << " gap" << hex_text(gap);
      // How much of the stated gap is used: the wrong keep survives this share of the growth.
      for (double share = largest_gap + 0.01; i % 8 == 0 && share < 1; share += 0.01) {
        if (exact::classify_grown(wide[i], gap * share) != references[i].planes) break;
        largest_gap = share;
      }
    }
    naive.add(fast::classify(fast::form_shaft(a, b, Normals::unit), t).answer, truth);
    unshortened.add(fast::classify(with_unshortened_normals(shaft), t).answer, truth);
    bare.add(fast::classify(without_thresholds(shaft), t).answer, truth);
    Shaft<F> no_slack = shaft;
    no_slack.slack = {};
    slack_gone.add(fast::classify(no_slack, t).answer, truth);
  }
  for (const int count : certified.of_truth) EXPECT_GE(count, affordable(10000));
  certified.record("certified");
  naive.record("naive");
  unshortened.record("unshortened");
  bare.record("without_thresholds");
  slack_gone.record("without_slack");
  this->RecordProperty("largest_share_of_the_stated_gap", std::to_string(largest_gap));
  EXPECT_GT(certified.wastes, 0);
  // The same cases catch every part of the certificate that is left out.
  EXPECT_GT(naive.false_culls, affordable(100));
  EXPECT_GT(naive.false_insides, affordable(100));
  EXPECT_GT(unshortened.false_culls, 0);
  EXPECT_GT(bare.false_culls, 0);
  EXPECT_GT(bare.false_insides, 0);
  EXPECT_GT(slack_gone.false_culls, 0);
  EXPECT_GT(slack_gone.false_insides, 0);
  EXPECT_GT(largest_gap, 0.1);
}

/// Normals are at most 1 - 5 u long and not much shorter: checked on exact squares.
TYPED_TEST(CertifiedShaftBall, NormalsAreShortenedByFiveToFifteenRoundoffs) {
  using F = TypeParam;
  CaseGenerator<F> generator(62, kHardNumbers);
  const mpq_class u(static_cast<double>(fast::Rounding<F>::u));
  const mpq_class longest = 1 - 5 * u, shortest = 1 - 15 * u;
  double largest = -100;
  int planes = 0;
  for (int i = 0; i < affordable(30000) && !this->HasFailure(); ++i) {
    Box<F> a, b;
    generator.boxes(a, b);
    const Shaft<F> shaft = fast::form_certified_ball_shaft(a, b);
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      if (std::isinf(plane.outside_threshold)) continue;
      ++planes;
      const mpq_class n0(static_cast<double>(plane.n0)), n1(static_cast<double>(plane.n1));
      const mpq_class square = n0 * n0 + n1 * n1;
      EXPECT_LE(square, longest * longest) << text_of(a) << text_of(b);
      EXPECT_GE(square, shortest * shortest) << text_of(a) << text_of(b);
      largest = std::max(largest, mpq_class((square - 1) / u / 2).get_d());
    }
  }
  EXPECT_GT(planes, affordable(30000));
  this->RecordProperty("longest_normal_in_roundoffs_above_1", std::to_string(largest));
  EXPECT_GT(largest, -8);  // some are close to the bound: shortening is not overdone
}

/// Both slacks are needed in full measure and no more: squares within 5 u of touching, sides within an ulp.
TYPED_TEST(CertifiedShaftBall, SlacksArePaidByRoundingAlone) {
  using F = TypeParam;
  const Box<F> a{{0, 0, 0, 8, 8, 8}}, b{{1, 1, 1, 7, 7, 7}};  // no planes
  const Shaft<F> shaft = fast::form_certified_ball_shaft(a, b);
  const F u = fast::Rounding<F>::u;
  EXPECT_EQ(shaft.slack.square_factor, 1 + 10 * u);
  EXPECT_EQ(shaft.slack.inside_factor, 1 + 4 * u);
  const auto answer = [&](F x, F r) { return fast::classify(shaft, Ball<F>{{x, 4, 4}, r}).answer; };
  EXPECT_EQ(answer(13, 5), Category::overlap);
  EXPECT_EQ(answer(13, F(5) * (1 - 4 * u)), Category::overlap);
  EXPECT_EQ(answer(13, F(5) * (1 - 16 * u)), Category::outside);
  EXPECT_EQ(answer(4, 4), Category::overlap);  // inside, but not by the slack
  EXPECT_EQ(answer(4, F(4) * (1 - 8 * u)), Category::inside);
}

/// Where squares underflow, rounding alone can double a sum of three: the offset pays for it.
TYPED_TEST(CertifiedShaftBall, UnderflowingSquaresCullNothing) {
  using F = TypeParam;
  const long double ulp = std::numeric_limits<F>::denorm_min();
  const F x = static_cast<F>(std::sqrt(0.55L * ulp)), r = static_cast<F>(std::sqrt(1.9L * ulp));
  const Box<F> box{{-1, -1, -1, 0, 0, 0}};
  const scene::ShaftBallCaseOf<F> c{box, box, {{x, x, x}, r}};  // d^2 = 1.65 ulp, computed as 3; r^2 as 2
  ASSERT_EQ(exact::classify(as_double(c)), Category::overlap);
  EXPECT_EQ(fast::classify(fast::form_certified_ball_shaft(box, box), c.t).answer, Category::overlap);
  EXPECT_EQ(fast::classify(fast::form_shaft(box, box, Normals::unit), c.t).answer, Category::outside);
}

/// Above the largest safe radius only what the extent box culls is culled, and nothing is inside.
TYPED_TEST(CertifiedShaftBall, HugeRadii) {
  using F = TypeParam;
  const F most = std::numeric_limits<F>::max();
  const Box<F> a{{0, 0, 0, 1, 1, 1}}, b{{4, 4, 0, 5, 5, 1}};
  const Shaft<F> shaft = fast::form_certified_ball_shaft(a, b);
  EXPECT_EQ(shaft.slack.largest_radius, most / 256);
  for (const F r : {most, most / 2, most / 255, std::sqrt(most) * 2}) {
    const Ball<F> t{{4, 1, 0}, r};
    EXPECT_EQ(fast::classify(shaft, t).answer, Category::overlap);
    EXPECT_FALSE(fast::classify(shaft, t).certain);
    EXPECT_TRUE(std::isinf(shaft.stated_gap.at(r)));
  }
  EXPECT_TRUE(std::isfinite(shaft.stated_gap.at(std::sqrt(most) / 4)));
  // Far beyond a plane, where squares overflow and so cull nothing: the plane decides up to the largest
  // radius.
  const std::array<F, 3> beyond{most / 32, -most / 32, 0};
  EXPECT_EQ(fast::classify(shaft, Ball<F>{beyond, most / 256}).answer, Category::outside);
  EXPECT_EQ(fast::classify(shaft, Ball<F>{beyond, most / 128}).answer, Category::overlap);
  const Shaft<F> far =
      fast::form_certified_ball_shaft<F>({{-most, 0, 0, most / 2, 1, 1}}, {{0, 2, 0, most, 4, 1}});
  ASSERT_GT(far.plane_count, 0);
  EXPECT_TRUE(std::isinf(far.stated_gap.at(F(1))));
  for (const ShaftPlane<F>& plane : far.planes()) EXPECT_TRUE(std::isinf(plane.outside_threshold));
}

/// One kernel: on naive data, normals and slacks included, the certified test is the naive one.
TYPED_TEST(CertifiedShaftBall, KernelOnResetDataIsTheNaiveTest) {
  using F = TypeParam;
  Banded (*const kernel)(const Shaft<F>&, const Ball<F>&) = &fast::classify<F>;
  CaseGenerator<F> generator(63, kHardNumbers);
  int differ = 0;
  for (int i = 0; i < affordable(50000) && !this->HasFailure(); ++i) {
    const auto [a, b, t] = hard_ball_case(generator);
    const Shaft<F> naive = fast::form_shaft(a, b, Normals::unit);
    Shaft<F> shaft = fast::form_certified_ball_shaft(a, b);
    const Banded before = kernel(shaft, t);
    ASSERT_EQ(shaft.plane_count, naive.plane_count);
    for (std::size_t k = 0; k < shaft.plane_count; ++k) {
      ShaftPlane<F>& plane = shaft.plane_set[k];
      plane.n0 = naive.plane_set[k].n0;
      plane.n1 = naive.plane_set[k].n1;
      plane.d = naive.plane_set[k].d;
      plane.outside_threshold = plane.inside_threshold = 0;
    }
    shaft.slack = {};
    const Banded reset = kernel(shaft, t), expected = kernel(naive, t);
    EXPECT_EQ(reset.answer, expected.answer) << text_of(scene::ShaftBallCaseOf<F>{a, b, t});
    EXPECT_EQ(reset.certain, expected.certain) << text_of(scene::ShaftBallCaseOf<F>{a, b, t});
    differ += before.answer != expected.answer;
  }
  EXPECT_GT(differ, 0);
}

}  // namespace
}  // namespace gnomon::tests
