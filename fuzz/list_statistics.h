// SPDX-License-Identifier: GPL-3.0-or-later
// Candidate lists on progressive radiosity, counted and timed: Haines and Wallace, "Statistics".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fast/cull_counters.h"
#include "fast/list_caster.h"
#include "fuzz/list_options_text.h"
#include "fuzz/spread.h"
#include "scene/scene.h"

namespace gnomon::fuzz {

/// Where rays start.
enum class ListStart : std::uint8_t {
  root,          ///< at the hierarchy's root
  emitter_list,  ///< at the items of the emitter list: the paper's baseline
  lists,         ///< at a list for each pair
};

/// One way to cast the rays: a row of the tables.
struct ListSpec {
  std::string name;
  ListStart start = ListStart::lists;
  ListSetup setup;
  /// Shafts between the boxes of the sample points, not of the whole patches.
  bool tight_boxes = false;
};

/// The rows of the paper's Table 1, in its order: baseline, keep closed, always open, overlap open, ratio
/// open at 0.2, 0.4, 0.6 and 0.8.
[[nodiscard]] std::vector<ListSpec> table1_specs();

/// What its text measures besides: the shadow cache alone, from the root; ratio open without mailbox marks at
/// 0.2, 0.6 and 0.8.
[[nodiscard]] std::vector<ListSpec> text_specs();

/// And from the root without the shadow cache: at the low rate alone.
[[nodiscard]] ListSpec uncached_spec();

/// The paper's method by its defaults, then every option by itself; asked at the low rate alone.
[[nodiscard]] std::vector<ListSpec> option_specs();

/// Counts of one row at one sampling rate. All rays face.
struct ListCounts {
  std::uint64_t pairs = 0;                          ///< that face each other
  std::uint64_t rays = 0;                           ///< of theirs
  std::uint64_t shadowed = 0;                       ///< of these, exactly
  fast::CastCounters cast;                          ///< cast.rays are the uncached ones
  fast::CullCounters cull;                          ///< cull.lists: shafts formed
  std::uint64_t false_lit = 0, false_shadowed = 0;  ///< wrong answers
  /// Lists held against the exact candidates: how many, of these those that lack a face that can block, which
  /// is one that meets the shaft exactly, reaches in front of both patches and, with back_faces, is no back
  /// face of a convex body; faces on them, and of these those that don't meet the shaft.
  std::uint64_t checked = 0, lacking = 0, checked_faces = 0, excess_faces = 0;
  /// Volumes on lists, of two items or more, that the paper calls complex boxes, and the primitives below
  /// them.
  std::uint64_t volumes = 0, below_volumes = 0;
};

/// Times of one row at one rate, in nanoseconds of processor time.
struct ListTimes {
  Spread ray;   ///< an uncached ray, with the building of lists
  Spread list;  ///< building alone, a list; 0 without any
};

/// One row, at the low rate of 1 sample of an emitter and the high one of 4.
struct ListRow {
  std::string scene;
  std::string table;  ///< "table1", "text", "options", "own"
  ListSpec spec;
  std::size_t rates = 2;  ///< 1: at the low rate alone
  std::array<ListCounts, 2> counts;
  std::array<ListTimes, 2> times;
};

struct ListMeasureOptions {
  std::vector<ListSpec> own;        ///< more rows
  unsigned rounds = 3;              ///< timed
  std::size_t checked_lists = 200;  ///< a row and rate, about, evenly chosen; pairs with several lists: more
  std::size_t steps = 20;           ///< of progressive radiosity: the paper's
};

/// Casts the rays of progressive radiosity's steps in every way, holds every answer against the truth,
/// and times the ways in turn. `scene` has floats alone. Nothing for a scene in which no patches face each
/// other.
[[nodiscard]] std::vector<ListRow> measure_lists(const std::string& name, const scene::Scene& scene,
                                                 const ListMeasureOptions& options,
                                                 const std::function<void(double done)>& on_progress);

}  // namespace gnomon::fuzz
