// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "reports/html_sections.h"
#include "reports/html_text.h"
#include "reports/ledger.h"

namespace gnomon::reports {
namespace {

std::string_view look_of(ClaimStatus status) {
  switch (status) {
    case ClaimStatus::proved:
    case ClaimStatus::confirmed:
    case ClaimStatus::reproduced:
      return "good";
    case ClaimStatus::refuted:
      return "bad";
    case ClaimStatus::erratum:
      return "warn";
    case ClaimStatus::open:
      return "idle";
  }
  return "idle";
}

std::string status_word(ClaimStatus status) {
  return fmt::format("<span class=\"word {}\" title=\"{}\">{}</span>", look_of(status),
                     escaped(meaning_of(status)), name_of(status));
}

std::string counts_table(std::span<const Claim> claims) {
  std::string head, exact, single;
  const StatusCounts exactly = count_statuses(claims, &Claim::status),
                     in_floats = count_statuses(claims, &Claim::status_f32);
  for (const ClaimStatus status : claim_statuses()) {
    const std::size_t i = static_cast<std::size_t>(status);
    head += fmt::format("<th scope=\"col\">{}</th>", status_word(status));
    exact += fmt::format("<td class=\"num{}\">{}</td>", exactly[i] == 0 ? " quiet" : "", exactly[i]);
    single += fmt::format("<td class=\"num{}\">{}</td>", in_floats[i] == 0 ? " quiet" : "", in_floats[i]);
  }
  return fmt::format(
      "<div class=\"scroll\"><table class=\"claim-counts\"><thead><tr><td></td>{}</tr></thead><tbody>\n"
      "<tr><th scope=\"row\">exactly</th>{}</tr>\n<tr><th scope=\"row\">in float32</th>{}</tr>\n"
      "</tbody></table></div>\n",
      head, exact, single);
}

std::string evidence(const Claim& claim) {
  std::string out;
  if (!claim.note.empty()) out += fmt::format("<p class=\"note\">{}</p>", escaped(claim.note));
  if (claim.pointers.empty()) return out;
  out += fmt::format(
      "<details><summary>{} to follow</summary>",
      claim.pointers.size() == 1 ? "1 pointer" : fmt::format("{} pointers", claim.pointers.size()));
  for (const ClaimPointer& pointer : claim.pointers) {
    out += fmt::format("<p>{}: {}</p><pre class=\"copy\">{}</pre>", kind_of(pointer),
                       escaped(words_of(pointer)), escaped(command_of(pointer)));
  }
  return out + "</details>";
}

std::string paper_table(const Paper& paper, std::span<const Claim> claims) {
  std::string out = fmt::format(
      "<h3>{}</h3>\n<div class=\"scroll\"><table class=\"claims\"><thead><tr><th scope=\"col\">id</th>"
      "<th scope=\"col\">exactly</th><th scope=\"col\">float32</th><th scope=\"col\">claim</th></tr></thead>"
      "<tbody>\n",
      escaped(paper.title));
  for (const Claim& claim : claims) {
    if (claim.paper != paper.id) continue;
    out += fmt::format(
        "<tr id=\"claim-{0}\"><th scope=\"row\">{0}</th><td>{1}</td><td>{2}</td><td>{3}{4}</td>"
        "</tr>\n",
        escaped(claim.id), status_word(claim.status), status_word(claim.status_f32), escaped(claim.text),
        evidence(claim));
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace

std::string claims_section(std::span<const Claim> claims) {
  if (claims.empty()) return "";
  std::string out =
      "<section id=\"claims\"><h2>What the papers claim</h2>\n<p>Each claim and what became of it, in exact "
      "arithmetic and in float32, whatever was run for this page. <code>gnomon claims</code> prints the "
      "same; "
      "its commands are typed in the source folder.</p>\n";
  out += counts_table(claims);
  out += "<details><summary>What the words mean</summary><dl>";
  for (const ClaimStatus status : claim_statuses()) {
    out += fmt::format("<dt>{}</dt><dd>{}</dd>", status_word(status), escaped(meaning_of(status)));
  }
  out += "</dl></details>\n";
  for (const Paper& paper : papers()) {
    const bool any = std::ranges::any_of(claims, [&](const Claim& c) { return c.paper == paper.id; });
    if (any) out += paper_table(paper, claims);
  }
  return out + "</section>\n";
}

}  // namespace gnomon::reports
