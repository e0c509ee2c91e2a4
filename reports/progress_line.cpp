// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace gnomon::reports {

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double done, const std::string& where) {
  if (!terminal_) return;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = done > 0.01 ? seconds / done - seconds : 0;
  std::fprintf(stderr, "\r\033[K%3.0f %%  %s  %.0f s left", 100 * done, where.c_str(), left);
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace gnomon::reports
