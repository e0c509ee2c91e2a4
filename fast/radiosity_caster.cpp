// SPDX-License-Identifier: MIT
#include "fast/radiosity_caster.h"

#include <algorithm>

#include "fast/box_around.h"

namespace gnomon::fast {

RadiosityCaster::RadiosityCaster(const ItemTree& tree, const scene::Scene& scene, const ListOptions& options,
                                 std::span<const std::uint8_t> convex)
    : tree_(tree), options_(options), builder_(tree, scene, options, convex), caster_(tree) {}

void RadiosityCaster::set_receivers(std::span<const ReceiverSamples> receivers) {
  samples_below_.assign(tree_.size(), 0);
  volumes_.resize(tree_.size());
  for (const ReceiverSamples& receiver : receivers) {
    if (receiver.own.count == 0 || receiver.samples == 0) continue;
    for (std::uint32_t i = tree_.primitive_of(receiver.own.first); i != kNoItem; i = tree_.parent(i)) {
      // Points may lie an ulp or so beside their polygon, and it beside the volume.
      volumes_[i] = box_around(samples_below_[i] == 0 ? tree_.item(i).box : volumes_[i], receiver.box);
      samples_below_[i] += receiver.samples;
    }
  }
}

/// The volume whose list the receiver with this polygon shares, or kNoItem.
std::uint32_t RadiosityCaster::shared_volume(const scene::FaceRun& own) const {
  if (options_.super_least == 0 || own.count == 0 || samples_below_.empty()) return kNoItem;
  const std::uint32_t leaf = tree_.primitive_of(own.first);
  std::uint32_t i = leaf;
  while (i != kNoItem && samples_below_[i] < options_.super_least) i = tree_.parent(i);
  return i == leaf || i == kNoItem || samples_below_[i] > options_.super_most ? kNoItem : i;
}

void RadiosityCaster::begin_emitter(const Reference& emitter) {
  builder_.begin_emitter(emitter);
  shared_list_of_.clear();
}

void RadiosityCaster::build(const Reference& receiver, std::uint64_t rays, const CandidateList& from,
                            CandidateList& list) {
  builder_.build(receiver, rays, from, list);
  if (on_list_) on_list_(list, builder_.emitter(), receiver);
}

const CandidateList& RadiosityCaster::shared_list(std::uint32_t volume, std::size_t emitter_points) {
  const auto [known, is_new] = shared_list_of_.try_emplace(volume);
  if (is_new) {
    if (shared_lists_.size() < shared_list_of_.size()) shared_lists_.emplace_back();
    CandidateList& list = shared_lists_[shared_list_of_.size() - 1];
    Reference all;
    all.box = volumes_[volume];
    build(all, std::uint64_t{samples_below_[volume]} * emitter_points, builder_.emitter_list(), list);
    known->second = &list;
  }
  return *known->second;
}

const CandidateList& RadiosityCaster::list_for(Pair& pair, const Group& group) {
  const Reference& receiver = pair.receiver;
  if (pair.points.rays() < options_.min_rays) return builder_.emitter_list();
  const CandidateList* from = &builder_.emitter_list();
  if (const std::uint32_t volume = shared_volume(receiver.own); volume != kNoItem) {
    from = &shared_list(volume, pair.points.to.size());
    if (!options_.nested) return *from;
  } else if (options_.super_least > pair.points.from.size()) {
    return *from;
  }
  if (group.is_all || options_.nested) {
    if (!pair.has_list) build(receiver, pair.points.rays(), *from, receiver_list_);
    pair.has_list = true;
    if (group.is_all) return receiver_list_;
    from = &receiver_list_;
  }
  Reference part = receiver;
  part.box = box_of(group.points);
  build(part, std::uint64_t{group.points.size()} * pair.points.to.size(), *from, group_list_);
  return group_list_;
}

template <CastRays kRays>
void RadiosityCaster::cast_group(Pair& pair, const Group& group, std::span<RayAnswer> answers) {
  const CandidateList* list = options_.wait_for_miss ? nullptr : &list_for(pair, group);
  if constexpr (kRays == CastRays::none) {
    const auto misses = [](RayAnswer answer) { return answer != RayAnswer::cached; };
    if (list == nullptr && std::any_of(answers.begin(), answers.end(), misses)) (void)list_for(pair, group);
    return;
  }
  const auto item_of = [&](const scene::FaceRun& run) {
    return run.count > 0 ? tree_.primitive_of(run.first) : kNoItem;
  };
  const std::uint32_t own_from = item_of(pair.receiver.own), own_to = item_of(builder_.emitter().own);
  auto answer = answers.begin();
  for (const auto& point : group.points) {
    for (auto light = pair.points.to.begin(); light != pair.points.to.end(); ++light, ++answer) {
      if (kRays == CastRays::uncached && *answer == RayAnswer::cached) continue;
      const Segment segment(point, *light);
      if (kRays == CastRays::all && options_.shadow_cache &&
          caster_.cached_blocks(segment, own_from, own_to)) {
        *answer = RayAnswer::cached;
        continue;
      }
      if (list == nullptr) list = &list_for(pair, group);
      const ListCaster::Hit hit = caster_.cast(*list, segment, own_from, own_to);
      *answer = hit.primitive != kNoItem ? RayAnswer::blocked : RayAnswer::lit;
      if (hit.item != kNoItem) builder_.count_hit(hit.item);
    }
  }
}

template <CastRays kRays>
void RadiosityCaster::cast_pair(Pair pair, std::span<RayAnswer> answers) {
  const auto [from, to] = pair.points;
  if (from.empty() || to.empty()) return;
  std::size_t group = from.size();
  if (options_.clump > 0) group = std::clamp<std::size_t>(options_.clump / to.size(), 1, from.size());
  for (std::size_t first = 0; first < from.size(); first += group) {
    const std::size_t count = std::min(group, from.size() - first);
    cast_group<kRays>(pair, {from.subspan(first, count), count == from.size()},
                      answers.subspan(first * to.size(), count * to.size()));
  }
}

void RadiosityCaster::receive(const Reference& receiver, const PairPoints& points,
                              std::span<RayAnswer> answers, CastRays rays) {
  const Pair pair{receiver, points};
  switch (rays) {
    case CastRays::all:
      return cast_pair<CastRays::all>(pair, answers);
    case CastRays::uncached:
      return cast_pair<CastRays::uncached>(pair, answers);
    case CastRays::none:
      return cast_pair<CastRays::none>(pair, answers);
  }
}

}  // namespace gnomon::fast
