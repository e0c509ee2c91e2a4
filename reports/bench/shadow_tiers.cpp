// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/bench/shadow_tiers.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>
#include <string_view>

#include "exact/first_hit.h"
#include "exact/shadow.h"
#include "fast/hierarchy.h"
#include "reports/bench/paired.h"
#include "reports/bench/tier_scenes.h"
#include "reports/peers/peers.h"

namespace gnomon::bench {

namespace {

using Queries = std::vector<scene::ShadowQuery>;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_order(const std::string& order, const Queries& queries, std::vector<Contender> contenders,
                 int rounds) {
  // The fastest of a few turns: what else the machine does comes in pieces of about their length.
  const auto seconds = time_paired(contenders, rounds, 4, 1);
  const auto count = static_cast<double>(queries.size());
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const Median time = median_of(seconds[i]), ratio = ratio_of(seconds[i], seconds[0]);
    std::printf("  %-9s %-15s %7.1f ns [%.1f, %.1f]   of naive's %.3f [%.3f, %.3f]\n", order.c_str(),
                contenders[i].name.c_str(), time.value / count * 1e9, time.low / count * 1e9,
                time.high / count * 1e9, ratio.value, ratio.low, ratio.high);
  }
}

void print_scene(const TierScene& made, const ShadowTierOptions& options) {
  const scene::Scene& scene = made.scene;
  const auto start = std::chrono::steady_clock::now();
  const fast::Hierarchy hierarchy(scene);
  const double built = seconds_since(start);
  Queries queries = queries_of(scene, hierarchy, options.side);
  const fast::ExactFaces faces{exact::blocks, exact::faces_away, exact::meets, exact::compare_hits};
  std::vector<fast::ShadowAnswer> answers(queries.size()), certified(queries.size()), naive(queries.size());
  fast::TestCounters counters;
  hierarchy.shadows_exact(faces, queries, answers, counters);
  hierarchy.shadows(fast::Hierarchy::Tier::certified, queries, certified);
  hierarchy.shadows(fast::Hierarchy::Tier::naive, queries, naive);
  std::size_t shadowed = 0, undecided = 0, wrong = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    shadowed += answers[i] == fast::ShadowAnswer::shadowed;
    undecided += certified[i] == fast::ShadowAnswer::undecided;
    wrong += naive[i] != answers[i];
  }
  const auto count = static_cast<double>(queries.size());
  std::printf(
      "%s, %zu faces: built in %.3f s, %.1f bytes a face; %zu queries, %.3f shadowed; a query: %.2f boxes, "
      "%.2f faces, %.2g by predicates; undecided %zu, naive wrong %zu\n",
      made.name.c_str(), scene.face_count(), built,
      static_cast<double>(hierarchy.bytes()) / static_cast<double>(scene.face_count()), queries.size(),
      static_cast<double>(shadowed) / count, static_cast<double>(counters.boxes) / count,
      static_cast<double>(counters.faces) / count, static_cast<double>(counters.exact) / count, undecided,
      wrong);
  std::vector<Contender> contenders;
  const auto add = [&](std::string_view name, auto run) {
    contenders.push_back({std::string(name), [&, run](int) {
                            run();
                            benchmark::ClobberMemory();
                          }});
  };
  add("naive", [&] { hierarchy.shadows(fast::Hierarchy::Tier::naive, queries, answers); });
  add("certified", [&] { hierarchy.shadows(fast::Hierarchy::Tier::certified, queries, answers); });
  add("exact", [&] { hierarchy.shadows_exact(faces, queries, answers); });
  std::vector<std::unique_ptr<fuzz::SceneCaster>> peers;
  std::vector<fuzz::Answer> peer_answers(queries.size());
  if (reports::has_embree()) {
    for (const fuzz::SceneMethod* method : reports::choose_scene_methods({"embree", "embree-robust"})) {
      const fuzz::SceneCaster* const peer = peers.emplace_back(method->make(scene)).get();
      add(method->name, [&, peer] { peer->shadows(queries, peer_answers); });
    }
  }
  print_order("image", queries, contenders, options.rounds);
  fuzz::CaseRandom random(6, 1, 0);
  for (std::size_t i = queries.size(); i > 1; --i) {
    std::swap(queries[i - 1], queries[random.bits() % i]);
  }
  print_order("shuffled", queries, contenders, options.rounds);
  std::fflush(stdout);
}

}  // namespace

void print_shadow_tiers(const ShadowTierOptions& options) {
  std::printf("shadow queries one by one on %s, %d paired rounds; [95 %% interval of the median]\n",
              fast::hierarchy_instruction_set(), options.rounds);
  for (const std::size_t faces : {10000u, 100000u, 1000000u}) {
    if (faces > options.most) continue;
    print_scene(make_bodies(faces), options);
    print_scene(make_hills(faces), options);
    print_scene(make_balls(faces), options);
  }
}

}  // namespace gnomon::bench
