// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/measure_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/statistics.h"
#include "fuzz/workload.h"
#include "reports/radiosity_ratio.h"

namespace gnomon::reports {
namespace {

using fuzz::FirstHitRow;
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
      "  {:<20}{:>9}{:>9}{:>9}{:>10}{:>10}{:>9}{:>8}{:>8}{:>30}{:>10}{:>9}{:>10}\n",
      row.scene, row.variant, row.workload, row.faces, row.queries(), of(row.matrix), of(row.touching),
      "method", "f. lit", "f. shad.", "of touch", "f.lit rt", "f.shad rt", "undecid.", "boxes", "faces",
      "ns [25 %, 75 %]", "shuffled", "set-up", "memory");
}

/// Set-up and memory, where they are known.
std::string set_up_text(const fuzz::SetUp* set_up) {
  if (set_up == nullptr) return fmt::format("{:>9}{:>10}", "", "");
  return fmt::format("{:>9}{:>10}", fmt::format("{:.4f}", set_up->seconds), bytes_text(set_up->bytes));
}

/// Tests, times, set-up and memory: what the tables of both questions end with.
template <class Row>
std::string cost_text(const Row& row, const fuzz::QueryTimes& times, const fuzz::SetUp* set_up) {
  const double n = static_cast<double>(std::max<std::uint64_t>(row.queries(), 1));
  const auto per_query = [&](std::uint64_t tests) {
    return row.tests ? fmt::format("{:.1f}", static_cast<double>(tests) / n) : std::string("-");
  };
  const fuzz::TestCounts tests = row.tests.value_or(fuzz::TestCounts{});
  return fmt::format("{:>8}{:>8}{:>30}{:>10.1f}", per_query(tests.boxes), per_query(tests.faces),
                     fmt::format("{:.1f} [{:.1f}, {:.1f}]", times.image.median, times.image.low25,
                                 times.image.high75),
                     times.shuffled.median) +
         set_up_text(set_up);
}

/// What is worth saying only where it happened.
template <class Row>
std::string remarks(const Row& row) {
  std::string text;
  if (row.tests && row.tests->exact > 0) {
    const double n = static_cast<double>(std::max<std::uint64_t>(row.queries(), 1));
    text += fmt::format("  {:.2g} exact a query", static_cast<double>(row.tests->exact) / n);
  }
  if (row.changed_by_order > 0) text += fmt::format("  {} changed by order", row.changed_by_order);
  if (row.promise_broken()) text += fmt::format("  PROMISE BROKEN ({})", name_of(row.method->promise));
  return text + "\n";
}

/// Of rows of radiosity: the pairs that have candidates, and what methods that are asked by pairs found.
std::string pairs_text(const ShadowRow& row, const fuzz::QueryTimes& times) {
  std::string text;
  if (times.listed) text += fmt::format("  with candidates {:.1f} ns", times.listed->median);
  if (row.pairs && row.pairs->pairs > 0) {
    const double n = static_cast<double>(row.pairs->pairs);
    text += fmt::format("; pairs: {:.0f} % all, {:.0f} % none, {:.1f} faces each",
                        100 * static_cast<double>(row.pairs->all) / n,
                        100 * static_cast<double>(row.pairs->none) / n,
                        static_cast<double>(row.pairs->faces) / n);
  }
  return text;
}

std::string row_text(const ShadowRow& row, const fuzz::QueryTimes& times, const fuzz::SetUp* set_up) {
  const auto& m = row.matrix;
  std::string text =
      fmt::format("  {:<20}{:>9}{:>9}{:>9}{:>10}{:>10}{:>9}", row.method->name, ShadowRow::false_lit(m),
                  ShadowRow::false_shadowed(m), ShadowRow::unsound(row.touching),
                  rate_text(ShadowRow::false_lit(m), row.dark()),
                  rate_text(ShadowRow::false_shadowed(m), ShadowRow::truths(m, 0)),
                  ShadowRow::column(m, fuzz::kUndecided));
  text += cost_text(row, times, set_up);
  if (ShadowRow::wrong_reason(m) > 0) {
    text += fmt::format("  {} dark for the wrong reason", ShadowRow::wrong_reason(m));
  }
  return text + pairs_text(row, times) + remarks(row);
}

std::string header_text(const FirstHitRow& row) {
  const auto of = [](const FirstHitRow::Matrix& m) {
    return fmt::format("{} hits, {} misses", FirstHitRow::truths(m, 1), FirstHitRow::truths(m, 0));
  };
  return fmt::format(
      "\n{} ({}) {}: first-hit, {} faces, {} rays, exactly {}; ties {}; touching {}\n"
      "  {:<20}{:>9}{:>9}{:>9}{:>9}{:>10}{:>9}{:>8}{:>8}{:>30}{:>10}{:>9}{:>10}\n",
      row.scene, row.variant, row.workload, row.faces, row.queries(), of(row.matrix), row.ties,
      of(row.touching), "method", "w. face", "f. miss", "f. hit", "of touch", "wrong rt", "undecid.", "boxes",
      "faces", "ns [25 %, 75 %]", "shuffled", "set-up", "memory");
}

