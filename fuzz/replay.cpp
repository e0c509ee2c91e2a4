// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/replay.h"

#include <algorithm>

#include "fuzz/generator.h"
#include "fuzz/method_failure.h"
#include "fuzz/replay_pair.h"
#include "fuzz/replay_shadow.h"
#include "fuzz/witness.h"
#include "scene/line_reader.h"

namespace gnomon::fuzz {

namespace {

template <class Q>
typename Q::Case parse_case(const scene::CorpusLine& line) {
  const std::vector<double> numbers = line.numbers(Q::number_count);
  const typename Q::Case c = case_of<typename Q::Case>(numbers);
  if (const std::optional<std::string_view> wanted = objection(c)) line.fail(*wanted, "none in this case");
  return c;
}

/// What a replay was asked for: methods by name, all when there are none; without those that have failed.
struct Asked {
  const std::vector<std::string>& names;
  const ReplayRows& rows;
  std::vector<std::string_view> retired{};

  [[nodiscard]] bool wants(std::string_view name) const {
    return (names.empty() || std::find(names.begin(), names.end(), name) != names.end()) &&
           std::find(retired.begin(), retired.end(), name) == retired.end();
  }
};

template <class Q>
void replay_line(const scene::CorpusLine& line, Asked& asked, ReplayResult& result) {
  const typename Q::Case c = parse_case<Q>(line);
  const scene::Scalar scalar = is_single(c) ? scene::Scalar::f32 : scene::Scalar::f64;
  const std::string where = line.file + ":" + std::to_string(line.line);
  const std::string_view truth = name_of(exact::classify(c));
  ++result.cases;
  if (line.answer) {
    if (std::find(Q::answers.begin(), Q::answers.end(), *line.answer) == Q::answers.end()) {
      line.fail("outside, overlap or inside after \"->\"", scene::in_quotes(*line.answer));
    }
    ++result.stated;
    if (*line.answer != truth) result.wrong_answers.push_back({where, *line.answer, std::string(truth)});
  }
  for (const Method<Q>* method : all_methods<Q>(asked.rows.plugins)) {
    if (!asked.wants(method->name)) continue;
    try {
      const Trial trial = try_case(*method, scalar, c);
      result.lines.push_back({where, std::string(Q::id), std::string(method->name),
                              std::string(answer_name(trial.answer)), std::string(name_of(trial.truth)),
                              std::string(name_of(trial.verdict)),
                              is_broken(method->promise, trial.verdict)});
    } catch (const MethodFailure& failure) {
      result.failures.push_back(where + ": " + failure.what());
      asked.retired.push_back(method->name);
    }
  }
}

/// Those of the rows that are wanted.
template <class Row>
std::vector<const Row*> wanted(std::span<const Row> rows, const Asked& asked) {
  std::vector<const Row*> result;
  for (const Row& row : rows) {
    if (asked.wants(row.name)) result.push_back(&row);
  }
  return result;
}

template <class Q>
bool has_method(const std::string& name, const Plugins* plugins) {
  const std::vector<const Method<Q>*> all = all_methods<Q>(plugins);
  return std::any_of(all.begin(), all.end(), [&](const Method<Q>* m) { return m->name == name; });
}

template <class Row>
bool has_row(std::span<const Row> all, const std::string& name) {
  return std::ranges::any_of(all, [&](const Row& row) { return row.name == name; });
}

bool is_known(const std::string& name, const ReplayRows& rows) {
  return has_method<ShaftBoxQuestion>(name, rows.plugins) ||
         has_method<ShaftBallQuestion>(name, rows.plugins) ||
         has_method<ShaftSlabsQuestion>(name, rows.plugins) ||
         has_method<ShaftOrientedBoxQuestion>(name, rows.plugins) ||
         has_method<ShaftEllipsoidQuestion>(name, rows.plugins) || has_row(rows.scene_methods, name) ||
         has_row(candidate_methods(), name) || has_row(pair_methods(), name);
}

}  // namespace

bool is_broken(Promise promise, Verdict verdict) {
  if (promise == Promise::none || verdict == Verdict::agree || verdict == Verdict::rejected) return false;
  return verdict == Verdict::unsound || promise == Promise::always_agrees;
}

bool ReplayResult::promise_broken() const {
  return std::any_of(lines.begin(), lines.end(), [](const ReplayLine& line) { return line.promise_broken; });
}

ReplayResult replay(const std::vector<scene::CorpusLine>& corpus, const std::vector<std::string>& methods,
                    const ReplayRows& rows) {
  for (const std::string& name : methods) {
    if (!is_known(name, rows)) {
      throw UsageError("--method: expected a method that `gnomon list` shows, found \"" + name + "\"");
    }
  }
  ReplayResult result;
  Asked asked{methods, rows};
  const std::vector<const SceneMethod*> scene_methods = wanted(rows.scene_methods, asked);
  const std::vector<const CandidateMethod*> candidates = wanted(candidate_methods(), asked);
  const std::vector<const PairMethod*> pairs = wanted(pair_methods(), asked);
  for (const scene::CorpusLine& line : corpus) {
    if (line.question == ShaftBoxQuestion::id) {
      replay_line<ShaftBoxQuestion>(line, asked, result);
    } else if (line.question == ShaftBallQuestion::id) {
      replay_line<ShaftBallQuestion>(line, asked, result);
    } else if (line.question == kShadowQuestion) {
      replay_shadow(line, scene_methods, result);
    } else if (line.question == kCandidatesQuestion) {
      replay_candidates(line, candidates, result);
    } else if (line.question == kPairQuestion) {
      replay_pair(line, pairs, result);
    } else if (!for_volume_question(line.question, [&](auto question) {
                 replay_line<decltype(question)>(line, asked, result);
               })) {
      line.fail(
          "a question (shaft-box, shaft-sphere, shaft-slabs, shaft-oriented-box, shaft-ellipsoid, shadow, "
          "shaft-candidates, patch-pair)",
          scene::in_quotes(line.question));
    }
  }
  return result;
}

}  // namespace gnomon::fuzz
