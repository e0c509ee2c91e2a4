// SPDX-License-Identifier: MIT
#include "scene/parse_number.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace gnomon::scene {
namespace {

/// std::from_chars says "out of range" for too large and for too small alike. Both lie far from 1, so the
/// sign of the decimal exponent of the first non-zero digit tells them apart. The word is known to be a
/// well-formed number.
bool is_beyond_one(std::string_view word) {
  const std::size_t e = word.find_first_of("eE");
  const std::string_view mantissa = word.substr(0, e);
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  // Digits between the first non-zero one and the point; negative when the point comes first.
  const auto digits = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  if (e == std::string_view::npos) return digits > 0;
  std::string_view exponent = word.substr(e + 1);
  if (exponent.front() == '+') exponent.remove_prefix(1);
  const std::optional<std::int64_t> value = parse_integer(exponent);
  // An exponent of over 64 bits outweighs the digits of any word that fits in memory.
  return value ? *value > -digits : exponent.front() != '-';
}

}  // namespace

template <class F>
std::optional<F> parse_real(std::string_view word) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word.front() == '-') return std::nullopt;
  }
  F value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || (error != std::errc{} && error != std::errc::result_out_of_range)) return std::nullopt;
  if (word.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    value = is_beyond_one(word) ? std::numeric_limits<F>::infinity() : F(0);
    if (word.front() == '-') value = -value;
  }
  return value;
}

template std::optional<float> parse_real<float>(std::string_view);
template std::optional<double> parse_real<double>(std::string_view);

std::optional<std::int64_t> parse_integer(std::string_view word) {
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace gnomon::scene
