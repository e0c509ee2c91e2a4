// SPDX-License-Identifier: GPL-3.0-or-later
// gnomon_bench: the speed of the batch kernels next to a plain read of the same memory.
//
//   gnomon_bench table [--rounds N] [--boxes] [--balls] [--most COUNT]
//     paired rounds, medians and ratios, as text
//   gnomon_bench box-and-ball [--rounds N] [--items N]
//     the same of the paper's tests, one item at a time
//   gnomon_bench shadow-truth [--rounds N] [--queries N] [--most TRIANGLES]
//     the exact shadow reference next to CGAL's AABB_tree
//   gnomon_bench shadow-tiers [--rounds N] [--most FACES] [--side N]
//     the tiers of the common ray caster on generated scenes, and Embree where it is installed
//   gnomon_bench pairs [--rounds N] [--rays 16,64,400] [--queries N] [SCENE]...
//     batches of radiosity rays next to single rays, on built-in scenes and files
//   gnomon_bench [--benchmark_...]
//     Google Benchmark on the workloads of the table
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "exact/shaft_ball.h"
#include "exact/shaft_box.h"
#include "fast/batch_ball.h"
#include "fast/batch_box.h"
#include "fast/certified_shaft.h"
#include "reports/bench/batch_data.h"
#include "reports/bench/box_and_ball.h"
#include "reports/bench/paired.h"
#include "reports/bench/pairs.h"
#include "reports/bench/shadow_tiers.h"
#include "reports/bench/shadow_truth.h"

namespace gnomon::bench {

namespace {

constexpr int kShafts = 8;

/// Reads every cache line's every word: what no kernel can be faster than from memory.
__attribute__((target_clones("avx512f", "avx2", "default"))) std::uint64_t read_all(const void* data,
                                                                                    std::size_t bytes) {
  const auto* words = static_cast<const std::uint64_t*>(data);
  std::uint64_t sums[32] = {};
  const std::size_t count = bytes / 8;
  std::size_t i = 0;
  for (; i + 32 <= count; i += 32) {
    for (std::size_t k = 0; k < 32; ++k) sums[k] |= words[i + k];
  }
  for (; i < count; ++i) sums[0] |= words[i];
  std::uint64_t all = 0;
  for (const std::uint64_t sum : sums) all |= sum;
  return all;
}

/// A row of the table: the same items in both precisions, a few shafts, and everybody who works on them.
struct Row {
  std::vector<Contender> contenders;
  std::size_t count = 0;
  double outside = 0, second_stage = 0, on_grid = 0, predicate = 0;  ///< shares, from the f32 exact tier
};

/// The contenders of one precision: `Questions` knows how to classify.
template <class F, class Items, class Questions>
void add_contenders(Row& row, std::shared_ptr<const Items> items, const std::vector<Ends>& ends,
                    const std::string& scalar, bool outside_only) {
  const std::size_t count = items->view().count;
  const auto bytes = std::make_shared<std::vector<std::uint8_t>>(count);
  const auto plane = std::make_shared<std::vector<std::uint64_t>>(fast::words_for(count));
  const auto questions = std::make_shared<std::vector<Questions>>();
  for (const Ends& pair : ends) {
    questions->emplace_back(scene::converted<F>(pair.a), scene::converted<F>(pair.b));
  }
  row.contenders.push_back({"read-" + scalar, [items](int) {
                              for (const auto& array : items->c) {
                                benchmark::DoNotOptimize(read_all(array.data(), array.size() * sizeof(F)));
                              }
                            }});
  const auto add = [&](const std::string& name, auto classify) {
    row.contenders.push_back({name + "-" + scalar, [=](int round) {
                                const Questions& q = (*questions)[static_cast<std::size_t>(round) % kShafts];
                                if (outside_only) {
                                  classify(q, items->view(), fast::BitPlanes{plane->data(), nullptr});
                                } else {
                                  classify(q, items->view(), std::span<std::uint8_t>(*bytes));
                                }
                                benchmark::ClobberMemory();
                              }});
  };
  add("naive", [](const Questions& q, const auto& view, auto out) { q.classify(q.naive, view, out); });
  add("certified",
      [](const Questions& q, const auto& view, auto out) { q.classify(q.certified, view, out); });
  add("exact", [](const Questions& q, const auto& view, auto out) { (void)q.exact(view, out); });
  if (sizeof(F) == 4) {
    fast::BatchCounters all;
    std::size_t outside = 0;
    for (const Questions& q : *questions) {
      const fast::BatchCounters counters = q.exact(items->view(), std::span<std::uint8_t>(*bytes));
      all.second_stage += counters.second_stage;
      all.on_grid += counters.on_grid;
      all.predicate_calls += counters.predicate_calls;
      for (const std::uint8_t byte : *bytes) outside += byte == 0;
    }
    const double trials = static_cast<double>(count) * static_cast<double>(ends.size());
    row.outside = static_cast<double>(outside) / trials;
    row.second_stage = static_cast<double>(all.second_stage) / trials;
    row.on_grid = static_cast<double>(all.on_grid) / trials;
    row.predicate = static_cast<double>(all.predicate_calls) / trials;
  }
}

template <class F>
struct BoxQuestions {
  BoxQuestions(const scene::Box<F>& a_box, const scene::Box<F>& b_box)
      : a(a_box),
        b(b_box),
        naive(fast::form_shaft(a, b, fast::Normals::as_formed)),
        certified(fast::form_certified_box_shaft(a, b)),
        exact_shaft(a, b) {}

