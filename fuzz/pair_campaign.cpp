// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_campaign.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <set>

#include "fuzz/chunk_loop.h"
#include "fuzz/pair_block.h"
#include "fuzz/pair_witness.h"
#include "fuzz/witness.h"

namespace gnomon::fuzz {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<PairChoice> choose_distributions(const std::vector<std::string>& names) {
  std::vector<PairChoice> choices;
  for (const std::string& name : names) choices.push_back(parse_pair_distribution(name));
  if (!choices.empty()) return choices;
  for (const PairDistribution& distribution : pair_distributions()) {
    if (!distribution.needs_argument) choices.push_back({&distribution, ""});
  }
  return choices;
}

template <class Q>
std::vector<const typename Q::Method*> choose_rows(std::span<const typename Q::Method> rows,
                                                   const std::vector<std::string>& names) {
  std::vector<const typename Q::Method*> chosen;
  std::string known;
  for (const typename Q::Method& row : rows) {
    known += (known.empty() ? "" : ", ") + std::string(row.name);
    if (names.empty() || std::find(names.begin(), names.end(), row.name) != names.end())
      chosen.push_back(&row);
  }
  for (const std::string& name : names) {
    if (std::none_of(chosen.begin(), chosen.end(), [&](const auto* row) { return row->name == name; })) {
      throw UsageError("--method: expected one of " + known + " for " + std::string(Q::id) + ", found \"" +
                       name + "\"");
    }
  }
  return chosen;
}

/// One distribution and its rows.
template <class Q>
struct PairBatch {
  PairChoice choice;
  PairStage<Q> stage;
  std::uint32_t stream = 0;
};

struct PairTotals {
  std::vector<Tally> tallies;
  std::vector<std::optional<MethodFailure>> failures;
  double reference_ns = 0, core_ns = 0;
};

template <class Q>
PairTotals run_batch(const PairBatch<Q>& batch, const CampaignOptions& options, double seconds,
                     const std::function<void(double)>& on_share) {
  const std::size_t count = batch.stage.methods.size(), keep = options.witnesses_per_row;
  PairTotals totals;
  totals.tallies.resize(count);
  FirstFailures failures(count);
  std::mutex mutex;
  ChunkPlan plan{PairBlock<Q>::kSize, options.trials, {}, options.jobs, options.shard, options.shards};
  if (options.seconds) plan.seconds = seconds;
  const auto work = [&](ChunkSource& source) {
    PairBlock<Q> block(batch.stage, options.seed, batch.stream, keep);
    std::vector<Tally> tallies(count);
    const double start = thread_ns();
    while (const std::optional<Chunk> chunk = source.next()) {
      block.fill(chunk->first, static_cast<std::size_t>(chunk->count));
      for (std::size_t m = 0; m < count; ++m) {
        if (failures.before(m, chunk->number)) continue;
        try {
          block.run(m, tallies[m]);
        } catch (const MethodFailure& failure) {
          failures.add(m, chunk->number, failure);
        }
      }
    }
    const std::lock_guard lock(mutex);
    for (std::size_t m = 0; m < count; ++m) totals.tallies[m].add(tallies[m], keep);
    totals.reference_ns += block.reference_ns();
    totals.core_ns += thread_ns() - start;
  };
  run_chunks(plan, failures, work, on_share);
  for (std::size_t m = 0; m < count; ++m) totals.failures.push_back(failures.of(m));
  return totals;
}

template <class Q>
void add_witnesses(const PairBatch<Q>& batch, const typename Q::Method& method, const Tally& tally,
                   std::uint64_t seed, RowResult& row, std::optional<MethodFailure>& failure) {
  const scene::Scene* const shared = batch.stage.source->scene_of_all();
  for (std::size_t fault = 0; fault < kFaults; ++fault) {
    for (const std::uint64_t trial : tally.faults[fault].trials()) {
      PairCase<typename Q::Query> c;
      batch.stage.source->make({seed, batch.stream, trial}, c);
      try {
        Witness witness = make_pair_witness<Q>(method, shared != nullptr ? *shared : c.scene, c.query, fault);
        witness.distribution = row.distribution;
        witness.seed = seed;
        witness.trial = trial;
        witness.name = witness_name(witness);
        row.witnesses.push_back(std::move(witness));
      } catch (const MethodFailure& thrown) {
        if (!failure) failure = thrown;
      }
    }
  }
}

template <class Q>
RowResult row_of(const PairBatch<Q>& batch, const typename Q::Method& method, const Tally& tally,
                 double reference_ns, std::uint64_t seed, std::optional<MethodFailure>& failure) {
  RowResult row;
  row.question = Q::id;
  row.method = method.name;
  row.promise = name_of(method.promise);
  row.tier = method.tier;
  row.distribution = batch.choice.label();
  row.scalar = "f32";
  row.trials = tally.trials;
  row.matrix = tally.matrix;
  row.faces = tally.faces;
  row.independent = !batch.choice.shares_scene();
  row.in_domain = batch.choice.distribution->in_every_domain;
  if (method.tier != "trivial") add_witnesses(batch, method, tally, seed, row, failure);
  if (tally.trials > 0) {
    row.ns_per_case = tally.ns / static_cast<double>(tally.trials);
    row.reference_ns_per_case = reference_ns / static_cast<double>(tally.trials);
  }
  return row;
}

}  // namespace

