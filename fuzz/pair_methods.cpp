// SPDX-License-Identifier: GPL-3.0-or-later
// The registry rows of shaft-candidates and patch-pair. Adding methods is a file with their finders or judges
// and a table of rows, and a line here.
#include <numeric>

#include "exact/patch_pair.h"
#include "exact/shaft_candidates.h"
#include "fuzz/list_candidates.h"
#include "fuzz/pair_caster_rows.h"
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

const CandidateMethod kTrivialFinder[] = {
    {"trivial", "trivial", Promise::never_unsound, kAllFloats, "every face of the scene", make_all_faces},
};
const CandidateMethod kReferenceFinder[] = {
    {"reference", "reference", Promise::always_agrees, kAllFloats,
     "what judges the others: exact, by a hierarchy; small scenes are judged face by face",
     make_reference_finder},
};

const PairMethod kTrivialJudge[] = {
    {"trivial", "trivial", Promise::never_unsound, kAllFloats, "always part", make_always_part},
};
const PairMethod kReferenceJudge[] = {
    {"reference", "reference", Promise::always_agrees, kAllFloats,
     "what judges the others: exact, by a hierarchy; small scenes are judged face by face",
     make_reference_judge},
};

template <class Row>
std::vector<Row> joined(std::initializer_list<std::span<const Row>> tables) {
  std::vector<Row> rows;
  for (const std::span<const Row> table : tables) rows.insert(rows.end(), table.begin(), table.end());
  return rows;
}

}  // namespace

std::span<const CandidateMethod> candidate_methods() {
  static const std::vector<CandidateMethod> rows = joined<CandidateMethod>({
      kTrivialFinder,
      list_candidate_rows(),
      caster_candidate_rows(),
      kReferenceFinder,
  });
  return rows;
}

std::span<const PairMethod> pair_methods() {
  static const std::vector<PairMethod> rows = joined<PairMethod>({
      kTrivialJudge,
      caster_pair_rows(),
      kReferenceJudge,
  });
  return rows;
}

}  // namespace gnomon::fuzz
