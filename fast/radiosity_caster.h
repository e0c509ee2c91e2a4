// SPDX-License-Identifier: MIT
// The paper's procedure for pairs of an emitter and receivers: shadow cache, list, rays.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fast/list_builder.h"
#include "fast/list_caster.h"

namespace gnomon::fast {

/// A receiver to come, for superstructuring: its polygon, how many sample points it has, and their box.
struct ReceiverSamples {
  scene::FaceRun own;
  std::uint32_t samples = 0;
  scene::Box<float> box;
};

/// Casts a ray from every sample point of a receiver to every one of the emitter, by lists as ListOptions
/// say: a ray that the cached blocker stops needs none; the first that it misses has the list made. Which
/// list a ray is cast at:
/// - with fewer rays than min_rays: the emitter list (the baseline, when min_rays is larger than any pair's);
/// - with superstructuring, for a receiver with less than super_least points: the list of the least volume
///   around it with that many, if that has at most super_most, else the emitter list;
/// - with clumps: that of its group of points, made from the receiver's list where `nested`, and there made
///   even where superstructuring has a shared list, from that one;
/// - else the receiver's.
/// Rays are naive floats (fast/list_caster.h). Not for several threads at once.
class RadiosityCaster {
 public:
  /// As ListBuilder.
  RadiosityCaster(const ItemTree& tree, const scene::Scene& scene, const ListOptions& options,
                  std::span<const std::uint8_t> convex = {});
  explicit RadiosityCaster(ItemTree&&, const scene::Scene&, const ListOptions&) = delete;

  /// Says what receivers there are, for superstructuring: those with a polygon of their own. Before
  /// begin_emitter().
  void set_receivers(std::span<const ReceiverSamples> receivers);
  /// The volume whose list the receiver with this polygon shares, or kNoItem. One such list is kept at a
  /// time: receivers are best taken in the order of their volumes.
  [[nodiscard]] std::uint32_t shared_volume(const scene::FaceRun& own) const;

  void begin_emitter(const Reference& emitter, std::span<const std::array<float, 3>> points);
  /// blocked[r * emitter points + e] becomes 1 where the ray from receiver point r to emitter point e is
  /// blocked, else 0; the span must have that size.
  void receive(const Reference& receiver, std::span<const std::array<float, 3>> points,
               std::span<std::uint8_t> blocked);

  [[nodiscard]] const CastCounters& cast_counters() const { return caster_.counters(); }
  [[nodiscard]] const CullCounters& cull_counters() const { return builder_.counters(); }
  [[nodiscard]] const ListBuilder& builder() const { return builder_; }

 private:
  struct Group {
    std::span<const std::array<float, 3>> points;
    bool is_all;
  };

  [[nodiscard]] const CandidateList& list_for(const Reference& receiver, std::size_t points,
                                              const Group& group);
  [[nodiscard]] const CandidateList& shared_list(std::uint32_t volume);
  void cast_group(const Reference& receiver, std::size_t points, const Group& group,
                  std::span<std::uint8_t> blocked);

  const ItemTree& tree_;
  ListOptions options_;
  ListBuilder builder_;
  ListCaster caster_;
  std::vector<std::array<float, 3>> emitter_points_;
  std::vector<std::uint32_t> samples_below_;     ///< of each item; empty: not known
  std::vector<scene::Box<float>> sample_boxes_;  ///< around them
  CandidateList shared_list_, receiver_list_, group_list_;
  std::uint32_t shared_volume_ = kNoItem;
  bool has_receiver_list_ = false;
};

}  // namespace gnomon::fast
