// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/html_report.h"

#include <fmt/format.h>

#include <string>

#include "reports/assets.h"
#include "reports/html_measure.h"
#include "reports/html_radiosity.h"
#include "reports/html_sections.h"
#include "reports/ledger.h"
#include "reports/result_reader.h"
#include "scene/atomic_file.h"

namespace gnomon::reports {
namespace {

/// A component without its pointer to a source map, which a browser's tools would go and look for.
std::string without_source_map(std::string_view script) {
  const auto at = script.rfind("//# sourceMappingURL=");
  return std::string(script.substr(0, at));
}

std::string scripts() {
  std::string out =
      "<script>\n/* Vega, BSD-3-Clause; licences at the foot of the page */\nvar vega = (function () {\n";
  out += asset("amd.js");
  for (const std::string_view name : vega_modules()) {
    out += fmt::format("current = \"{}\";\n{}\n", name, without_source_map(asset(name)));
  }
  out += "return modules;\n})();\n</script>\n";
  out += fmt::format("<script>\n{}</script>\n<script>\n{}</script>\n", asset("plot.js"), asset("report.js"));
  return out;
}

std::string page(std::span<const ResultFile> files, std::span<const MeasureFile> scenes) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light "
      "dark\">\n"
      "<title>gnomon report</title>\n<link rel=\"icon\" href=\"data:,\">\n";
  out += fmt::format("<style>\n{}</style>\n</head>\n<body>\n<main>\n", asset("report.css"));
  out += verdict_section(files) + measure_verdict(scenes) + plot_section(files) + methods_section(files) +
         rows_section(files) + lists_section(files) + measure_section(scenes) + radiosity_section(scenes) +
         error_sources_section(files) + mix_section(files) + witness_section(files) +
         other_results_section(files) + claims_section(ledger()) + foot_section(files);
  out += "</main>\n" + scripts() + "</body>\n</html>\n";
  return out;
}

}  // namespace

void write_html_report(const std::filesystem::path& dir, const std::filesystem::path& out) {
  const std::vector<ResultFile> files =
      read_result_folder(dir);  // first: it says what is wrong with the folder
  scene::write_whole_file(out, page(files, read_measure_files(dir)));
}

}  // namespace gnomon::reports