  template <class Out>
  static void classify(const fast::BatchBoxShaft<F>& shaft, const fast::BoxesSoA<F>& boxes, Out out) {
    fast::classify_boxes<F>(shaft, boxes, out);
  }
  template <class Out>
  fast::BatchCounters exact(const fast::BoxesSoA<F>& boxes, Out out) const {
    return fast::classify_boxes_exact<F>(exact_shaft, boxes, out, [this](const scene::Box<F>& t) {
      return exact::classify(scene::converted<double>(scene::ShaftBoxCaseOf<F>{a, b, t}));
    });
  }

  scene::Box<F> a, b;
  fast::BatchBoxShaft<F> naive, certified;
  fast::ExactBoxShaft<F> exact_shaft;
};

Row box_row(Data data, std::size_t count, bool outside_only) {
  Row row;
  row.count = count;
  const std::vector<Ends> ends = make_shafts(data, kShafts);
  add_contenders<float, Boxes<float>, BoxQuestions<float>>(
      row, std::make_shared<const Boxes<float>>(make_boxes<float>(data, count)), ends, "f32", outside_only);
  add_contenders<double, Boxes<double>, BoxQuestions<double>>(
      row, std::make_shared<const Boxes<double>>(make_boxes<double>(data, count)), ends, "f64", outside_only);
  return row;
}

template <class F>
struct BallQuestions {
  BallQuestions(const scene::Box<F>& a_box, const scene::Box<F>& b_box)
      : a(a_box),
        b(b_box),
        naive(fast::form_shaft(a, b, fast::Normals::unit)),
        certified(fast::form_certified_ball_shaft(a, b)),
        exact_shaft(a, b) {}

  template <class Out>
  static void classify(const fast::BatchBallShaft<F>& shaft, const fast::BallsSoA<F>& balls, Out out) {
    fast::classify_balls<F>(shaft, balls, out);
  }
  template <class Out>
  fast::BatchCounters exact(const fast::BallsSoA<F>& balls, Out out) const {
    return fast::classify_balls_exact<F>(exact_shaft, balls, out, [this](const scene::Ball<F>& t) {
      return exact::classify(scene::converted<double>(scene::ShaftBallCaseOf<F>{a, b, t}));
    });
  }

