// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/replay_shadow.h"

#include <algorithm>
#include <stdexcept>

#include "exact/hierarchy.h"
#include "exact/shadow.h"
#include "scene/scalar.h"
#include "scene/shadow_case.h"
#include "scene/single.h"

namespace gnomon::fuzz {

namespace {

bool are_floats(const scene::ShadowQuery& query) {
  return std::ranges::all_of(query.point, scene::is_float) &&
         std::ranges::all_of(query.light, scene::is_float);
}

scene::Shadow truth_of(const scene::ShadowCase& c, const std::string& where) {
  const exact::ShadowTruth by_faces = exact::shadow_by_all_faces(c.scene, c.query);
  if (exact::Hierarchy(c.scene).shadow(c.query) != by_faces) {
    throw std::logic_error(where + ": the exact references differ: a bug of gnomon's");
  }
  return by_faces.answer;
}

Answer answer_of(const SceneMethod& method, const scene::ShadowCase& c) {
  if (!is_in_domain(method, c.scene, c.query)) return kRejected;
  Answer answer = kRejected;
  method.make(c.scene)->shadows({&c.query, 1}, {&answer, 1});
  return answer;
}

Verdict verdict_of(Answer answer, scene::Shadow truth) {
  if (answer == kRejected) return Verdict::rejected;
  if (answer == kUndecided) return Verdict::undecided;
  return answer == static_cast<Answer>(truth) ? Verdict::agree : Verdict::unsound;
}

std::string_view name_of_answer(Answer answer) {
  if (answer == kRejected) return "rejected";
  return answer == kUndecided ? "undecided" : kShadowAnswers[answer];
}

}  // namespace

bool are_floats(const scene::Scene& scene) {
  try {
    return scene::rounded_to_floats(scene).moved == 0;
  } catch (const std::runtime_error&) {
    return false;  // no float is near, or a ball reaches beyond all of them
  }
}

bool is_in_domain(const SceneMethod& method, const scene::Scene& scene, const scene::ShadowQuery& query) {
  if (!method.has_balls && !scene.balls.empty()) return false;
  return method.takes_doubles || (are_floats(query) && are_floats(scene));
}

void replay_shadow(const scene::CorpusLine& line, std::span<const SceneMethod* const> methods,
                   ReplayResult& result) {
  const scene::ShadowCase c = scene::read_shadow_case(line);
  const std::optional<scene::Shadow> stated = scene::stated_shadow(line);
  const std::string where = line.file + ":" + std::to_string(line.line);
  const scene::Shadow truth = truth_of(c, where);
  const std::string reference(name_of(truth));
  ++result.cases;
  if (stated) ++result.stated;
  if (stated && *stated != truth) result.wrong_answers.push_back({where, *line.answer, reference});
  for (const SceneMethod* method : methods) {
    const Answer answer = answer_of(*method, c);
    const Verdict verdict = verdict_of(answer, truth);
    result.lines.push_back({where, line.question, std::string(method->name),
                            std::string(name_of_answer(answer)), reference, std::string(name_of(verdict)),
                            is_broken(method->promise, verdict)});
  }
}

}  // namespace gnomon::fuzz
