// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/html_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gnomon::reports {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// The length of the UTF-8 sequence at the start of `text`, 0 when there is none that is well formed.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  std::size_t length = 0;
  std::uint32_t code = 0;
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) length = 2, code = lead & 0x1FU;
  if (lead >= 0xE0 && lead <= 0xEF) length = 3, code = lead & 0x0FU;
  if (lead >= 0xF0 && lead <= 0xF4) length = 4, code = lead & 0x07U;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool forbidden =
      (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF || code == 0xFFFE || code == 0xFFFF;
  return overlong || forbidden ? 0 : length;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t length = utf8_length(text);
    const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' && c != '\r';
    if (length == 0 || control || c == 0x7F) {
      out += kReplacement;
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '\'') {
      out += "&#39;";
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

std::string script_safe(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

std::string shell_word(std::string_view text) {
  const bool plain =
      !text.empty() && text.front() != '-' && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./:,+=@%").find(c) != std::string_view::npos;
      });
  if (plain) return std::string(text);
  std::string out = text.starts_with('-') ? "'./" : "'";
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + "'";
}

std::string thousands(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, ",");
  }
  return digits;
}

std::string rate_text(double rate) {
  if (rate == 0) return "0";
  if (rate == 1) return "100\u00a0%";
  if (rate < 1e-3) {
    std::string text = fmt::format("{:.1e}", rate);
    if (text.size() == 7 && text[5] == '0') text.erase(5, 1);  // 4.5e-05 as 4.5e-5
    return text;
  }
  return rate > 0.999 ? fmt::format("{:.5g}\u00a0%", 100 * rate) : fmt::format("{:.3g}\u00a0%", 100 * rate);
}

std::string share_text(const Share& share) {
  if (share.n == 0) return "none asked";
  if (share.k == 0) return fmt::format("0 of {} (< {})", thousands(share.n), rate_text(share.rate.high95));
  return fmt::format("{} of {}", thousands(share.k), thousands(share.n));
}

std::string share_html(const Share& share) {
  return "<span class=\"nowrap\">" + escaped(share_text(share)) + "</span>";
}

std::string time_text(std::optional<double> ns) {
  if (!ns) return "–";
  if (*ns < 1000) return fmt::format("{:.3g}\u00a0ns", *ns);
  return *ns < 1e6 ? fmt::format("{:.3g}\u00a0µs", *ns / 1e3) : fmt::format("{:.3g}\u00a0ms", *ns / 1e6);
}

std::string ulps_text(std::optional<double> ulps) {
  return ulps ? fmt::format("{:.3g} ulp", *ulps) : "beyond any double";
}

}  // namespace gnomon::reports
