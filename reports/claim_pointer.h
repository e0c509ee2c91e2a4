// SPDX-License-Identifier: GPL-3.0-or-later
// Where a claim's status comes from: something that a command shows again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace gnomon::reports {

/// A theorem or lemma that Coq checks.
struct TheoremPointer {
  std::string file;  ///< "proofs/NAME.v"
  std::string name;
};

/// A unit test.
struct TestPointer {
  std::string name;  ///< "Suite.Name", for typed suites too
};

/// A case, and what a method says of it.
struct WitnessPointer {
  std::string file;                   ///< text corpus
  std::optional<std::uint64_t> line;  ///< of the case; none when it is the file's only one
  std::string method;
  std::string answer;   ///< what it says
  std::string exactly;  ///< the exact answer
};

/// Many trials, counted.
struct CampaignPointer {
  std::string command;       ///< "gnomon fuzz QUESTION ..." with method, trials and seed
  std::string counts;        ///< the field of a result row that is counted: "unsound", "waste", "model", ...
  std::uint64_t errors = 0;  ///< its sum over the rows
  std::uint64_t trials = 0;  ///< trials of all rows
  double high95 = 1;         ///< upper end of the 95 % interval of errors / trials
  std::uint64_t subset = 0;  ///< so many trials a row show the same direction
};

/// A time or a rate of this machine's, printed again by a command.
struct MeasurementPointer {
  std::string command;
  std::string figures;  ///< what it printed when the claim was settled, and where
};

using ClaimPointer =
    std::variant<TheoremPointer, TestPointer, WitnessPointer, CampaignPointer, MeasurementPointer>;

/// "theorem", "test", "witness", "campaign", "measurement".
[[nodiscard]] std::string_view kind_of(const ClaimPointer& pointer);

/// What it points to, in a few words.
[[nodiscard]] std::string words_of(const ClaimPointer& pointer);

/// The command that follows it, to be typed in the source folder (`gnomon` is build/release/gnomon).
[[nodiscard]] std::string command_of(const ClaimPointer& pointer);

}  // namespace gnomon::reports
