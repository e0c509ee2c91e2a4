// SPDX-License-Identifier: MIT
#include "fast/radiosity_caster.h"

#include <algorithm>

#include "fast/tree_sketch.h"

namespace gnomon::fast {

namespace {

scene::Box<float> box_of(std::span<const std::array<float, 3>> points) {
  scene::Box<float> box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lo, hi] = std::minmax_element(
        points.begin(), points.end(), [&](const auto& p, const auto& q) { return p[axis] < q[axis]; });
    box.c[axis] = (*lo)[axis];
    box.c[axis + 3] = (*hi)[axis];
  }
  return box;
}

}  // namespace

RadiosityCaster::RadiosityCaster(const ItemTree& tree, const scene::Scene& scene, const ListOptions& options,
                                 std::span<const std::uint8_t> convex)
    : tree_(tree), options_(options), builder_(tree, scene, options, convex), caster_(tree) {}

void RadiosityCaster::set_receivers(std::span<const ReceiverSamples> receivers) {
  samples_below_.assign(tree_.size(), 0);
  sample_boxes_.assign(tree_.size(), {});
  for (const ReceiverSamples& receiver : receivers) {
    if (receiver.own.count == 0 || receiver.samples == 0) continue;
    for (std::uint32_t i = tree_.primitive_of(receiver.own.first); i != kNoItem; i = tree_.parent(i)) {
      sample_boxes_[i] = samples_below_[i] == 0 ? receiver.box : box_around(sample_boxes_[i], receiver.box);
      samples_below_[i] += receiver.samples;
    }
  }
}

std::uint32_t RadiosityCaster::shared_volume(const scene::FaceRun& own) const {
  if (options_.super_least == 0 || own.count == 0 || samples_below_.empty()) return kNoItem;
  const std::uint32_t leaf = tree_.primitive_of(own.first);
  std::uint32_t i = leaf;
  while (i != kNoItem && samples_below_[i] < options_.super_least) i = tree_.parent(i);
  return i == leaf || i == kNoItem || samples_below_[i] > options_.super_most ? kNoItem : i;
}

void RadiosityCaster::begin_emitter(const Reference& emitter, std::span<const std::array<float, 3>> points) {
  builder_.begin_emitter(emitter);
  emitter_points_.assign(points.begin(), points.end());
  caster_.clear_cache();
  shared_volume_ = kNoItem;
}

const CandidateList& RadiosityCaster::shared_list(std::uint32_t volume) {
  if (volume != shared_volume_) {
    Reference all;
    all.box = sample_boxes_[volume];
    builder_.build(all, std::uint64_t{samples_below_[volume]} * emitter_points_.size(), shared_list_);
    shared_volume_ = volume;
  }
  return shared_list_;
}

const CandidateList& RadiosityCaster::list_for(const Reference& receiver, std::size_t points,
                                               const Group& group) {
  const std::uint64_t rays = std::uint64_t{points} * emitter_points_.size();
  if (rays < options_.min_rays) return builder_.emitter_list();
  const CandidateList* from = &builder_.emitter_list();
  if (const std::uint32_t volume = shared_volume(receiver.own); volume != kNoItem) {
    from = &shared_list(volume);
    if (!options_.nested) return *from;
  } else if (options_.super_least > points) {
    return *from;
  }
  if (group.is_all || options_.nested) {
    if (!has_receiver_list_) builder_.build(receiver, rays, *from, receiver_list_);
    has_receiver_list_ = true;
    if (group.is_all) return receiver_list_;
    from = &receiver_list_;
  }
  Reference part = receiver;
  part.box = box_of(group.points);
  builder_.build(part, std::uint64_t{group.points.size()} * emitter_points_.size(), *from, group_list_);
  return group_list_;
}

void RadiosityCaster::cast_group(const Reference& receiver, std::size_t points, const Group& group,
                                 std::span<std::uint8_t> blocked) {
  const auto item_of = [&](const scene::FaceRun& run) {
    return run.count > 0 ? tree_.primitive_of(run.first) : kNoItem;
  };
  const std::uint32_t own_from = item_of(receiver.own), own_to = item_of(builder_.emitter().own);
  const CandidateList* list = options_.wait_for_miss ? nullptr : &list_for(receiver, points, group);
  std::size_t ray = 0;
  for (const auto& point : group.points) {
    for (const auto& light : emitter_points_) {
      const Segment segment(point, light);
      std::uint8_t& answer = blocked[ray++];
      if (options_.shadow_cache && caster_.cached_blocks(segment, own_from, own_to)) {
        answer = 1;
        continue;
      }
      if (list == nullptr) list = &list_for(receiver, points, group);
      const ListCaster::Hit hit = caster_.cast(*list, segment, own_from, own_to);
      answer = hit.primitive != kNoItem ? 1 : 0;
      if (answer != 0) builder_.count_hit(hit.item);
    }
  }
}

void RadiosityCaster::receive(const Reference& receiver, std::span<const std::array<float, 3>> points,
                              std::span<std::uint8_t> blocked) {
  has_receiver_list_ = false;
  const std::size_t lights = emitter_points_.size();
  if (points.empty() || lights == 0) return;
  std::size_t group = points.size();
  if (options_.clump > 0) group = std::clamp<std::size_t>(options_.clump / lights, 1, points.size());
  for (std::size_t first = 0; first < points.size(); first += group) {
    const std::size_t count = std::min(group, points.size() - first);
    cast_group(receiver, points.size(), {points.subspan(first, count), count == points.size()},
               blocked.subspan(first * lights, count * lights));
  }
}

}  // namespace gnomon::fast
