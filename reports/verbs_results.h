// SPDX-License-Identifier: GPL-3.0-or-later
// The verbs that read result files and write others: compare, merge.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace gnomon::reports {

/// Adds the verbs; once one is parsed, `run` is set to what it does and returns the exit status.
void add_result_verbs(CLI::App& app, std::function<int()>& run);

}  // namespace gnomon::reports
