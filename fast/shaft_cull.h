// SPDX-License-Identifier: MIT
// The cull test of a list: items against a shaft and the half-spaces of its polygons.
#pragma once

#include <array>
#include <cstdint>

#include "fast/cull_counters.h"
#include "fast/front_plane.h"
#include "fast/item_tree.h"
#include "fast/list_options.h"
#include "fast/shaft.h"
#include "scene/category.h"

namespace gnomon::fast {

/// A shaft between two boxes as the options want it: naive or certified, for boxes or balls, planes sorted,
/// weak ones left out, cut by half-spaces, and with a smaller second shaft for primitives where there is an
/// adjacency tolerance.
class ShaftCull {
 public:
  /// Both boxes must be valid.
  void form(const ItemTree& tree, const ListOptions& options, const scene::Box<float>& emitter,
            const scene::Box<float>& receiver);
  /// What is not in front of the plane is outside from now on; at most two.
  void cut(const FrontPlane& plane) { fronts_[front_count_++] = plane; }

  /// `meets_emitter`: the item is known not to be outside of the shaft. Inside is told from overlap only
  /// where asked for. Certified: outside is never wrong, unless there is a tolerance; in front means strictly
  /// so, and a half-space of its own tests the item's box, also where volumes are spheres.
  [[nodiscard]] scene::Category classify(const ItemTree& tree, std::uint32_t item, bool meets_emitter,
                                         bool want_inside, CullCounters& counters) const;

 private:
  [[nodiscard]] scene::Category classify_box(const Shaft<float>& shaft, const scene::Box<float>& box,
                                             bool meets_emitter, bool want_inside,
                                             CullCounters& counters) const;
  [[nodiscard]] scene::Category classify_ball(const Shaft<float>& shaft, const scene::Ball<float>& ball,
                                              bool meets_emitter, bool want_inside,
                                              CullCounters& counters) const;

  Shaft<float> shaft_, narrow_;
  bool has_narrow_ = false;
  std::array<FrontPlane, 2> fronts_;
  std::uint32_t front_count_ = 0;
};

/// The share of the extent box's volume that the plane cuts off: half of the product of the shares that its
/// two legs have of the sides, 0 to 1/2.
[[nodiscard]] float share_cut_off(const Shaft<float>& shaft, const ShaftPlane<float>& plane);

/// The box without `share` of its size on each of its sides.
[[nodiscard]] scene::Box<float> shrunk(const scene::Box<float>& box, float share);

}  // namespace gnomon::fast
