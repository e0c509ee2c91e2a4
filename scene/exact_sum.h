// SPDX-License-Identifier: MIT
// Internal to scene/: sums of products of doubles, without any error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gnomon::scene {

/// An exact sum of products of finite doubles: fixed-point numbers wide enough for every one of them
/// (Kulisch, "Computer Arithmetic and Validity", 2008), so that neither overflow nor underflow needs a
/// thought. Positive and negative terms are summed apart, so that carries stay short.
class ExactSum {
 public:
  /// Adds a * b; both must be finite. Holds for up to 2^91 terms.
  void add(double a, double b);
  void subtract(double a, double b) { add(-a, b); }

  /// -1, 0 or 1: the sign of the sum.
  [[nodiscard]] int sign() const;

  /// True when the sum's magnitude is greater than the other's.
  [[nodiscard]] bool exceeds(const ExactSum& other) const;

 private:
  /// A product of two doubles is an integer of at most 106 bits times 2^e, -2148 <= e <= 1942: 4196 bits
  /// hold it, and 67 words leave 92 for carries.
  static constexpr std::size_t kWords = 67;
  using Words = std::array<std::uint64_t, kWords>;  // the least first

  static bool is_less(const Words& a, const Words& b);
  [[nodiscard]] Words magnitude() const;

  Words positive_{}, negative_{};
};

}  // namespace gnomon::scene
