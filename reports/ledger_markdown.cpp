// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/ledger.h"
#include "reports/ledger_text.h"

namespace gnomon::reports {
namespace {

/// Text as a cell of a table: a bar would end it, and what means something to Markdown is kept literal.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '<' || c == '`' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string meanings() {
  std::string out = "| status | means |\n| --- | --- |\n";
  for (const ClaimStatus status : claim_statuses()) {
    out += fmt::format("| {} | {} |\n", name_of(status), cell(meaning_of(status)));
  }
  return out;
}

std::string evidence(const Claim& claim) {
  std::string out = fmt::format("\n**{}** ({}; float32: {}). {}\n", claim.id, name_of(claim.status),
                                name_of(claim.status_f32), cell(claim.text));
  if (!claim.note.empty()) out += fmt::format("\n{}\n", cell(claim.note));
  out += "\n";
  for (const ClaimPointer& pointer : claim.pointers) {
    out += fmt::format("- {}: {}\n  `{}`\n", kind_of(pointer), cell(words_of(pointer)), command_of(pointer));
  }
  return out;
}

std::string section(const Paper& paper, std::span<const Claim> claims) {
  std::vector<Claim> own;
  std::ranges::copy_if(claims, std::back_inserter(own), [&](const Claim& c) { return c.paper == paper.id; });
  if (own.empty()) return "";
  std::string out = fmt::format(
      "\n## {}\n\nExact: {}. Float32: {}.\n\n| id | exact | float32 | claim |\n"
      "| --- | --- | --- | --- |\n",
      paper.title, counts_text(count_statuses(own, &Claim::status)),
      counts_text(count_statuses(own, &Claim::status_f32)));
  for (const Claim& claim : own) {
    out += fmt::format("| {} | {} | {} | {} |\n", claim.id, name_of(claim.status), name_of(claim.status_f32),
                       cell(claim.text));
  }
  for (const Claim& claim : own) {
    if (!claim.pointers.empty() || !claim.note.empty()) out += evidence(claim);
  }
  return out;
}

}  // namespace

std::string ledger_markdown(std::span<const Claim> claims) {
  std::set<std::string_view> wholes;
  for (const Claim& claim : claims) wholes.insert(claim.whole());
  std::string out = fmt::format(
      "# The papers' claims\n\n<!-- Written by `gnomon claims --markdown` from proofs/claims.json; do not "
      "edit. "
      "-->\n\n"
      "{} claims of four papers in {} entries, each with what became of it in exact arithmetic and in "
      "float32, "
      "and the command that shows it again. Where rounding has no part in a claim, both say the same.\n\n"
      "Exact: {}. Float32: {}.\n\n",
      wholes.size(), claims.size(), counts_text(count_statuses(claims, &Claim::status)),
      counts_text(count_statuses(claims, &Claim::status_f32)));
  out += meanings();
  out +=
      "\nCommands are typed in the source folder after a release build; `gnomon` is "
      "`build/release/gnomon`.\n";
  for (const Paper& paper : papers()) out += section(paper, claims);
  return out;
}

}  // namespace gnomon::reports
