// SPDX-License-Identifier: GPL-3.0-or-later
// What measuring a scene comes to: counts, which are the same on every run, and times, which are not.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/first_hit_row.h"
#include "fuzz/list_statistics.h"
#include "fuzz/scene_method.h"
#include "fuzz/spread.h"
#include "fuzz/verdict.h"

namespace gnomon::fuzz {

/// A method's answers to one workload of one scene.
struct ShadowRow {
  std::string scene, variant, workload;
  std::size_t faces = 0;
  const SceneMethod* method = nullptr;
  /// Exact answers against the method's, in the order of kShadowAnswers.
  std::array<std::array<std::uint64_t, kColumns>, kTruths> matrix{};
  /// The same of the touching queries alone: they are in `matrix` too.
  std::array<std::array<std::uint64_t, kColumns>, kTruths> touching{};
  /// Queries that are answered otherwise when they come in the shuffled order.
  std::uint64_t changed_by_order = 0;
  std::optional<TestCounts> tests;
  std::optional<PairTotals> pairs;  ///< of methods that are asked pair by pair

  using Matrix = std::array<std::array<std::uint64_t, kColumns>, kTruths>;
  [[nodiscard]] static std::uint64_t truths(const Matrix& m, std::size_t truth);
  /// Said to be lit, and in shadow.
  [[nodiscard]] static std::uint64_t false_lit(const Matrix& m) { return m[1][0] + m[2][0]; }
  /// Said to be in shadow, for whatever reason, and lit.
  [[nodiscard]] static std::uint64_t false_shadowed(const Matrix& m) { return m[0][1] + m[0][2]; }
  /// In shadow, but not for the reason that the method says.
  [[nodiscard]] static std::uint64_t wrong_reason(const Matrix& m) { return m[1][2] + m[2][1]; }
  [[nodiscard]] static std::uint64_t unsound(const Matrix& m) {
    return false_lit(m) + false_shadowed(m) + wrong_reason(m);
  }
  [[nodiscard]] static std::uint64_t column(const Matrix& m, std::size_t answer) {
    return m[0][answer] + m[1][answer] + m[2][answer];
  }

  [[nodiscard]] std::uint64_t queries() const {
    return truths(matrix, 0) + truths(matrix, 1) + truths(matrix, 2);
  }
  [[nodiscard]] std::uint64_t dark() const { return truths(matrix, 1) + truths(matrix, 2); }
  [[nodiscard]] bool promise_broken() const;
};

/// Nanoseconds of processor time a query, of the row with the same index.
struct QueryTimes {
  Spread image, shuffled;
  std::optional<Spread> listed;  ///< of radiosity: of the pairs whose shaft exactly holds a face
};

/// What making a method's structure took.
struct SetUp {
  std::string scene, variant;
  const SceneMethod* method = nullptr;
  double seconds = 0;
  std::size_t bytes = 0;
};

struct Measurement {
  std::vector<ShadowRow> rows;
  std::vector<QueryTimes> times;  ///< one a row
  std::vector<FirstHitRow> hit_rows;
  std::vector<QueryTimes> hit_times;  ///< one a row of hit_rows
  std::vector<SetUp> set_ups;
  std::vector<ListRow> lists;
  std::vector<std::string> notes;  ///< what was left out, and why; rounding of scenes

  [[nodiscard]] bool promise_broken() const;
};

}  // namespace gnomon::fuzz
