// SPDX-License-Identifier: MIT
// The cases of the question `shadow` as lines of a text corpus.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/corpus.h"
#include "scene/scene.h"
#include "scene/shadow_query.h"

namespace gnomon::scene {

/// One instance of `shadow` with a scene of its own: one object, which is not one-sided.
struct ShadowCase {
  Scene scene;
  ShadowQuery query;

  friend bool operator==(const ShadowCase&, const ShadowCase&) = default;
};

/// Reads `shadow p(3) light(3) own n (tri v0(3) v1(3) v2(3) | ball c(3) r) * n`. `own` is the number of p's
/// face among the n faces of the line, from 0 on, or -1; query.own is its number in the scene, where balls
/// come after all triangles. There may be no faces. Throws InputError naming file and line for anything else:
/// a number that is missing, none, or not finite, an own face that isn't there, a ball that is not valid or
/// reaches beyond the finite numbers, words after the last face.
[[nodiscard]] ShadowCase read_shadow_case(const CorpusLine& line);

/// The answer that the line states, if any; throws InputError for a word that is none of lit, shadowed,
/// facing.
[[nodiscard]] std::optional<Shadow> stated_shadow(const CorpusLine& line);

/// The case as such a line, with numbers as hexadecimal floats; no arrow when the answer is empty. What a
/// line can't say of a scene (objects, lights, views) is left out. `query.own` must be a face or kNoFace.
[[nodiscard]] std::string corpus_text(const ShadowCase& c, std::string_view answer);

}  // namespace gnomon::scene
