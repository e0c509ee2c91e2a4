// SPDX-License-Identifier: GPL-3.0-or-later
// The speed of batches of radiosity rays, next to the same rays one by one: by our hierarchy, and by Embree
// where it is installed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::bench {

struct PairBenchOptions {
  int rounds = 15;
  std::vector<std::size_t> rays{16, 64, 400};  ///< of a pair: square numbers
  std::size_t queries = 20000;                 ///< rays of a row, at most
  std::vector<std::string> scenes;             ///< names or files; the built-in three when empty
};

/// The words from the third on: [--rounds N] [--rays N,...] [--queries N] [SCENE]... Nothing where they are
/// something else, or a number of rays is no square.
[[nodiscard]] std::optional<PairBenchOptions> parse_pairs(int argc, char** argv);

/// Prints, for every scene and number of rays, ns a ray of every tier with all set-up, and the ratios of the
/// others to the exact tier with 95 % intervals; over all pairs, and over those whose list is not empty.
void print_pairs(const PairBenchOptions& options);

}  // namespace gnomon::bench
