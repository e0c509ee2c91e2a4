// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/bench/pairs.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numeric>

#include "exact/convexity.h"
#include "exact/first_hit.h"
#include "exact/shadow.h"
#include "fast/hierarchy.h"
#include "fast/pair_visibility.h"
#include "fuzz/float_faces.h"
#include "fuzz/radiosity.h"
#include "reports/bench/paired.h"
#include "reports/peers/embree_segments.h"
#include "reports/scene_source.h"
#include "scene/single.h"

namespace gnomon::bench {

namespace {

using fast::ShadowAnswer;
using Points = std::vector<std::array<float, 3>>;

const fast::ExactFaces kExactFaces{exact::blocks, exact::faces_away, exact::meets, exact::compare_hits};

/// The rays of a row: pairs in floats, and the same as single queries.
struct Workload {
  std::vector<Points> from, to;
  std::vector<fast::RayBatch> batches;
  std::vector<reports::SegmentBatch> segments;
  std::vector<scene::ShadowQuery> queries;

  void add(const fuzz::RadiosityPair& pair) {
    const auto floats = [](const std::vector<fuzz::Vector3>& points) {
      Points list;
      for (const auto& p : points) list.push_back(fuzz::to_floats(p));
      return list;
    };
    from.push_back(floats(pair.from.points));
    to.push_back(floats(pair.to.points));
    // The lists' own memory does not move when the vector of lists grows.
    batches.push_back({from.back(), to.back(), pair.from.own, pair.to.own});
    segments.push_back({from.back(), to.back()});
    for (std::size_t i = 0; i < pair.rays(); ++i) queries.push_back(pair.query(i));
  }
};

struct Casters {
  const fast::Hierarchy& hierarchy;
  const fast::PairCaster& pairs;
  std::vector<std::pair<std::string, std::unique_ptr<reports::SegmentCaster>>> embree;
};

/// Answers all batches, one after another.
template <class Ask>
void for_each_batch(const Workload& work, std::vector<ShadowAnswer>& answers, const Ask& ask) {
  std::size_t first = 0;
  for (const fast::RayBatch& batch : work.batches) {
    const std::size_t rays = batch.from.size() * batch.to.size();
    ask(batch, std::span(answers).subspan(first, rays));
    first += rays;
  }
  benchmark::ClobberMemory();
}

/// The ratios of single rays to the exact tier: Embree's fastest and our hierarchy. 0: not measured.
struct Ratios {
  double embree = 0, hierarchy = 0;
};

/// The geometric mean over the rows that were measured; "-" where there are none.
std::string mean_text(const std::vector<Ratios>& rows, double Ratios::*which) {
  double sum = 0;
  std::size_t count = 0;
  for (const Ratios& row : rows) {
    if (!(row.*which > 0)) continue;
    sum += std::log(row.*which);
    ++count;
  }
  if (count == 0) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", std::exp(sum / static_cast<double>(count)));
  return text.data();
}

Ratios print_row(const std::string& title, const Workload& work, const Casters& casters, int rounds) {
  const std::size_t rays = work.queries.size();
  if (rays == 0) return {};
  fast::PairScratch scratch;
  std::vector<ShadowAnswer> exact(rays), certified(rays), naive(rays), single(rays);
  std::vector<std::uint8_t> blocked(rays);
  std::vector<Contender> contenders = {
      {"pair exact",
       [&](int) {
         for_each_batch(work, exact, [&](const fast::RayBatch& batch, std::span<ShadowAnswer> answers) {
           casters.pairs.shadows_exact(kExactFaces, batch, scratch, answers);
         });
       }},
      {"pair certified",
       [&](int) {
         for_each_batch(work, certified, [&](const fast::RayBatch& batch, std::span<ShadowAnswer> answers) {
           casters.pairs.shadows_certified(batch, scratch, answers);
         });
       }},
      {"pair naive",
       [&](int) {
         for_each_batch(work, naive, [&](const fast::RayBatch& batch, std::span<ShadowAnswer> answers) {
           casters.pairs.shadows_naive(batch, scratch, answers);
         });
       }},
      {"hierarchy exact", [&](int) {
         casters.hierarchy.shadows_exact(kExactFaces, work.queries, single);
         benchmark::ClobberMemory();
       }}};
  for (const auto& named : casters.embree) {
    contenders.push_back({named.first, [&work, &blocked, caster = named.second.get()](int) {
                            caster->run(work.segments, blocked);
                            benchmark::ClobberMemory();
                          }});
  }
  const auto seconds = time_paired(contenders, rounds, 3, 1);

  fast::PairCounters counters;
  for_each_batch(work, exact, [&](const fast::RayBatch& batch, std::span<ShadowAnswer> answers) {
    casters.pairs.shadows_exact(kExactFaces, batch, scratch, answers, &counters);
  });
  std::size_t shadowed = 0, undecided = 0, wrong = 0, naive_wrong = 0;
  for (std::size_t i = 0; i < rays; ++i) {
    shadowed += exact[i] == ShadowAnswer::shadowed;
    undecided += certified[i] == ShadowAnswer::undecided;
    wrong += exact[i] != single[i];
    naive_wrong += naive[i] != exact[i];
  }
  const auto pairs = static_cast<double>(counters.pairs);
  std::printf(
      "%s: %zu pairs, %zu rays, shadowed %.3f; all %.3f, none %.3f of the pairs; a pair: nodes %.1f, leaves "
      "%.1f, faces %.1f, tests/ray %.1f, exact %.3f; undecided %zu, naive wrong %zu, unlike the hierarchy "
      "%zu\n",
      title.c_str(), work.batches.size(), rays, static_cast<double>(shadowed) / static_cast<double>(rays),
      static_cast<double>(counters.all) / pairs, static_cast<double>(counters.none) / pairs,
      static_cast<double>(counters.nodes) / pairs, static_cast<double>(counters.leaves) / pairs,
      static_cast<double>(counters.faces) / pairs,
      static_cast<double>(counters.tests) / static_cast<double>(rays),
      static_cast<double>(counters.exact) / pairs, undecided, naive_wrong, wrong);
  Ratios ratios;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const Median time = median_of(seconds[i]), ratio = ratio_of(seconds[i], seconds[0]);
    std::printf("  %-16s %7.2f ns a ray   / pair exact %6.2f [%.2f, %.2f]\n", contenders[i].name.c_str(),
                time.value * 1e9 / static_cast<double>(rays), ratio.value, ratio.low, ratio.high);
    if (contenders[i].name == "hierarchy exact") ratios.hierarchy = ratio.value;
    if (contenders[i].name.starts_with("embree") && !contenders[i].name.ends_with("16")) {
      ratios.embree = ratios.embree > 0 ? std::min(ratios.embree, ratio.value) : ratio.value;
    }
  }
  std::fflush(stdout);
  return ratios;
}

bool is_square(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
  return n > 0 && side * side == n;
}

}  // namespace

