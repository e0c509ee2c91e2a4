// SPDX-License-Identifier: GPL-3.0-or-later
// The exact categories of a batch of balls, and a predicate that knows them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exact/shaft_ball.h"
#include "tests/batch_cases.h"

namespace gnomon::tests {

template <class F>
std::vector<scene::Category> truth_of(const BallBatch<F>& batch) {
  std::vector<scene::ShaftBallCase> cases;
  for (std::size_t i = 0; i < batch.view().count; ++i) {
    cases.push_back(scene::converted<double>(scene::ShaftBallCaseOf<F>{batch.a, batch.b, batch.view()[i]}));
  }
  std::vector<exact::ShaftBallReference> references(cases.size());
  exact::refer(cases, references);
  std::vector<scene::Category> truth;
  for (const auto& reference : references) truth.push_back(reference.truth);
  return truth;
}

/// The predicate, from truths known before: asked again and again by each target, rationals would be slow.
template <class F>
auto predicate_for(const BallBatch<F>& batch, const std::vector<scene::Category>& truth) {
  std::map<std::string, scene::Category> answers;
  for (std::size_t i = 0; i < truth.size(); ++i) answers[text_of(batch.view()[i])] = truth[i];
  return [answers](const scene::Ball<F>& t) { return answers.at(text_of(t)); };
}

}  // namespace gnomon::tests
