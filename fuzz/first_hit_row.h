// SPDX-License-Identifier: GPL-3.0-or-later
// What asking a method for first hits comes to, as counts.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fuzz/scene_method.h"

namespace gnomon::fuzz {

/// The exact answers of `first-hit`, as rows of a matrix.
inline constexpr std::array<std::string_view, 2> kHitTruths{"none", "face"};
/// What can be said, as its columns: `right` is any of the faces that tie, `rejected` a number of no face.
inline constexpr std::array<std::string_view, 5> kHitAnswers{"none", "right", "wrong", "undecided",
                                                             "rejected"};

/// A method's answers to one workload of rays of one scene.
struct FirstHitRow {
  enum Column : std::uint8_t { none, right, wrong, undecided, rejected };
  using Matrix = std::array<std::array<std::uint64_t, kHitAnswers.size()>, kHitTruths.size()>;

  std::string scene, variant, workload;
  std::size_t faces = 0;
  const SceneMethod* method = nullptr;
  Matrix matrix{};
  /// The same of the touching rays alone: they are in `matrix` too.
  Matrix touching{};
  /// Rays on which several faces tie.
  std::uint64_t ties = 0;
  /// Rays that are answered otherwise when they come in the shuffled order.
  std::uint64_t changed_by_order = 0;
  std::optional<TestCounts> tests;

  /// Rays that meet nothing, exactly (0), or some face (1).
  [[nodiscard]] static std::uint64_t truths(const Matrix& m, std::size_t truth);
  /// A face that is met later, or not at all, in the place of the first one.
  [[nodiscard]] static std::uint64_t wrong_face(const Matrix& m) { return m[1][wrong]; }
  /// Said to meet nothing though it meets a face.
  [[nodiscard]] static std::uint64_t false_miss(const Matrix& m) { return m[1][none]; }
  /// Said to meet a face though it meets nothing.
  [[nodiscard]] static std::uint64_t false_hit(const Matrix& m) { return m[0][wrong]; }
  [[nodiscard]] static std::uint64_t unsound(const Matrix& m) {
    return wrong_face(m) + false_miss(m) + false_hit(m);
  }
  [[nodiscard]] static std::uint64_t column(const Matrix& m, Column answer) {
    return m[0][answer] + m[1][answer];
  }

  [[nodiscard]] std::uint64_t queries() const { return truths(matrix, 0) + truths(matrix, 1); }
  [[nodiscard]] bool promise_broken() const;
};

}  // namespace gnomon::fuzz