std::optional<PairBenchOptions> parse_pairs(int argc, char** argv) {
  PairBenchOptions options;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (!word.starts_with("--")) {
      options.scenes.push_back(word);
      continue;
    }
    if (i + 1 == argc) return std::nullopt;
    const char* value = argv[++i];
    if (word == "--rays") {
      options.rays.clear();
      for (char* end = nullptr;; value = end + 1) {
        const std::size_t rays = std::strtoull(value, &end, 10);
        if (end == value || !is_square(rays) || (*end != ',' && *end != 0)) return std::nullopt;
        options.rays.push_back(rays);
        if (*end == 0) break;
      }
    } else if (word == "--rounds") {
      options.rounds = std::atoi(value);
    } else if (word == "--queries") {
      options.queries = static_cast<std::size_t>(std::max(std::atoll(value), 0LL));
    } else {
      return std::nullopt;
    }
  }
  if (options.rounds < 1 || options.queries < 1) return std::nullopt;
  return options;
}

void print_pairs(const PairBenchOptions& options) {
  std::printf("%s, %d paired rounds; [95 %% interval of the median]\n", fast::hierarchy_instruction_set(),
              options.rounds);
  const std::vector<std::string> names =
      options.scenes.empty() ? std::vector<std::string>{"office", "classroom", "floor"} : options.scenes;
  std::vector<Ratios> all, busy;
  for (const std::string& name : names) {
    const scene::Scene scene = scene::rounded_to_floats(reports::load_scene(name).scene).scene;
    std::vector<std::uint8_t> convex;
    for (const scene::Object& object : scene.objects) convex.push_back(exact::is_convex(scene, object));
    const fast::Hierarchy hierarchy(scene);
    const fast::PairCaster caster(scene, convex);
    Casters casters{hierarchy, caster, {}};
    using reports::EmbreeMode;
    const std::pair<const char*, EmbreeMode> modes[] = {{"embree", EmbreeMode::single},
                                                        {"embree-robust", EmbreeMode::robust},
                                                        {"embree-high", EmbreeMode::high_quality},
                                                        {"embree-packet16", EmbreeMode::packet16}};
    for (const auto& [mode_name, mode] : modes) {
      auto embree = reports::make_embree_segments(scene, mode);
      if (embree != nullptr) casters.embree.emplace_back(mode_name, std::move(embree));
    }
    for (const std::size_t rays : options.rays) {
      const auto pairs = fuzz::record_pairs(scene, {rays, options.queries, 1});
      Workload every, listed;
      std::vector<std::uint32_t> faces;
      for (const auto& pair : pairs) {
        every.add(pair);
        const fast::RayBatch& batch = every.batches.back();
        caster.candidates(caster.prepare(batch.from, batch.own_from), caster.prepare(batch.to, batch.own_to),
                          faces);
        if (!faces.empty()) listed.add(pair);
      }
      const std::string title = name + ", " + std::to_string(rays) + " rays";
      all.push_back(print_row(title, every, casters, options.rounds));
      busy.push_back(print_row(title + ", list not empty", listed, casters, options.rounds));
    }
  }
  std::printf(
      "geometric means: Embree's best single ray / pair exact %s, list not empty %s; hierarchy "
      "exact / pair exact %s, list not empty %s\n",
      mean_text(all, &Ratios::embree).c_str(), mean_text(busy, &Ratios::embree).c_str(),
      mean_text(all, &Ratios::hierarchy).c_str(), mean_text(busy, &Ratios::hierarchy).c_str());
}

}  // namespace gnomon::bench
