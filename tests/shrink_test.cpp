// SPDX-License-Identifier: GPL-3.0-or-later
// Shrinking keeps what it shows, and witnesses replay to the fault that they were made of.
#include "fuzz/shrink.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <sstream>

#include "fuzz/campaign.h"
#include "fuzz/replay.h"
#include "fuzz/witness.h"
#include "scene/corpus.h"

namespace gnomon::fuzz {
namespace {

using scene::Scalar;

int axis_of_three(std::size_t i) {
  return static_cast<int>(i % 3);
}

/// Numbers of every size that rc makes poorly: bits of a unit, an exponent, a sign.
rc::Gen<double> any_number() {
  return rc::gen::apply(
      [](std::uint32_t bits, int exponent, bool negative) {
        const double x = std::ldexp(static_cast<double>(bits >> 8), exponent - 24);
        return negative ? -x : x;
      },
      rc::gen::arbitrary<std::uint32_t>(), rc::gen::inRange(-40, 40), rc::gen::arbitrary<bool>());
}

TEST(Complexity, OrdersNumbersAsAReaderWould) {
  const auto of = [](double x) { return complexity({x}); };
  EXPECT_EQ(complexity({}), 0);
  EXPECT_EQ(of(0), 0);
  EXPECT_EQ(of(-0.0), 0);
  EXPECT_LT(of(0), of(1));
  EXPECT_LT(of(1), of(2));   // one bit each, a smaller exponent
  EXPECT_LT(of(1), of(-1));  // a sign costs
  EXPECT_LT(of(-1), of(3));
  EXPECT_LT(of(3), of(5));
  EXPECT_LT(of(0.5), of(0.1));
  EXPECT_LT(of(1024), of(1023));
  EXPECT_LT(of(1), of(std::nextafter(1, 2)));
  EXPECT_DOUBLE_EQ(complexity({3, -5, 0.25}), of(3) + of(-5) + of(0.25));
}

RC_GTEST_PROP(Shrink, KeepsTheFailureAndNeverGrows, ()) {
  const std::vector<double> numbers = *rc::gen::container<std::vector<double>>(6, any_number());
  const double least = *any_number();
  const Scalar scalar = *rc::gen::element(Scalar::f32, Scalar::f64);
  int asked = 0;
  const StillFails fails = [&](const std::vector<double>& x) {
    ++asked;
    return x[0] - x[3] >= numbers[0] - numbers[3] - std::fabs(least) && x[4] <= numbers[4];
  };
  const std::vector<double> small = shrink(numbers, scalar, axis_of_three, fails);
  const int first = asked;
  RC_ASSERT(small.size() == numbers.size());
  RC_ASSERT(fails(small));
  RC_ASSERT(complexity(small) <= complexity(numbers));
  RC_ASSERT(shrink(numbers, scalar, axis_of_three, fails) == small);
  RC_ASSERT(asked == 2 * first + 1);  // deterministic to the last question
  if (scalar == Scalar::f32) {
    for (const double x : small) RC_ASSERT(scene::is_float(x));
  }
}

RC_GTEST_PROP(Shrink, AsksOnlyForSimplerFiniteCasesOfTheScalarWithinItsBudget, ()) {
  const std::vector<double> numbers = *rc::gen::container<std::vector<double>>(6, any_number());
  const int budget = *rc::gen::inRange(0, 200);
  const double complexity_before = complexity(numbers);
  int asked = 0;
  bool sane = true;
  const StillFails fails = [&](const std::vector<double>& x) {
    ++asked;
    for (const double value : x) sane &= std::isfinite(value) && scene::is_float(value);
    sane &= complexity(x) < complexity_before;
    return false;
  };
  RC_ASSERT(shrink(numbers, Scalar::f32, axis_of_three, fails, budget) == numbers);
  RC_ASSERT(sane);
  RC_ASSERT(asked <= budget);
}

TEST(Shrink, FindsTheObviousMinimum) {
  const std::vector<double> numbers{0.1, -17.3, 1e10, 5.25, 0.7, 12345.678};
  const auto at_least = [&](std::size_t i, double bound) {
    return shrink(numbers, Scalar::f64, axis_of_three,
                  [=](const std::vector<double>& x) { return x[i] > bound; });
  };
  EXPECT_EQ(at_least(5, 3.7), (std::vector<double>{0, 0, 0, 0, 0, 4}));
  EXPECT_EQ(at_least(3, 0), (std::vector<double>{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(at_least(0, -1), (std::vector<double>(6, 0)));
  const auto negative =
      shrink(numbers, Scalar::f64, axis_of_three, [](const std::vector<double>& x) { return x[1] < -2.5; });
  EXPECT_EQ(negative, (std::vector<double>{0, -4, 0, 0, 0, 0}));
  const auto ordered = shrink(numbers, Scalar::f64, axis_of_three,
                              [](const std::vector<double>& x) { return x[0] < x[3] && x[4] != x[1]; });
  // y - 1 and x + 1, or the like: two numbers of one bit.
  EXPECT_LE(complexity(ordered), 2 * complexity({1}) + 1);
}

TEST(Shrink, MovesAndScalesWholeAxes) {
  // Only the differences along x count, and their ratio: 1000.5 .. 1001.5 .. 1003.5.
  const std::vector<double> numbers{1000.5, 3, 0, 1001.5, 5, 0, 1003.5, 7, 0};
  const auto small = shrink(numbers, Scalar::f64, axis_of_three, [](const std::vector<double>& x) {
    return x[3] > x[0] && x[6] - x[3] == 2 * (x[3] - x[0]);
  });
  EXPECT_EQ(small[6] - small[3], 2 * (small[3] - small[0]));
  EXPECT_LE(complexity(small), complexity({0, 1, 3}));
  EXPECT_EQ(small[1] + small[2] + small[4] + small[5] + small[7] + small[8], 0);
}

TEST(Shrink, LeavesARadiusToItself) {
  // The last number is on no axis: a move of x must not take it along.
  const auto axis_of = [](std::size_t i) { return i == 3 ? -1 : static_cast<int>(i); };
  const auto small = shrink({100, 200, 300, 7}, Scalar::f64, axis_of,
                            [](const std::vector<double>& x) { return x[3] >= 6.5; });
  EXPECT_EQ(small, (std::vector<double>{0, 0, 0, 8}));
}

TEST(Shrink, HandlesTheEndsOfTheRange) {
  const double most = 0x1.fffffffffffffp+1023, least = 0x1p-1074;
  const auto large = shrink({most, -most, 0, most, most, 0}, Scalar::f64, axis_of_three,
                            [](const std::vector<double>& x) { return x[0] >= 0x1p1023; });
  EXPECT_GE(large[0], 0x1p1023);
  EXPECT_TRUE(std::isfinite(large[0]));
  EXPECT_EQ(complexity(large),
            complexity({large[0]}));  // the others are 0: moves beyond the range are refused
  const auto small = shrink({least, 3 * least, 0, 5 * least, 0, 0}, Scalar::f64, axis_of_three,
                            [](const std::vector<double>& x) { return x[3] > 0 && x[3] < 1e-300; });
  EXPECT_LE(complexity(small), complexity({0x1p-1072}));
  // Scaled down or rounded up, these would be floats no more.
  bool floats = true;
  const auto far_apart = shrink({0x1p100, 0x3p-149, 0, 0x1.fffffep+127, 0, 0}, Scalar::f32, axis_of_three,
                                [&floats](const std::vector<double>& x) {
                                  for (const double value : x) floats &= scene::is_float(value);
                                  return x[1] > 0 && x[0] > x[1] * 0x1p200 && x[3] > 0x1p+127;
                                });
  EXPECT_TRUE(floats);
  for (const double x : far_apart) EXPECT_TRUE(scene::is_float(x));
  EXPECT_EQ(shrink({}, Scalar::f64, axis_of_three, [](const auto&) { return true; }), std::vector<double>{});
}

/// Every witness of a campaign over the distributions that find most.
template <class Q>
void expect_witnesses_replay() {
  CampaignOptions options;
  options.trials = 3000;
  options.jobs = 2;
  options.witnesses_per_row = 3;
  options.distributions = {"near-touch", "offset", "degenerate", "huge"};
  std::size_t seen = 0, unsound = 0;
  for (const RowResult& row : run_campaign<Q>(options).rows) {
    for (const Witness& witness : row.witnesses) {
      ++seen;
      EXPECT_EQ(witness.question, Q::id);
      EXPECT_EQ(witness.method, row.method);
      EXPECT_EQ(witness.case_text.find('\n'), std::string::npos);
      EXPECT_EQ(
          witness.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-"),
          std::string::npos);
      EXPECT_NE(witness.name.front(), '.');
      EXPECT_TRUE(witness.name.ends_with(".txt"));

      std::istringstream in(witness_text(witness));
      const std::vector<scene::CorpusLine> lines = scene::read_corpus(in, "w");
      ASSERT_EQ(lines.size(), 1u) << witness_text(witness);
      EXPECT_EQ(lines[0].answer, witness.reference);
      const ReplayResult replayed = replay(lines, {witness.method});
      ASSERT_EQ(replayed.lines.size(), 1u);
      EXPECT_TRUE(replayed.wrong_answers.empty()) << witness.case_text;
      const ReplayLine& line = replayed.lines[0];
      EXPECT_EQ(line.answer, witness.answer) << witness.case_text;
      EXPECT_EQ(line.reference, witness.reference) << witness.case_text;
      const bool lies = witness.verdict == "false cull" || witness.verdict == "false inside";
      EXPECT_EQ(line.verdict, lies ? "unsound" : "waste") << witness.case_text;
      unsound += lies ? 1 : 0;
      EXPECT_EQ(witness.answer == "outside", witness.verdict == "false cull");
      EXPECT_EQ(witness.answer == "inside", witness.verdict == "false inside");

      // The case as generated shows the same fault, and is no simpler.
      std::istringstream original("\n" + witness.original_text);
      const scene::CorpusLine first = scene::read_corpus(original, "o").at(0);
      const ReplayLine before = replay({first}, {witness.method}).lines.at(0);
      EXPECT_EQ(before.answer, witness.answer) << witness.original_text;
      EXPECT_LE(complexity(lines[0].numbers(Q::number_count)), complexity(first.numbers(Q::number_count)));

      // A disagreement of the model stays one, and so does one of rounding.
      const Method<Q>& method = *choose_methods<Q>({witness.method}).at(0);
      const Scalar scalar = witness.scalar == "f32" ? Scalar::f32 : Scalar::f64;
      const auto by_model = [&](const scene::CorpusLine& l) {
        const Trial trial = try_case(method, scalar, case_of<typename Q::Case>(l.numbers(Q::number_count)));
        return static_cast<Answer>(trial.twin) == trial.answer;
      };
      EXPECT_EQ(by_model(lines[0]), by_model(first)) << witness.case_text;

      // The stated gap is the shrunk case's own, on the wrong side of the fault's boundary.
      const auto c = case_of<typename Q::Case>(lines[0].numbers(Q::number_count));
      const bool outer = witness.verdict == "false cull" || witness.verdict == "false keep";
      const exact::Boundary boundary = outer ? exact::Boundary::outside : exact::Boundary::inside;
      EXPECT_EQ(witness.gap, exact::gap(c, boundary));
      EXPECT_EQ(witness.gap > 0, witness.verdict == "false keep" || witness.verdict == "false inside");
      EXPECT_EQ(std::signbit(witness.gap_length), witness.gap < 0) << witness.case_text;
    }
  }
  EXPECT_GT(seen, 50u);
  EXPECT_GT(unsound, 10u);
}

TEST(Witness, OfBoxesReplaysToItsFault) {
  expect_witnesses_replay<ShaftBoxQuestion>();
}
TEST(Witness, OfBallsReplaysToItsFault) {
  expect_witnesses_replay<ShaftBallQuestion>();
}

TEST(Witness, ShrinksToSomethingThatFitsOneLine) {
  CampaignOptions options;
  options.trials = 20000;
  options.methods = {"naive-f32"};
  options.distributions = {"near-touch"};
  const std::vector<RowResult> rows = run_campaign<ShaftBoxQuestion>(options).rows;
  ASSERT_EQ(rows.size(), 1u);
  bool culled = false;
  for (const Witness& witness : rows[0].witnesses) {
    if (witness.verdict != "false cull") continue;
    culled = true;
    EXPECT_LE(witness.case_text.size(), 200u) << witness.case_text;
    EXPECT_LT(witness.case_text.size(), witness.original_text.size() * 3 / 4);
  }
  EXPECT_TRUE(culled);
}

TEST(Witness, NamesAreSafeWhateverTheDistribution) {
  Witness witness;
  witness.question = "shaft-box";
  witness.method = "naive-f32";
  witness.verdict = "false cull";
  witness.distribution = "mesh:../a b/\xc3\xa9*$(x).off";
  witness.scalar = "f32";
  witness.seed = 12;
  witness.trial = 345;
  EXPECT_EQ(witness_name(witness), "shaft-box.naive-f32.false-cull.mesh-..-a-b------x-.off.f32.12.345.txt");
}

}  // namespace
}  // namespace gnomon::fuzz
