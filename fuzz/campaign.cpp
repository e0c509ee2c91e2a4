// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/campaign.h"

#include <chrono>
#include <mutex>
#include <set>

#include "fuzz/chunk_loop.h"
#include "fuzz/trial_block.h"
#include "fuzz/witness.h"
#include "scene/corpus.h"

namespace gnomon::fuzz {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// All methods that share the cases of one distribution and scalar.
template <class Q>
struct Batch {
  DistributionChoice choice;
  scene::Scalar scalar;
  std::vector<const Method<Q>*> methods;
};

template <class Q>
std::vector<Batch<Q>> plan(const CampaignOptions& options) {
  std::vector<DistributionChoice> choices;
  for (const std::string& name : options.distributions) choices.push_back(parse_distribution(name));
  if (choices.empty()) {
    for (const Distribution& distribution : distributions()) {
      if (!distribution.needs_argument) choices.push_back({&distribution, ""});
    }
  }
  const std::vector<const Method<Q>*> chosen = choose_methods<Q>(options.methods, options.plugins);
  std::vector<Batch<Q>> batches;
  for (const DistributionChoice& choice : choices) {
    for (const scene::Scalar scalar : {scene::Scalar::f32, scene::Scalar::f64}) {
      if (options.scalar && *options.scalar != scalar) continue;
      Batch<Q> batch{choice, scalar, {}};
      for (const Method<Q>* method : chosen) {
        if (options.methods.empty() && method->in_batches && choice.per_shaft == 1) continue;
        if (options.scalar || method->has(scalar)) batch.methods.push_back(method);
      }
      if (!batch.methods.empty()) batches.push_back(std::move(batch));
    }
  }
  return batches;
}

struct BatchTotals {
  std::vector<Tally> tallies;
  std::vector<std::optional<MethodFailure>> failures;  // of each method
  double reference_ns = 0, core_ns = 0;
};

template <class Q>
void work(const Batch<Q>& batch, const Generator<typename Q::Case>& generator, const CampaignOptions& options,
          std::uint32_t stream, ChunkSource& source, FirstFailures& failures, std::mutex& mutex,
          BatchTotals& totals) {
  const std::size_t keep = options.witnesses_per_row;
  TrialBlock<Q> block(options.seed, stream, batch.choice.per_shaft, batch.scalar, keep);
  std::vector<Tally> tallies(batch.methods.size());
  const double start = thread_ns();
  while (const std::optional<Chunk> chunk = source.next()) {
    block.fill(generator, chunk->first, static_cast<std::size_t>(chunk->count));
    for (std::size_t m = 0; m < batch.methods.size(); ++m) {
      if (failures.before(m, chunk->number)) continue;
      try {
        block.run(*batch.methods[m], tallies[m]);
      } catch (const MethodFailure& failure) {
        failures.add(m, chunk->number, failure);
      }
    }
  }
  const std::lock_guard lock(mutex);
  for (std::size_t m = 0; m < tallies.size(); ++m) totals.tallies[m].add(tallies[m], keep);
  totals.reference_ns += block.reference_ns();
  totals.core_ns += thread_ns() - start + block.elsewhere_ns();
}

template <class Q>
BatchTotals run_batch(const Batch<Q>& batch, const Generator<typename Q::Case>& generator,
                      const CampaignOptions& options, std::uint32_t stream, double seconds,
                      const std::function<void(double)>& on_share) {
  BatchTotals totals;
  totals.tallies.resize(batch.methods.size());
  FirstFailures failures(batch.methods.size());
  std::mutex mutex;
  ChunkPlan plan{TrialBlock<Q>::kSize, options.trials, {}, options.jobs, options.shard, options.shards};
  if (options.seconds) plan.seconds = seconds;
  run_chunks(
      plan, failures,
      [&](ChunkSource& source) { work(batch, generator, options, stream, source, failures, mutex, totals); },
      on_share);
  for (std::size_t m = 0; m < batch.methods.size(); ++m) totals.failures.push_back(failures.of(m));
  return totals;
}

/// The witness of a fault, shrunk; as generated where the method fails on simpler cases; else none. Says in
/// `failure` what went wrong.
template <class Q>
std::optional<Witness> witness_of(const Method<Q>& method, scene::Scalar scalar, const typename Q::Case& c,
                                  Fault fault, std::optional<MethodFailure>& failure) {
  for (const Shrinking shrinking : {Shrinking::on, Shrinking::off}) {
    try {
      const Trial again = try_case(method, scalar, c);
      const bool wrong = again.verdict == Verdict::waste || again.verdict == Verdict::unsound;
      if (!wrong || Q::fault(again.truth, again.answer) != fault) {
        const std::string text = scene::corpus_text(Q::id, numbers_of(c), "");
        failure = MethodFailure(
            std::string(method.name) + " answered otherwise when asked again, alone, on " + text, {text});
        return std::nullopt;
      }
      return make_witness(method, scalar, c, shrinking);
    } catch (const MethodFailure& thrown) {
      if (!failure) failure = thrown;
    }
  }
  return std::nullopt;
}

template <class Q>
RowResult row_of(const Batch<Q>& batch, const Method<Q>& method, const Tally& tally,
                 const BatchTotals& totals, const Generator<typename Q::Case>& generator,
                 const CampaignOptions& options, std::uint32_t stream,
                 std::optional<MethodFailure>& failure) {
  RowResult row;
  row.question = Q::id;
  row.method = method.name;
  row.promise = name_of(method.promise);
  row.tier = method.tier;
  row.distribution = batch.choice.label();
  row.scalar = name_of(batch.scalar);
  row.trials = tally.trials;
  row.matrix = tally.matrix;
  row.touching_outside = tally.touching_outside;
  row.touching_inside = tally.touching_inside;
  row.unsound_touching = tally.unsound_touching;
  row.rounding = tally.rounding;
  row.model = tally.model;
  row.rounding_and_model = tally.rounding_and_model;
  row.threshold_checked = tally.threshold_checked;
  row.threshold_exceeded = tally.threshold_exceeded;
  row.in_domain = batch.choice.distribution->in_every_domain;
  const auto case_of_trial = [&](std::uint64_t trial) {
    CaseRandom random(options.seed, stream, trial, batch.choice.per_shaft);
    return generator.make(random);
  };
  if (tally.largest.known()) {
    const typename Q::Case c = case_of_trial(tally.largest.trial());
    const bool outer = exact::gap(c, exact::Boundary::outside) == tally.largest.gap();
    const double length =
        gap_length(c, tally.largest.gap(), outer ? exact::Boundary::outside : exact::Boundary::inside);
    row.worst = WorstGap{tally.largest.gap(), length, length / scene::ulp_of(largest_number(c), batch.scalar),
                         tally.largest.trial()};
  }
  for (std::size_t fault = 0; fault < kFaults && method.tier != "trivial"; ++fault) {
    for (const std::uint64_t trial : tally.faults[fault].trials()) {
      std::optional<Witness> witness =
          witness_of(method, batch.scalar, case_of_trial(trial), static_cast<Fault>(fault), failure);
      if (!witness) continue;
      witness->distribution = row.distribution;
      witness->seed = options.seed;
      witness->trial = trial;
      witness->name = witness_name(*witness);
      row.witnesses.push_back(std::move(*witness));
    }
  }
  if (tally.trials > 0) {
    row.ns_per_case = tally.ns / static_cast<double>(tally.trials);
    row.reference_ns_per_case = totals.reference_ns / static_cast<double>(tally.trials);
  }
  return row;
}

}  // namespace

