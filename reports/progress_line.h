// SPDX-License-Identifier: GPL-3.0-or-later
// How far a long job is, for people at terminals.
#pragma once

#include <chrono>
#include <string>

namespace gnomon::reports {

/// A line on standard error where that is a terminal, with the time left; silent elsewhere. The line is gone
/// when the object is.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// `done` is a share of 1.
  void show(double done, const std::string& where);

 private:
  bool terminal_, shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace gnomon::reports
