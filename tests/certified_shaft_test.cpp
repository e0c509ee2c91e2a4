// SPDX-License-Identifier: GPL-3.0-or-later
// The thresholds of certified box shafts from both sides: never too small, not much too big.
#include "fast/certified_shaft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "exact/shaft_box.h"
#include "fast/shaft_box.h"
#include "tests/certified_shaft_cases.h"
#include "tests/shaft_text.h"

namespace gnomon::tests {
namespace {

using fast::Banded;
using fast::Normals;
using fast::Shaft;
using fast::ShaftPlane;
using scene::Box;
using scene::Category;

template <class F>
class CertifiedShaft : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(CertifiedShaft, Scalars);

TYPED_TEST(CertifiedShaft, BoxesAreNeverUnsoundAndWasteWithinTheStatedGap) {
  using F = TypeParam;
  CaseGenerator<F> generator(51, kHardNumbers);
  std::vector<scene::ShaftBoxCaseOf<F>> cases;
  std::vector<scene::ShaftBoxCase> wide;
  for (int i = 0; i < (sizeof(F) == 4 ? 400000 : 200000); ++i) {
    cases.push_back(hard_box_case(generator));
    wide.push_back(as_double(cases.back()));
  }
  std::vector<exact::ShaftBoxReference> references(wide.size());
  exact::refer(wide, references);

  Tally certified, naive;
  double largest_gap = 0;
  for (std::size_t i = 0; i < cases.size() && !this->HasFailure(); ++i) {
    const auto& [a, b, t] = cases[i];
    const Category truth = references[i].truth;
    const Shaft<F> shaft = fast::form_certified_box_shaft(a, b);
    const Banded banded = fast::classify(shaft, t);
    certified.add(banded.answer, truth);
    certified.undecided += !banded.certain;
    EXPECT_EQ(certified.unsound(), 0) << text_of(wide[i]) << " " << truth;
    if (banded.certain || banded.answer != Category::overlap) {
      EXPECT_EQ(banded.answer, truth) << text_of(wide[i]);
    }
    if (banded.answer != truth) {
      const double gap = static_cast<double>(shaft.stated_gap.at(F(0)));
      EXPECT_NE(exact::classify_grown(wide[i], gap), truth) << text_of(wide[i]) << " gap" << hex_text(gap);
      if (i % 4 == 0 && truth == Category::outside) {
        largest_gap = std::max(largest_gap, exact::gap(wide[i], exact::Boundary::outside).get_d() / gap);
      }
    }
    const Category of_naive = fast::classify(fast::form_shaft(a, b, Normals::as_formed), t).answer;
    naive.add(of_naive, truth);
  }
  for (const int count : certified.of_truth) EXPECT_GE(count, affordable(10000));
  certified.record("certified");
  naive.record("naive");
  // The same cases catch thresholds that are missing.
  EXPECT_GT(naive.false_culls, affordable(100));
  EXPECT_GT(naive.false_insides, affordable(100));
  this->RecordProperty("largest_share_of_the_stated_gap", std::to_string(largest_gap));
  EXPECT_GT(largest_gap, 0.4);  // nor is the stated gap much too big
  EXPECT_GT(certified.wastes, 0);
  EXPECT_GT(certified.undecided, 0);
}

/// One kernel for both tiers: on the naive data it is the naive test, bit for bit.
TYPED_TEST(CertifiedShaft, BoxKernelOnResetDataIsTheNaiveTest) {
  using F = TypeParam;
  Banded (*const kernel)(const Shaft<F>&, const Box<F>&) = &fast::classify<F>;
  CaseGenerator<F> generator(53, kHardNumbers);
  int differ = 0;
  for (int i = 0; i < affordable(50000) && !this->HasFailure(); ++i) {
    const auto [a, b, t] = hard_box_case(generator);
    Shaft<F> shaft = fast::form_certified_box_shaft(a, b);
    const Shaft<F> naive = fast::form_shaft(a, b, Normals::as_formed);
    const Banded before = kernel(shaft, t);
    for (ShaftPlane<F>& plane : shaft.planes()) plane.outside_threshold = plane.inside_threshold = 0;
    const Banded reset = kernel(shaft, t), expected = kernel(naive, t);
    EXPECT_EQ(reset.answer, expected.answer) << text_of(scene::ShaftBoxCaseOf<F>{a, b, t});
    EXPECT_EQ(reset.certain, expected.certain) << text_of(scene::ShaftBoxCaseOf<F>{a, b, t});
    differ += before.answer != expected.answer;
  }
  EXPECT_GT(differ, 0);
}

/// A plane whose evaluation could overflow decides nothing, and the stated gap says so.
TYPED_TEST(CertifiedShaft, OverflowingPlanesAreDisarmed) {
  using F = TypeParam;
  const F most = std::numeric_limits<F>::max(), root = std::sqrt(most) / 4;
  for (const F size : {most, most / 16, root * 16}) {
    const Box<F> a{{-size, 0, 0, -size / 2, size / 2, 0}}, b{{size / 2, 0, 0, size, size, 0}};
    const Shaft<F> shaft = fast::form_certified_box_shaft(a, b);
    ASSERT_GT(shaft.plane_count, 0);
    for (const ShaftPlane<F>& plane : shaft.planes()) {
      EXPECT_TRUE(std::isinf(plane.outside_threshold));
      EXPECT_TRUE(std::isnan(plane.inside_threshold));
    }
    EXPECT_TRUE(std::isinf(shaft.stated_gap.at(F(0))));
    const Box<F> beyond{{-size, size, 0, -size, size, 0}};
    EXPECT_EQ(fast::classify(shaft, beyond).answer, Category::overlap);
    EXPECT_FALSE(fast::classify(shaft, beyond).certain);
  }
  // Well below the largest number nothing is disarmed.
  const Box<F> a{{-root / 64, 0, 0, -root / 128, root / 128, 0}},
      b{{root / 128, 0, 0, root / 64, root / 64, 0}};
  const Shaft<F> shaft = fast::form_certified_box_shaft(a, b);
  for (const ShaftPlane<F>& plane : shaft.planes()) {
    EXPECT_TRUE(std::isfinite(plane.outside_threshold));
  }
}

}  // namespace
}  // namespace gnomon::tests
