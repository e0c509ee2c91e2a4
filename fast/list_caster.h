// SPDX-License-Identifier: MIT
// Rays against candidate lists (Haines, Wallace: "Candidate List Access").
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fast/candidate_list.h"
#include "fast/item_tree.h"

namespace gnomon::fast {

/// What rays cost, the same on every machine. The paper's tests a ray are boxes + objects, over the rays that
/// the shadow cache did not answer.
struct CastCounters {
  std::uint64_t rays = 0;         ///< cast at a list
  std::uint64_t boxes = 0;        ///< volumes of items (boxes or spheres) tested, primitives' own included
  std::uint64_t objects = 0;      ///< polygons and balls tested
  std::uint64_t blocked = 0;      ///< of `rays`
  std::uint64_t cache_tests = 0;  ///< rays tested against the cached blocker first; each one object test
  std::uint64_t cache_hits = 0;   ///< of those: blocked; these are not among `rays`

  friend bool operator==(const CastCounters&, const CastCounters&) = default;
};

/// A segment from a point to a light, as the usual arithmetic in floats wants it.
struct Segment {
  std::array<float, 3> from{}, to{}, direction{}, inverse{};

  Segment(const std::array<float, 3>& point, const std::array<float, 3>& light) : from(point), to(light) {
    for (std::size_t k = 0; k < 3; ++k) {
      direction[k] = light[k] - point[k];
      inverse[k] = 1 / direction[k];
    }
  }
};

/// Is the segment blocked by a primitive (naive floats: no promise)? A triangle blocks when the line passes
/// through it, edges included, strictly between the ends of the segment; one that the line lies in does not.
/// A ball blocks when the point of the segment nearest to its centre lies in it.
[[nodiscard]] bool blocks(const ItemTree& tree, std::uint32_t primitive, const Segment& segment);

/// Does the segment meet the item's volume (naive floats)? Tests by slabs, or by distance, that are widened
/// by more than their roundings, so that no volume is missed that holds a blocker, but for what overflows.
[[nodiscard]] bool meets_volume(const ItemTree& tree, std::uint32_t item, const Segment& segment);

/// Casts rays of one tree, by stack: an item's volume first, then its children or its primitive. The first
/// blocker found ends a ray. Not for several threads at once; allocates nothing.
class ListCaster {
 public:
  struct Hit {
    std::uint32_t primitive = kNoItem;  ///< what blocks, or kNoItem
    std::uint32_t item = kNoItem;       ///< the item of the list that it was found by
  };

  explicit ListCaster(const ItemTree& tree) : tree_(tree) { stack_.reserve(tree.stack_size()); }
  explicit ListCaster(ItemTree&&) = delete;

  /// The two own primitives (items, or kNoItem) never block.
  [[nodiscard]] Hit cast(const CandidateList& list, const Segment& segment, std::uint32_t own_from,
                         std::uint32_t own_to);
  /// The shadow cache: true when the primitive that blocked the last ray blocks this one too.
  [[nodiscard]] bool cached_blocks(const Segment& segment, std::uint32_t own_from, std::uint32_t own_to);
  /// Forgets the last blocker.
  void clear_cache() { cached_ = kNoItem; }

  [[nodiscard]] const CastCounters& counters() const { return counters_; }

 private:
  const ItemTree& tree_;
  std::vector<std::uint32_t> stack_;
  std::uint32_t cached_ = kNoItem;
  CastCounters counters_;
};

}  // namespace gnomon::fast