template <class Q>
std::vector<const Method<Q>*> choose_methods(const std::vector<std::string>& names, const Plugins* plugins) {
  const std::vector<const Method<Q>*> all_rows = all_methods<Q>(plugins);
  std::vector<const Method<Q>*> chosen;
  for (const Method<Q>* method : all_rows) {
    if (names.empty() || std::find(names.begin(), names.end(), method->name) != names.end())
      chosen.push_back(method);
  }
  for (const std::string& name : names) {
    const bool known =
        std::any_of(chosen.begin(), chosen.end(), [&](const Method<Q>* m) { return m->name == name; });
    if (known) continue;
    std::string all;
    for (const Method<Q>* method : all_rows) all += (all.empty() ? "" : ", ") + std::string(method->name);
    throw UsageError("--method: expected one of " + all + " for " + std::string(Q::id) + ", found \"" + name +
                     "\"");
  }
  return chosen;
}

template <class Q>
CampaignResult run_campaign(const CampaignOptions& options, const OnProgress& on_progress,
                            const OnBatch& on_batch) {
  std::vector<Batch<Q>> batches = plan<Q>(options);
  // A mesh that can't be read is said before hours of trials, not after.
  std::vector<std::unique_ptr<Generator<typename Q::Case>>> generators;
  for (const Batch<Q>& batch : batches)
    generators.push_back(make_generator<typename Q::Case>(batch.choice, batch.scalar));

  CampaignResult result;
  result.seed = options.seed;
  result.shard = options.shard;
  result.shards = options.shards;
  result.witnesses_per_row = options.witnesses_per_row;
  const double share = 1.0 / static_cast<double>(batches.size());
  std::set<std::string_view> retired;  // methods that failed: what follows would only fail again
  for (std::size_t b = 0; b < batches.size(); ++b) {
    Batch<Q>& batch = batches[b];
    std::erase_if(batch.methods, [&](const Method<Q>* method) { return retired.contains(method->name); });
    result.complete = b + 1 == batches.size();
    if (batch.methods.empty()) continue;
    const std::string where =
        std::string(Q::id) + " " + batch.choice.label() + " " + std::string(name_of(batch.scalar));
    const std::uint32_t stream = stream_of(where);
    std::function<void(double)> on_share;
    if (on_progress)
      on_share = [&](double part) { on_progress({(static_cast<double>(b) + part) * share, where}); };
    const Clock::time_point start = Clock::now();
    const BatchTotals totals =
        run_batch(batch, *generators[b], options, stream, options.seconds.value_or(0) * share, on_share);
    result.seconds += seconds_since(start);
    result.core_seconds += totals.core_ns * 1e-9;
    for (std::size_t m = 0; m < batch.methods.size(); ++m) {
      const Method<Q>& method = *batch.methods[m];
      std::optional<MethodFailure> failure = totals.failures[m];
      if (!failure) {
        result.rows.push_back(
            row_of(batch, method, totals.tallies[m], totals, *generators[b], options, stream, failure));
        result.trials += totals.tallies[m].trials;
      }
      if (!failure) continue;
      result.failures.push_back({std::string(method.name), batch.choice.label(),
                                 std::string(name_of(batch.scalar)), failure->what(), failure->cases()});
      retired.insert(method.name);
    }
    if (on_batch) on_batch(result);
  }
  return result;
}

template CampaignResult run_campaign<ShaftBoxQuestion>(const CampaignOptions&, const OnProgress&,
                                                       const OnBatch&);
template CampaignResult run_campaign<ShaftBallQuestion>(const CampaignOptions&, const OnProgress&,
                                                        const OnBatch&);
template CampaignResult run_campaign<ShaftSlabsQuestion>(const CampaignOptions&, const OnProgress&,
                                                         const OnBatch&);
template CampaignResult run_campaign<ShaftOrientedBoxQuestion>(const CampaignOptions&, const OnProgress&,
                                                               const OnBatch&);
template CampaignResult run_campaign<ShaftEllipsoidQuestion>(const CampaignOptions&, const OnProgress&,
                                                             const OnBatch&);
template std::vector<const Method<ShaftBoxQuestion>*> choose_methods(const std::vector<std::string>&,
                                                                     const Plugins*);
template std::vector<const Method<ShaftBallQuestion>*> choose_methods(const std::vector<std::string>&,
                                                                      const Plugins*);

}  // namespace gnomon::fuzz
