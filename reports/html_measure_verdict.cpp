// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/html_measure.h"
#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

struct Tally {
  std::set<std::string> methods;
  std::uint64_t wrong = 0, queries = 0, undecided = 0;
};

/// The methods of a tier on all workloads of a question.
Tally tally_of(std::span<const MeasureFile> files, const std::string& question, const std::string& tier) {
  Tally tally;
  for (const MeasureFile& file : files) {
    for (const MeasureRow& row : file.rows) {
      if (row.question != question || row.tier != tier) continue;
      tally.methods.insert(row.method);
      tally.wrong += row.unsound;
      tally.undecided += row.undecided + row.rejected;
      tally.queries += row.queries;
    }
  }
  return tally;
}

std::string tier_html(const Tally& tally, const char* tier, const char* name) {
  if (tally.methods.empty()) return "";
  std::string methods;
  for (const std::string& method : tally.methods) {
    methods += fmt::format("{}<code>{}</code>", methods.empty() ? "" : ", ", escaped(method));
  }
  const Share wrong = share_of(tally.wrong, tally.queries);
  std::string out = fmt::format("<li><b class=\"t-{}\">{}</b> ({}): {} wrong of {} queries; 95 %: {} to {}",
                                tier, name, methods, thousands(wrong.k), thousands(wrong.n),
                                rate_text(wrong.rate.low95), rate_text(wrong.rate.high95));
  if (tally.undecided > 0) out += fmt::format("; {} left open", thousands(tally.undecided));
  return out + "</li>\n";
}

std::string promises_html(std::span<const MeasureFile> files) {
  std::string broken;
  std::size_t promises = 0;
  for (const MeasureFile& file : files) {
    for (const MeasureRow& row : file.rows) {
      promises += row.promise != "none" ? 1 : 0;
      if (!row.promise_broken) continue;
      broken += fmt::format(
          "<li><code>{}</code> promised “{}” for <code>{}</code> and broke it on {} ({}) "
          "<code>{}</code>.</li>",
          escaped(row.method), escaped(row.promise), escaped(row.question), escaped(row.scene),
          escaped(row.variant), escaped(row.workload));
    }
  }
  if (!broken.empty()) {
    return fmt::format("<div class=\"banner bad\"><b>A promise was broken on a scene.</b><ul>{}</ul></div>\n",
                       broken);
  }
  return fmt::format(
      "<div class=\"banner good\"><b>Every promise held on scenes.</b> {} rows come with one.</div>\n",
      thousands(promises));
}

}  // namespace

std::string measure_verdict(std::span<const MeasureFile> files) {
  constexpr struct {
    const char *tier, *name;
  } kTiers[] = {{"exact", "Exact methods"},
                {"certified", "Certified methods"},
                {"naive", "Naive methods"},
                {"peer", "Other projects"}};
  std::string questions;
  for (const char* const question : {"shadow", "first-hit"}) {
    std::string tiers;
    for (const auto& [tier, name] : kTiers) tiers += tier_html(tally_of(files, question, tier), tier, name);
    if (tiers.empty()) continue;
    questions += fmt::format("<div><h3><code>{}</code></h3><ul>\n{}</ul></div>\n", question, tiers);
  }
  const bool rows =
      std::any_of(files.begin(), files.end(), [](const MeasureFile& file) { return !file.rows.empty(); });
  if (!rows) return "";
  return promises_html(files) + (questions.empty()
                                     ? ""
                                     : "<p>All workloads of all scenes together, the hard ones "
                                       "included.</p>\n<div class=\"headlines\" id=\"scene-verdicts\">\n" +
                                           questions + "</div>\n");
}

}  // namespace gnomon::reports
