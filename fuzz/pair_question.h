// SPDX-License-Identifier: GPL-3.0-or-later
// The questions shaft-candidates and patch-pair, as the trial loop sees them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exact/patch_pair.h"
#include "exact/shaft_candidates.h"
#include "fuzz/face_sums.h"
#include "fuzz/pair_method.h"
#include "fuzz/question_words.h"

namespace gnomon::fuzz {

/// What an answer comes to: the row and column of the matrix.
struct PairJudgement {
  std::size_t truth = 0;
  Answer answer = 0;
  FaceSums faces{};
};

/// Holds lists of faces against each other without sorting them.
class FaceMarks {
 public:
  /// Of a list that is right and one that a method gave, in a scene of so many faces. Throws
  /// std::runtime_error, which says what is wrong with it, for a list that names a face twice or one that is
  /// not there.
  [[nodiscard]] FaceSums compare(std::size_t face_count, std::span<const std::uint32_t> truth,
                                 std::span<const std::uint32_t> listed);

 private:
  std::vector<std::uint64_t> marks_;
  std::uint64_t last_ = 0;
};

struct CandidateQuestion {
  static constexpr std::string_view id = "shaft-candidates";
  using Query = BoxPair;
  using Method = CandidateMethod;
  using Maker = CandidateFinder;
  using Reply = std::vector<std::uint32_t>;  ///< faces
  /// What refers queries about a scene that many of them share.
  using Referee = exact::ShaftCandidates;

  [[nodiscard]] static std::span<const Method> methods() { return candidate_methods(); }
  static void ask(const Maker& finder, const Query& query, Reply& reply) { finder.faces(query, reply); }
  static void refer(const Referee& referee, const Query& query, Reply& truth);
  static void refer(const scene::Scene& scene, const Query& query, Reply& truth);
  [[nodiscard]] static PairJudgement judge(const scene::Scene& scene, const Reply& truth, const Reply& reply,
                                           FaceMarks& marks);
};

struct PatchQuestion {
  static constexpr std::string_view id = "patch-pair";
  using Query = scene::PatchPair;
  using Method = PairMethod;
  using Maker = PairJudge;
  using Reply = Answer;
  using Referee = exact::PatchPairs;

  [[nodiscard]] static std::span<const Method> methods() { return pair_methods(); }
  static void ask(const Maker& judge, const Query& query, Reply& reply) { reply = judge.visibility(query); }
  static void refer(const Referee& referee, const Query& query, Reply& truth);
  static void refer(const scene::Scene& scene, const Query& query, Reply& truth);
  /// Throws std::runtime_error for an answer that is none.
  [[nodiscard]] static PairJudgement judge(const scene::Scene& scene, const Reply& truth, const Reply& reply,
                                           FaceMarks& marks);
};

/// The case as a line of a corpus, with the exact answer.
[[nodiscard]] std::string pair_text(const scene::Scene& scene, const BoxPair& query,
                                    const std::vector<std::uint32_t>& truth);
[[nodiscard]] std::string pair_text(const scene::Scene& scene, const scene::PatchPair& query, Answer truth);

}  // namespace gnomon::fuzz
