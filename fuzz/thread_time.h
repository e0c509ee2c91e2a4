// SPDX-License-Identifier: GPL-3.0-or-later
// Processor time.
#pragma once

#include <ctime>

namespace gnomon::fuzz {

/// The processor time of the calling thread in nanoseconds: what other programs on the machine take does not
/// count.
[[nodiscard]] inline double thread_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

}  // namespace gnomon::fuzz
