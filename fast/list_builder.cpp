// SPDX-License-Identifier: MIT
#include "fast/list_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/box_relation.h"
#include "fast/tree_sketch.h"

namespace gnomon::fast {

using scene::Category;

ListBuilder::ListBuilder(const ItemTree& tree, const scene::Scene& scene, const ListOptions& options,
                         std::span<const std::uint8_t> convex)
    : tree_(tree), options_(options), hits_(options.sorting == Sorting::hits ? tree.size() : 0, 0) {
  root_list_.marks.begin(tree.size());
  if (!tree.empty()) root_list_.items.push_back(0);
  open_.reserve(tree.stack_size());
  if (!options.back_faces) return;
  for (std::size_t o = 0; o < std::min(convex.size(), scene.objects.size()); ++o) {
    const scene::Object& object = scene.objects[o];
    // A single triangle or ball is convex too, but no body with a front side alone.
    if (convex[o] == 0 || !object.one_sided || object.triangle_count < 4 || object.ball_count > 0) continue;
    Solid solid{static_cast<std::uint32_t>(object.first_triangle),
                static_cast<std::uint32_t>(object.triangle_count),
                tree.item(tree.primitive_of(static_cast<std::uint32_t>(object.first_triangle))).box};
    for (std::uint32_t t = 0; t < solid.count; ++t)
      solid.box = box_around(solid.box, tree.item(tree.primitive_of(solid.first + t)).box);
    solids_.push_back(solid);
  }
}

bool ListBuilder::encloses(std::uint32_t i, const scene::Box<float>& box) {
  ++counters_.enclosures;
  if (tree_.volumes() == Volumes::boxes) return contains(tree_.item(i).box, box);
  // Arvo's sum with the farther sides.
  const scene::Ball<float>& ball = tree_.ball(i);
  float sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float x = ball.centre[static_cast<std::size_t>(axis)];
    const float far = std::max(std::fabs(x - box.lo(axis)), std::fabs(x - box.hi(axis)));
    sum += far * far;
  }
  return sum <= ball.radius * ball.radius;
}

void ListBuilder::collect_emitter_items(std::uint32_t start) {
  open_.clear();
  open_.push_back({start, false, {}});
  while (!open_.empty()) {
    const std::uint32_t i = open_.back().item;
    open_.pop_back();
    const Item& item = tree_.item(i);
    if (is_own(i)) continue;
    ++counters_.emitter_volumes;
    if (options_.behind_emitter && emitter_front_ && emitter_front_->none_in_front(item.box)) continue;
    if (!item.is_primitive() && encloses(i, emitter_.box)) {
      for (std::uint32_t k = item.count(); k-- > 0;) open_.push_back({item.first + k, false, {}});
      continue;
    }
    emitter_list_.items.push_back(i);
    if (options_.emitter_overlap) {
      const bool overlaps = tree_.volumes() == Volumes::boxes
                                ? meets(item.box, emitter_.box)
                                : squared_distance(tree_.ball(i).centre, emitter_.box) <=
                                      tree_.ball(i).radius * tree_.ball(i).radius;
      emitter_list_.meets_emitter.push_back(overlaps ? 1 : 0);
    }
  }
}

void ListBuilder::climb_from_emitter(std::uint32_t own) {
  for (std::uint32_t below = own; tree_.parent(below) != kNoItem; below = tree_.parent(below)) {
    const Item& parent = tree_.item(tree_.parent(below));
    for (std::uint32_t k = 0; k < parent.count(); ++k) {
      if (parent.first + k != below) collect_emitter_items(parent.first + k);
    }
  }
}

bool ListBuilder::is_outside(const Solid& solid) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (emitter_.box.hi(axis) < solid.box.lo(axis) || emitter_.box.lo(axis) > solid.box.hi(axis)) return true;
  }
  for (std::uint32_t t = 0; t < solid.count; ++t) {
    const FrontPlane plane =
        form_front_plane(tree_.triangle(solid.first + t), emitter_.box, options_.arithmetic);
    if (plane.all_in_front(emitter_.box)) return true;
  }
  return false;
}

// A ray between points that are not in the inside of a closed convex body and meets it does so first, as seen
// from the emitter, at a face whose front the emitter's point sees: at an edge or in the plane of a face, at
// one of the neighbours. That face is not among those that have all of the emitter's box behind them or in
// their plane. A receiver's point on the body, in front of whose polygon the emitter's points lie, is met by
// no ray that also meets the body elsewhere. The emitter's box must keep off the body altogether: from its
// inside, and from points of its boundary, where the body stands on the emitter, rays leave it by faces that
// the box lies behind, and by no other.
void ListBuilder::mark_back_faces() {
  for (const Solid& solid : solids_) {
    if (!is_outside(solid)) continue;
    for (std::uint32_t t = 0; t < solid.count;) {
      const std::uint32_t i = tree_.primitive_of(solid.first + t);
      ++counters_.back_faces;
      const FrontPlane plane =
          form_front_plane(tree_.triangle(solid.first + t), emitter_.box, options_.arithmetic);
      if (plane.none_in_front(emitter_.box)) emitter_list_.marks.mark(i);
      t += tree_.item(i).count();
    }
  }
}

