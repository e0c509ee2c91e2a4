// SPDX-License-Identifier: GPL-3.0-or-later
// Which methods failed in a batch of trials, and where first: the same for any number of threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "fuzz/method_failure.h"

namespace gnomon::fuzz {

/// The failure of the lowest chunk for each method. Chunks are handed out in order, and a method is asked for
/// every chunk below its first failure, so that the lowest one is found whatever the threads do.
class FirstFailures {
 public:
  explicit FirstFailures(std::size_t methods) : first_(methods) {}

  /// Did the method fail on a chunk before this one? Then it need not be asked.
  [[nodiscard]] bool before(std::size_t method, std::uint64_t chunk) {
    const std::lock_guard lock(mutex_);
    return first_[method] && first_[method]->chunk < chunk;
  }
  [[nodiscard]] bool all_before(std::uint64_t chunk) {
    const std::lock_guard lock(mutex_);
    return std::all_of(first_.begin(), first_.end(),
                       [chunk](const auto& first) { return first && first->chunk < chunk; });
  }
  void add(std::size_t method, std::uint64_t chunk, const MethodFailure& failure) {
    const std::lock_guard lock(mutex_);
    if (!first_[method] || chunk < first_[method]->chunk) first_[method] = At{chunk, failure};
  }
  [[nodiscard]] std::optional<MethodFailure> of(std::size_t method) {
    const std::lock_guard lock(mutex_);
    return first_[method] ? std::optional(first_[method]->failure) : std::nullopt;
  }

 private:
  struct At {
    std::uint64_t chunk;
    MethodFailure failure;
  };
  std::mutex mutex_;
  std::vector<std::optional<At>> first_;
};

}  // namespace gnomon::fuzz
