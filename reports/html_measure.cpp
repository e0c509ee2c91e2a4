// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/html_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>

#include "fuzz/workload.h"
#include "reports/html_panel.h"
#include "reports/html_text.h"

namespace gnomon::reports {
namespace {

constexpr PanelText kFalseLit{"Unsound: lit though in shadow", "false lit / queries that are not lit",
                              "ns per query"};
constexpr PanelText kFalseShadowed{"Unsound: in shadow though lit", "false shadowed / queries that are lit",
                                   "ns per query"};

constexpr PanelText kWrongFace{"Unsound: another face than the first", "wrong face / rays that meet one",
                               "ns per query"};
constexpr PanelText kFalseMiss{"Unsound: none though there is a face", "false miss / rays that meet one",
                               "ns per query"};

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const unsigned three = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (unsigned k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[three >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

/// The scene's picture beside the result file; empty when there is none.
std::string picture(const std::filesystem::path& folder, const std::string& scene) {
  const std::filesystem::path path = folder / (std::filesystem::path(scene).filename().string() + ".png");
  std::ifstream in(path, std::ios::binary);
  if (!in) return "";
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!bytes.starts_with("\x89PNG\r\n")) return "";
  return fmt::format("<p><img alt=\"{}\" src=\"data:image/png;base64,{}\"/></p>\n", escaped(scene),
                     base64(bytes));
}

std::string plot(std::span<const MeasureRow> rows, Share MeasureRow::*errors, const PanelText& text) {
  PlotPanel panel;
  for (const MeasureRow& row : rows) {
    if (!row.image || (row.*errors).n == 0 || !(row.image->median > 0)) continue;
    const double ns = row.image->median;
    if (row.tier == "reference") {
      panel.references.push_back({row.method, ns});
    } else {
      panel.points.push_back({row.method, row.tier, "f32", "", ns, false, ns, row.*errors, 0, 0, "start"});
    }
  }
  if (panel.points.empty()) return "";
  panel.x = time_axis(panel.points, panel.references);
  panel.y = error_axis(panel.points);
  pull_in(panel);
  place_labels(panel);
  return panel_svg(panel, text, rows.front().scene + " " + rows.front().workload);
}

std::string count_cell(std::uint64_t n, const char* look) {
  return fmt::format("<td class=\"num {}\">{}</td>", n == 0 ? "quiet" : look, thousands(n));
}

/// The shares of pairs that a method answered without a test of any ray, and its candidates a pair.
std::string pair_cells(const std::optional<PairShares>& pairs) {
  if (!pairs || pairs->pairs == 0) return "<td class=\"num\">–</td><td class=\"num\">–</td>";
  const auto percent = [&](std::uint64_t n) {
    return 100 * static_cast<double>(n) / static_cast<double>(pairs->pairs);
  };
  return fmt::format("<td class=\"num\">{:.0f} % / {:.0f} %</td><td class=\"num\">{:.1f}</td>",
                     percent(pairs->all), percent(pairs->none), pairs->faces);
}

std::string row_html(const MeasureRow& row) {
  const auto tests = [](const std::optional<double>& n) {
    return fmt::format("<td class=\"num\">{}</td>", n ? fmt::format("{:.1f}", *n) : "–");
  };
  const auto time = [](const std::optional<TimeSpread>& t) {
    return t ? fmt::format("<td class=\"num\">{:.1f} <small>[{:.1f}, {:.1f}]</small></td>", t->median,
                           t->low25, t->high75)
             : "<td class=\"num\">–</td>";
  };
  std::string out = fmt::format("<tr><th scope=\"row\"><span class=\"dot t-{}\"></span>{}</th><td>{}{}</td>",
                                escaped(row.tier), escaped(row.method), escaped(row.promise),
                                row.promise_broken ? " <b class=\"bad\">broken</b>" : "");
  const auto share_cell = [](const Share& share) {
    return fmt::format("<td class=\"num\">{}</td>", share_html(share));
  };
  if (row.question == "first-hit") {
    out += share_cell(row.wrong_face) + share_cell(row.false_miss) + share_cell(row.false_hit);
  } else {
    out += share_cell(row.false_lit) + share_cell(row.false_shadowed) + count_cell(row.wrong_reason, "bad");
  }
  out += count_cell(row.unsound_touching, "warn") + count_cell(row.undecided + row.rejected, "warn") +
         tests(row.boxes) + tests(row.face_tests) + time(row.image) + time(row.shuffled);
  if (fuzz::is_radiosity(row.workload)) out += time(row.listed) + pair_cells(row.pairs);
  out += fmt::format("<td class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n",
                     row.set_up_seconds ? fmt::format("{:.2g} ms", *row.set_up_seconds * 1e3) : "–",
                     row.bytes > 0 ? thousands((row.bytes + 999) / 1000) + " kB" : "–");
  return out;
}

std::string workload_html(std::span<const MeasureRow> rows) {
  const MeasureRow& first = rows.front();
  std::string out = fmt::format("<h4>{} <small>{}, {}: {} faces, {} queries</small></h4>\n",
                                escaped(first.workload), escaped(first.question), escaped(first.variant),
                                thousands(first.faces), thousands(first.queries));
  const bool rays = first.question == "first-hit";
  const std::string plots =
      rays ? plot(rows, &MeasureRow::wrong_face, kWrongFace) + plot(rows, &MeasureRow::false_miss, kFalseMiss)
           : plot(rows, &MeasureRow::false_lit, kFalseLit) +
                 plot(rows, &MeasureRow::false_shadowed, kFalseShadowed);
  if (!plots.empty()) out += "<div class=\"panels\">\n" + plots + "</div>\n";
  out +=
      "<div class=\"scroll\"><table><thead><tr><th scope=\"col\">Method</th><th scope=\"col\">Promise</th>";
  out += rays
             ? "<th scope=\"col\">Wrong face</th><th scope=\"col\">False miss</th><th scope=\"col\">False "
               "hit</th>"
             : "<th scope=\"col\">False lit</th><th scope=\"col\">False shadowed</th><th scope=\"col\">Dark, "
               "wrong reason</th>";
  out +=
      "<th scope=\"col\">of all these touching</th><th scope=\"col\">Undecided</th><th "
      "scope=\"col\">Boxes</th><th scope=\"col\">Faces</th><th scope=\"col\">ns, image order</th><th "
      "scope=\"col\">ns, shuffled</th>";
  if (fuzz::is_radiosity(first.workload)) {
    out +=
        "<th scope=\"col\">ns, pairs with candidates</th><th scope=\"col\">Pairs all / none</th><th "
        "scope=\"col\">Faces a pair</th>";
  }
  out += "<th scope=\"col\">Set-up</th><th scope=\"col\">Memory</th></tr></thead><tbody>\n";
  for (const MeasureRow& row : rows) out += row_html(row);
  return out + "</tbody></table></div>\n";
}

/// The rows scene by scene, in the order in which scenes first come: both questions of a scene together.
std::vector<MeasureRow> by_scene(const std::vector<MeasureRow>& rows) {
  std::vector<std::string> scenes;
  for (const MeasureRow& row : rows) {
    if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
  }
  std::vector<MeasureRow> sorted;
  for (const std::string& scene : scenes) {
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(sorted),
                 [&](const MeasureRow& row) { return row.scene == scene; });
  }
  return sorted;
}

std::string file_html(const std::filesystem::path& path, const std::vector<MeasureRow>& unsorted) {
  const std::vector<MeasureRow> rows = by_scene(unsorted);
  std::string out, scene;
  for (auto from = rows.begin(); from != rows.end();) {
    const auto to = std::find_if(from, rows.end(), [&](const MeasureRow& row) {
      return row.question != from->question || row.scene != from->scene || row.variant != from->variant ||
             row.workload != from->workload;
    });
    if (from->scene != scene) {
      scene = from->scene;
      out +=
          fmt::format("<h3>{} <small>{}</small></h3>\n", escaped(scene), escaped(path.filename().string()));
      out += picture(path.parent_path(), scene);
    }
    out += workload_html({from, to});
    from = to;
  }
  return out;
}

}  // namespace

std::string measure_section(std::span<const MeasureFile> files) {
  std::string out;
  for (const MeasureFile& file : files) out += file_html(file.path, file.rows);
  if (out.empty()) return out;
  return "<section id=\"scenes\"><h2>Scenes</h2>\n<p>Methods on the queries that scenes ask, judged by the "
         "exact answers. Queries of a scene are not independent; the 95 % intervals take them as if they "
         "were. "
         "Times are medians of rounds in which all methods take turns, with quartiles; boxes and faces are "
         "tests a query.</p>\n" +
         out + "</section>\n";
}

}  // namespace gnomon::reports
