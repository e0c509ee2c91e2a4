// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/pair_methods_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fuzz/pair_question.h"
#include "fuzz/pair_source.h"

namespace gnomon::reports {

namespace {

using Json = nlohmann::ordered_json;

template <class Q>
std::string methods_text() {
  std::string text = fmt::format("{}\n", Q::id);
  for (const typename Q::Method& method : Q::methods()) {
    text += fmt::format("  {:<32} {:<11}{:<9}{:<16}{}\n", method.name, method.tier, "f32",
                        name_of(method.promise), method.summary);
  }
  return text + "\n";
}

template <class Q>
Json question_json() {
  Json methods = Json::array();
  for (const typename Q::Method& method : Q::methods()) {
    methods.push_back({{"name", method.name},
                       {"tier", method.tier},
                       {"promise", name_of(method.promise)},
                       {"scalars", {"f32"}},
                       {"domain", method.domain},
                       {"in_batches", false},
                       {"summary", method.summary}});
  }
  return {{"id", Q::id}, {"answers", fuzz::words_of(Q::id).answers}, {"methods", methods}};
}

std::string shares_text(const fuzz::QuestionWords& words, const std::array<double, fuzz::kTruths>& least) {
  std::string text;
  for (std::size_t truth = 0; truth < words.truth_count(); ++truth) {
    text += fmt::format("{}{:g}", truth == 0 ? "" : "/", 100 * least[truth]);
  }
  return text + " %";
}

Json shares_json(const fuzz::QuestionWords& words, const std::array<double, fuzz::kTruths>& least) {
  Json json = Json::object();
  for (std::size_t truth = 0; truth < words.truth_count(); ++truth) {
    json[std::string(words.truths[truth])] = least[truth];
  }
  return json;
}

}  // namespace

std::string pair_methods_text() {
  return methods_text<fuzz::CandidateQuestion>() + methods_text<fuzz::PatchQuestion>();
}

std::string pair_distributions_text() {
  std::string text =
      "\nDistributions of shaft-candidates and patch-pair (at least these shares empty/some and "
      "all/none/part):\n\n";
  for (const fuzz::PairDistribution& distribution : fuzz::pair_distributions()) {
    std::string shares = "whatever the scene has";
    if (!distribution.needs_argument) {
      shares = shares_text(fuzz::words_of(fuzz::CandidateQuestion::id), distribution.least_candidates) +
               ", " + shares_text(fuzz::words_of(fuzz::PatchQuestion::id), distribution.least_pairs);
    }
    text += fmt::format("  {:<16}{}\n  {:<16}{}{}\n", distribution.name, distribution.description, "", shares,
                        distribution.argument.empty() ? "" : fmt::format("; ARG: {}", distribution.argument));
  }
  return text;
}

Json candidate_question_json() {
  return question_json<fuzz::CandidateQuestion>();
}

Json patch_question_json() {
  return question_json<fuzz::PatchQuestion>();
}

Json pair_distributions_json() {
  Json all = Json::array();
  for (const fuzz::PairDistribution& distribution : fuzz::pair_distributions()) {
    all.push_back({{"name", distribution.name},
                   {"argument", distribution.argument},
                   {"description", distribution.description},
                   {"in_every_domain", distribution.in_every_domain},
                   {"least_mix_candidates",
                    shares_json(fuzz::words_of(fuzz::CandidateQuestion::id), distribution.least_candidates)},
                   {"least_mix_pairs",
                    shares_json(fuzz::words_of(fuzz::PatchQuestion::id), distribution.least_pairs)}});
  }
  return all;
}

}  // namespace gnomon::reports
