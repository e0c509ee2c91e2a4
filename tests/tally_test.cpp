// SPDX-License-Identifier: GPL-3.0-or-later
// What a trial comes to: verdicts, faults, promises on made-up rows, tallies put together, rates.
#include "fuzz/tally.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "fuzz/campaign.h"
#include "fuzz/shaft_questions.h"
#include "fuzz/statistics.h"
#include "fuzz/witness.h"

namespace gnomon::fuzz {
namespace {

using scene::Category;

TEST(Verdicts, AreTheTableOfTheDesign) {
  constexpr Verdict a = Verdict::agree, w = Verdict::waste, u = Verdict::unsound, d = Verdict::undecided,
                    r = Verdict::rejected;
  constexpr Verdict expected[kTruths][kColumns] = {{a, w, u, d, r}, {u, a, u, d, r}, {u, w, a, d, r}};
  for (std::size_t truth = 0; truth < kTruths; ++truth) {
    for (std::size_t answer = 0; answer < kColumns; ++answer) {
      EXPECT_EQ(ShaftAnswers::judge(static_cast<Category>(truth), static_cast<Answer>(answer)),
                expected[truth][answer])
          << truth << " " << answer;
    }
  }
}

TEST(Verdicts, FaultsSayHowAndWhichBoundary) {
  using B = exact::Boundary;
  const struct {
    Category truth, answer;
    Fault fault;
    B boundary;
    const char* name;
  } rows[] = {{Category::outside, Category::overlap, Fault::false_keep, B::outside, "false keep"},
              {Category::outside, Category::inside, Fault::false_inside, B::inside, "false inside"},
              {Category::overlap, Category::outside, Fault::false_cull, B::outside, "false cull"},
              {Category::overlap, Category::inside, Fault::false_inside, B::inside, "false inside"},
              {Category::inside, Category::outside, Fault::false_cull, B::outside, "false cull"},
              {Category::inside, Category::overlap, Fault::missed_inside, B::inside, "missed inside"}};
  for (const auto& row : rows) {
    EXPECT_EQ(ShaftAnswers::fault(row.truth, static_cast<Answer>(row.answer)), row.fault);
    EXPECT_EQ(ShaftAnswers::boundary(row.fault), row.boundary);
    EXPECT_EQ(name_of(row.fault), row.name);
  }
}

TEST(Verdicts, AnswersHaveNames) {
  const char* const names[] = {"outside", "overlap", "inside", "undecided", "rejected"};
  for (Answer answer = 0; answer < kColumns; ++answer) EXPECT_EQ(answer_name(answer), names[answer]);
  for (std::size_t i = 0; i < kTruths; ++i) {
    EXPECT_EQ(ShaftAnswers::answers[i], answer_name(static_cast<Answer>(i)));
    EXPECT_EQ(ShaftAnswers::answers[i], name_of(static_cast<Category>(i)));
  }
}

/// A row with one trial of the given verdict.
RowResult row_with(Promise promise, std::size_t truth, Answer answer) {
  RowResult row;
  row.promise = name_of(promise);
  row.trials = 1000;
  row.matrix[0][0] = 500;
  row.matrix[1][1] = 300;
  row.matrix[2][2] = 199;
  ++row.matrix[truth][answer];
  return row;
}

// No broken method can be registered from outside, so the judgement is tested on rows as such a method would
// make.
TEST(Promises, AreBrokenByExactlyTheirVerdicts) {
  for (std::size_t truth = 0; truth < kTruths; ++truth) {
    for (Answer answer = 0; answer < kColumns; ++answer) {
      const Verdict verdict = ShaftAnswers::judge(static_cast<Category>(truth), answer);
      const std::string where = std::to_string(truth) + " answered " + std::string(answer_name(answer));
      const bool unsound = verdict == Verdict::unsound, undecided = verdict == Verdict::undecided;
      EXPECT_FALSE(row_with(Promise::none, truth, answer).promise_broken()) << where;
      EXPECT_EQ(row_with(Promise::never_unsound, truth, answer).promise_broken(), unsound || undecided)
          << where;
      EXPECT_EQ(row_with(Promise::always_agrees, truth, answer).promise_broken(),
                unsound || undecided || verdict == Verdict::waste)
          << where;
      // Outside of the stated domain a method may say that it can't tell; never a lie.
      for (const Promise promise : {Promise::never_unsound, Promise::always_agrees}) {
        RowResult row = row_with(promise, truth, answer);
        row.in_domain = false;
        EXPECT_EQ(row.promise_broken(),
                  unsound || (promise == Promise::always_agrees && verdict == Verdict::waste))
            << where;
      }
    }
  }
}

TEST(Promises, AThresholdThatDoesNotHoldBreaksAnyPromise) {
  for (const Promise promise : {Promise::none, Promise::never_unsound, Promise::always_agrees}) {
    RowResult row = row_with(promise, 0, 0);
    row.threshold_checked = 10;
    EXPECT_FALSE(row.promise_broken());
    row.threshold_exceeded = 1;
    EXPECT_TRUE(row.promise_broken());
  }
}

TEST(Promises, OneBrokenRowBreaksTheCampaign) {
  CampaignResult result;
  EXPECT_FALSE(result.promise_broken());
  result.rows = {row_with(Promise::always_agrees, 0, 0), row_with(Promise::never_unsound, 0, 1)};
  EXPECT_FALSE(result.promise_broken());
  result.rows.push_back(row_with(Promise::never_unsound, 1, 0));
  EXPECT_TRUE(result.promise_broken());
}

RC_GTEST_PROP(Tallies, LowestTrialsDoNotDependOnTheOrder, (std::vector<std::uint64_t> offered)) {
  const std::size_t keep = *rc::gen::inRange<std::size_t>(0, 5);
  std::sort(offered.begin(), offered.end());
  offered.erase(std::unique(offered.begin(), offered.end()), offered.end());  // trials are counted once
  std::vector<std::uint64_t> expected(
      offered.begin(), offered.begin() + static_cast<std::ptrdiff_t>(std::min(keep, offered.size())));
  for (int turn = 0; turn < 3; ++turn) {
    LowestTrials lowest;
    for (const std::uint64_t trial : offered) lowest.offer(trial, keep);
    RC_ASSERT(lowest.trials() == expected);
    const std::size_t by = offered.empty() ? 0 : *rc::gen::inRange<std::size_t>(0, offered.size());
    std::rotate(offered.begin(), offered.begin() + static_cast<std::ptrdiff_t>(by), offered.end());
    if (turn == 1) std::reverse(offered.begin(), offered.end());
  }
}

TEST(Tallies, TheLargestGapIsOneOfSizeAndTiesGoToTheLowerTrial) {
  const std::vector<std::pair<exact::Gap, std::uint64_t>> offers{{exact::Gap(1, 3), 9},
                                                                 {exact::Gap(-1, 2), 7},
                                                                 {exact::Gap(1, 2), 3},
                                                                 {exact::Gap(-1, 2), 5},
                                                                 {exact::Gap(0), 0}};
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  do {
    LargestGap largest;
    EXPECT_FALSE(largest.known());
    for (const std::size_t i : order) {
      // What the bound rules out must not be the largest.
      if (largest.may_exceed(std::fabs(offers[i].first.get_d())))
        largest.offer(offers[i].first, offers[i].second);
    }
    ASSERT_TRUE(largest.known());
    EXPECT_EQ(largest.gap(), exact::Gap(1, 2));
    EXPECT_EQ(largest.trial(), 3u);
  } while (std::next_permutation(order.begin(), order.end()));
}

// 1/3 is no double: a bound of just below it must still let 1/3 + tiny through, and one ulp below must not
// lose a tie.
TEST(Tallies, GapsThatRoundAlikeAreToldApartExactly) {
  const exact::Gap third(1, 3);
  const exact::Gap more = third + exact::Gap(mpz_class(1), mpz_class(1) << 200);
  LargestGap largest;
  largest.offer(third, 1);
  ASSERT_TRUE(largest.may_exceed(more.get_d()));
  largest.offer(more, 2);
  EXPECT_EQ(largest.trial(), 2u);
  largest.offer(third, 0);
  EXPECT_EQ(largest.trial(), 2u);
  EXPECT_FALSE(largest.may_exceed(0.25));
  EXPECT_TRUE(largest.may_exceed(HUGE_VAL));
}

Tally some_tally(std::uint64_t base) {
  Tally t;
  t.trials = base;
  for (std::size_t truth = 0; truth < kTruths; ++truth) {
    for (std::size_t answer = 0; answer < kColumns; ++answer)
      t.matrix[truth][answer] = base + 10 * truth + answer;
  }
  t.touching_outside = base + 1;
  t.touching_inside = base + 2;
  t.unsound_touching = base + 3;
  t.rounding = base + 4;
  t.model = base + 5;
  t.rounding_and_model = base + 6;
  t.threshold_checked = base + 7;
  t.threshold_exceeded = base + 8;
  t.ns = static_cast<double>(base);
  for (std::uint64_t fault = 0; fault < kFaults; ++fault) t.faults[fault].offer(base + fault, 2);
  t.largest.offer(exact::Gap(static_cast<unsigned long>(base)), base);
  return t;
}

TEST(Tallies, AddFieldByField) {
  Tally sum;
  for (const std::uint64_t base : {100u, 2000u, 30u}) sum.add(some_tally(base), 2);
  const std::uint64_t total = 2130;
  EXPECT_EQ(sum.trials, total);
  for (std::size_t truth = 0; truth < kTruths; ++truth) {
    for (std::size_t answer = 0; answer < kColumns; ++answer) {
      EXPECT_EQ(sum.matrix[truth][answer], total + 3 * (10 * truth + answer));
    }
  }
  const std::uint64_t counts[] = {
      sum.touching_outside,   sum.touching_inside,   sum.unsound_touching,  sum.rounding, sum.model,
      sum.rounding_and_model, sum.threshold_checked, sum.threshold_exceeded};
  for (std::uint64_t i = 0; i < 8; ++i) EXPECT_EQ(counts[i], total + 3 * (i + 1)) << i;
  EXPECT_EQ(sum.ns, 2130);
  for (std::uint64_t fault = 0; fault < kFaults; ++fault) {
    EXPECT_EQ(sum.faults[fault].trials(), (std::vector<std::uint64_t>{30 + fault, 100 + fault}));
  }
  EXPECT_EQ(sum.largest.trial(), 2000u);
}

// A beam [0, 5] x [0, 1]^2 and balls whose distances are plain numbers.
TEST(Gaps, AreToldAsLengths) {
  const auto length = [](double y, double radius, exact::Boundary boundary) {
    const scene::ShaftBallCase c{{{0, 0, 0, 1, 1, 1}}, {{4, 0, 0, 5, 1, 1}}, {{2.5, y, 0.5}, radius}};
    return gap_length(c, exact::gap(c, boundary), boundary);
  };
  using B = exact::Boundary;
  EXPECT_EQ(length(3, 0.5, B::outside), 1.5);
  EXPECT_EQ(length(3, 2, B::outside), 0);
  EXPECT_EQ(length(3, 2.25, B::outside), -0.25);
  EXPECT_EQ(length(0.5, 0.25, B::outside), -0.25);  // the centre lies within: d is 0
  EXPECT_EQ(length(0.5, 0, B::outside), 0);
  EXPECT_EQ(length(0.5, 0.375, B::inside), -0.125);
  EXPECT_EQ(length(0.5, 0.5, B::inside), 0);
  EXPECT_EQ(length(0.5, 100, B::inside), 99.5);
  EXPECT_EQ(length(3, 0.5, B::inside), 2.5);                  // two beyond the side and a radius
  EXPECT_EQ(length(0x1p1000, 0x1p999, B::outside), 0x1p999);  // whose squares no double holds
  const scene::ShaftBoxCase box{{{0, 0, 0, 1, 1, 1}}, {{4, 0, 0, 5, 1, 1}}, {{2, 1.5, 0, 3, 2, 1}}};
  EXPECT_EQ(gap_length(box, exact::gap(box, B::outside), B::outside), 0.5);
}

TEST(Gaps, EveryNumberHasAnUlp) {
  using scene::Scalar;
  EXPECT_EQ(scene::ulp_of(-1, Scalar::f32), 0x1p-23);
  EXPECT_EQ(scene::ulp_of(1, Scalar::f64), 0x1p-52);
  EXPECT_EQ(scene::ulp_of(0, Scalar::f32), 0x1p-149);
  EXPECT_EQ(scene::ulp_of(0, Scalar::f64), 0x1p-1074);
  EXPECT_EQ(scene::ulp_of(0x1.fffffep+127, Scalar::f32), 0x1p104);  // no neighbour above: that below counts
  EXPECT_EQ(scene::ulp_of(0x1.fffffffffffffp+1023, Scalar::f64), 0x1p971);
}

TEST(Rates, NoHitsHaveTheClosedFormBound) {
  for (const std::uint64_t n : {1u, 10u, 100u, 1000000u}) {
    const Rate rate = rate_of(0, n);
    EXPECT_EQ(rate.value, 0);
    EXPECT_EQ(rate.low95, 0);
    const double bound = -std::expm1(std::log(0.025) / static_cast<double>(n));
    EXPECT_NEAR(rate.high95, bound, 1e-9 * bound);
    const Rate all = rate_of(n, n);
    EXPECT_EQ(all.value, 1);
    EXPECT_EQ(all.high95, 1);
    EXPECT_NEAR(all.low95, 1 - bound, 1e-9);
  }
}

// As R's binom.test says them.
TEST(Rates, AgreeWithTheTables) {
  const struct {
    std::uint64_t hits, trials;
    double low, high;
  } rows[] = {{1, 10, 0.002528579, 0.4450161},
              {5, 10, 0.1870860, 0.8129140},
              {10, 100, 0.04900469, 0.1762226},
              {2, 20, 0.01234853, 0.3169827},
              {50, 100, 0.3983211, 0.6016789}};
  for (const auto& row : rows) {
    const Rate rate = rate_of(row.hits, row.trials);
    EXPECT_DOUBLE_EQ(rate.value, static_cast<double>(row.hits) / static_cast<double>(row.trials));
    EXPECT_NEAR(rate.low95, row.low, 1e-6) << row.hits << " of " << row.trials;
    EXPECT_NEAR(rate.high95, row.high, 1e-6) << row.hits << " of " << row.trials;
  }
}

TEST(Rates, OfNoTrialsKnowNothing) {
  const Rate rate = rate_of(0, 0);
  EXPECT_EQ(rate.value, 0);
  EXPECT_EQ(rate.low95, 0);
  EXPECT_EQ(rate.high95, 1);
}

RC_GTEST_PROP(Rates, HoldTheirValueBetweenTheirBounds, ()) {
  const std::uint64_t trials = *rc::gen::inRange<std::uint64_t>(1, 2000000);
  const std::uint64_t hits = *rc::gen::inRange<std::uint64_t>(0, trials + 1);
  const Rate rate = rate_of(hits, trials);
  RC_ASSERT(0 <= rate.low95 && rate.low95 <= rate.value && rate.value <= rate.high95 && rate.high95 <= 1);
}

}  // namespace
}  // namespace gnomon::fuzz
