// SPDX-License-Identifier: GPL-3.0-or-later
// Text and numbers as the report writes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reports/summary.h"

namespace gnomon::reports {

/// The text with & < > " ' written as entities, so that it is text and nothing else in HTML and SVG, in
/// attributes too; control characters that XML forbids become U+FFFD, and so does what is not UTF-8.
[[nodiscard]] std::string escaped(std::string_view text);

/// A JSON text safe inside <script>: every '<' written as \u003c.
[[nodiscard]] std::string script_safe(std::string_view json);

/// The text as one word of a POSIX shell.
[[nodiscard]] std::string shell_word(std::string_view text);

/// 1234567 as "1,234,567".
[[nodiscard]] std::string thousands(std::uint64_t n);

/// A rate in words (the blank does not break): "12.3 %" from 0.1 % on, "4.5e-5" below, "0" for 0.
[[nodiscard]] std::string rate_text(double rate);

/// "0 of 66,123 (< 5.6e-5)", "204 of 66,123", or "none asked" for n = 0.
[[nodiscard]] std::string share_text(const Share& share);

/// The same as HTML that does not break across lines.
[[nodiscard]] std::string share_html(const Share& share);

/// "12.5 ns", "1.24 µs", or a dash for a time that was not measured.
[[nodiscard]] std::string time_text(std::optional<double> ns);

/// A gap in ulps, "0.25 ulp" or "3.1e+05 ulp", or that it is beyond double's range.
[[nodiscard]] std::string ulps_text(std::optional<double> ulps);

}  // namespace gnomon::reports
