// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/verb_claims.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "reports/ledger.h"
#include "reports/ledger_text.h"

namespace gnomon::reports {
namespace {

struct ClaimsArguments {
  std::vector<std::string> ids, papers, statuses;
  bool json = false, markdown = false;
};

std::string known_ids() {
  std::string out;
  for (const Paper& paper : papers()) {
    out += fmt::format("{}{}1 to {}{}", out.empty() ? "" : ", ", paper.letter, paper.letter, paper.claims);
  }
  return out;
}

std::string known_papers() {
  std::string out;
  for (const Paper& paper : papers()) out += fmt::format("{}{}", out.empty() ? "" : ", ", paper.id);
  return out;
}

std::string known_statuses() {
  std::string out;
  for (const ClaimStatus status : claim_statuses()) {
    out += fmt::format("{}{}", out.empty() ? "" : ", ", name_of(status));
  }
  return out;
}

void refuse_unknown(const ClaimsArguments& arguments) {
  for (const std::string& id : arguments.ids) {
    if (std::ranges::none_of(ledger(), [&](const Claim& c) { return c.id == id || c.whole() == id; })) {
      throw std::runtime_error(
          fmt::format("claims: expected ids of claims ({}), found \"{}\"", known_ids(), id));
    }
  }
  for (const std::string& name : arguments.papers) {
    if (std::ranges::none_of(papers(), [&](const Paper& p) { return p.id == name; })) {
      throw std::runtime_error(
          fmt::format("--paper: expected one of {}, found \"{}\"", known_papers(), name));
    }
  }
  for (const std::string& name : arguments.statuses) {
    if (!status_of(name)) {
      throw std::runtime_error(
          fmt::format("--status: expected one of {}, found \"{}\"", known_statuses(), name));
    }
  }
  if (arguments.json && arguments.markdown) {
    throw std::runtime_error("claims: expected --json or --markdown, found both");
  }
}

/// True when the list is empty or holds one of the words.
bool chosen(const std::vector<std::string>& list, std::initializer_list<std::string_view> words) {
  return list.empty() || std::ranges::any_of(list, [&](const std::string& wanted) {
           return std::ranges::find(words, wanted) != words.end();
         });
}

int run_claims(const ClaimsArguments& arguments) {
  refuse_unknown(arguments);
  std::vector<Claim> shown;
  for (const Claim& claim : ledger()) {
    if (chosen(arguments.ids, {claim.id, claim.whole()}) && chosen(arguments.papers, {claim.paper}) &&
        chosen(arguments.statuses, {name_of(claim.status), name_of(claim.status_f32)})) {
      shown.push_back(claim);
    }
  }
  std::cout << (arguments.json       ? ledger_json(shown)
                : arguments.markdown ? ledger_markdown(shown)
                                     : ledger_text(shown));
  return 0;
}

}  // namespace

void add_claims_verb(CLI::App& app, std::function<int()>& run) {
  CLI::App* const verb =
      app.add_subcommand("claims", "The ledger: what the papers claim, what became of it, how to see it");
  const auto arguments = std::make_shared<ClaimsArguments>();
  verb->add_option("id", arguments->ids, "claims, e.g. S2 (with its parts) or S2a; all without it");
  verb->add_option("--paper", arguments->papers, "claims of one paper (repeatable): " + known_papers())
      ->allow_extra_args(false);
  verb->add_option("--status", arguments->statuses,
                   "claims with this status, exactly or in float32 (repeatable): " + known_statuses())
      ->allow_extra_args(false);
  verb->add_flag("--json", arguments->json, "as JSON");
  verb->add_flag("--markdown", arguments->markdown, "as Markdown: proofs/CLAIMS.md");
  std::string meanings = "Status, in exact arithmetic and in float32:\n";
  for (const ClaimStatus status : claim_statuses()) {
    meanings += fmt::format("  {:<10}  {}\n", name_of(status), meaning_of(status));
  }
  verb->footer(meanings +
               "Below a claim stand the commands that show it again, to be typed in the source folder.\n"
               "Examples:\n"
               "  gnomon claims S2 S6\n"
               "  gnomon claims --paper shaft-culling --status refuted\n"
               "  gnomon claims --json");
  verb->final_callback([&run, arguments] { run = [arguments] { return run_claims(*arguments); }; });
}

}  // namespace gnomon::reports
