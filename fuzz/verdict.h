// SPDX-License-Identifier: GPL-3.0-or-later
// What a trial comes to.
#pragma once

#include <cstdint>
#include <string_view>

namespace gnomon::fuzz {

/// An answer as an index into its question's list of answers, or one of the two words that every question
/// knows.
using Answer = std::uint8_t;
inline constexpr Answer kUndecided = 3, kRejected = 4;
/// Rows of a matrix are truths (three at most), columns are answers, then undecided and rejected.
inline constexpr std::size_t kTruths = 3, kColumns = 5;

enum class Verdict : std::uint8_t { agree, waste, unsound, undecided, rejected };

[[nodiscard]] constexpr std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::agree:
      return "agree";
    case Verdict::waste:
      return "waste";
    case Verdict::unsound:
      return "unsound";
    case Verdict::undecided:
      return "undecided";
    case Verdict::rejected:
      return "rejected";
  }
  return "?";
}

/// The ways to be wrong about a shaft, worst first.
enum class Fault : std::uint8_t { false_cull, false_inside, false_keep, missed_inside };
inline constexpr std::size_t kFaults = 4;

[[nodiscard]] constexpr std::string_view name_of(Fault fault) {
  switch (fault) {
    case Fault::false_cull:
      return "false cull";
    case Fault::false_inside:
      return "false inside";
    case Fault::false_keep:
      return "false keep";
    case Fault::missed_inside:
      return "missed inside";
  }
  return "?";
}

}  // namespace gnomon::fuzz
