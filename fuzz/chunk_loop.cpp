// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/chunk_loop.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace gnomon::fuzz {

ChunkSource::ChunkSource(const ChunkPlan& plan, FirstFailures& failures)
    : plan_(plan),
      failures_(failures),
      chunks_(plan.seconds ? UINT64_MAX / plan.size : (plan.trials + plan.size - 1) / plan.size) {}

std::optional<Chunk> ChunkSource::next() {
  if (stopped_.load(std::memory_order_relaxed)) return std::nullopt;
  const std::uint64_t taken = taken_.fetch_add(1);
  if (plan_.seconds && taken > 0) {  // no row is left without trials
    const std::chrono::duration<double> spent = Clock::now() - start_;
    if (spent.count() >= *plan_.seconds) return std::nullopt;
  }
  const std::uint64_t number = taken * plan_.shards + (plan_.shard - 1);
  if (number >= chunks_ || failures_.all_before(number)) return std::nullopt;
  const std::uint64_t first = number * plan_.size;
  return Chunk{number, first, plan_.seconds ? plan_.size : std::min(plan_.size, plan_.trials - first)};
}

double ChunkSource::share() const {
  const std::chrono::duration<double> spent = Clock::now() - start_;
  const double part = plan_.seconds
                          ? spent.count() / *plan_.seconds
                          : static_cast<double>(taken_) * plan_.shards / static_cast<double>(chunks_);
  return std::min(1.0, part);
}

void run_chunks(const ChunkPlan& plan, FirstFailures& failures, const std::function<void(ChunkSource&)>& work,
                const std::function<void(double)>& on_share) {
  ChunkSource source(plan, failures);
  std::mutex mutex;
  std::condition_variable finished;
  std::exception_ptr error;
  unsigned threads_left = plan.jobs;
  {
    std::vector<std::jthread> threads;
    for (unsigned j = 0; j < plan.jobs; ++j) {
      threads.emplace_back([&] {
        try {
          work(source);
        } catch (...) {
          const std::lock_guard lock(mutex);
          if (!error) error = std::current_exception();
          source.stop();
        }
        const std::lock_guard lock(mutex);
        if (--threads_left == 0) finished.notify_one();
      });
    }
    std::unique_lock lock(mutex);
    while (threads_left != 0) {
      finished.wait_for(lock, std::chrono::milliseconds(200));
      if (on_share) on_share(source.share());
    }
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace gnomon::fuzz
