// SPDX-License-Identifier: MIT
#include "fast/shaft_cull.h"

#include <cmath>

#include "fast/box_relation.h"
#include "fast/certified_shaft.h"

namespace gnomon::fast {

using scene::Category;

namespace {

Shaft<float> formed(const ListOptions& options, Volumes volumes, const scene::Box<float>& a,
                    const scene::Box<float>& b) {
  if (options.arithmetic == Arithmetic::naive)
    return form_shaft(a, b, volumes == Volumes::boxes ? Normals::as_formed : Normals::unit);
  return volumes == Volumes::boxes ? form_certified_box_shaft(a, b) : form_certified_ball_shaft(a, b);
}

/// Sorts the planes by what they cut off, the most first, and leaves out the weak ones.
void choose_planes(const ListOptions& options, Shaft<float>& shaft) {
  if (!options.sort_planes && !(options.weak_planes > 0)) return;
  struct Share {
    float share;
    std::uint8_t plane;
  };
  std::array<Share, 8> shares{};
  std::uint8_t kept = 0;
  for (std::uint8_t i = 0; i < shaft.plane_count; ++i) {
    const float share = share_cut_off(shaft, shaft.plane_set[i]);
    if (share < options.weak_planes) continue;
    std::uint8_t place = kept++;
    for (; options.sort_planes && place > 0 && shares[place - 1U].share < share; --place)
      shares[place] = shares[place - 1U];
    shares[place] = {share, i};
  }
  const auto all = shaft.plane_set;
  for (std::uint8_t i = 0; i < kept; ++i) shaft.plane_set[i] = all[shares[i].plane];
  shaft.plane_count = kept;
}

}  // namespace

float share_cut_off(const Shaft<float>& shaft, const ShaftPlane<float>& plane) {
  // On the two axes of the plane the extent box is a rectangle, and the plane's edges on `a` and `b` lie on
  // two of its sides that meet in the culled edge: what is cut off is a triangle with that corner.
  const auto leg = [&](Face along) {
    const int axis = axis_of(along);
    return std::fabs(0.5F * shaft.a.c[along] - 0.5F * shaft.b.c[along]) /
           (0.5F * shaft.extent.hi(axis) - 0.5F * shaft.extent.lo(axis));
  };
  return 0.5F * leg(plane.far0) * leg(plane.far1);
}

scene::Box<float> shrunk(const scene::Box<float>& box, float share) {
  scene::Box<float> result = box;
  for (int axis = 0; axis < 3; ++axis) {
    const float by = share * (box.hi(axis) - box.lo(axis));
    const float lo = box.lo(axis) + by, hi = box.hi(axis) - by;
    if (lo <= hi) {  // also false where the size overflows
      result.lo(axis) = lo;
      result.hi(axis) = hi;
    }
  }
  return result;
}

void ShaftCull::form(const ItemTree& tree, const ListOptions& options, const scene::Box<float>& emitter,
                     const scene::Box<float>& receiver) {
  shaft_ = formed(options, tree.volumes(), emitter, receiver);
  choose_planes(options, shaft_);
  has_narrow_ = options.adjacency > 0;
  if (has_narrow_) {
    narrow_ = formed(options, tree.volumes(), emitter, shrunk(receiver, options.adjacency));
    choose_planes(options, narrow_);
  }
  front_count_ = 0;
}

Category ShaftCull::classify_box(const Shaft<float>& shaft, const scene::Box<float>& box, bool meets_emitter,
                                 bool want_inside, CullCounters& counters) const {
  if (!meets_emitter) {
    const auto apart = [&](const scene::Box<float>& other) {
      ++counters.comparisons;
      return !meets(box, other);
    };
    if (apart(shaft.extent)) return Category::outside;
    // What meets a reference box can't be outside (claim S10); comparisons alone tell.
    if (apart(shaft.a) && apart(shaft.b)) {
      for (const ShaftPlane<float>& plane : shaft.planes()) {
        ++counters.planes;
        if (plane.near_value(box) > plane.outside_threshold) return Category::outside;
      }
    }
  }
  if (!want_inside) return Category::overlap;
  ++counters.comparisons;
  if (!contains(shaft.extent, box)) return Category::overlap;
  for (const ShaftPlane<float>& plane : shaft.planes()) {
    ++counters.planes;
    if (!(plane.far_value(box) <= plane.inside_threshold)) return Category::overlap;
  }
  return Category::inside;
}

Category ShaftCull::classify_ball(const Shaft<float>& shaft, const scene::Ball<float>& ball,
                                  bool meets_emitter, bool want_inside, CullCounters& counters) const {
  const BallSlack<float>& slack = shaft.slack;
  const float square = ball.radius * ball.radius;
  const auto apart = [&](const scene::Box<float>& box) {
    ++counters.comparisons;
    return squared_distance(ball.centre, box) > square * slack.square_factor + slack.square_offset;
  };
  if (!meets_emitter && apart(shaft.extent)) return Category::outside;
  if (!(ball.radius <= slack.largest_radius)) return Category::overlap;
  // With the certified slack a ball just beside a reference box counts as meeting it, which keeps it.
  if (!meets_emitter) meets_emitter = !apart(shaft.a) || !apart(shaft.b);

  bool inside = want_inside;
  counters.comparisons += want_inside ? 1 : 0;
  for (int axis = 0; axis < 3 && inside; ++axis) {
    const float x = ball.centre[static_cast<std::size_t>(axis)], reach = ball.radius * slack.inside_factor;
    inside = x - shaft.extent.lo(axis) >= reach && shaft.extent.hi(axis) - x >= reach;
  }
  if (meets_emitter && !inside) return Category::overlap;
  for (const ShaftPlane<float>& plane : shaft.planes()) {
    ++counters.planes;
    const float value = plane.value_at(ball.centre);
    if (!meets_emitter && value > ball.radius + plane.outside_threshold) return Category::outside;
    inside = inside && value <= plane.inside_threshold - ball.radius;
  }
  return inside ? Category::inside : Category::overlap;
}

Category ShaftCull::classify(const ItemTree& tree, std::uint32_t i, bool meets_emitter, bool want_inside,
                             CullCounters& counters) const {
  ++counters.volumes;
  const Item& item = tree.item(i);
  for (std::uint32_t k = 0; k < front_count_; ++k) {
    ++counters.planes;
    if (fronts_[k].none_in_front(item.box)) return Category::outside;
  }
  const Shaft<float>& shaft = has_narrow_ && item.is_primitive() ? narrow_ : shaft_;
  const Category category = tree.volumes() == Volumes::boxes
                                ? classify_box(shaft, item.box, meets_emitter, want_inside, counters)
                                : classify_ball(shaft, tree.ball(i), meets_emitter, want_inside, counters);
  if (category != Category::inside) return category;
  for (std::uint32_t k = 0; k < front_count_; ++k) {
    ++counters.planes;
    if (!fronts_[k].none_behind(item.box)) return Category::overlap;
  }
  return Category::inside;
}

}  // namespace gnomon::fast
