// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/bench/box_and_ball.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "fast/shaft_ball.h"
#include "fast/shaft_box.h"
#include "reports/bench/batch_data.h"
#include "reports/bench/paired.h"

namespace gnomon::bench {

namespace {

constexpr int kShafts = 8;

/// Boxes, and balls with their centres and the mean of their half sides, against a few shafts.
template <class F>
struct Items {
  std::vector<fast::Shaft<F>> of_boxes, of_balls;
  std::vector<scene::Box<F>> boxes;
  std::vector<scene::Ball<F>> balls;

  Items(Data data, std::size_t count) {
    for (const Ends& ends : make_shafts(data, kShafts)) {
      const auto a = scene::converted<F>(ends.a), b = scene::converted<F>(ends.b);
      of_boxes.push_back(fast::form_shaft(a, b, fast::Normals::as_formed));
      of_balls.push_back(fast::form_shaft(a, b, fast::Normals::unit));
    }
    for (std::size_t i = 0; i < count; ++i) {
      fuzz::CaseRandom random(8, static_cast<std::uint32_t>(data), i);
      const scene::Box<F> box = scene::converted<F>(random_box(random, data, 0.05f));
      scene::Ball<F> ball;
      for (int axis = 0; axis < 3; ++axis) {
        ball.centre[static_cast<std::size_t>(axis)] = (box.lo(axis) + box.hi(axis)) / 2;
        ball.radius += (box.hi(axis) - box.lo(axis)) / 6;
      }
      boxes.push_back(box);
      balls.push_back(ball);
    }
  }
};

scene::Category category_of(scene::Category category) {
  return category;
}
scene::Category category_of(fast::Banded banded) {
  return banded.answer;
}

/// The share of items that are told to be outside.
template <class Shaft, class Item, class Classify>
double run(const std::vector<Shaft>& shafts, const std::vector<Item>& items, int round, Classify classify) {
  const Shaft& shaft = shafts[static_cast<std::size_t>(round) % shafts.size()];
  std::size_t outside = 0;
  for (const Item& item : items) outside += category_of(classify(shaft, item)) == scene::Category::outside;
  return static_cast<double>(outside) / static_cast<double>(items.size());
}

template <class F>
void print_rows(Data data, const std::string& scalar, const BoxAndBallOptions& options) {
  const auto items = std::make_shared<const Items<F>>(data, options.items);
  const auto whole = [](const auto& shaft, const auto& item) { return fast::classify(shaft, item); };
  const auto printed = [](const auto& shaft, const auto& item) {
    return fast::classify_as_printed(shaft, item);
  };
  std::vector<Contender> contenders;
  const auto add = [&](const char* name, auto classify, const auto& shafts, const auto& those) {
    contenders.push_back({name, [&shafts, &those, items, classify](int round) {
                            benchmark::DoNotOptimize(run(shafts, those, round, classify));
                          }});
  };
  add("printed, boxes", printed, items->of_boxes, items->boxes);
  add("printed, balls", printed, items->of_balls, items->balls);
  add("corrected, boxes", whole, items->of_boxes, items->boxes);
  add("corrected, balls", whole, items->of_balls, items->balls);

  double boxes_outside = 0, balls_outside = 0;
  for (int round = 0; round < kShafts; ++round) {
    boxes_outside += run(items->of_boxes, items->boxes, round, whole) / kShafts;
    balls_outside += run(items->of_balls, items->balls, round, whole) / kShafts;
  }
  std::printf("%s, %s: outside %.3f of the boxes, %.3f of the balls\n", name_of(data).c_str(), scalar.c_str(),
              boxes_outside, balls_outside);
  const auto seconds =
      time_paired(contenders, options.rounds, 6, static_cast<int>(1 + 20000 / options.items));
  const double to_nanoseconds = 1e9 / static_cast<double>(options.items);
  for (std::size_t i = 0; i < contenders.size(); i += 2) {
    const Median ratio = ratio_of(seconds[i], seconds[i + 1]);
    std::printf("  %-17s %6.2f ns   %-17s %6.2f ns   box / ball %.3f [%.3f, %.3f]\n",
                contenders[i].name.c_str(), median_of(seconds[i]).value * to_nanoseconds,
                contenders[i + 1].name.c_str(), median_of(seconds[i + 1]).value * to_nanoseconds, ratio.value,
                ratio.low, ratio.high);
  }
  std::fflush(stdout);
}

}  // namespace

void print_box_and_ball(const BoxAndBallOptions& options) {
  std::printf("one item at a time, %zu items, %d paired rounds; [95 %% interval of the median]\n",
              options.items, options.rounds);
  for (const Data data : {Data::random6, Data::random8, Data::ties}) {
    print_rows<float>(data, "f32", options);
    print_rows<double>(data, "f64", options);
  }
}

}  // namespace gnomon::bench
