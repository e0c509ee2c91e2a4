// SPDX-License-Identifier: MIT
// The question `shadow`: is a point hidden from a point light?
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace gnomon::scene {

/// Stands for "no face" where a face's number is expected.
inline constexpr std::uint32_t kNoFace = 0xffff'ffff;

/// A point, the light that it may be hidden from, and the face of the scene that it lies on: the own face, or
/// kNoFace. The point need not lie on its own face exactly. Equal point and light: an empty segment, lit
/// unless facing. All numbers must be finite.
struct ShadowQuery {
  std::array<double, 3> point{}, light{};
  std::uint32_t own = kNoFace;

  friend bool operator==(const ShadowQuery&, const ShadowQuery&) = default;
};

/// `facing`: in shadow without a blocker, because a one-sided own surface faces away from the light.
enum class Shadow : std::uint8_t { lit, shadowed, facing };

[[nodiscard]] constexpr std::string_view name_of(Shadow shadow) {
  switch (shadow) {
    case Shadow::lit:
      return "lit";
    case Shadow::shadowed:
      return "shadowed";
    case Shadow::facing:
      return "facing";
  }
  return "?";
}

}  // namespace gnomon::scene
