// SPDX-License-Identifier: GPL-3.0-or-later
// Whole numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <string>

namespace gnomon::reports {

/// Whole numbers alone: CLI11 reads "-5" as the largest count but four.
[[nodiscard]] inline CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  return {[least, most](const std::string& text) -> std::string {
            std::uint64_t value = 0;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc{} && stop == end && value >= least && value <= most) return {};
            return "expected a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                   ", found \"" + text + "\"";
          },
          ""};
}

}  // namespace gnomon::reports
