// SPDX-License-Identifier: MIT
// Numbers of text corpora: decimal or hexadecimal floats, read and written without loss.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gnomon::scene {

/// The whole word as a double: decimal ("-1.5e3"; rounded once to nearest) or hexadecimal ("0x1.8p+1"), with
/// an optional sign. Nothing when the word is no number, has anything after it, or is "inf" or "nan";
/// infinity of its sign when a finite number is beyond the largest double.
[[nodiscard]] std::optional<double> parse_float_text(std::string_view word);

/// The shortest hexadecimal form, "0x1.8p+1": reads back as the same double, -0 and denormals included.
[[nodiscard]] std::string hex_text(double value);

/// The shortest decimal form that reads back as the same double.
[[nodiscard]] std::string decimal_text(double value);

}  // namespace gnomon::scene
