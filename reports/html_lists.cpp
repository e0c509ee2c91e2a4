// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "reports/html_sections.h"
#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

std::uint64_t sum_of(const ResultRow& row, const char* name) {
  const auto it = row.faces.find(name);
  return it == row.faces.end() ? 0 : it->second;
}

std::string mean_cell(std::uint64_t sum, std::uint64_t lists) {
  const double mean = lists == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(lists);
  return fmt::format("<td class=\"num{}\" data-key=\"{}\">{:.4g}</td>", sum == 0 ? " quiet" : "", mean, mean);
}

std::string row_html(const ResultRow& row) {
  const std::uint64_t missing = sum_of(row, "missing");
  return fmt::format("<tr><th scope=\"row\"><span class=\"dot t-{}\"></span>{}</th><td>{}{}</td>",
                     escaped(row.tier), escaped(row.method), escaped(row.distribution),
                     row.independent ? "" : "<small>of one scene</small>") +
         mean_cell(sum_of(row, "true"), row.trials) + mean_cell(sum_of(row, "listed"), row.trials) +
         mean_cell(sum_of(row, "excess"), row.trials) +
         fmt::format(
             "<td class=\"num {}\" data-key=\"{}\">{}</td><td class=\"num\" data-key=\"{}\">{}</td></tr>\n",
             missing == 0 ? "quiet" : "bad", missing, thousands(missing), row.trials, thousands(row.trials));
}

}  // namespace

std::string lists_section(std::span<const ResultFile> files) {
  std::string rows;
  for (const ResultFile& file : files) {
    for (const ResultRow& row : file.rows) {
      if (!row.faces.empty()) rows += row_html(row);
    }
  }
  if (rows.empty()) return "";
  return "<section id=\"lists\"><h2>How long the lists are</h2>\n<p>Faces a list of "
         "<code>shaft-candidates</code>: those that meet the shaft exactly, those that the method lists, and "
         "those that it need not; and how many faces are missing in all lists together. Queries of one "
         "scene are not independent; their intervals take them as if they were.</p>\n"
         "<div class=\"scroll tall\"><table class=\"rows\"><thead><tr><th scope=\"col\">Method</th><th "
         "scope=\"col\">Distribution</th><th scope=\"col\">True</th><th scope=\"col\">Listed</th><th "
         "scope=\"col\">Excess</th><th scope=\"col\">Missing, in all</th><th scope=\"col\">Lists</th></tr>"
         "</thead><tbody>\n" +
         rows + "</tbody></table></div></section>\n";
}

}  // namespace gnomon::reports