  scene::Box<F> a, b;
  fast::BatchBallShaft<F> naive, certified;
  fast::ExactBallShaft<F> exact_shaft;
};

Row ball_row(Data data, std::size_t count, bool outside_only) {
  Row row;
  row.count = count;
  const std::vector<Ends> ends = make_shafts(data, kShafts);
  add_contenders<float, Balls<float>, BallQuestions<float>>(
      row, std::make_shared<const Balls<float>>(make_balls<float>(data, count)), ends, "f32", outside_only);
  add_contenders<double, Balls<double>, BallQuestions<double>>(
      row, std::make_shared<const Balls<double>>(make_balls<double>(data, count)), ends, "f64", outside_only);
  return row;
}

/// "value [low, high]"
std::string text_of(const Median& median) {
  char text[80];
  std::snprintf(text, sizeof text, "%.3f [%.3f, %.3f]", median.value, median.low, median.high);
  return text;
}

/// Prints the row, and says how fast exact-f32 is next to naive-f32.
Median print_row(const std::string& title, const Row& row, int rounds) {
  // Slices of about 0.1 ms, of which the fastest counts: what else the machine does comes in longer pieces.
  const int repeats = static_cast<int>(std::max<std::size_t>(1, 100000 / row.count));
  const int slices = row.count > 1000000 ? 1 : 12;
  const auto seconds = time_paired(row.contenders, rounds, slices, repeats);
  std::printf("%s, N = %zu: outside %.3f, second stage %.3g (on a grid %.3g), predicate %.2g\n",
              title.c_str(), row.count, row.outside, row.second_stage, row.on_grid, row.predicate);
  const std::size_t half = row.contenders.size() / 2;
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    const Median taken = median_of(seconds[i]);
    // The naive row of the same precision, and the read of the same memory.
    const Median to_naive = ratio_of(seconds[i < half ? 1 : half + 1], seconds[i]);
    const Median to_naive32 = ratio_of(seconds[1], seconds[i]);
    const Median to_read = ratio_of(seconds[i < half ? 0 : half], seconds[i]);
    std::printf("  %-14s %7.0f M/s   of naive %s   of naive-f32 %s   of the read %s\n",
                row.contenders[i].name.c_str(), static_cast<double>(row.count) / taken.value * 1e-6,
                text_of(to_naive).c_str(), text_of(to_naive32).c_str(), text_of(to_read).c_str());
  }
  std::fflush(stdout);
  return ratio_of(seconds[1], seconds[3]);
}

constexpr std::size_t kInL1 = 1000, kInL2 = 40000, kInMemory = 10000000;
constexpr Data kAllData[] = {Data::random6, Data::random8, Data::ties, Data::dense_ties};

struct TableOptions {
  int rounds = 31;
  bool boxes = true, balls = true;
  std::size_t most = kInMemory;
};

int print_table(const TableOptions& options) {
  std::printf(
      "batch kernels on %s, %d paired rounds; \"of\" is a ratio of speeds, [95 %% interval of the median]\n",
      fast::batch_instruction_set(), options.rounds);
  std::string summary;
  const auto add_row = [&](const std::string& title, const Row& row) {
    const Median exact = print_row(title, row, options.rounds);
    char line[160];
    std::snprintf(line, sizeof line, "  %-40s N = %8zu   %s\n", title.c_str(), row.count,
                  text_of(exact).c_str());
    summary += line;
  };
  for (const std::size_t count : {kInL1, kInL2, kInMemory}) {
    if (count > options.most) continue;
    for (const Data data : kAllData) {
      if (options.boxes) {
        add_row("boxes, three-way, " + name_of(data), box_row(data, count, false));
        if (count == kInL1) add_row("boxes, outside only, " + name_of(data), box_row(data, count, true));
      }
      if (options.balls) add_row("balls, three-way, " + name_of(data), ball_row(data, count, false));
    }
  }
  std::printf("exact-f32 of naive-f32:\n%s", summary.c_str());
  return 0;
}

void register_row(const std::string& items, Data data, const Row& row) {
  for (const Contender& contender : row.contenders) {
    const std::string name =
        items + "/" + name_of(data) + "/" + std::to_string(row.count) + "/" + contender.name;
    benchmark::RegisterBenchmark(name.c_str(), [contender, count = row.count](benchmark::State& state) {
      int round = 0;
      for (auto _ : state) contender.run(round++);
      state.SetItemsProcessed(static_cast<std::int64_t>(count) * state.iterations());
    });
  }
}

void register_all() {
  for (const std::size_t count : {kInL1, kInL2}) {
    for (const Data data : kAllData) {
      register_row("boxes", data, box_row(data, count, false));
      register_row("balls", data, ball_row(data, count, false));
    }
  }
}

int usage() {
  std::fprintf(stderr,
               "usage: gnomon_bench table [--rounds N] [--boxes] [--balls] [--most COUNT]\n"
               "       gnomon_bench box-and-ball [--rounds N] [--items N]\n"
               "       gnomon_bench shadow-truth [--rounds N] [--queries N] [--most TRIANGLES]\n"
               "       gnomon_bench shadow-tiers [--rounds N] [--most FACES] [--side N]\n"
               "       gnomon_bench pairs [--rounds N] [--rays N,...] [--queries N] [SCENE]...\n");
  return 2;
}

/// An option with a number of at least 1, and where it goes.
struct CountOption {
  std::string_view name;
  std::variant<int*, std::size_t*> into;
};

/// Reads the words from the third on; false when one is no such option with its number.
bool read_counts(int argc, char** argv, std::initializer_list<CountOption> options) {
  for (int i = 2; i < argc; i += 2) {
    const auto* const option = std::find_if(options.begin(), options.end(),
                                            [&](const CountOption& known) { return known.name == argv[i]; });
    const int number = i + 1 < argc ? std::atoi(argv[i + 1]) : 0;
    if (option == options.end() || number < 1) return false;
    std::visit([number](auto* into) { *into = static_cast<std::remove_pointer_t<decltype(into)>>(number); },
               option->into);
  }
  return true;
}

int box_and_ball(int argc, char** argv) {
  BoxAndBallOptions options;
  if (!read_counts(argc, argv, {{"--rounds", &options.rounds}, {"--items", &options.items}})) return usage();
  print_box_and_ball(options);
  return 0;
}

int shadow_truth(int argc, char** argv) {
  ShadowTruthOptions options;
  if (!read_counts(
          argc, argv,
          {{"--rounds", &options.rounds}, {"--queries", &options.queries}, {"--most", &options.most}})) {
    return usage();
  }
  print_shadow_truth(options);
  return 0;
}

int pairs(int argc, char** argv) {
  const std::optional<PairBenchOptions> options = parse_pairs(argc, argv);
  if (!options) return usage();
  print_pairs(*options);
  return 0;
}

int shadow_tiers(int argc, char** argv) {
  ShadowTierOptions options;
  if (!read_counts(argc, argv,
                   {{"--rounds", &options.rounds}, {"--most", &options.most}, {"--side", &options.side}})) {
    return usage();
  }
  print_shadow_tiers(options);
  return 0;
}

}  // namespace

