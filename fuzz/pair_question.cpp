// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/pair_question.h"

#include <numeric>
#include <stdexcept>

#include "scene/pair_case.h"

namespace gnomon::fuzz {

FaceSums FaceMarks::compare(std::size_t face_count, std::span<const std::uint32_t> truth,
                            std::span<const std::uint32_t> listed) {
  if (marks_.size() < face_count) marks_.resize(face_count, 0);
  const std::uint64_t right = last_ + 1, found = last_ + 2;
  last_ = found;
  for (const std::uint32_t face : truth) marks_[face] = right;
  FaceSums sums;
  sums.in_truth = truth.size();
  sums.listed = listed.size();
  for (const std::uint32_t face : listed) {
    if (face >= face_count) {
      throw std::runtime_error("listed face " + std::to_string(face) + " of " + std::to_string(face_count));
    }
    if (marks_[face] == found) throw std::runtime_error("listed face " + std::to_string(face) + " twice");
    sums.excess += marks_[face] != right;
    marks_[face] = found;
  }
  sums.missing = sums.in_truth + sums.excess - sums.listed;
  return sums;
}

void CandidateQuestion::refer(const Referee& referee, const Query& query, Reply& truth) {
  referee.faces(scene::converted<double>(query.a), scene::converted<double>(query.b), truth);
}

void CandidateQuestion::refer(const scene::Scene& scene, const Query& query, Reply& truth) {
  const exact::CandidateShaft shaft(scene::converted<double>(query.a), scene::converted<double>(query.b));
  truth.clear();
  for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
    if (shaft.meets(scene, face)) truth.push_back(face);
  }
}

PairJudgement CandidateQuestion::judge(const scene::Scene& scene, const Reply& truth, const Reply& reply,
                                       FaceMarks& marks) {
  const FaceSums faces = marks.compare(scene.face_count(), truth, reply);
  const Answer answer = faces.missing > 0 ? 2 : faces.excess > 0 ? 1 : 0;
  return {truth.empty() ? 0u : 1u, answer, faces};
}

void PatchQuestion::refer(const Referee& referee, const Query& query, Reply& truth) {
  truth = static_cast<Answer>(referee.visibility(query));
}

void PatchQuestion::refer(const scene::Scene& scene, const Query& query, Reply& truth) {
  truth = static_cast<Answer>(exact::patch_pair_by_all_faces(scene, query));
}

PairJudgement PatchQuestion::judge(const scene::Scene& /*scene*/, const Reply& truth, const Reply& reply,
                                   FaceMarks& /*marks*/) {
  if (reply >= kColumns) throw std::runtime_error("answered number " + std::to_string(reply));
  return {truth, reply};
}

std::string pair_text(const scene::Scene& scene, const BoxPair& query,
                      const std::vector<std::uint32_t>& truth) {
  scene::CandidatesCase c{scene, scene::converted<double>(query.a), scene::converted<double>(query.b), {}};
  c.number.resize(scene.face_count());
  std::iota(c.number.begin(), c.number.end(), 0u);
  return corpus_text(c, scene::candidates_text(truth, c.number));
}

std::string pair_text(const scene::Scene& scene, const scene::PatchPair& query, Answer truth) {
  scene::PairCase c{scene, query, {}};
  c.number.resize(scene.face_count());
  std::iota(c.number.begin(), c.number.end(), 0u);
  return corpus_text(c, name_of(static_cast<scene::PairVisibility>(truth)));
}

}  // namespace gnomon::fuzz
