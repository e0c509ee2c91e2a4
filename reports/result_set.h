// SPDX-License-Identifier: GPL-3.0-or-later
// What result files say, as the report needs it: rows of counts, witnesses, timings.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::reports {

/// A rate with its two-sided 95 % interval, 0 <= low95 <= value <= high95 <= 1.
struct Rate {
  double value = 0;
  double low95 = 0;
  double high95 = 1;
  std::optional<std::uint64_t> of;  ///< of how many cases
};

/// How far a case is from its decision boundary: the exact number as "p/q" (for balls of a length squared),
/// and as a length and in ulps for reading; nothing where these are beyond double's range.
struct GapText {
  std::string rational;
  std::optional<double> approx, ulps;
};

/// Counts by exact answer, then by the method's answer.
using Matrix = std::map<std::string, std::map<std::string, std::uint64_t>>;

/// One row of a campaign: a method on a distribution. Field names are those of the result file.
struct ResultRow {
  std::string question, method, promise, tier, distribution, scalar;
  std::uint64_t trials = 0;
  std::map<std::string, std::uint64_t> touching;
  Matrix matrix;
  std::uint64_t waste = 0, unsound = 0, false_culls = 0, false_insides = 0, unsound_touching = 0;
  std::uint64_t undecided = 0, rejected = 0;
  std::uint64_t rounding = 0, model = 0, rounding_and_model = 0;
  bool knows_twin = true;                      ///< false: errors are not told apart into rounding and model
  bool independent = true;                     ///< false: all queries are of one scene
  std::map<std::string, std::uint64_t> faces;  ///< sums of shaft-candidates: true, listed, missing, excess
  Rate waste_rate, unsound_rate;
  std::optional<Rate> false_inside_rate;
  std::optional<GapText> worst_gap;
  bool promise_broken = false;
  std::uint64_t threshold_exceeded = 0;
  std::optional<double> ns;            ///< measured time per case, when the file has one for this row
  std::optional<double> reference_ns;  ///< the exact reference's on the same cases
};

/// A saved disagreement.
struct ResultWitness {
  std::string name, question, method, distribution, scalar, verdict, answer, reference, case_line;
  std::string as_generated;  ///< the case before it was shrunk; may be empty
  std::optional<GapText> gap;
};

/// One result file. For kinds other than "fuzz" only `table` is filled: each row's plain fields as text.
struct ResultFile {
  std::string name, kind, tool, command;
  std::string shard;  ///< "I/N" or, merged, "I,J/N"; empty or "1/1" when the file is the whole run
  std::optional<std::uint64_t> seed;
  std::vector<std::uint64_t> seeds;  ///< more than one when runs of several seeds were merged
  std::vector<ResultRow> rows;
  std::vector<ResultWitness> witnesses;
  std::vector<std::vector<std::pair<std::string, std::string>>> table;
  std::vector<std::pair<std::string, std::string>> environment;
};

}  // namespace gnomon::reports
