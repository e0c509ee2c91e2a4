// SPDX-License-Identifier: GPL-3.0-or-later
// Distributions with @K, and the rows that need them: the batch kernels as methods.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "fuzz/campaign.h"
#include "fuzz/shaft_questions.h"
#include "fuzz/shapes.h"
#include "tests/shaft_random.h"

namespace gnomon::fuzz {
namespace {

using scene::Scalar;

template <class Q>
class SharedShafts : public testing::Test {};
using Questions = testing::Types<ShaftBoxQuestion, ShaftBallQuestion>;
TYPED_TEST_SUITE(SharedShafts, Questions);

std::vector<std::string> names_that_share() {
  std::vector<std::string> names{"offset:1e5", "integer-grid:64"};
  for (const Distribution& distribution : distributions()) {
    if (!distribution.needs_argument && distribution.shares_shafts) names.emplace_back(distribution.name);
  }
  return names;
}

template <class Case>
std::array<double, 12> shaft_of(const Case& c) {
  std::array<double, 12> numbers{};
  for (std::size_t i = 0; i < 6; ++i) {
    numbers[i] = c.a.c[i];
    numbers[i + 6] = c.b.c[i];
  }
  return numbers;
}

/// So many trials share each shaft, no more and no fewer, and their t differ.
template <class Case>
void expect_groups(const Generator<Case>& generator, const std::string& where) {
  constexpr std::uint64_t kPerShaft = 12, kShafts = 20;
  std::map<std::array<double, 12>, std::set<std::uint64_t>> groups;
  std::set<std::vector<double>> all;
  for (std::uint64_t trial = 0; trial < kPerShaft * kShafts; ++trial) {
    CaseRandom random(3, 4, trial, kPerShaft);
    const Case c = generator.make(random);
    EXPECT_FALSE(objection(c).has_value()) << where;
    groups[shaft_of(c)].insert(trial / kPerShaft);
    all.insert(numbers_of(c));
  }
  // Grids and small meshes have few shafts and boxes to draw from: some coincide by chance.
  EXPECT_GE(groups.size(), kShafts - 2) << where;
  EXPECT_LE(groups.size(), kShafts) << where;
  EXPECT_GE(all.size(), kPerShaft * kShafts * 2 / 3) << where;
}

}  // namespace

TYPED_TEST(SharedShafts, AreSharedBySoManyTrials) {
  using Case = typename TypeParam::Case;
  for (const std::string& name : names_that_share()) {
    for (const Scalar scalar : {Scalar::f32, Scalar::f64}) {
      const DistributionChoice choice = parse_distribution(name + "@12");
      EXPECT_EQ(choice.per_shaft, 12u);
      EXPECT_EQ(choice.label(), name + "@12");
      expect_groups(*make_generator<Case>(choice, scalar), name);
    }
  }
  const std::string file = testing::TempDir() + "soup@home" + std::to_string(::getpid()) + ".off";
  std::ofstream mesh(file);
  mesh << "OFF\n180 60 0\n";
  tests::Random random(5);
  for (int i = 0; i < 180; ++i) mesh << random.unit() << " " << random.unit() << " " << random.unit() << "\n";
  for (int i = 0; i < 60; ++i) mesh << "3 " << 3 * i << " " << 3 * i + 1 << " " << 3 * i + 2 << "\n";
  mesh.close();
  EXPECT_EQ(parse_distribution("mesh:" + file).per_shaft, 1u);  // an @ of a name is a letter
  expect_groups(*make_generator<Case>(parse_distribution("mesh:" + file + "@12"), Scalar::f32), "mesh");
  std::filesystem::remove(file);
}

TEST(SharedShaftNames, AreRefusedWhereTheyMakeNoSense) {
  for (const auto& [name, expected] :
       std::map<std::string, std::string>{{"nested@2", "none can be shared"},
                                          {"uniform@", "expected @K"},
                                          {"uniform@0", "expected @K"},
                                          {"uniform@-3", "expected @K"},
                                          {"uniform@1.5", "expected @K"},
                                          {"uniform@1048577", "expected @K"},
                                          {"uniform@99999999999999999999", "expected @K"},
                                          {"integer-grid:8@0", "expected @K"},
                                          {"no-such@4", "expected one of"}}) {
    try {
      (void)parse_distribution(name);
      ADD_FAILURE() << name;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(parse_distribution("nested@1").label(), "nested");
  EXPECT_EQ(parse_distribution("uniform@1048576").per_shaft, 1048576u);
}

// The batch rows say what the one-by-one rows say, trial by trial as far as counts can tell; exact ones the
// truth.
TYPED_TEST(SharedShafts, BatchRowsCountWhatTheOthersCount) {
  using Q = TypeParam;
  CampaignOptions options;
  options.trials = static_cast<std::uint64_t>(tests::affordable(20000));
  options.seed = 11;
  options.witnesses_per_row = 0;
  options.methods = {"naive-f32",       "certified-f32",       "certified-f64",       "exact",
                     "batch-naive-f32", "batch-certified-f32", "batch-certified-f64", "batch-exact"};
  for (const std::string& name : names_that_share()) options.distributions.push_back(name + "@700");
  options.distributions.insert(options.distributions.end(), {"uniform", "nested", "degenerate@3"});
  const CampaignResult result = run_campaign<Q>(options);
  std::map<std::string, const RowResult*> rows;
  for (const RowResult& row : result.rows) rows[row.method + " " + row.distribution + row.scalar] = &row;
  std::size_t compared = 0;
  std::uint64_t unsound = 0;
  for (const auto& [key, row] : rows) {
    EXPECT_FALSE(row->promise_broken()) << key;
    unsound += row->method == "naive-f32" ? row->count(Verdict::unsound) : 0;
    const auto batch = rows.find("batch-" + key);
    if (batch == rows.end()) continue;
    EXPECT_EQ(batch->second->matrix, row->matrix) << key;
    EXPECT_EQ(batch->second->threshold_checked, row->threshold_checked) << key;
    ++compared;
  }
  EXPECT_EQ(compared, 5 * options.distributions.size());
  EXPECT_GT(unsound, 0u) << "rows that never differ from the truth can't be told apart";
}

TYPED_TEST(SharedShafts, BatchRowsAreLeftOutWhereNothingIsSharedUnlessNamed) {
  using Q = TypeParam;
  CampaignOptions options;
  options.trials = 64;
  options.distributions = {"uniform", "uniform@8"};
  std::map<std::string, std::size_t> batches;
  for (const RowResult& row : run_campaign<Q>(options).rows) {
    batches[row.distribution] += row.method.starts_with("batch-") ? 1 : 0;
  }
  EXPECT_EQ(batches["uniform"], 0u);
  EXPECT_EQ(batches["uniform@8"], 5u);  // the exact one in both scalars
  options.methods = {"batch-exact"};
  EXPECT_EQ(run_campaign<Q>(options).rows.size(), 4u);
}

// Runs end where either box changes, and where the arrays are full.
TEST(BatchRuns, AreCutWhereTheShaftChanges) {
  using Row = Method<ShaftBoxQuestion>;
  const std::span<const Row> rows = methods<ShaftBoxQuestion>();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [](const Row& r) { return r.name == "batch-exact"; });
  ASSERT_NE(row, rows.end());
  std::vector<scene::ShaftBoxCase> cases;
  CaseRandom random(12, 0, 0);
  for (const bool moves_a : {true, false}) {  // from one run to the next, one of the two boxes
    double by = 0;
    for (const int length : {1, 2, 255, 256, 257, 600, 3}) {
      scene::ShaftBoxCase c{{{0, 0, 0, 1, 1, 1}}, {{9, 9, 9, 10, 10, 10}}, {}};
      by += 3;
      for (const int face : {1, 4}) (moves_a ? c.a : c.b).c[static_cast<std::size_t>(face)] += by;
      for (int i = 0; i < length; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
          const double lo = random.between<double>(0, axis == 1 ? 30 : 10);
          set_axis(c.t, axis, lo, lo + random.unit<double>());
        }
        cases.push_back(c);
      }
    }
  }
  std::vector<Answer> answers(cases.size(), kRejected);
  row->run_f64(cases, answers);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    ASSERT_EQ(answers[i], static_cast<Answer>(exact::classify(cases[i]))) << i;
  }
}

}  // namespace gnomon::fuzz
