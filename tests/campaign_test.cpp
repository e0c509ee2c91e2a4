// SPDX-License-Identifier: GPL-3.0-or-later
// The trial loop: the same results for any jobs and shards, counts that add up, promises kept and noticed
// when broken.
#include "fuzz/campaign.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "fuzz/shaft_questions.h"
#include "fuzz/statistics.h"
#include "fuzz/tally.h"
#include "fuzz/witness.h"
#include "reports/result_json.h"
#include "tests/shaft_random.h"

namespace gnomon::fuzz {
namespace {

using nlohmann::ordered_json;

/// What a result file says, timings apart.
ordered_json said(const CampaignResult& result) {
  ordered_json json = ordered_json::parse(reports::result_json(result));
  json.erase("measured");
  return json;
}

CampaignOptions few(std::uint64_t trials, unsigned jobs = 1) {
  CampaignOptions options;
  options.trials = trials;
  options.jobs = jobs;
  return options;
}

template <class Q>
class CampaignOf : public testing::Test {};
using Questions = testing::Types<ShaftBoxQuestion, ShaftBallQuestion>;
TYPED_TEST_SUITE(CampaignOf, Questions);

// 5000 trials are four blocks and a part of one: threads get different numbers of them.
TYPED_TEST(CampaignOf, GivesTheSameForAnyNumberOfJobs) {
  CampaignOptions options = few(5000);
  options.distributions = {"uniform", "near-touch", "offset:1e5"};
  const ordered_json one = said(run_campaign<TypeParam>(options));
  for (const unsigned jobs : {2u, 3u}) {
    options.jobs = jobs;
    EXPECT_EQ(said(run_campaign<TypeParam>(options)).dump(), one.dump()) << jobs << " jobs";
  }
  options.jobs = 1;
  options.seed = 2;
  EXPECT_NE(said(run_campaign<TypeParam>(options))["rows"].dump(), one["rows"].dump());
  options.seed = (std::uint64_t{1} << 32) + 1;  // the upper half of a seed counts
  EXPECT_NE(said(run_campaign<TypeParam>(options))["rows"].dump(), one["rows"].dump());
}

TYPED_TEST(CampaignOf, GivesEachMethodTheSameAloneAsAmongOthers) {
  CampaignOptions options = few(3000);
  options.distributions = {"near-touch", "degenerate"};
  const CampaignResult all = run_campaign<TypeParam>(options);
  options.distributions = {"degenerate"};
  options.methods = {"slab-f64"};
  const CampaignResult alone = run_campaign<TypeParam>(options);
  ASSERT_EQ(alone.rows.size(), 1u);
  std::size_t found = 0;
  for (const RowResult& row : all.rows) {
    if (row.method != "slab-f64" || row.distribution != "degenerate") continue;
    ++found;
    EXPECT_EQ(row.matrix, alone.rows[0].matrix);
    EXPECT_EQ(row.rounding, alone.rows[0].rounding);
  }
  EXPECT_EQ(found, 1u);
}

TYPED_TEST(CampaignOf, ShardsAddUpToTheWhole) {
  CampaignOptions options = few(7000);
  options.distributions = {"near-touch", "offset"};
  const CampaignResult whole = run_campaign<TypeParam>(options);
  options.shards = 3;
  std::vector<RowResult> sum;
  for (options.shard = 1; options.shard <= 3; ++options.shard) {
    options.jobs = options.shard;
    const CampaignResult part = run_campaign<TypeParam>(options);
    EXPECT_EQ(part.shard, options.shard);
    if (sum.empty()) {
      sum = part.rows;
      continue;
    }
    ASSERT_EQ(part.rows.size(), sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) {
      RowResult& row = sum[i];
      const RowResult& more = part.rows[i];
      row.trials += more.trials;
      for (std::size_t truth = 0; truth < kTruths; ++truth) {
        for (std::size_t answer = 0; answer < kColumns; ++answer)
          row.matrix[truth][answer] += more.matrix[truth][answer];
      }
      row.touching_outside += more.touching_outside;
      row.touching_inside += more.touching_inside;
      row.unsound_touching += more.unsound_touching;
      row.rounding += more.rounding;
      row.model += more.model;
      row.rounding_and_model += more.rounding_and_model;
      row.threshold_checked += more.threshold_checked;
      if (more.worst && (!row.worst || abs(more.worst->value) > abs(row.worst->value)))
        row.worst = more.worst;
      for (const Witness& witness : more.witnesses) row.witnesses.push_back(witness);
    }
  }
  ASSERT_EQ(sum.size(), whole.rows.size());
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const RowResult& row = whole.rows[i];
    const std::string where = row.method + " " + row.distribution + " " + row.scalar;
    EXPECT_EQ(sum[i].trials, 7000u) << where;
    EXPECT_EQ(sum[i].matrix, row.matrix) << where;
    EXPECT_EQ(sum[i].touching_outside, row.touching_outside) << where;
    EXPECT_EQ(sum[i].touching_inside, row.touching_inside) << where;
    EXPECT_EQ(sum[i].unsound_touching, row.unsound_touching) << where;
    EXPECT_EQ(sum[i].rounding, row.rounding) << where;
    EXPECT_EQ(sum[i].model, row.model) << where;
    EXPECT_EQ(sum[i].rounding_and_model, row.rounding_and_model) << where;
    EXPECT_EQ(sum[i].threshold_checked, row.threshold_checked) << where;
    ASSERT_EQ(sum[i].worst.has_value(), row.worst.has_value()) << where;
    if (row.worst) {
      EXPECT_EQ(sum[i].worst->value, row.worst->value) << where;
    }
    // The whole run's witnesses are among those of the parts.
    for (const Witness& witness : row.witnesses) {
      EXPECT_TRUE(std::any_of(sum[i].witnesses.begin(), sum[i].witnesses.end(), [&](const Witness& other) {
        return other.name == witness.name && other.case_text == witness.case_text;
      })) << witness.name;
    }
  }
}

TYPED_TEST(CampaignOf, CountsAddUp) {
  CampaignOptions options = few(2000);
  options.witnesses_per_row = 2;
  for (const std::optional<scene::Scalar> scalar :
       {std::optional<scene::Scalar>{}, std::optional(scene::Scalar::f64)}) {
    options.scalar = scalar;
    const CampaignResult result = run_campaign<TypeParam>(options);
    std::uint64_t trials = 0;
    for (const RowResult& row : result.rows) {
      const std::string where = row.method + " " + row.distribution + " " + row.scalar;
      trials += row.trials;
      EXPECT_EQ(row.trials, 2000u) << where;
      EXPECT_EQ(row.truths(0) + row.truths(1) + row.truths(2), row.trials) << where;
      std::uint64_t verdicts = 0, faults = 0;
      for (const Verdict v :
           {Verdict::agree, Verdict::waste, Verdict::unsound, Verdict::undecided, Verdict::rejected}) {
        verdicts += row.count(v);
      }
      for (const Fault f :
           {Fault::false_cull, Fault::false_inside, Fault::false_keep, Fault::missed_inside}) {
        faults += row.count(f);
      }
      EXPECT_EQ(verdicts, row.trials) << where;
      EXPECT_EQ(faults, row.count(Verdict::waste) + row.count(Verdict::unsound)) << where;
      EXPECT_EQ(row.count(Fault::false_cull) + row.count(Fault::false_inside), row.count(Verdict::unsound))
          << where;
      // A wrong answer is rounding's or the model's; where both err and still differ from truth, of both.
      EXPECT_LE(faults, row.rounding + row.model + row.rounding_and_model) << where;
      EXPECT_LE(row.rounding + row.model, faults) << where;
      EXPECT_EQ(row.worst.has_value(), faults > 0) << where;
      EXPECT_LE(row.unsound_touching, row.count(Verdict::unsound)) << where;
      std::map<std::string, int> of_fault;
      for (const Witness& witness : row.witnesses) ++of_fault[witness.verdict];
      for (const Fault f :
           {Fault::false_cull, Fault::false_inside, Fault::false_keep, Fault::missed_inside}) {
        const int most = row.tier == "trivial" ? 0 : 2;
        EXPECT_EQ(of_fault[std::string(name_of(f))],
                  static_cast<int>(std::min<std::uint64_t>(row.count(f), static_cast<std::uint64_t>(most))))
            << where;
      }
      if (scalar && row.method.ends_with("f32") &&
          (row.distribution == "uniform" || row.distribution == "thin")) {
        EXPECT_GT(row.count(Verdict::rejected), 0u) << where;  // doubles that are no floats
      }
      if (!scalar) {
        EXPECT_EQ(row.count(Verdict::rejected), 0u) << where;
      }
      EXPECT_EQ(row.count(Verdict::undecided), 0u) << where;
    }
    EXPECT_EQ(trials, result.trials);
  }
}

TYPED_TEST(CampaignOf, FewTrialsAndTimeLimitsWork) {
  CampaignOptions options = few(1);
  options.methods = {"exact"};
  options.distributions = {"uniform"};
  EXPECT_EQ(run_campaign<TypeParam>(options).trials, 2u);  // f32 and f64
  options.shards = 3;
  options.shard = 3;
  EXPECT_EQ(run_campaign<TypeParam>(options).trials, 0u);
  options = few(1, 2);
  options.methods = {"trivial"};
  options.seconds = 0.05;
  const CampaignResult timed = run_campaign<TypeParam>(options);
  for (const RowResult& row : timed.rows) {
    EXPECT_EQ(row.trials % 1024, 0u);
    EXPECT_GE(row.trials, 1024u) << row.distribution;  // however late it is
  }
  EXPECT_LT(timed.seconds, 20);
  options.methods = {"no-such"};
  EXPECT_THROW((void)run_campaign<TypeParam>(options), UsageError);
}

/// Certified and exact rows over one distribution; those that over- and underflow are in it too, with fewer
/// trials (nearly all of theirs need rationals). Returns how many thresholds were looked at.
template <class Q>
std::uint64_t expect_promises(const std::string& distribution, std::uint64_t trials) {
  CampaignOptions options = few(static_cast<std::uint64_t>(tests::affordable(static_cast<int>(trials))), 2);
  for (const Method<Q>& method : methods<Q>()) {
    if (method.promise != Promise::none && method.tier != "trivial") {
      options.methods.emplace_back(method.name);
    }
  }
  EXPECT_EQ(options.methods.size(), 6u);
  options.distributions = {distribution};
  const CampaignResult result = run_campaign<Q>(options);
  EXPECT_FALSE(result.promise_broken());
  std::uint64_t checked = 0;
  for (const RowResult& row : result.rows) {
    checked += row.threshold_checked;
    EXPECT_EQ(row.trials, options.trials);
    EXPECT_EQ(row.count(Verdict::unsound), 0u) << row.method << " " << row.scalar;
    EXPECT_EQ(row.count(Verdict::rejected) + row.count(Verdict::undecided), 0u) << row.method;
    if (row.tier == "exact") {
      EXPECT_EQ(row.count(Verdict::agree), row.trials) << row.scalar;
    }
    if (!row.promise_broken()) continue;
    for (const Witness& witness : row.witnesses) ADD_FAILURE() << witness.method << ": " << witness.case_text;
  }
  return checked;
}

class PromisesOn : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] std::uint64_t trials(std::uint64_t in_domain) const {
    return parse_distribution(GetParam()).distribution->in_every_domain ? in_domain : in_domain / 4;
  }
};

