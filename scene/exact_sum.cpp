// SPDX-License-Identifier: MIT
#include "scene/exact_sum.h"

#include <algorithm>
#include <bit>

namespace gnomon::scene {
namespace {

__extension__ typedef unsigned __int128 Uint128;

/// |value| = integer * 2^exponent, exponent >= -1074.
struct Parts {
  std::uint64_t integer;
  int exponent;
};

Parts parts_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  return {field == 0 ? fraction : fraction | std::uint64_t{1} << 52, std::max(field, 1) - 1075};
}

bool is_negative(double value) {
  return (std::bit_cast<std::uint64_t>(value) >> 63) != 0;
}

}  // namespace

void ExactSum::add(double a, double b) {
  const Parts x = parts_of(a), y = parts_of(b);
  const Uint128 product = static_cast<Uint128>(x.integer) * y.integer;
  if (product == 0) return;
  Words& words = is_negative(a) != is_negative(b) ? negative_ : positive_;
  const auto place = static_cast<std::size_t>(x.exponent + y.exponent + 2 * 1074);
  const std::size_t shift = place % 64;
  const Uint128 low = product << shift;
  const std::uint64_t parts[3] = {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(low >> 64),
                                  shift == 0 ? 0 : static_cast<std::uint64_t>(product >> (128 - shift))};
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < 3 || carry != 0; ++i) {
    std::uint64_t& word = words.at(place / 64 + i);
    const Uint128 sum = static_cast<Uint128>(word) + (i < 3 ? parts[i] : 0) + carry;
    word = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64);
  }
}

bool ExactSum::is_less(const Words& a, const Words& b) {
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

int ExactSum::sign() const {
  return is_less(negative_, positive_) ? 1 : is_less(positive_, negative_) ? -1 : 0;
}

ExactSum::Words ExactSum::magnitude() const {
  const bool negative = is_less(positive_, negative_);
  const Words& more = negative ? negative_ : positive_;
  const Words& less = negative ? positive_ : negative_;
  Words words{};
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < kWords; ++i) {
    words[i] = more[i] - less[i] - borrow;
    borrow = more[i] < less[i] || (more[i] == less[i] && borrow != 0) ? 1 : 0;
  }
  return words;
}

bool ExactSum::exceeds(const ExactSum& other) const {
  return is_less(other.magnitude(), magnitude());
}

}  // namespace gnomon::scene
