// SPDX-License-Identifier: MIT
// How candidate lists are made and used: every choice of Haines and Wallace, each on its own.
#pragma once

#include <cstdint>

#include "fast/strict_float.h"

namespace gnomon::fast {

/// What is done with a bounding volume that the shaft meets ("Creating the Candidate List").
enum class Strategy : std::uint8_t {
  keep_closed,   ///< it goes on the list
  always_open,   ///< it is opened, even when it lies inside: the list has primitives only
  overlap_open,  ///< it goes on the list when it lies inside, and is opened when it overlaps
  ratio_open,    ///< as overlap_open, but kept closed when more than a share of its children meet the shaft
};

/// The order of a list ("Future Work": candidate list sorting).
enum class Sorting : std::uint8_t {
  none,         ///< as found
  solid_angle,  ///< the largest first: surface over squared distance from the middle of the receiver's box
  nearest,      ///< the nearest first: distance of the middles of the item's and the receiver's box
  hits,         ///< the item first through which most rays of this emitter were found blocked so far
};

/// The arithmetic of the cull tests.
enum class Arithmetic : std::uint8_t {
  naive,      ///< the paper's formulas in floats: lists may lose what meets the shaft
  certified,  ///< the same with proved thresholds: nothing is lost
};

/// The defaults are the paper's method as it was measured; what "Future Work" adds is off.
struct ListOptions {
  Strategy strategy = Strategy::ratio_open;
  /// Of ratio_open, 0 to 1: kept closed when more than this share of the children meet the shaft. Printed:
  /// 0.2 to 0.8.
  float ratio = 0.4F;
  /// Of ratio_open: a volume with a single child that meets the shaft is opened whatever the ratio.
  bool discard_single = true;
  bool enclosure = true;  ///< a volume that encloses a reference box is always opened
  bool emitter_list =
      true;  ///< shafts start from the list of what does not enclose the emitter, not the root
  /// Items of the emitter list that meet the emitter's box are not tested against the shaft's outside.
  bool emitter_overlap = true;
  bool behind_emitter = true;  ///< what lies behind a one-sided emitter is left out
  /// Faces of solids that face away from all of the emitter's box are left out, of objects that the caller
  /// vouches for. Changes nothing for rays between points in front of each other's polygons (claim S21): also
  /// not on the solid that the receiver belongs to. Solids whose inside the emitter's box may reach keep all.
  bool back_faces = false;
  bool mailbox = true;        ///< of ratio_open: children found outside are marked, and passed over by rays
  bool shadow_cache = true;   ///< what blocked the last ray is tested first
  bool wait_for_miss = true;  ///< no list is made before a ray of the pair misses the shadow cache
  /// Pairs with fewer rays than this go without a list of their own; the paper thinks 10 the break-even. 0:
  /// none.
  std::uint32_t min_rays = 0;
  /// The share of the receiver's box that is taken off each of its sides where primitives are held against
  /// the shaft, 0 to below 0.5: culls what only touches the receiver. Loses blockers near its rim (claim
  /// S22), in any arithmetic. 0: off.
  float adjacency = 0;

  /// Of "Future Work". A receiver's points are taken in groups, each with a shaft of its own, of as many
  /// points as make at most this many rays (but at least one point). 0: all in one.
  std::uint32_t clump = 0;
  bool nested = false;  ///< groups start from the receiver's list instead of the emitter's
  /// A list is made for the least volume around the receiver that has at least `super_least` sample points of
  /// receivers below it, if it has at most `super_most`, and shared by all of them. 0 (least): off.
  std::uint32_t super_least = 0, super_most = 0;
  Sorting sorting = Sorting::none;
  bool sort_planes = false;  ///< planes that cut more off the extent box are tested first
  /// Planes that cut off less than this share of the extent box's volume are left out. 0: none.
  float weak_planes = 0;
  /// With fewer rays than this the strategy is keep_closed, whatever it is else. 0: never.
  std::uint32_t open_from_rays = 0;
  /// The planes of the emitter's and the receiver's polygon bound the shaft too.
  bool patch_planes = false;
  Arithmetic arithmetic = Arithmetic::naive;

  friend bool operator==(const ListOptions&, const ListOptions&) = default;
};

}  // namespace gnomon::fast
