// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/list_figures.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::reports {
namespace {

constexpr PrintedRow kTable1[] = {
    {"baseline", {44.6, 787, 762}, {79.2, 1487, 1355}},
    {"keep closed", {28.4, 642, 534}, {47.8, 1094, 919}},
    {"always open", {132.9, 2268, 1785}, {27.5, 1289, 694}},
    {"overlap open", {66.7, 1382, 1008}, {25.8, 1283, 680}},
    {"ratio open 0.2", {22.1, 670, 482}, {27.1, 1104, 685}},
    {"ratio open 0.4", {21.9, 681, 480}, {26.7, 1135, 682}},
    {"ratio open 0.6", {22.1, 679, 478}, {25.0, 1154, 654}},
    {"ratio open 0.8", {24.1, 753, 524}, {21.1, 1327, 631}},
};

enum class PaperScene : std::uint8_t { standard, premeshed, none };

PaperScene paper_scene(std::string_view scene) {
  const std::string_view name = scene.substr(0, scene.find(':'));
  return name == "office"        ? PaperScene::standard
         : name == "office-fine" ? PaperScene::premeshed
                                 : PaperScene::none;
}

double over(double a, double b) {
  return b > 0 ? a / b : 0;
}
double real(std::uint64_t n) {
  return static_cast<double>(n);
}

/// Nanoseconds a ray at the high rate; 0 of what was not asked there, or not timed.
double high_ns(const ListFigures& row) {
  return row.rates.size() > 1 && row.rates[1].ray ? row.rates[1].ray->median : 0;
}

std::string direction_of(double ours, double printed) {
  return (ours < 1) == (printed < 1) ? "same" : "opposite";
}

}  // namespace

double ListRate::tests() const {
  return over(real(boxes) + real(objects), real(uncached));
}
double ListRate::all_tests() const {
  return real(boxes) + real(objects) + real(cache_tests);
}
double ListRate::rays_a_shaft() const {
  return over(real(uncached), real(shafts));
}
double ListRate::of_shafts(std::uint64_t count) const {
  return over(real(count), real(shafts));
}

double ListFigures::tests() const {
  double sum = 0;
  for (const ListRate& rate : rates) sum += rate.tests();
  return over(sum, static_cast<double>(rates.size()));
}

ListFigures figures_of(const fuzz::ListRow& row) {
  ListFigures figures{row.scene, row.table, row.spec.name, text_of(row.spec.setup), {}};
  for (std::size_t k = 0; k < row.rates; ++k) {
    const fuzz::ListCounts& c = row.counts[k];
    ListRate rate{c.pairs,
                  c.rays,
                  c.shadowed,
                  c.cast.cache_tests,
                  c.cast.cache_hits,
                  c.cast.rays,
                  c.cast.boxes,
                  c.cast.objects,
                  c.cull.lists,
                  c.cull.volumes,
                  c.cull.items,
                  c.cull.comparisons,
                  c.cull.planes,
                  c.volumes,
                  c.below_volumes,
                  c.false_lit,
                  c.false_shadowed,
                  c.checked,
                  c.lacking,
                  c.checked_faces,
                  c.excess_faces,
                  row.times[k].ray,
                  {}};
    if (row.spec.start == fuzz::ListStart::lists) rate.list = row.times[k].list;
    figures.rates.push_back(rate);
  }
  return figures;
}

std::span<const PrintedRow> printed_table1() {
  return kTable1;
}

const std::array<double, 3>* printed_for(const ListFigures& row) {
  const PaperScene scene = paper_scene(row.scene);
  const auto printed = std::find_if(std::begin(kTable1), std::end(kTable1),
                                    [&](const PrintedRow& candidate) { return candidate.name == row.name; });
  if (scene == PaperScene::none || row.table != "table1" || printed == std::end(kTable1)) return nullptr;
  return scene == PaperScene::standard ? &printed->standard : &printed->premeshed;
}

const ListFigures* find_row(std::span<const ListFigures> rows, std::string_view scene,
                            std::string_view name) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const ListFigures& row) {
    return row.scene == scene && row.name == name;
  });
  return found == rows.end() ? nullptr : &*found;
}

std::array<Table1Cell, 3> table1_cells(std::span<const ListFigures> rows, const ListFigures& row) {
  const ListFigures* const base = find_row(rows, row.scene, "baseline");
  const std::array<double, 3>* const printed = printed_for(row);
  const std::array<double, 3>* const printed_base = base != nullptr ? printed_for(*base) : nullptr;
  const auto value_of = [](const ListFigures& of, std::size_t k) {
    if (k == 0) return of.tests();
    return of.rates.size() >= k && of.rates[k - 1].ray ? of.rates[k - 1].ray->median : 0;
  };
  std::array<Table1Cell, 3> cells;
  for (std::size_t k = 0; k < 3; ++k) {
    Table1Cell& cell = cells[k];
    cell.value = value_of(row, k);
    cell.ratio = base != nullptr ? over(cell.value, value_of(*base, k)) : 0;
    if (printed == nullptr || printed_base == nullptr) continue;
    cell.printed = (*printed)[k];
    cell.printed_ratio = (*printed)[k] / (*printed_base)[k];
    if (&row != base && cell.value > 0) cell.direction = direction_of(cell.ratio, *cell.printed_ratio);
  }
  return cells;
}

