// SPDX-License-Identifier: GPL-3.0-or-later
// How many cases of each class a test has seen: a comparison that never met a class proves nothing about it.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "tests/shaft_rational_reference.h"

namespace gnomon::tests {

struct ClassCounts {
  std::array<int, 3> of{};  ///< by Category
  int touching_outside = 0, touching_inside = 0;
  std::uint64_t in_rationals = 0;
  int false_positives = 0;

  void add(const ReferenceAnswer& answer) {
    ++of[static_cast<std::size_t>(answer.truth)];
    touching_outside += answer.touches_outside;
    touching_inside += answer.touches_inside;
  }

  [[nodiscard]] int least() const {
    return std::min({of[0], of[1], of[2], touching_outside, touching_inside});
  }

  void record() const {
    testing::Test::RecordProperty("outside", of[0]);
    testing::Test::RecordProperty("overlap", of[1]);
    testing::Test::RecordProperty("inside", of[2]);
    testing::Test::RecordProperty("touching_outside", touching_outside);
    testing::Test::RecordProperty("touching_inside", touching_inside);
    testing::Test::RecordProperty("in_rationals", static_cast<int>(in_rationals));
    testing::Test::RecordProperty("false_positives", false_positives);
  }

  void expect_at_least(int count) const {
    EXPECT_GE(of[0], count) << "outside";
    EXPECT_GE(of[1], count) << "overlap";
    EXPECT_GE(of[2], count) << "inside";
    EXPECT_GE(touching_outside, count) << "touching outside";
    EXPECT_GE(touching_inside, count) << "touching inside";
  }
};

}  // namespace gnomon::tests
