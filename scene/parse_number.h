// SPDX-License-Identifier: MIT
// Words to numbers, strictly: the whole word or nothing, and no locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace gnomon::scene {

/// The decimal number that is the whole word, rounded once to the nearest F (ties to even); F is float or
/// double. Nothing when the word is no number, or has anything after it. A magnitude beyond F's range gives
/// the infinity of its sign, one below the least denormal gives zero or that denormal, whichever is nearer,
/// with its sign; "inf" and "nan" in strtod's spellings give themselves, so ask std::isfinite. One leading
/// '+' is allowed; hexadecimal is not.
template <class F>
[[nodiscard]] std::optional<F> parse_real(std::string_view word);

/// The decimal integer that is the whole word; nothing when it is none (also "+1" and "1.0") or needs over 64
/// bits.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view word);

extern template std::optional<float> parse_real<float>(std::string_view);
extern template std::optional<double> parse_real<double>(std::string_view);

}  // namespace gnomon::scene
