// SPDX-License-Identifier: MIT
// The cases of the questions `shaft-candidates` and `patch-pair` as lines of a text corpus.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/box.h"
#include "scene/corpus.h"
#include "scene/patch_pair.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// One instance of `shaft-candidates` with a scene of its own.
struct CandidatesCase {
  Scene scene;
  Box<double> a, b;
  std::vector<std::uint32_t> number;  ///< the scene's number of each face of the line, from 0 on

  friend bool operator==(const CandidatesCase&, const CandidatesCase&) = default;
};

/// One instance of `patch-pair` with a scene of its own.
struct PairCase {
  Scene scene;
  PatchPair pair;
  std::vector<std::uint32_t> number;  ///< as above

  friend bool operator==(const PairCase&, const PairCase&) = default;
};

/// Reads `shaft-candidates Alo(3) Ahi(3) Blo(3) Bhi(3) n (tri v0(3) v1(3) v2(3) | ball c(3) r) * n`. Throws
/// InputError naming file and line for anything else: a number that is missing, none, or not finite, a box
/// with lo > hi, a ball that is not valid or reaches beyond the finite numbers, words after the last face.
[[nodiscard]] CandidatesCase read_candidates_case(const CorpusLine& line);

/// Reads `patch-pair a0(3) a1(3) a2(3) own b0(3) b1(3) b2(3) own n (tri ... | ball ...) * n`. `own` is the
/// number of the patch's face among the n faces of the line, from 0 on, or -1; the pair has its number in the
/// scene. Throws as above, and for an own face that isn't there.
[[nodiscard]] PairCase read_pair_case(const CorpusLine& line);

/// The faces that the line states, if any: numbers of the scene, ascending. Throws InputError for what is no
/// `{0 2 5}` (`{}` for none), with numbers of faces as on the line, in any order, none twice.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> stated_candidates(const CorpusLine& line,
                                                                          const CandidatesCase& c);

/// Numbers of the scene as such a set, with the numbers that the faces have on the line.
[[nodiscard]] std::string candidates_text(std::span<const std::uint32_t> faces,
                                          std::span<const std::uint32_t> number);

/// The answer that the line states, if any; throws InputError for a word that is none of all, none, part.
[[nodiscard]] std::optional<PairVisibility> stated_visibility(const CorpusLine& line);

/// The case as such a line, with numbers as hexadecimal floats, first all triangles, then all balls; no arrow
/// when the answer is empty. What a line can't say of a scene (objects, lights, views) is left out.
[[nodiscard]] std::string corpus_text(const CandidatesCase& c, std::string_view answer);
[[nodiscard]] std::string corpus_text(const PairCase& c, std::string_view answer);

}  // namespace gnomon::scene
