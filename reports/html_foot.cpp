// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "reports/assets.h"
#include "reports/html_sections.h"
#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

std::string environment_list(const ResultFile& file) {
  if (file.environment.empty()) return "";
  std::string out = "<dl class=\"environment\">";
  for (const auto& [key, value] : file.environment) {
    out += fmt::format("<dt>{}</dt><dd>{}</dd>", escaped(key), escaped(value));
  }
  return out + "</dl>\n";
}

}  // namespace

std::string other_results_section(std::span<const ResultFile> files) {
  std::string out;
  for (const ResultFile& file : files) {
    if (file.table.empty()) continue;
    std::vector<std::string> columns;
    for (const auto& row : file.table) {
      for (const auto& [key, value] : row) {
        if (std::find(columns.begin(), columns.end(), key) == columns.end()) columns.push_back(key);
      }
    }
    out += fmt::format("<h3>{} <small>{}</small></h3>\n<div class=\"scroll\"><table><thead><tr>",
                       escaped(file.kind), escaped(file.name));
    for (const auto& column : columns) out += fmt::format("<th scope=\"col\">{}</th>", escaped(column));
    out += "</tr></thead><tbody>\n";
    for (const auto& row : file.table) {
      out += "<tr>";
      for (const auto& column : columns) {
        const auto it =
            std::find_if(row.begin(), row.end(), [&](const auto& cell) { return cell.first == column; });
        out += fmt::format("<td>{}</td>", it == row.end() ? "" : escaped(it->second));
      }
      out += "</tr>\n";
    }
    out += "</tbody></table></div>\n";
  }
  return out.empty() ? out : "<section id=\"other\"><h2>Other results</h2>\n" + out + "</section>\n";
}

std::string foot_section(std::span<const ResultFile> files) {
  std::string out = "<footer id=\"foot\"><h2>How this was made</h2>\n";
  const ResultFile* last = nullptr;
  for (const ResultFile& file : files) {
    out += fmt::format("<h3>{} <small>{}{}</small></h3>\n<pre class=\"copy\">{}</pre>\n", escaped(file.name),
                       escaped(file.tool), file.seed ? fmt::format(", seed {}", *file.seed) : "",
                       escaped(file.command));
    const bool same = last && last->environment == file.environment;
    out += same && !file.environment.empty() ? "<p class=\"note\">Same environment as above.</p>\n"
                                             : environment_list(file);
    last = &file;
  }
  out +=
      "<p class=\"note\">Counts depend on the command and the seed alone; times are of this "
      "environment.</p>\n";
  out += fmt::format(
      "<details><summary>Licences: gnomon is GPL-3.0-or-later; this page holds Vega (BSD-3-Clause)</summary>"
      "<pre>{}</pre></details></footer>\n",
      escaped(asset("vega-licences.txt")));
  return out;
}

}  // namespace gnomon::reports
