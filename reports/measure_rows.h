// SPDX-License-Identifier: GPL-3.0-or-later
// What result files of `gnomon measure` say, as the report needs it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/list_figures.h"
#include "reports/summary.h"

namespace gnomon::reports {

class Node;

/// Median and quartiles of rounds, in nanoseconds a query.
struct TimeSpread {
  double median = 0, low25 = 0, high75 = 0;
};

/// What a method that is asked pair by pair found out.
struct PairShares {
  std::uint64_t pairs = 0, all = 0, none = 0;  ///< all lit and all blocked: without a test of any ray
  double faces = 0;                            ///< candidates a pair
};

/// One method on one workload of one variant of a scene. Field names are those of the result file.
struct MeasureRow {
  std::string question, scene, variant, workload, method, tier, promise;
  std::uint64_t faces = 0, queries = 0;
  Share false_lit, false_shadowed;          ///< of `shadow` alone
  Share wrong_face, false_miss, false_hit;  ///< of `first-hit` alone
  std::uint64_t wrong_reason = 0, unsound = 0, unsound_touching = 0, undecided = 0, rejected = 0;
  std::uint64_t changed_by_order = 0;
  std::map<std::string, std::uint64_t> truths;    ///< queries by exact answer
  std::map<std::string, std::uint64_t> touching;  ///< touching ones by exact answer
  bool promise_broken = false;
  std::optional<double> boxes, face_tests, exact;  ///< tests a query
  std::optional<TimeSpread> image, shuffled;
  std::optional<TimeSpread> listed;  ///< of radiosity: of the pairs whose shaft exactly holds a face
  std::optional<PairShares> pairs;
  std::optional<double> set_up_seconds;
  std::uint64_t bytes = 0;
};

/// The rows of a result file of that kind with what was measured of them. Throws scene::InputError, with one
/// line, for what is missing or can't be.
[[nodiscard]] std::vector<MeasureRow> read_measure_rows(const Node& top);

/// One result file of `gnomon measure`.
struct MeasureFile {
  std::filesystem::path path;
  std::vector<MeasureRow> rows;
  std::vector<ListFigures> lists;  ///< candidate lists on progressive radiosity
};

/// Those of a folder, in the order of their names; other result files are passed over.
[[nodiscard]] std::vector<MeasureFile> read_measure_files(const std::filesystem::path& folder);

}  // namespace gnomon::reports
