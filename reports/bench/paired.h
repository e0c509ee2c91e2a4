// SPDX-License-Identifier: GPL-3.0-or-later
// Paired timing: all contenders run in every round, in turn, and are compared round by round. On a shared
// machine the speed of the whole drifts by tens of percent, but its ratios within a round hardly do.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace gnomon::bench {

/// Something to time: one call works through all items of a row.
struct Contender {
  std::string name;
  std::function<void(int round)> run;
};

/// A median with the interval that covers the true one with at least 95 %: order statistics of the sample,
/// whose ranks follow the binomial distribution with p = 1/2; nothing is assumed of how times are
/// distributed.
struct Median {
  double value = 0, low = 0, high = 0;
};

[[nodiscard]] inline Median median_of(std::vector<double> sample) {
  std::sort(sample.begin(), sample.end());
  const std::size_t n = sample.size();
  // The largest k with P(Binomial(n, 1/2) < k) <= 2.5 %.
  double probability = std::pow(0.5, static_cast<double>(n)), below = 0;
  std::size_t k = 0;
  while (k < n / 2 && below + probability <= 0.025) {
    below += probability;
    probability *= static_cast<double>(n - k) / static_cast<double>(k + 1);
    ++k;
  }
  const std::size_t low = k > 0 ? k - 1 : 0;
  return {n % 2 != 0 ? sample[n / 2] : (sample[n / 2 - 1] + sample[n / 2]) / 2, sample[low],
          sample[n - 1 - low]};
}

/// seconds[contender][round]: in each round everybody has `slices` turns of `repeats` calls each; the fastest
/// turn counts.
[[nodiscard]] inline std::vector<std::vector<double>> time_paired(const std::vector<Contender>& contenders,
                                                                  int rounds, int slices, int repeats) {
  using Clock = std::chrono::steady_clock;
  std::vector<std::vector<double>> seconds(contenders.size());
  for (int round = -1; round < rounds; ++round) {  // round -1 warms up
    std::vector<double> best(contenders.size(), std::numeric_limits<double>::infinity());
    for (int slice = 0; slice < slices; ++slice) {
      for (std::size_t i = 0; i < contenders.size(); ++i) {
        // Every other slice backwards, so that nobody always follows the same neighbour.
        const std::size_t which = (round + slice) % 2 == 0 ? i : contenders.size() - 1 - i;
        if (slices > 1) contenders[which].run(std::max(round, 0));  // its caches and branch predictors
        const auto start = Clock::now();
        for (int repeat = 0; repeat < repeats; ++repeat) contenders[which].run(std::max(round, 0));
        best[which] =
            std::min(best[which], std::chrono::duration<double>(Clock::now() - start).count() / repeats);
      }
    }
    for (std::size_t i = 0; i < contenders.size() && round >= 0; ++i) seconds[i].push_back(best[i]);
  }
  return seconds;
}

/// The median of numerator[round] / denominator[round].
[[nodiscard]] inline Median ratio_of(const std::vector<double>& numerator,
                                     const std::vector<double>& denominator) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < numerator.size(); ++i) ratios.push_back(numerator[i] / denominator[i]);
  return median_of(std::move(ratios));
}

}  // namespace gnomon::bench