void ListBuilder::begin_emitter(const Reference& emitter) {
  emitter_ = emitter;
  emitter_list_.items.clear();
  emitter_list_.meets_emitter.clear();
  emitter_list_.marks.begin(tree_.size());
  own_emitter_ = emitter.own.count > 0 ? tree_.primitive_of(emitter.own.first) : kNoItem;
  own_receiver_ = kNoItem;
  std::fill(hits_.begin(), hits_.end(), 0);
  emitter_front_.reset();
  if (tree_.empty()) return;
  if (emitter.front && (options_.behind_emitter || options_.patch_planes))
    emitter_front_ = form_front_plane(*emitter.front, tree_.item(0).box, options_.arithmetic);
  mark_back_faces();
  if (!options_.emitter_list) {
    emitter_list_.items.push_back(0);
  } else if (own_emitter_ != kNoItem) {
    climb_from_emitter(own_emitter_);
  } else {
    collect_emitter_items(0);
  }
}

void ListBuilder::build(const Reference& receiver, std::uint64_t rays, const CandidateList& from,
                        CandidateList& list) {
  ++counters_.lists;
  list.items.clear();
  list.meets_emitter.clear();
  list.marks.begin(tree_.size());
  list.parent = &from;
  if (tree_.empty()) return;
  own_receiver_ = receiver.own.count > 0 ? tree_.primitive_of(receiver.own.first) : kNoItem;
  const Strategy strategy = rays < options_.open_from_rays ? Strategy::keep_closed : options_.strategy;
  cull_.form(tree_, options_, emitter_.box, receiver.box);
  // With an emitter list, what lies behind the emitter is gone already, but for what is below its items.
  if (emitter_front_ && (options_.patch_planes || !options_.emitter_list)) cull_.cut(*emitter_front_);
  if (options_.patch_planes && receiver.front)
    cull_.cut(form_front_plane(*receiver.front, tree_.item(0).box, options_.arithmetic));
  for (std::size_t k = 0; k < from.items.size(); ++k) {
    const bool meets_emitter = !from.meets_emitter.empty() && from.meets_emitter[k] != 0;
    walk({from.items[k], meets_emitter, {}}, strategy, receiver.box, list);
  }
  if (options_.sorting != Sorting::none) sort(receiver.box, list);
  counters_.items += list.items.size();
}

/// True when the volume is to stay closed; its children are left in children_ with their categories, in any
/// case without those that were marked before.
bool ListBuilder::keeps_by_ratio(const Item& item, CandidateList& list) {
  children_.clear();
  std::uint32_t met = 0;
  for (std::uint32_t k = 0; k < item.count(); ++k) {
    const std::uint32_t child = item.first + k;
    if (is_own(child) || list.is_marked(child)) continue;
    const Category category =
        cull_.classify(tree_, child, false, !tree_.item(child).is_primitive(), counters_);
    met += category != Category::outside ? 1 : 0;
    children_.push_back({child, false, category});
  }
  if (met == 0 || (met == 1 && options_.discard_single)) return false;
  return static_cast<float>(met) > options_.ratio * static_cast<float>(item.count());
}

void ListBuilder::walk(const Open& start, Strategy strategy, const scene::Box<float>& receiver,
                       CandidateList& list) {
  const bool want_inside = strategy == Strategy::overlap_open || strategy == Strategy::ratio_open;
  open_.clear();
  open_.push_back(start);
  while (!open_.empty()) {
    const Open now = open_.back();
    open_.pop_back();
    if (is_own(now.item) || list.is_marked(now.item)) continue;
    const Item& item = tree_.item(now.item);
    const Category category = now.category ? *now.category
                                           : cull_.classify(tree_, now.item, now.meets_emitter,
                                                            want_inside && !item.is_primitive(), counters_);
    if (category == Category::outside) continue;
    if (item.is_primitive()) {
      list.items.push_back(now.item);
      continue;
    }
    const bool must_open =
        options_.enclosure &&
        (encloses(now.item, receiver) || (!options_.emitter_list && encloses(now.item, emitter_.box)));
    if (!must_open) {
      if (strategy == Strategy::keep_closed || (want_inside && category == Category::inside)) {
        list.items.push_back(now.item);
        continue;
      }
      if (strategy == Strategy::ratio_open) {
        const bool keeps = keeps_by_ratio(item, list);
        if (keeps) list.items.push_back(now.item);
        for (auto child = children_.rbegin(); child != children_.rend(); ++child) {
          if (!keeps) {
            open_.push_back(*child);
          } else if (options_.mailbox && child->category == Category::outside) {
            list.marks.mark(child->item);
            ++counters_.marks;
          }
        }
        continue;
      }
    }
    for (std::uint32_t k = item.count(); k-- > 0;) open_.push_back({item.first + k, false, {}});
  }
}

void ListBuilder::sort(const scene::Box<float>& receiver, CandidateList& list) {
  keys_.clear();
  for (const std::uint32_t i : list.items) {
    const scene::Box<float>& box = tree_.item(i).box;
    double squared = 0;  // four times the squared distance of the middles
    for (int axis = 0; axis < 3; ++axis) {
      const double apart = static_cast<double>(box.lo(axis)) + static_cast<double>(box.hi(axis)) -
                           static_cast<double>(receiver.lo(axis)) - static_cast<double>(receiver.hi(axis));
      squared += apart * apart;
    }
    double key = squared;
    if (options_.sorting == Sorting::solid_angle)
      key = squared > 0 ? -half_surface(box) / squared : -std::numeric_limits<double>::infinity();
    if (options_.sorting == Sorting::hits) key = -static_cast<double>(hits_[i]);
    keys_.emplace_back(key, static_cast<std::uint32_t>(keys_.size()));
  }
  // Ties stay as found: the second of a pair is the place.
  std::sort(keys_.begin(), keys_.end());
  for (auto& [key, place] : keys_) place = list.items[place];
  for (std::size_t k = 0; k < keys_.size(); ++k) list.items[k] = keys_[k].second;
}

}  // namespace gnomon::fast
