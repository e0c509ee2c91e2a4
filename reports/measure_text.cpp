// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/measure_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/statistics.h"

namespace gnomon::reports {
namespace {

using fuzz::ShadowRow;

std::string bytes_text(std::size_t bytes) {
  const double value = static_cast<double>(bytes);
  if (value < 1e3) return fmt::format("{} B", bytes);
  if (value < 1e6) return fmt::format("{:.1f} kB", value / 1e3);
  if (value < 1e9) return fmt::format("{:.1f} MB", value / 1e6);
  return fmt::format("{:.1f} GB", value / 1e9);
}

/// "1.2e-05", or for none seen the upper end of the 95 % interval, "<3.7e-05".
std::string rate_text(std::uint64_t hits, std::uint64_t of) {
  if (of == 0) return "-";
  const fuzz::Rate rate = fuzz::rate_of(hits, of);
  return hits == 0 ? fmt::format("<{:.1e}", rate.high95) : fmt::format("{:.1e}", rate.value);
}

std::string header_text(const ShadowRow& row) {
  const auto of = [&](const ShadowRow::Matrix& m) {
    return fmt::format("{} lit, {} shadowed, {} facing", ShadowRow::truths(m, 0), ShadowRow::truths(m, 1),
                       ShadowRow::truths(m, 2));
  };
  return fmt::format(
      "\nshadow {} ({}) {}: {} faces, {} queries, exactly {}; touching {}\n"
      "  {:<20}{:>9}{:>9}{:>9}{:>10}{:>10}{:>9}{:>8}{:>8}{:>26}{:>10}{:>9}{:>10}\n",
      row.scene, row.variant, row.workload, row.faces, row.queries(), of(row.matrix), of(row.touching),
      "method", "f. lit", "f. shad.", "of touch", "f.lit rt", "f.shad rt", "undecid.", "boxes", "faces",
      "ns [25 %, 75 %]", "shuffled", "set-up", "memory");
}

std::string row_text(const ShadowRow& row, const fuzz::ShadowTimes& times, const fuzz::SetUp* set_up) {
  const auto& m = row.matrix;
  const double n = static_cast<double>(std::max<std::uint64_t>(row.queries(), 1));
  const auto per_query = [&](std::uint64_t tests) {
    return row.tests ? fmt::format("{:.1f}", static_cast<double>(tests) / n) : std::string("-");
  };
  const fuzz::TestCounts tests = row.tests.value_or(fuzz::TestCounts{});
  std::string text = fmt::format(
      "  {:<20}{:>9}{:>9}{:>9}{:>10}{:>10}{:>9}{:>8}{:>8}{:>26}{:>10.1f}{:>9}{:>10}", row.method->name,
      ShadowRow::false_lit(m), ShadowRow::false_shadowed(m), ShadowRow::unsound(row.touching),
      rate_text(ShadowRow::false_lit(m), row.dark()),
      rate_text(ShadowRow::false_shadowed(m), ShadowRow::truths(m, 0)),
      ShadowRow::column(m, fuzz::kUndecided), per_query(tests.boxes), per_query(tests.faces),
      fmt::format("{:.1f} [{:.1f}, {:.1f}]", times.image.median, times.image.low25, times.image.high75),
      times.shuffled.median, set_up != nullptr ? fmt::format("{:.4f}", set_up->seconds) : "",
      set_up != nullptr ? bytes_text(set_up->bytes) : "");
  if (ShadowRow::wrong_reason(m) > 0) {
    text += fmt::format("  {} dark for the wrong reason", ShadowRow::wrong_reason(m));
  }
  if (tests.exact > 0) text += fmt::format("  {:.2g} exact a query", static_cast<double>(tests.exact) / n);
  if (row.changed_by_order > 0) text += fmt::format("  {} changed by order", row.changed_by_order);
  if (row.promise_broken()) text += fmt::format("  PROMISE BROKEN ({})", name_of(row.method->promise));
  return text + "\n";
}

constexpr const char* kLegend =
    "\nf. lit, f. shad.: said to be lit or in shadow and exactly not; of touch: such errors, and dark for "
    "the "
    "wrong\nreason, on touching queries. Rates are of queries exactly dark, or lit; \"<\": none seen, upper "
    "end "
    "of the 95 %\ninterval. Queries of a scene are not independent; the intervals take them as if they were. "
    "boxes, faces: tests a query.\nns: processor time a query in the order of the image, median of the "
    "rounds "
    "and quartiles; shuffled: the same\nqueries in random order; set-up in seconds.\n";

}  // namespace

std::string measure_text(const fuzz::Measurement& measurement) {
  std::string text, last;
  for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
    const ShadowRow& row = measurement.rows[i];
    const std::string key = row.scene + "\n" + row.variant + "\n" + row.workload;
    if (key != last) text += header_text(row);
    last = key;
    const auto set_up = std::find_if(
        measurement.set_ups.begin(), measurement.set_ups.end(), [&](const fuzz::SetUp& candidate) {
          return candidate.method == row.method && candidate.scene == row.scene &&
                 candidate.variant == row.variant;
        });
    text += row_text(row, measurement.times[i], set_up != measurement.set_ups.end() ? &*set_up : nullptr);
  }
  if (!measurement.rows.empty()) text += kLegend;
  if (!measurement.notes.empty()) text += "\n";
  for (const std::string& note : measurement.notes) text += note + "\n";
  return text;
}

}  // namespace gnomon::reports
