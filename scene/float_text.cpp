// SPDX-License-Identifier: MIT
#include "scene/float_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "scene/parse_number.h"

namespace gnomon::scene {

namespace {

std::optional<double> parse_hex(std::string_view digits) {
  // A sign or "inf" after the "0x" would be taken by from_chars.
  constexpr std::string_view kFirst = "0123456789abcdefABCDEF.";
  if (digits.empty() || kFirst.find(digits.front()) == std::string_view::npos) return std::nullopt;
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value, std::chars_format::hex);
  if (stop != end) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too large or too small: only the exponent tells. What underflows has a negative one.
    const std::size_t p = digits.find_first_of("pP");
    const bool small = p != std::string_view::npos && p + 1 < digits.size() && digits[p + 1] == '-';
    return small ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (error != std::errc{}) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_float_text(std::string_view word) {
  std::string_view rest = word;
  const bool negative = !rest.empty() && rest.front() == '-';
  if (!rest.empty() && (rest.front() == '-' || rest.front() == '+')) rest.remove_prefix(1);
  if (rest.size() > 2 && rest[0] == '0' && (rest[1] == 'x' || rest[1] == 'X')) {
    const std::optional<double> value = parse_hex(rest.substr(2));
    if (!value || std::isnan(*value)) return std::nullopt;
    return negative ? -*value : *value;
  }
  // Words of letters ("inf", "nan") are no numbers here.
  if (rest.empty() || !((rest.front() >= '0' && rest.front() <= '9') || rest.front() == '.'))
    return std::nullopt;
  return parse_real<double>(word);
}

std::string hex_text(double value) {
  std::array<char, 40> buffer{};
  const double magnitude = std::fabs(value);
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude, std::chars_format::hex);
  const std::string digits(buffer.data(), error == std::errc{} ? end : buffer.data());
  return (std::signbit(value) ? "-0x" : "0x") + digits;
}

std::string decimal_text(double value) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), error == std::errc{} ? end : buffer.data()};
}

}  // namespace gnomon::scene
