// SPDX-License-Identifier: GPL-3.0-or-later
// Threads over the chunks of a batch of trials.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "fuzz/first_failures.h"

namespace gnomon::fuzz {

/// Which trials of a batch are run, and by how many threads.
struct ChunkPlan {
  std::uint64_t size = 1024;        ///< trials a chunk
  std::uint64_t trials = 0;         ///< of the whole batch, all shards together
  std::optional<double> seconds{};  ///< instead of trials; at least a chunk is run
  unsigned jobs = 1, shard = 1, shards = 1;
};

/// The trials first .. first + count - 1.
struct Chunk {
  std::uint64_t number = 0, first = 0, count = 0;
};

/// Hands out this shard's chunks in their order, to any number of threads.
class ChunkSource {
 public:
  ChunkSource(const ChunkPlan& plan, FirstFailures& failures);

  /// The next chunk; none when all are taken, the time is over, every method has failed, or stop() was
  /// called.
  [[nodiscard]] std::optional<Chunk> next();
  void stop() { stopped_ = true; }
  /// About how much is taken, of 1.
  [[nodiscard]] double share() const;

 private:
  using Clock = std::chrono::steady_clock;

  ChunkPlan plan_;
  FirstFailures& failures_;
  std::uint64_t chunks_;
  Clock::time_point start_ = Clock::now();
  std::atomic<std::uint64_t> taken_ = 0;
  std::atomic<bool> stopped_ = false;
};

/// Runs `work` in each of the plan's threads; it takes chunks until there are none. Says the share done to
/// `on_share`, when there is one, a few times a second and from the calling thread. Throws what the first
/// thread that failed threw.
void run_chunks(const ChunkPlan& plan, FirstFailures& failures, const std::function<void(ChunkSource&)>& work,
                const std::function<void(double)>& on_share);

}  // namespace gnomon::fuzz
