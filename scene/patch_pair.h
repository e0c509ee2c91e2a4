// SPDX-License-Identifier: MIT
// The question `patch-pair`: do two patches see each other?
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "scene/shadow_query.h"

namespace gnomon::scene {

/// A patch that sends or receives light: the closed triangle of these corners, which may be degenerate, and
/// the face of the scene that it is, or kNoFace (a part of a polygon light is none).
struct Patch {
  std::array<std::array<double, 3>, 3> corners{};
  std::uint32_t face = kNoFace;

  friend bool operator==(const Patch&, const Patch&) = default;
};

struct PatchPair {
  Patch a, b;

  friend bool operator==(const PatchPair&, const PatchPair&) = default;
};

/// An open segment between the patches is the set of (1-s)p + sq, 0 < s < 1, for a p of `a` and a q of `b`.
/// all: no face of the scene but the two patches' own meets an open segment between them.
/// none: not all, and one other face (a triangle or a ball) that lies strictly between the planes of both
///   patches meets the open segment from every corner of `a` to every corner of `b`, and so every open
///   segment between them: the shadow of a convex set is convex. Strictly between: every point p of the face
///   has n_a.(p - a_0) of one sign, not 0, the one that all corners of `b` have too (n_a the normal of `a`,
///   by its corners), and the same with the patches exchanged. A patch without a normal, or that the other
///   one's plane cuts or touches, has nothing between.
/// part: otherwise. What several faces hide together counts as part.
enum class PairVisibility : std::uint8_t { all, none, part };

[[nodiscard]] constexpr std::string_view name_of(PairVisibility visibility) {
  switch (visibility) {
    case PairVisibility::all:
      return "all";
    case PairVisibility::none:
      return "none";
    case PairVisibility::part:
      return "part";
  }
  return "?";
}

}  // namespace gnomon::scene
