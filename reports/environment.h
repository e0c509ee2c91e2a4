// SPDX-License-Identifier: GPL-3.0-or-later
// Where figures were measured.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gnomon::reports {

/// Compiler, flags, processor, threads, and what the floating-point environment does: (name, value) in print
/// order.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> environment();

/// The version as `gnomon --version` says it.
[[nodiscard]] std::string version();

}  // namespace gnomon::reports