int run(int argc, char** argv) {
  if (argc >= 2 && std::strcmp(argv[1], "box-and-ball") == 0) return box_and_ball(argc, argv);
  if (argc >= 2 && std::strcmp(argv[1], "shadow-truth") == 0) return shadow_truth(argc, argv);
  if (argc >= 2 && std::strcmp(argv[1], "pairs") == 0) return pairs(argc, argv);
  if (argc >= 2 && std::strcmp(argv[1], "shadow-tiers") == 0) return shadow_tiers(argc, argv);
  if (argc < 2 || std::strcmp(argv[1], "table") != 0) {
    register_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return usage();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
  }
  TableOptions options;
  bool chosen = false;
  for (int i = 2; i < argc; ++i) {
    const std::string option = argv[i];
    const auto choose = [&](bool& which) {
      if (!chosen) options.boxes = options.balls = false;
      chosen = which = true;
    };
    if (option == "--boxes") {
      choose(options.boxes);
    } else if (option == "--balls") {
      choose(options.balls);
    } else if (i + 1 < argc && option == "--rounds") {
      options.rounds = std::atoi(argv[++i]);
    } else if (i + 1 < argc && option == "--most") {
      options.most = static_cast<std::size_t>(std::atoll(argv[++i]));
    } else {
      return usage();
    }
  }
  if (options.rounds < 1) return usage();
  return print_table(options);
}

}  // namespace gnomon::bench

int main(int argc, char** argv) {
  return gnomon::bench::run(argc, argv);
}
