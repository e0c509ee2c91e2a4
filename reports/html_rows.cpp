// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "reports/html_sections.h"
#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

/// A table cell that sorts by a number.
std::string number_cell(double key, const std::string& content, const char* classes = "num") {
  return fmt::format("<td class=\"{}\" data-key=\"{}\">{}</td>", classes, key, content);
}

std::string count_cell(std::uint64_t n) {
  return number_cell(static_cast<double>(n), thousands(n), n == 0 ? "num quiet" : "num");
}

/// Count of chances, and below it the rate with its interval; zeros carry their bound already.
std::string share_cell(const Share& share, const char* look) {
  if (share.n == 0) return number_cell(-1, "none asked", "num quiet");
  std::string text = share_html(share);
  if (share.k > 0) {
    text += fmt::format("<small>{} [{}, {}]</small>", rate_text(share.rate.value),
                        rate_text(share.rate.low95), rate_text(share.rate.high95));
  }
  // Zeros sort below all rates, among themselves by bound.
  const double key = share.k == 0 ? share.rate.high95 * 1e-20 : share.rate.value;
  return number_cell(key, text, share.k == 0 ? "num quiet" : look);
}

/// For what the row doesn't tell; rows of questions about pairs know no touching and no threshold.
std::string unknown_cell() {
  return number_cell(-1, "–", "num quiet");
}

std::string touching_cell(const ResultRow& row) {
  std::uint64_t all = 0;
  std::string parts;
  for (const auto& [truth, n] : row.touching) {
    all += n;
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", escaped(truth), thousands(n));
  }
  return number_cell(static_cast<double>(all),
                     all == 0 ? "0" : fmt::format("{}<small>{}</small>", thousands(all), parts),
                     all == 0 ? "num quiet" : "num");
}

std::string gap_cell(const ResultRow& row) {
  if (!row.worst_gap) return unknown_cell();
  if (!row.worst_gap->ulps)
    return number_cell(std::numeric_limits<double>::max(), ulps_text({}), "num quiet");
  const double ulps = std::abs(*row.worst_gap->ulps);
  std::string text = ulps_text(ulps);
  if (row.worst_gap->approx) text += fmt::format("<small>{:.3g}</small>", std::abs(*row.worst_gap->approx));
  return number_cell(ulps, text);
}

std::string row_html(const ResultRow& row, const std::string& file, bool several_files) {
  const Summary s = summarise(row);
  std::string out = fmt::format(
      "<tr data-question=\"{0}\" data-method=\"{1}\" data-distribution=\"{2}\" data-wrong=\"{3}\">",
      escaped(row.question), escaped(row.method), escaped(row.distribution),
      s.culls.k + s.insides.k + row.unsound > 0 ? "unsound"
      : s.wasted.k > 0                          ? "waste"
                                                : "none");
  out += fmt::format("<th scope=\"row\"><span class=\"dot t-{}\"></span>{}<small>{}</small></th>",
                     escaped(s.tier), escaped(row.method), escaped(row.promise));
  out += fmt::format("<td>{}</td><td>{}</td>", escaped(row.question), escaped(row.distribution));
  out += share_cell(s.culls, "num bad") + share_cell(s.insides, "num bad") + share_cell(s.wasted, "num warn");
  out += number_cell(row.ns.value_or(-1), time_text(row.ns));
  out += number_cell(row.reference_ns.value_or(-1), time_text(row.reference_ns));
  const bool tells = row.knows_twin;
  out += gap_cell(row) + count_cell(row.trials) + (tells ? touching_cell(row) : unknown_cell());
  out += tells ? count_cell(row.unsound_touching) : unknown_cell();
  out += count_cell(row.undecided) + count_cell(row.rejected);
  out += (tells ? count_cell(row.threshold_exceeded) : unknown_cell()) +
         fmt::format("<td>{}</td>", escaped(row.scalar));
  if (several_files) out += fmt::format("<td>{}</td>", escaped(file));
  return out + "</tr>\n";
}

constexpr const char* kHead = R"(<thead><tr><th scope="col">Method</th><th scope="col">Question</th>
<th scope="col">Distribution</th>
<th scope="col" title="said outside of what is not; of pairs in a scene: any unsound answer">False culls</th>
<th scope="col" title="said inside of what is not">False insides</th>
<th scope="col" title="kept though exactly outside; of pairs in a scene: any wasteful answer">Waste</th>
<th scope="col">Time</th><th scope="col" title="the exact reference on the same cases">Reference</th>
<th scope="col" title="how far the worst wrong answer is from the decision boundary">Worst gap</th>
<th scope="col">Trials</th>
<th scope="col" title="the answer changes under arbitrarily small moves">Touching</th>
<th scope="col" title="unsound answers among touching cases">Unsound, touching</th>
<th scope="col" title="the method said that it can't tell">Undecided</th>
<th scope="col" title="outside the method's stated domain">Rejected</th>
<th scope="col" title="waste beyond the exact twin's, farther from the boundary than the method's stated threshold">Over threshold</th>
<th scope="col">Scalar</th>)";

}  // namespace

std::string rows_section(std::span<const ResultFile> files) {
  std::size_t fuzz_files = 0;
  for (const ResultFile& file : files) fuzz_files += file.rows.empty() ? 0 : 1;
  if (fuzz_files == 0) return "";
  std::string out = "<section id=\"rows\"><h2>Every row</h2>\n";
  out +=
      "<p>Counts of chances, then the rate with its 95 % interval. A zero is given with its upper "
      "bound.</p>\n";
  out += "<div id=\"row-filters\" hidden></div>\n<div class=\"scroll tall\"><table class=\"rows\">";
  out += kHead;
  out += fuzz_files > 1 ? "<th scope=\"col\">File</th></tr></thead><tbody>\n" : "</tr></thead><tbody>\n";
  for (const ResultFile& file : files) {
    for (const ResultRow& row : file.rows) out += row_html(row, file.name, fuzz_files > 1);
  }
  return out + "</tbody></table></div></section>\n";
}

}  // namespace gnomon::reports