std::optional<double> break_even(const ListFigures& baseline, const ListFigures& row, std::size_t rate) {
  if (rate >= row.rates.size() || rate >= baseline.rates.size()) return std::nullopt;
  const ListRate &with = row.rates[rate], &without = baseline.rates[rate];
  if (!with.ray || !with.list || !without.ray) return std::nullopt;
  const double cast = with.ray->median - over(with.list->median * real(with.shafts), real(with.uncached));
  const double saved = without.ray->median - cast;
  if (!(saved > 0)) return std::nullopt;
  return with.list->median / saved;
}

std::vector<TextFigure> text_figures(std::span<const ListFigures> rows, std::string_view scene) {
  std::vector<TextFigure> figures;
  const PaperScene paper = paper_scene(scene);
  const auto row = [&](std::string_view name) { return find_row(rows, scene, name); };
  const auto printed = [&](const char* standard, const char* premeshed) {
    return std::string(paper == PaperScene::standard    ? standard
                       : paper == PaperScene::premeshed ? premeshed
                                                        : "");
  };
  const auto percent = [](double share) { return fmt::format("{:.1f} %", 100 * share); };
  // `same`: of what has a direction.
  const auto say = [&](std::string what, std::string ours, std::string theirs,
                       std::optional<bool> same = std::nullopt) {
    const char* const direction = theirs.empty() || !same ? "" : *same ? "same" : "opposite";
    figures.push_back({std::move(what), std::move(ours), std::move(theirs), direction});
  };
  const ListFigures* const none = row("no shadow cache");
  const ListFigures* const cache = row("shadow cache alone");
  const ListFigures* const base = row("baseline");
  if (cache != nullptr && !cache->rates.empty()) {
    const ListRate& low = cache->rates[0];
    say("rays shadowed, 1 sample", percent(over(real(low.shadowed), real(low.rays))),
        printed("54 %", "54 %"));
    say("of these found by the shadow cache", percent(over(real(low.cache_hits), real(low.shadowed))),
        printed("78 %", "78 %"), 2 * low.cache_hits > low.shadowed);
    if (none != nullptr && !none->rates.empty()) {
      const double saved = 1 - over(low.all_tests(), none->rates[0].all_tests());
      say("tests saved by the shadow cache", percent(saved), printed("31 %", "31 %"), saved > 0);
    }
    if (base != nullptr && !base->rates.empty()) {
      const double saved = 1 - over(base->rates[0].all_tests(), low.all_tests());
      say("tests saved by the emitter list", percent(saved), printed("17 %", "12 %"), saved > 0);
    }
  }
  if (const ListFigures* const closed = row("keep closed"); closed != nullptr && closed->rates.size() == 2) {
    say("uncached rays a shaft, low and high rate",
        fmt::format("{:.1f}, {:.1f}", closed->rates[0].rays_a_shaft(), closed->rates[1].rays_a_shaft()),
        printed("8.1, 34.0", "3.9, 18.5"));
  }
  for (const auto& [ratio, theirs] : {std::pair{"0.2", "2.6"}, {"0.6", "1.4"}, {"0.8", "<0.01"}}) {
    const ListFigures* const with = row(fmt::format("ratio open {}", ratio));
    const ListFigures* const without = row(fmt::format("ratio open {}, no marks", ratio));
    if (with == nullptr || without == nullptr) continue;
    const double saved = without->tests() - with->tests();
    say(fmt::format("tests a ray saved by marks at ratio {}", ratio), fmt::format("{:.3f}", saved),
        printed("", theirs), saved >= 0);
  }
  if (const ListFigures* const open = row("overlap open"); open != nullptr && !open->rates.empty()) {
    const ListRate& low = open->rates[0];
    const double boxes = low.of_shafts(low.volumes);
    say("complex boxes inside a shaft", fmt::format("{:.2f}", boxes), printed("0.71", "0.36"));
    say("objects below each", fmt::format("{:.1f}", over(real(low.below_volumes), real(low.volumes))),
        printed("33.1", "4.3"));
  }
  if (base == nullptr || cache == nullptr) return figures;
  double fewest = 0, quickest = 0, most = 0;
  for (const ListFigures& candidate : rows) {
    if (candidate.scene != scene || !candidate.name.starts_with("ratio open") ||
        candidate.table != "table1") {
      continue;
    }
    fewest = std::max(fewest, over(base->tests(), candidate.tests()));
    quickest = std::max(quickest, over(high_ns(*base), high_ns(candidate)));
    most = std::max(most, over(high_ns(*cache), high_ns(candidate)));
  }
  say("fewer tests with the best ratio: factor", fmt::format("{:.2f}", fewest), printed("2.0", "3.8"),
      fewest > 1);
  if (quickest > 0) {
    say("speed-up with the best ratio, high rate", fmt::format("{:.2f}", quickest),
        printed("1.6", "2.2 (2.147)"), quickest > 1);
  }
  if (most > 0) {
    say("total speed-up, emitter list included", fmt::format("{:.2f}", most), printed("", "2.44"), most > 1);
  }
  for (const char* const name : {"keep closed", "ratio open 0.4"}) {
    const ListFigures* const list = row(name);
    if (list == nullptr || list->rates.size() < 2 || !list->rates[0].ray) continue;
    const auto from = [&](std::size_t rate) {
      const std::optional<double> rays = break_even(*base, *list, rate);
      return rays ? fmt::format("{:.1f}", *rays) : std::string("never");
    };
    say(fmt::format("rays that pay for a shaft, {}, low and high rate", name),
        fmt::format("{}, {}", from(0), from(1)), printed("about 10", "about 10"));
  }
  return figures;
}

}  // namespace gnomon::reports
