// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of candidate lists as result files have them, and the numbers that the paper printed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/list_statistics.h"
#include "fuzz/spread.h"

namespace gnomon::reports {

/// A row at one sampling rate. Field names are those of the result file.
struct ListRate {
  std::uint64_t pairs = 0, rays = 0, shadowed = 0;
  std::uint64_t cache_tests = 0, cache_hits = 0;
  std::uint64_t uncached = 0, boxes = 0, objects = 0;   ///< rays that were cast, and their tests
  std::uint64_t shafts = 0, cull_tests = 0, items = 0;  ///< lists made, tests for them, items on them
  std::uint64_t comparisons = 0, planes = 0;            ///< of these tests: with boxes, and planes evaluated
  std::uint64_t volumes = 0, below_volumes = 0;         ///< complex boxes on lists, primitives below
  std::uint64_t false_lit = 0, false_shadowed = 0;
  std::uint64_t checked = 0, lacking = 0, checked_faces = 0, excess_faces = 0;
  std::optional<fuzz::Spread> ray, list;  ///< ns an uncached ray with building; ns of building a list

  [[nodiscard]] double tests() const;                         ///< boxes and objects, a ray
  [[nodiscard]] double all_tests() const;                     ///< in all, with those of the cache
  [[nodiscard]] double rays_a_shaft() const;                  ///< uncached ones
  [[nodiscard]] double of_shafts(std::uint64_t count) const;  ///< count / shafts
  [[nodiscard]] std::uint64_t wrong() const { return false_lit + false_shadowed; }
};

struct ListFigures {
  std::string scene, table, name, setup;
  std::vector<ListRate> rates;  ///< low; high where asked

  [[nodiscard]] double tests() const;  ///< a ray: the average of both rates, as in the paper
};

[[nodiscard]] ListFigures figures_of(const fuzz::ListRow& row);

/// A row of the paper's Table 1 for one scene: tests a ray, microseconds a ray at the low and the high rate.
struct PrintedRow {
  std::string_view name;
  std::array<double, 3> standard, premeshed;
};
[[nodiscard]] std::span<const PrintedRow> printed_table1();

/// The printed numbers that belong to our scene: office the standard one, office-fine the premeshed one,
/// whatever their size. Nothing for others.
[[nodiscard]] const std::array<double, 3>* printed_for(const ListFigures& row);

/// The row of that scene and name; nullptr when there is none.
[[nodiscard]] const ListFigures* find_row(std::span<const ListFigures> rows, std::string_view scene,
                                          std::string_view name);

/// What the paper's text says beside its table, ours and printed.
struct TextFigure {
  std::string what, ours, printed;
  std::string direction;  ///< "same", "opposite", or empty where there is none
};
[[nodiscard]] std::vector<TextFigure> text_figures(std::span<const ListFigures> rows, std::string_view scene);

/// A row of Table 1 beside the printed one: ours over our baseline, printed over the printed baseline.
struct Table1Cell {
  double value = 0, ratio = 1;
  std::optional<double> printed, printed_ratio;
  std::string direction;
};
/// Tests, low time, high time.
[[nodiscard]] std::array<Table1Cell, 3> table1_cells(std::span<const ListFigures> rows,
                                                     const ListFigures& row);

/// The rays a shaft from which on a list pays, at a rate: its building over what it saves a ray. Nothing
/// where it saves none.
[[nodiscard]] std::optional<double> break_even(const ListFigures& baseline, const ListFigures& row,
                                               std::size_t rate);

/// Both tables and what the text says, for each scene; empty without rows.
[[nodiscard]] std::string lists_text(std::span<const ListFigures> rows);

}  // namespace gnomon::reports
