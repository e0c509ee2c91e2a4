// SPDX-License-Identifier: GPL-3.0-or-later
// Two results of one workload: errors first, then speed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/measure_rows.h"

namespace gnomon::reports {

struct CompareOptions {
  /// Times per case whose ratio is within 1 - tolerance .. 1 + tolerance count as equal.
  double tolerance = 0.05;
  /// A row that takes more than this many times its old time is a regression; without it speed is none.
  std::optional<double> speed_limit;
};

enum class Change : std::uint8_t { worse, better, other };

/// One count of one row that differs. Seed and cases are the same, so counts are no samples: every change is
/// one of the method (or of the numbers that it is given), never of chance.
struct ErrorChange {
  std::string row;    ///< "shaft-box naive-f32 uniform f32"
  std::string field;  ///< of the result file, e.g. "unsound"
  std::uint64_t before = 0, after = 0;
  Change change = Change::other;
  std::string words = {};  ///< for "promise", where the numbers are its strength: which promises
};

struct SpeedChange {
  std::string row;
  double before = 0, after = 0;  ///< ns per case, above 0
  double ratio = 1;              ///< after / before
  bool within_noise = true, above_limit = false;
  /// Quartiles of rounds, which results of `gnomon measure` have.
  std::optional<TimeSpread> before_spread = {}, after_spread = {};
};

struct Comparison {
  std::string old_name, new_name, command;
  std::string unit = "case";              ///< what times are of: a case, or a query
  std::size_t rows = 0;                   ///< in both
  std::vector<ErrorChange> errors;        ///< worse, then better, then other ones
  std::vector<SpeedChange> speeds;        ///< slowest first
  std::optional<double> reference_ratio;  ///< median of the exact reference's new / old time
  std::vector<std::string> only_old, only_new;
  /// The same command gave both: a row that is only in the old result is lost, not left out on purpose.
  bool same_command = false;
  /// What differs between the places where the two were measured: name, then "old -> new".
  std::vector<std::pair<std::string, std::string>> environment;

  [[nodiscard]] bool regressed() const;
};

/// Compares two results of one kind, `gnomon fuzz` or `gnomon measure`.
///
/// Of `gnomon fuzz`: row by row (question, method, distribution, scalar). Worse is: a
/// promise newly broken; more of unsound, false_culls, false_insides or unsound_touching in any row; more
/// waste, undecided or rejected in a certified or exact one; a row that the same command no longer gives.
/// Throws scene::InputError naming the file and what was expected when one is no result file, when seeds or
/// shards differ, when no row is in both, and when a row in both has other trials or other cases (seen by
/// their exact answers).
///
/// Of `gnomon measure`: as compare_measurements() does. Throws, besides, when one kind is not the other.
[[nodiscard]] Comparison compare_results(const std::filesystem::path& before,
                                         const std::filesystem::path& after, const CompareOptions& options);

/// Compares two results of `gnomon measure`, row by row (question, scene, variant, workload, method). Worse
/// is: a promise weakened or newly broken; more wrong answers of any kind in any row; more undecided,
/// rejected or changed by order in one that promises something; a row that the same command no longer gives.
/// A time is within noise when its ratio is within the tolerance or the quartiles of old and new overlap; it
/// is above the limit only when they don't. Throws scene::InputError when seeds or lights differ, when no row
/// is in both, and when a row in both has other faces or other queries (by number, exact answers and touching
/// ones).
[[nodiscard]] Comparison compare_measurements(const std::filesystem::path& before,
                                              const std::filesystem::path& after,
                                              const CompareOptions& options);

/// For people; ends with a newline.
[[nodiscard]] std::string comparison_text(const Comparison& comparison, const CompareOptions& options);
/// The same for scripts: schema 1, kind "compare".
[[nodiscard]] std::string comparison_json(const Comparison& comparison, const CompareOptions& options);

}  // namespace gnomon::reports
