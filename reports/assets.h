// SPDX-License-Identifier: GPL-3.0-or-later
// The report's style sheet, scripts and Vega, and the ledger, embedded into the library when it is built.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gnomon::reports {

/// The bytes of an embedded file, by name ("report.css", "vega-util"); they live as long as the program.
/// Throws std::logic_error for a name that was not embedded.
[[nodiscard]] std::string_view asset(std::string_view name);

/// The names of Vega's components, each after all that it needs.
[[nodiscard]] std::vector<std::string_view> vega_modules();

}  // namespace gnomon::reports