template <class Q>
CampaignResult run_pair_campaign(const CampaignOptions& options, const OnProgress& on_progress,
                                 const OnBatch& on_batch, std::span<const typename Q::Method> rows) {
  if (options.scalar == scene::Scalar::f64)
    throw UsageError("--scalar: expected f32 for " + std::string(Q::id) +
                     ", found f64: its cases are floats");
  if (options.plugins != nullptr && !options.plugins->empty())
    throw UsageError("--plugin: " + std::string(Q::id) + " is no question that plug-ins answer");
  const std::vector<const typename Q::Method*> methods = choose_rows<Q>(rows, options.methods);
  const std::vector<PairChoice> choices = choose_distributions(options.distributions);
  // A scene that can't be read is said before hours of trials, not after.
  std::vector<std::unique_ptr<PairSource<typename Q::Query>>> sources;
  for (const PairChoice& choice : choices) sources.push_back(make_pair_source<typename Q::Query>(choice));

  CampaignResult result;
  result.seed = options.seed;
  result.shard = options.shard;
  result.shards = options.shards;
  result.witnesses_per_row = options.witnesses_per_row;
  const double share = 1.0 / static_cast<double>(choices.size());
  std::set<std::string_view> retired;  // methods that failed: what follows would only fail again
  for (std::size_t b = 0; b < choices.size(); ++b) {
    PairBatch<Q> batch{choices[b], {sources[b].get(), methods, nullptr, {}}, 0};
    std::erase_if(batch.stage.methods, [&](const auto* method) { return retired.contains(method->name); });
    result.complete = b + 1 == choices.size();
    if (batch.stage.methods.empty()) continue;
    const std::string where = std::string(Q::id) + " " + batch.choice.label() + " f32";
    batch.stream = stream_of(where);
    if (const scene::Scene* const scene = sources[b]->scene_of_all()) {
      batch.stage.referee = std::make_unique<typename Q::Referee>(*scene);
      for (const auto* method : batch.stage.methods) batch.stage.answerers.push_back(method->make(*scene));
    }
    std::function<void(double)> on_share;
    if (on_progress)
      on_share = [&](double part) { on_progress({(static_cast<double>(b) + part) * share, where}); };
    const Clock::time_point start = Clock::now();
    const PairTotals totals = run_batch(batch, options, options.seconds.value_or(0) * share, on_share);
    result.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    result.core_seconds += totals.core_ns * 1e-9;
    for (std::size_t m = 0; m < batch.stage.methods.size(); ++m) {
      const typename Q::Method& method = *batch.stage.methods[m];
      std::optional<MethodFailure> failure = totals.failures[m];
      if (!failure) {
        result.rows.push_back(
            row_of(batch, method, totals.tallies[m], totals.reference_ns, options.seed, failure));
        result.trials += result.rows.back().trials;
      }
      if (!failure) continue;
      result.failures.push_back(
          {std::string(method.name), batch.choice.label(), "f32", failure->what(), failure->cases()});
      retired.insert(method.name);
    }
    if (on_batch) on_batch(result);
  }
  return result;
}

template CampaignResult run_pair_campaign<CandidateQuestion>(const CampaignOptions&, const OnProgress&,
                                                             const OnBatch&,
                                                             std::span<const CandidateMethod>);
template CampaignResult run_pair_campaign<PatchQuestion>(const CampaignOptions&, const OnProgress&,
                                                         const OnBatch&, std::span<const PairMethod>);

}  // namespace gnomon::fuzz
