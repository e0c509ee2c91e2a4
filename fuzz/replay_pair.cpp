// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/replay_pair.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "exact/patch_pair.h"
#include "exact/shaft_candidates.h"
#include "fuzz/replay_shadow.h"
#include "scene/pair_case.h"
#include "scene/scalar.h"

namespace gnomon::fuzz {

namespace {

using Faces = std::vector<std::uint32_t>;
using scene::PairVisibility;

std::string where_of(const scene::CorpusLine& line) {
  return line.file + ":" + std::to_string(line.line);
}

[[noreturn]] void fail_for_two_references(const std::string& where) {
  throw std::logic_error(where + ": the exact references differ: a bug of gnomon's");
}

bool are_floats(const scene::Box<double>& box) {
  return std::ranges::all_of(box.c, scene::is_float);
}

bool are_floats(const scene::Patch& patch) {
  return std::ranges::all_of(patch.corners,
                             [](const auto& p) { return std::ranges::all_of(p, scene::is_float); });
}

Verdict verdict_of(const Faces& answer, const Faces& truth) {
  if (!std::ranges::includes(answer, truth)) return Verdict::unsound;
  return answer.size() == truth.size() ? Verdict::agree : Verdict::waste;
}

Verdict verdict_of(Answer answer, PairVisibility truth) {
  if (answer == kRejected) return Verdict::rejected;
  if (answer == kUndecided) return Verdict::undecided;
  if (answer == static_cast<Answer>(truth)) return Verdict::agree;
  return answer == static_cast<Answer>(PairVisibility::part) ? Verdict::waste : Verdict::unsound;
}

std::string name_of_answer(Answer answer) {
  if (answer == kRejected) return "rejected";
  return std::string(answer == kUndecided ? "undecided" : name_of(static_cast<PairVisibility>(answer)));
}

/// What the method lists, ascending.
Faces faces_by(const CandidateMethod& method, const scene::CandidatesCase& c, const std::string& where) {
  Faces faces;
  method.make(c.scene)->faces({scene::converted<float>(c.a), scene::converted<float>(c.b)}, faces);
  std::sort(faces.begin(), faces.end());
  const bool twice = std::adjacent_find(faces.begin(), faces.end()) != faces.end();
  if (twice || (!faces.empty() && faces.back() >= c.scene.face_count())) {
    throw std::logic_error(where + ": " + std::string(method.name) +
                           " lists a face twice, or one that is not there: a bug of gnomon's");
  }
  return faces;
}

}  // namespace

void replay_candidates(const scene::CorpusLine& line, std::span<const CandidateMethod* const> methods,
                       ReplayResult& result) {
  const scene::CandidatesCase c = scene::read_candidates_case(line);
  const std::optional<Faces> stated = scene::stated_candidates(line, c);
  const std::string where = where_of(line);
  const Faces truth = exact::shaft_candidates_by_all_faces(c.scene, c.a, c.b);
  Faces by_hierarchy;
  exact::ShaftCandidates(c.scene).faces(c.a, c.b, by_hierarchy);
  if (by_hierarchy != truth) fail_for_two_references(where);
  const std::string reference = scene::candidates_text(truth, c.number);
  ++result.cases;
  if (stated) ++result.stated;
  if (stated && *stated != truth) result.wrong_answers.push_back({where, *line.answer, reference});
  const bool in_domain = are_floats(c.a) && are_floats(c.b) && are_floats(c.scene);
  for (const CandidateMethod* method : methods) {
    const Faces answer = in_domain ? faces_by(*method, c, where) : Faces();
    const Verdict verdict = in_domain ? verdict_of(answer, truth) : Verdict::rejected;
    result.lines.push_back({where, line.question, std::string(method->name),
                            in_domain ? scene::candidates_text(answer, c.number) : "rejected", reference,
                            std::string(name_of(verdict)), is_broken(method->promise, verdict)});
  }
}

void replay_pair(const scene::CorpusLine& line, std::span<const PairMethod* const> methods,
                 ReplayResult& result) {
  const scene::PairCase c = scene::read_pair_case(line);
  const std::optional<PairVisibility> stated = scene::stated_visibility(line);
  const std::string where = where_of(line);
  const PairVisibility truth = exact::patch_pair_by_all_faces(c.scene, c.pair);
  if (exact::PatchPairs(c.scene).visibility(c.pair) != truth) fail_for_two_references(where);
  const std::string reference(name_of(truth));
  ++result.cases;
  if (stated) ++result.stated;
  if (stated && *stated != truth) result.wrong_answers.push_back({where, *line.answer, reference});
  const bool in_domain = are_floats(c.pair.a) && are_floats(c.pair.b) && are_floats(c.scene);
  for (const PairMethod* method : methods) {
    const Answer answer = in_domain ? method->make(c.scene)->visibility(c.pair) : kRejected;
    const Verdict verdict = verdict_of(answer, truth);
    result.lines.push_back({where, line.question, std::string(method->name), name_of_answer(answer),
                            reference, std::string(name_of(verdict)), is_broken(method->promise, verdict)});
  }
}

}  // namespace gnomon::fuzz