std::string row_text(const FirstHitRow& row, const fuzz::QueryTimes& times, const fuzz::SetUp* set_up) {
  const auto& m = row.matrix;
  std::string text = fmt::format(
      "  {:<20}{:>9}{:>9}{:>9}{:>9}{:>10}{:>9}", row.method->name, FirstHitRow::wrong_face(m),
      FirstHitRow::false_miss(m), FirstHitRow::false_hit(m), FirstHitRow::unsound(row.touching),
      rate_text(FirstHitRow::unsound(m), row.queries()), FirstHitRow::column(m, FirstHitRow::undecided));
  text += cost_text(row, times, set_up);
  if (const std::uint64_t n = FirstHitRow::column(m, FirstHitRow::rejected); n > 0) {
    text += fmt::format("  {} numbers of no face", n);
  }
  return text + remarks(row);
}

const fuzz::SetUp* set_up_of(const fuzz::Measurement& measurement, const auto& row) {
  const auto set_up =
      std::find_if(measurement.set_ups.begin(), measurement.set_ups.end(), [&](const fuzz::SetUp& candidate) {
        return candidate.method == row.method && candidate.scene == row.scene &&
               candidate.variant == row.variant;
      });
  return set_up != measurement.set_ups.end() ? &*set_up : nullptr;
}

std::string ratios_text(const fuzz::Measurement& measurement) {
  std::vector<RadiosityTime> times;
  for (std::size_t i = 0; i < measurement.rows.size(); ++i) {
    const ShadowRow& row = measurement.rows[i];
    if (!fuzz::is_radiosity(row.workload)) continue;
    times.push_back({row.scene + "\n" + row.variant + "\n" + row.workload, std::string(row.method->name),
                     measurement.times[i].image.median});
  }
  std::string text;
  for (const RadiosityRatio& ratio : ratios_to_embree(times)) {
    if (text.empty()) {
      text =
          "\nradiosity: time a ray over that of Embree's quickest row that asks ray by ray, over scenes and "
          "rays a pair\n" +
          fmt::format("  {:<24}{:>16}{:>10}{:>10}{:>8}\n", "method", "geometric mean", "least", "most", "of");
    }
    text += fmt::format("  {:<24}{:>16.2f}{:>10.2f}{:>10.2f}{:>8}\n", ratio.method, ratio.mean, ratio.least,
                        ratio.most, ratio.places);
  }
  return text;
}

template <class Row>
std::string tables_text(const fuzz::Measurement& measurement, const std::vector<Row>& rows,
                        const std::vector<fuzz::QueryTimes>& times) {
  std::string text, last;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const std::string key = row.scene + "\n" + row.variant + "\n" + row.workload;
    if (key != last) text += header_text(row);
    last = key;
    text += row_text(row, times[i], set_up_of(measurement, row));
  }
  return text;
}

constexpr const char* kShadowLegend =
    "\nf. lit, f. shad.: said to be lit or in shadow and exactly not; of touch: such errors, and dark for "
    "the "
    "wrong\nreason, on touching queries. Rates are of queries exactly dark, or lit.\n";

constexpr const char* kHitLegend =
    "\nw. face: another face than those that the ray meets first (all that tie are right); f. miss: none, "
    "though there is\none; f. hit: a face, though there is none; of touch: such errors on touching rays; "
    "wrong "
    "rt: the rate of them all.\n";

constexpr const char* kLegend =
    "\n\"<\": none seen, upper end of the 95 % interval. Queries of a scene are not independent; the "
    "intervals "
    "take them as\nif they were. boxes, faces: tests a query. ns: processor time a query in the order of the "
    "image, median of the rounds\nand quartiles; shuffled: the same queries in random order; set-up in "
    "seconds.\n";

}  // namespace

std::string measure_text(const fuzz::Measurement& measurement) {
  std::string text = tables_text(measurement, measurement.rows, measurement.times) +
                     tables_text(measurement, measurement.hit_rows, measurement.hit_times) +
                     ratios_text(measurement);
  if (!measurement.rows.empty()) text += kShadowLegend;
  if (!measurement.hit_rows.empty()) text += kHitLegend;
  if (!text.empty()) text += kLegend;
  if (!measurement.notes.empty()) text += "\n";
  for (const std::string& note : measurement.notes) text += note + "\n";
  return text;
}

}  // namespace gnomon::reports
