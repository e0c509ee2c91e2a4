// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/html_radiosity.h"

#include <fmt/format.h>

#include "fuzz/workload.h"
#include "reports/html_text.h"
#include "reports/radiosity_ratio.h"

namespace gnomon::reports {
namespace {

std::string head(std::span<const char* const> titles) {
  std::string out = "<div class=\"scroll\"><table><thead><tr>";
  for (const char* const title : titles) out += fmt::format("<th scope=\"col\">{}</th>", title);
  return out + "</tr></thead><tbody>\n";
}
constexpr const char* kEnd = "</tbody></table></div>\n";

std::string name_cell(const std::string& name) {
  return fmt::format("<tr><th scope=\"row\">{}</th>", escaped(name));
}
std::string number_cell(const std::string& text) {
  return fmt::format("<td class=\"num\">{}</td>", text);
}
std::string count_cell(std::uint64_t n) {
  return fmt::format("<td class=\"num {}\">{}</td>", n == 0 ? "quiet" : "bad", thousands(n));
}

std::string ours_cell(const Table1Cell& cell, int digits) {
  return number_cell(fmt::format("{:.{}f} <small>{:.2f}</small>", cell.value, digits, cell.ratio));
}

std::string printed_cell(const Table1Cell& cell, int digits) {
  if (!cell.printed) return number_cell("–");
  const char* const look = cell.direction == "opposite" ? " class=\"warn\"" : "";
  return number_cell(
      fmt::format("{:.{}f} <small>{:.2f}</small>{}", *cell.printed, digits, *cell.printed_ratio,
                  cell.direction.empty() ? "" : fmt::format(" <b{}>{}</b>", look, cell.direction)));
}

struct Errors {
  std::uint64_t wrong = 0, lacking = 0, checked = 0;
};

Errors errors_of(const ListFigures& row) {
  Errors errors;
  for (const ListRate& rate : row.rates) {
    errors.wrong += rate.wrong();
    errors.lacking += rate.lacking;
    errors.checked += rate.checked;
  }
  return errors;
}

std::string table1_html(std::span<const ListFigures> rows, const std::string& scene) {
  constexpr const char* kTitles[] = {"Strategy",      "Tests a ray",
                                     "printed",       "Low rate, ns a ray",
                                     "printed, µs",   "High rate, ns a ray",
                                     "printed, µs",   "Wrong answers",
                                     "Lists lacking", "of"};
  std::string out = head(kTitles);
  for (const ListFigures& row : rows) {
    if (row.scene != scene || row.table != "table1") continue;
    const std::array<Table1Cell, 3> cells = table1_cells(rows, row);
    const Errors errors = errors_of(row);
    out += name_cell(row.name);
    for (std::size_t k = 0; k < 3; ++k)
      out += ours_cell(cells[k], k == 0 ? 1 : 0) + printed_cell(cells[k], k == 0 ? 1 : 0);
    out += count_cell(errors.wrong) + count_cell(errors.lacking) + number_cell(thousands(errors.checked)) +
           "</tr>\n";
  }
  return out + kEnd;
}

std::string figures_html(std::span<const ListFigures> rows, const std::string& scene) {
  constexpr const char* kTitles[] = {"The text", "Ours", "Printed", "Direction"};
  std::string out = head(kTitles);
  for (const TextFigure& figure : text_figures(rows, scene)) {
    out += name_cell(figure.what) + number_cell(escaped(figure.ours)) + number_cell(escaped(figure.printed)) +
           fmt::format("<td>{}</td></tr>\n", figure.direction);
  }
  return out + kEnd;
}

std::string options_html(std::span<const ListFigures> rows, const std::string& scene) {
  constexpr const char* kTitles[] = {"Options",   "Samples",       "Tests a ray",  "Tests a shaft",
                                     "of boxes",  "of planes",     "Items a list", "ns a ray",
                                     "ns a list", "Wrong answers", "Lists lacking"};
  std::string body;
  for (const ListFigures& row : rows) {
    if (row.scene != scene || (row.table != "options" && row.table != "own")) continue;
    for (std::size_t k = 0; k < row.rates.size(); ++k) {
      const ListRate& rate = row.rates[k];
      const auto ns = [](const std::optional<fuzz::Spread>& time) {
        return number_cell(time ? fmt::format("{:.0f}", time->median) : "–");
      };
      body += name_cell(row.name) + number_cell(k == 0 ? "1" : "4") +
              number_cell(fmt::format("{:.1f}", rate.tests())) +
              number_cell(fmt::format("{:.1f}", rate.of_shafts(rate.cull_tests))) +
              number_cell(fmt::format("{:.1f}", rate.of_shafts(rate.comparisons))) +
              number_cell(fmt::format("{:.1f}", rate.of_shafts(rate.planes))) +
              number_cell(fmt::format("{:.1f}", rate.of_shafts(rate.items))) + ns(rate.ray) + ns(rate.list) +
              count_cell(rate.wrong()) + count_cell(rate.lacking) + "</tr>\n";
    }
  }
  if (body.empty()) return "";
  return "<details><summary>Options one by one</summary>\n" + head(kTitles) + body + kEnd + "</details>\n";
}

std::string lists_html(std::span<const ListFigures> rows) {
  std::string out;
  for (const ListFigures& row : rows) {
    if (row.table != "table1" || row.name != "baseline") continue;
    out += fmt::format("<h3>Candidate lists on {}</h3>\n", escaped(row.scene)) +
           table1_html(rows, row.scene) + figures_html(rows, row.scene) + options_html(rows, row.scene);
  }
  if (out.empty()) return out;
  return "<p>Shaft culling’s Table 1 on 20 steps of progressive radiosity, with 1 and 4 samples an emitter: "
         "tests "
         "of boxes and objects a ray that the shadow cache left, both rates averaged, and the time of such a "
         "ray "
         "with the building of lists. Small: over the baseline. <b>same</b> or <b>opposite</b>: more or less "
         "than "
         "the baseline, as printed or not. Every answer is held against the exact one; a sample of the lists "
         "is "
         "held against the exact candidates.</p>\n" +
         out;
}

std::string ratios_html(std::span<const MeasureFile> files) {
  std::vector<RadiosityTime> times;
  for (const MeasureFile& file : files) {
    for (const MeasureRow& row : file.rows) {
      if (!fuzz::is_radiosity(row.workload) || !row.image) continue;
      times.push_back({file.path.string() + "\n" + row.scene + "\n" + row.variant + "\n" + row.workload,
                       row.method, row.image->median});
    }
  }
  constexpr const char* kTitles[] = {"Method", "Geometric mean", "Least", "Most", "of"};
  std::string body;
  for (const RadiosityRatio& ratio : ratios_to_embree(times)) {
    body += name_cell(ratio.method) + number_cell(fmt::format("{:.2f}", ratio.mean)) +
            number_cell(fmt::format("{:.2f}", ratio.least)) + number_cell(fmt::format("{:.2f}", ratio.most)) +
            number_cell(std::to_string(ratio.places)) + "</tr>\n";
  }
  if (body.empty()) return "";
  return "<h3>Batches of rays</h3>\n<p>Time a ray over that of Embree’s quickest row that asks ray by ray, "
         "over "
         "scenes and rays a pair; methods named shaft- are asked pair by pair. Their errors stand with the "
         "scenes.</p>\n" +
         head(kTitles) + body + kEnd;
}

}  // namespace

std::string radiosity_section(std::span<const MeasureFile> files) {
  std::string out = ratios_html(files);
  for (const MeasureFile& file : files) out += lists_html(file.lists);
  if (out.empty()) return out;
  return "<section id=\"radiosity\"><h2>Radiosity</h2>\n" + out + "</section>\n";
}

}  // namespace gnomon::reports
