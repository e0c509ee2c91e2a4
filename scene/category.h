// SPDX-License-Identifier: MIT
// The three answers of the shaft questions.
#pragma once

#include <cstdint>
#include <string_view>

namespace gnomon::scene {

/// How a closed set T lies to a closed shaft S: `outside` when they have no common point, `inside` when T is
/// a subset of S, else `overlap`. Touching counts as meeting.
enum class Category : std::uint8_t { outside, overlap, inside };

[[nodiscard]] constexpr std::string_view name_of(Category category) {
  switch (category) {
    case Category::outside:
      return "outside";
    case Category::overlap:
      return "overlap";
    case Category::inside:
      return "inside";
  }
  return "?";
}

}  // namespace gnomon::scene
