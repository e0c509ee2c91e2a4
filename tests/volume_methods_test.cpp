// SPDX-License-Identifier: GPL-3.0-or-later
// The methods for slab sets, oriented boxes and ellipsoids: their promises, their error bounds from both
// sides, their rows, cases and witnesses.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "fast/shaft_ellipsoid.h"
#include "fast/shaft_oriented_box.h"
#include "fast/shaft_spanned_inl.h"
#include "fuzz/campaign.h"
#include "fuzz/replay.h"
#include "fuzz/volume_questions.h"
#include "fuzz/witness.h"
#include "reports/explain.h"
#include "scene/input_error.h"
#include "tests/shaft_random.h"
#include "tests/volume_definition.h"

namespace gnomon::tests {
namespace {

using fuzz::Fault;
using fuzz::RowResult;
using fuzz::Verdict;

template <class Q>
class VolumeMethods : public testing::Test {};
using Questions =
    testing::Types<fuzz::ShaftSlabsQuestion, fuzz::ShaftOrientedBoxQuestion, fuzz::ShaftEllipsoidQuestion>;
TYPED_TEST_SUITE(VolumeMethods, Questions);

/// A small campaign over everything: promises, thresholds, domains and the shares of truths.
TYPED_TEST(VolumeMethods, KeepTheirPromises) {
  using Q = TypeParam;
  fuzz::CampaignOptions options;
  options.seed = 7;
  options.trials = Q::id == fuzz::ShaftOrientedBoxQuestion::id ? 600 : 200;
  options.witnesses_per_row = 0;
  const fuzz::CampaignResult result = fuzz::run_campaign<Q>(options);
  std::uint64_t checked = 0, naive_unsound = 0;
  std::array<std::uint64_t, 3> truths{};
  for (const RowResult& row : result.rows) {
    SCOPED_TRACE(row.method + " " + row.distribution + " " + row.scalar);
    EXPECT_FALSE(row.promise_broken());
    EXPECT_EQ(row.count(Verdict::rejected), 0u);
    EXPECT_EQ(row.count(Verdict::undecided), 0u);
    EXPECT_EQ(row.threshold_exceeded, 0u);
    checked += row.threshold_checked;
    if (row.tier == "naive") naive_unsound += row.count(Verdict::unsound);
    if (row.method == "separating-all-f32" || row.method == "separating-all-f64" || row.tier == "exact") {
      EXPECT_EQ(row.model + row.rounding_and_model, 0u);
    }
    // Integers of one digit: doubles make no rounding errors, so that what is wrong is the model's.
    const bool polytope = Q::id != fuzz::ShaftEllipsoidQuestion::id;
    if (polytope && row.tier == "naive" && row.distribution == "integer-grid") {
      EXPECT_EQ(row.rounding + row.rounding_and_model, 0u);
    }
    for (std::size_t truth = 0; truth < 3 && row.method == "exact"; ++truth)
      truths[truth] += row.truths(truth);
  }
  EXPECT_GT(checked, 200u);
  EXPECT_GT(naive_unsound, 10u);
  for (const std::uint64_t count : truths) EXPECT_GT(count, options.trials);  // of about twenty times as many
}

/// A slab set's bound along a diagonal may be looser than what its other slabs leave: the test takes the
/// range of the set, as its exact twin does. Rare: two of 20000 cases tell.
TEST(SlabMethods, DiagonalsTakeTheRangeOfTheSet) {
  fuzz::CampaignOptions options;
  options.seed = 1;
  options.trials = static_cast<std::uint64_t>(affordable(20000));
  options.witnesses_per_row = 0;
  options.methods = {"naive-f32"};
  options.distributions = {"integer-grid"};
  const fuzz::CampaignResult result = fuzz::run_campaign<fuzz::ShaftSlabsQuestion>(options);
  ASSERT_EQ(result.rows.size(), 1u);
  EXPECT_EQ(result.rows[0].rounding + result.rows[0].rounding_and_model, 0u);
}

TYPED_TEST(VolumeMethods, CasesAreTheirNumbers) {
  using Q = TypeParam;
  for (const fuzz::Distribution& distribution : fuzz::distributions()) {
    if (distribution.needs_argument) continue;
    const auto generator = fuzz::make_generator<typename Q::Case>({&distribution, ""}, scene::Scalar::f32);
    for (std::uint64_t i = 0; i < 40; ++i) {
      fuzz::CaseRandom random(3, 4, i);
      const typename Q::Case c = generator->make(random);
      EXPECT_FALSE(fuzz::objection(c)) << distribution.name << i;
      EXPECT_TRUE(fuzz::is_single(c)) << distribution.name;
      const std::vector<double> numbers = fuzz::numbers_of(c);
      ASSERT_EQ(numbers.size(), Q::number_count);
      EXPECT_EQ(fuzz::case_of<typename Q::Case>(numbers), c);
      for (std::size_t n = 0; n < numbers.size(); ++n) {
        std::vector<double> bad = numbers;
        bad[n] = std::numeric_limits<double>::quiet_NaN();
        EXPECT_TRUE(fuzz::objection(fuzz::case_of<typename Q::Case>(bad))) << n;
        bad[n] = HUGE_VAL;
        EXPECT_TRUE(fuzz::objection(fuzz::case_of<typename Q::Case>(bad))) << n;
      }
    }
  }
}

TYPED_TEST(VolumeMethods, CasesShareTheirShafts) {
  using Q = TypeParam;
  for (const char* name : {"uniform", "near-touch", "integer-grid"}) {
    const auto generator =
        fuzz::make_generator<typename Q::Case>(fuzz::parse_distribution(name), scene::Scalar::f32);
    fuzz::CaseRandom first(3, 4, 8, 4), second(3, 4, 9, 4);
    const typename Q::Case c = generator->make(first), d = generator->make(second);
    EXPECT_EQ(c.a, d.a);
    EXPECT_EQ(c.b, d.b);
    EXPECT_FALSE(c.t == d.t);
  }
}

/// Witnesses are shrunk, replayed with the same answers, and told in words.
TYPED_TEST(VolumeMethods, WitnessesReplay) {
  using Q = TypeParam;
  fuzz::CampaignOptions options;
  options.trials = 150;
  options.methods = {"naive-f32"};
  options.distributions = {"offset"};
  const fuzz::CampaignResult result = fuzz::run_campaign<Q>(options);
  ASSERT_EQ(result.rows.size(), 1u);
  ASSERT_FALSE(result.rows[0].witnesses.empty());
  for (const fuzz::Witness& witness : result.rows[0].witnesses) {
    EXPECT_LE(witness.case_text.size(), witness.original_text.size());
    std::istringstream in(fuzz::witness_text(witness));
    const std::vector<scene::CorpusLine> lines = scene::read_corpus(in, "w.txt");
    ASSERT_EQ(lines.size(), 1u);
    const fuzz::ReplayResult again = fuzz::replay(lines, {"naive-f32", "exact"});
    ASSERT_EQ(again.lines.size(), 2u);
    EXPECT_TRUE(again.wrong_answers.empty());
    EXPECT_EQ(again.lines[0].answer, witness.answer);
    EXPECT_EQ(again.lines[1].answer, witness.reference);
    const std::string words = reports::explain(lines[0], nullptr);
    for (const char* part : {"gap to outside", "gap to inside", "The methods say", "Pictures are drawn of"}) {
      EXPECT_NE(words.find(part), std::string::npos) << part;
    }
    EXPECT_THROW((void)reports::explain_svg(lines[0]), scene::InputError);
  }
}

TEST(VolumeCases, AnEmptySlabSetIsBadInput) {
  std::istringstream in("\nshaft-slabs 0 0 0 1 1 1 4 0 0 5 1 1  5 1 1 8 -3 -5 5  5 1 1 8 -3 -5 5\n");
  try {
    (void)fuzz::replay(scene::read_corpus(in, "c.txt"), {"exact"});
    FAIL() << "an empty slab set passed";
  } catch (const scene::InputError& error) {
    EXPECT_STREQ(error.what(),
                 "c.txt:2: expected a slab set with a point in all seven slabs, found none in this case");
  }
}

TEST(VolumeCases, NamedOnesHaveTheirAnswers) {
  const auto lines = scene::read_corpus(std::string(GNOMON_SOURCE_DIR) + "/tests/corpus/volumes.txt");
  const fuzz::ReplayResult result = fuzz::replay(lines, {});
  EXPECT_GE(result.stated, 29u);
  EXPECT_EQ(result.stated, result.cases);
  EXPECT_TRUE(result.wrong_answers.empty());
  EXPECT_FALSE(result.promise_broken());
}

/// A plane of the shaft in rationals, times the power of two of its rounded form.
struct ExactPlane {
  PointQ n;
  Q d, base;  ///< base: sum |N_j a_j|
};

template <class F>
ExactPlane exact_plane(const fast::SupportShaft<F>& shaft, std::size_t i) {
  const fast::SupportPlane<F>& plane = shaft.planes()[i];
  ExactPlane exact{{Q(plane.n[0]), Q(plane.n[1]), Q(plane.n[2])}, Q(plane.d), abs(Q(plane.d))};
  if (i < 6) return exact;  // sides are exact
  const fast::Shaft<F> formed = fast::form_shaft(shaft.a, shaft.b, fast::Normals::as_formed);
  const fast::ShaftPlane<F>& p = formed.planes()[i - 6];
  const auto f = static_cast<std::size_t>(p.far0 % 3), g = static_cast<std::size_t>(p.far1 % 3);
  const Q scale = p.n0 != 0 ? Q(plane.n[f]) / Q(p.n0) : Q(plane.n[g]) / Q(p.n1);
  const Q run0 = Q(shaft.b.c[p.far1]) - Q(shaft.a.c[p.far1]),
          run1 = Q(shaft.a.c[p.far0]) - Q(shaft.b.c[p.far0]);
  exact.n[f] = scale * abs(run0) * (p.far0 < 3 ? -1 : 1);
  exact.n[g] = scale * abs(run1) * (p.far1 < 3 ? -1 : 1);
  exact.d = -(exact.n[f] * Q(shaft.a.c[p.far0]) + exact.n[g] * Q(shaft.a.c[p.far1]));
  exact.base = abs(exact.n[f] * Q(shaft.a.c[p.far0])) + abs(exact.n[g] * Q(shaft.a.c[p.far1]));
  return exact;
}

/// Rounded near and far values against 512 bits: always within the error that is taken off, which is at
/// most 7.01 u of the magnitudes and used up by a fifth at least somewhere.
template <class Question, class Reach, class F>
void expect_bounds(const char* distribution, double least_share) {
  const auto generator = fuzz::make_generator<typename Question::Case>(
      fuzz::parse_distribution(distribution), sizeof(F) == 4 ? scene::Scalar::f32 : scene::Scalar::f64);
  double share = 0;
  for (std::uint64_t i = 0; i < 400 && !testing::Test::HasFailure(); ++i) {
    fuzz::CaseRandom random(17, 18, i);
    const auto c = scene::converted<F>(generator->make(random));
    const fast::SupportShaft<F> shaft = fast::form_support_shaft(c.a, c.b);
    for (std::size_t p = 0; p < shaft.plane_count; ++p) {
      const fast::SupportPlane<F>& plane = shaft.planes()[p];
      const F value = fast::dot(plane.n, c.t.centre) + plane.d;
      const F reach = Reach::of(fast::dot(plane.n, c.t.axes[0]), fast::dot(plane.n, c.t.axes[1]),
                                fast::dot(plane.n, c.t.axes[2]));
      const F error = fast::error_of<Reach>(plane, fast::magnitudes_of(c.t));
      ASSERT_TRUE(std::isfinite(error));
      const ExactPlane exact = exact_plane(shaft, p);
      const auto along = [&](const std::array<F, 3>& v) {
        return Q(exact.n[0] * Q(v[0]) + exact.n[1] * Q(v[1]) + exact.n[2] * Q(v[2]));
      };
      constexpr unsigned kBits = 512;
      mpf_class reached(0, kBits);
      Q squares = 0, magnitudes = exact.base;
      for (const auto& u : c.t.axes) {
        reached += mpf_class(abs(along(u)), kBits);
        squares += along(u) * along(u);
      }
      if (std::is_same_v<Reach, fast::EllipsoidReach>) reached = sqrt(mpf_class(squares, kBits));
      for (std::size_t j = 0; j < 3; ++j) {
        Q sum = abs(Q(c.t.centre[j]));
        for (const auto& u : c.t.axes) sum += abs(Q(u[j]));
        magnitudes += abs(exact.n[j]) * sum;
      }
      const mpf_class middle(Q(along(c.t.centre) + exact.d), kBits);
      const mpf_class near(middle - reached, kBits), far(middle + reached, kBits);
      const mpf_class wrong_near = abs(mpf_class(near - mpf_class(value - reach, kBits), kBits)),
                      wrong_far = abs(mpf_class(far - mpf_class(value + reach, kBits), kBits));
      EXPECT_LE(wrong_near, mpf_class(error, kBits));
      EXPECT_LE(wrong_far, mpf_class(error, kBits));
      const Q whole = Q(fast::Rounding<F>::u) * magnitudes;
      EXPECT_LE(Q(error), Q(7.01) * whole + 2 * Q(Reach::template kTiny<F>));
      EXPECT_GE(Q(error), Q(6.5002) * whole);
      if (whole > 0) share = std::max(share, mpf_class(wrong_near / mpf_class(whole, kBits)).get_d());
    }
  }
  EXPECT_GE(share, least_share);  // in units of u, of which the bound has 7
  if (least_share > 0) {
    EXPECT_LE(share, 6.5002);  // of denormals underflow takes more
  }
}

TEST(VolumeBounds, OrientedBoxes) {
  expect_bounds<fuzz::ShaftOrientedBoxQuestion, fast::BoxReach, float>("uniform", 1.4);
  expect_bounds<fuzz::ShaftOrientedBoxQuestion, fast::BoxReach, double>("offset", 1.4);
  expect_bounds<fuzz::ShaftOrientedBoxQuestion, fast::BoxReach, float>("mixed-magnitude", 1);
  expect_bounds<fuzz::ShaftOrientedBoxQuestion, fast::BoxReach, float>("denormal", 0);
}

TEST(VolumeBounds, Ellipsoids) {
  expect_bounds<fuzz::ShaftEllipsoidQuestion, fast::EllipsoidReach, float>("uniform", 1.4);
  expect_bounds<fuzz::ShaftEllipsoidQuestion, fast::EllipsoidReach, double>("offset", 1.4);
}

}  // namespace
}  // namespace gnomon::tests
