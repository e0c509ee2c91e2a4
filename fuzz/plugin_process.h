// SPDX-License-Identifier: GPL-3.0-or-later
// A plug-in's processes, as gnomon sees them: start, ask, wait no longer than a limit, learn how one ended.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "fuzz/file_descriptor.h"
#include "fuzz/plugin_memory.h"

namespace gnomon::fuzz::plugin {

/// One process that has loaded the plug-in. Used by one thread at a time.
struct Worker {
  Worker(pid_t process, const FileDescriptor& memory, FileDescriptor end)
      : pid(process), region(memory, Region::Side::gnomon), channel(std::move(end)) {}

  pid_t pid;
  Region region;
  FileDescriptor channel;
};

/// What comes of waiting for a worker.
enum class Reply : std::uint8_t { ready, ended, timed_out };

/// Waits for the worker's byte. What is left of the limit does not count what signals interrupt.
[[nodiscard]] Reply wait_for(const Worker& worker, double seconds);
/// Lets the worker take up the request in its region.
[[nodiscard]] Reply ask(const Worker& worker, double seconds);

/// The process that all of a plug-in's workers are forked from. It is forked from gnomon when that has only
/// one thread, and loads nothing itself, so that a worker can be started safely at any time, from any thread.
/// It and its workers end with gnomon, however that ends.
class Nursery {
 public:
  /// Call it on the main thread, while that is the only one. Throws std::system_error.
  explicit Nursery(std::string library);
  ~Nursery();
  Nursery(const Nursery&) = delete;
  Nursery& operator=(const Nursery&) = delete;

  /// Starts a process that loads the plug-in; wait_for() tells when that is done. Throws std::system_error,
  /// also when the nursery itself is gone.
  [[nodiscard]] std::unique_ptr<Worker> start();
  /// Ends a worker, giving it a little time to end by itself when it may; the status is that of waitpid().
  int end(const Worker& worker, bool by_itself);

 private:
  std::mutex mutex_;
  FileDescriptor channel_;
  pid_t pid_ = -1;
};

}  // namespace gnomon::fuzz::plugin
