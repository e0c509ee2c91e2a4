// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shaft-candidates and patch-pair. Adding a method is a finder or judge (a file) and a
// row in its table.
#include <numeric>

#include "exact/patch_pair.h"
#include "exact/shaft_candidates.h"
#include "fuzz/pair_method.h"

namespace gnomon::fuzz {
namespace {

constexpr std::string_view kAllFloats = "all finite floats";

class AllFaces final : public CandidateFinder {
 public:
  explicit AllFaces(std::size_t count) : count_(count) {}
  void faces(const BoxPair& /*pair*/, std::vector<std::uint32_t>& out) const override {
    out.resize(count_);
    std::iota(out.begin(), out.end(), 0u);
  }

 private:
  std::size_t count_;
};

std::unique_ptr<CandidateFinder> make_all_faces(const scene::Scene& scene) {
  return std::make_unique<AllFaces>(scene.face_count());
}

class AlwaysPart final : public PairJudge {
 public:
  [[nodiscard]] Answer visibility(const scene::PatchPair& /*pair*/) const override {
    return static_cast<Answer>(scene::PairVisibility::part);
  }
};

std::unique_ptr<PairJudge> make_always_part(const scene::Scene& /*scene*/) {
  return std::make_unique<AlwaysPart>();
}

class ReferenceFinder final : public CandidateFinder {
 public:
  explicit ReferenceFinder(const scene::Scene& scene) : candidates_(scene) {}
  void faces(const BoxPair& pair, std::vector<std::uint32_t>& out) const override {
    candidates_.faces(scene::converted<double>(pair.a), scene::converted<double>(pair.b), out);
  }

 private:
  exact::ShaftCandidates candidates_;
};

std::unique_ptr<CandidateFinder> make_reference_finder(const scene::Scene& scene) {
  return std::make_unique<ReferenceFinder>(scene);
}

class ReferenceJudge final : public PairJudge {
 public:
  explicit ReferenceJudge(const scene::Scene& scene) : pairs_(scene) {}
  [[nodiscard]] Answer visibility(const scene::PatchPair& pair) const override {
    return static_cast<Answer>(pairs_.visibility(pair));
  }

 private:
  exact::PatchPairs pairs_;
};

std::unique_ptr<PairJudge> make_reference_judge(const scene::Scene& scene) {
  return std::make_unique<ReferenceJudge>(scene);
}

const CandidateMethod kCandidateRows[] = {
    {"trivial", "trivial", Promise::never_unsound, kAllFloats, "every face of the scene", make_all_faces},
    {"reference", "reference", Promise::always_agrees, kAllFloats,
     "what judges the others: exact, by a hierarchy; small scenes are judged face by face",
     make_reference_finder},
};

const PairMethod kPairRows[] = {
    {"trivial", "trivial", Promise::never_unsound, kAllFloats, "always part", make_always_part},
    {"reference", "reference", Promise::always_agrees, kAllFloats,
     "what judges the others: exact, by a hierarchy; small scenes are judged face by face",
     make_reference_judge},
};

}  // namespace

std::span<const CandidateMethod> candidate_methods() {
  return kCandidateRows;
}

std::span<const PairMethod> pair_methods() {
  return kPairRows;
}

}  // namespace gnomon::fuzz
