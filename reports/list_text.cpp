// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "reports/list_figures.h"

namespace gnomon::reports {
namespace {

std::string cell_text(const Table1Cell& cell, int digits) {
  return fmt::format("{:>16}", fmt::format("{:.{}f} ({:.2f})", cell.value, digits, cell.ratio));
}

std::string printed_text(const Table1Cell& cell, int digits) {
  if (!cell.printed) return "";
  return fmt::format("{:>15}", fmt::format("{:.{}f} ({:.2f})", *cell.printed, digits, *cell.printed_ratio));
}

std::string errors_text(const ListFigures& row) {
  std::uint64_t wrong = 0, lacking = 0, checked = 0, faces = 0, excess = 0;
  for (const ListRate& rate : row.rates) {
    wrong += rate.wrong();
    lacking += rate.lacking;
    checked += rate.checked;
    faces += rate.checked_faces;
    excess += rate.excess_faces;
  }
  const std::string lists = checked > 0 ? fmt::format("{}/{}", lacking, checked) : "-";
  const std::string share =
      faces > 0 ? fmt::format("{:.0f} %", 100 * static_cast<double>(excess) / static_cast<double>(faces))
                : "-";
  return fmt::format("{:>7}{:>13}{:>8}", wrong, lists, share);
}

std::string table1_text(std::span<const ListFigures> rows, const ListFigures& first) {
  const bool printed = printed_for(first) != nullptr;
  const ListRate &low = first.rates[0], &high = first.rates[1];
  std::string text = fmt::format(
      "\ncandidate lists on {}: 20 steps of progressive radiosity, {} rays with 1 sample an emitter, {} with "
      "4\n  {:<18}{:>16}{:>16}{:>16}{:>7}{:>13}{:>8}",
      first.scene, low.rays, high.rays, "Table 1", "tests a ray", "ns a ray, low", "ns a ray, high", "wrong",
      "lacking", "excess");
  if (printed)
    text += fmt::format(" |{:>15}{:>15}{:>15}  {}", "printed tests", "low us", "high us", "direction");
  text += "\n";
  for (const ListFigures& row : rows) {
    if (row.scene != first.scene || row.table != "table1") continue;
    const std::array<Table1Cell, 3> cells = table1_cells(rows, row);
    text += fmt::format("  {:<18}{}{}{}{}", row.name, cell_text(cells[0], 1), cell_text(cells[1], 0),
                        cell_text(cells[2], 0), errors_text(row));
    if (printed) {
      text +=
          fmt::format(" |{}{}{}  {} {} {}", printed_text(cells[0], 1), printed_text(cells[1], 0),
                      printed_text(cells[2], 0), cells[0].direction, cells[1].direction, cells[2].direction);
    }
    while (text.ends_with(' ')) text.pop_back();
    text += "\n";
  }
  return text;
}

std::string figures_text(std::span<const ListFigures> rows, std::string_view scene) {
  std::string text = fmt::format("  {:<60}{:>16}{:>16}\n", "the text", "ours", "printed");
  for (const TextFigure& figure : text_figures(rows, scene)) {
    text +=
        fmt::format("  {:<60}{:>16}{:>16}  {}", figure.what, figure.ours, figure.printed, figure.direction);
    while (text.ends_with(' ')) text.pop_back();
    text += "\n";
  }
  return text;
}

std::string rate_text(const ListFigures& row, const ListRate& rate, const char* samples) {
  return fmt::format("  {:<32}{:>8}{:>10.1f}{:>10.1f}{:>8.1f}{:>8.1f}{:>8.1f}{:>8.1f}{:>9.0f}{:>9.0f}{}\n",
                     row.name, samples, rate.tests(), rate.of_shafts(rate.cull_tests),
                     rate.of_shafts(rate.comparisons), rate.of_shafts(rate.planes),
                     rate.of_shafts(rate.items), rate.rays_a_shaft(), rate.ray ? rate.ray->median : 0,
                     rate.list ? rate.list->median : 0,
                     errors_text({row.scene, row.table, row.name, row.setup, {rate}}));
}

/// The rows of a table rate by rate.
std::string rows_text(std::span<const ListFigures> rows, std::string_view scene, std::string_view table,
                      const char* title) {
  std::string text;
  for (const ListFigures& row : rows) {
    if (row.scene != scene || row.table != table) continue;
    if (text.empty()) {
      text = fmt::format("  {:<32}{:>8}{:>10}{:>10}{:>8}{:>8}{:>8}{:>8}{:>9}{:>9}{:>7}{:>13}{:>8}\n", title,
                         "samples", "tests/ray", "culls/sh.", "boxes", "planes", "items", "rays", "ns/ray",
                         "ns/list", "wrong", "lacking", "excess");
    }
    for (std::size_t k = 0; k < row.rates.size(); ++k)
      text += rate_text(row, row.rates[k], k == 0 ? "1" : "4");
  }
  return text;
}

constexpr const char* kLegend =
    "\nTests a ray: boxes and objects, of rays that the shadow cache left, both rates averaged; in brackets "
    "over "
    "the baseline.\nns: processor time of such a ray, making lists included, medians of rounds. Direction: "
    "of "
    "tests, low and high time, more\nor less than the baseline as printed, or not. wrong: answers that "
    "differ "
    "from the exact ones, of all rays. lacking: lists\nwithout a face that may block, of a sample held "
    "against "
    "the exact candidates; excess: faces on these that miss the shaft.\nculls, items, rays: a shaft's tests "
    "of items, items on its list, uncached rays; boxes, planes: of these tests, comparisons\nwith boxes and "
    "planes evaluated.\n";

}  // namespace

std::string lists_text(std::span<const ListFigures> rows) {
  std::string text;
  for (const ListFigures& row : rows) {
    if (row.table != "table1" || row.name != "baseline" || row.rates.size() < 2) continue;
    text += table1_text(rows, row) + figures_text(rows, row.scene) +
            rows_text(rows, row.scene, "options", "options, one by one") +
            rows_text(rows, row.scene, "own", "--shaft");
  }
  return text.empty() ? text : text + kLegend;
}

}  // namespace gnomon::reports