TEST_P(PromisesOn, Boxes) {
  const std::uint64_t checked = expect_promises<ShaftBoxQuestion>(GetParam(), trials(200000));
  if (GetParam() == "near-touch") {
    EXPECT_GT(checked, 1000u) << "no threshold was needed: the check tests nothing";
  }
}
TEST_P(PromisesOn, Balls) {
  const std::uint64_t checked = expect_promises<ShaftBallQuestion>(GetParam(), trials(20000));
  if (GetParam() == "near-touch") {
    EXPECT_GT(checked, 100u) << "no threshold was needed: the check tests nothing";
  }
}

std::vector<std::string> promise_distributions() {
  std::vector<std::string> names{"offset:1e5", "offset:1e12", "offset:1e30", "integer-grid:1048576"};
  for (const Distribution& distribution : distributions()) {
    if (distribution.needs_argument) continue;
    names.emplace_back(distribution.name);
    if (distribution.shares_shafts) names.push_back(names.back() + "@100");
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Campaign, PromisesOn, testing::ValuesIn(promise_distributions()),
                         [](const testing::TestParamInfo<std::string>& of) {
                           std::string name;
                           for (const char c : of.param)
                             name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           return name;
                         });

std::uint64_t unsound_of(const CampaignResult& result, const std::string& method,
                         const std::string& distribution) {
  for (const RowResult& row : result.rows) {
    if (row.method == method && row.distribution == distribution) return row.count(Verdict::unsound);
  }
  ADD_FAILURE() << "no row " << method << " " << distribution;
  return 0;
}

// The hunt finds what is there: without these, clean rows would say nothing.
TEST(Campaign, FindsWhatTheNaiveMethodsDoWrong) {
  CampaignOptions options = few(20000, 2);
  options.scalar = scene::Scalar::f32;
  options.methods = {"naive-f32", "normalised-f32", "printed-f32", "naive-f64"};
  options.distributions = {"near-touch", "offset", "integer-grid"};
  const CampaignResult result = run_campaign<ShaftBoxQuestion>(options);
  EXPECT_GT(unsound_of(result, "naive-f32", "near-touch"), 100u);
  EXPECT_GT(unsound_of(result, "naive-f32", "offset"), 5u);
  EXPECT_EQ(unsound_of(result, "naive-f32", "integer-grid"), 0u);  // small integers: floats make no error
  for (const char* distribution : {"near-touch", "offset", "integer-grid"}) {
    EXPECT_GT(unsound_of(result, "normalised-f32", distribution), 5u) << distribution;
  }
  EXPECT_EQ(unsound_of(result, "naive-f64", "integer-grid"), 0u);
  EXPECT_FALSE(result.promise_broken());  // naive methods promise nothing
  for (const RowResult& row : result.rows) {
    EXPECT_EQ(row.model > 0, row.method == "printed-f32")
        << row.method;  // the corrected box test is exact as a model
  }
}

TEST(Campaign, TheSphereTestIsWrongAsAModelAndTheSlabTestIsNot) {
  CampaignOptions options = few(20000, 2);
  options.methods = {"naive-f32", "naive-f64", "slab-f32", "slab-f64", "exact"};
  options.distributions = {"uniform"};
  const CampaignResult result = run_campaign<ShaftBallQuestion>(options);
  std::size_t naive = 0;
  for (const RowResult& row : result.rows) {
    if (row.method.starts_with("naive")) {
      ++naive;
      EXPECT_GT(row.model, 20u) << row.method;
      EXPECT_GT(row.count(Fault::false_keep), 20u) << row.method;
    } else {
      EXPECT_EQ(row.model, 0u) << row.method;
      EXPECT_EQ(row.rounding_and_model, 0u) << row.method;
    }
  }
  EXPECT_EQ(naive, 2u);
}

}  // namespace
}  // namespace gnomon::fuzz
