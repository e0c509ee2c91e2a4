// SPDX-License-Identifier: MIT
// The paper's procedure for pairs of an emitter and receivers: shadow cache, list, rays.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <unordered_map>
#include <utility>
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

/// The sample points of a receiver and of its emitter: one ray from every `from` to every `to`. Ray r *
/// to.size() + e goes from point r to point e.
struct PairPoints {
  std::span<const std::array<float, 3>> from, to;

  [[nodiscard]] std::size_t rays() const { return from.size() * to.size(); }
};

enum class RayAnswer : std::uint8_t {
  lit,
  blocked,
  cached,  ///< blocked, by what blocked the last ray: no list was needed
};

/// Which rays of a pair receive() casts. The latter two are for times: of rays alone, and of lists alone.
enum class CastRays : std::uint8_t {
  all,       ///< all that the shadow cache does not answer
  uncached,  ///< all whose answer is given as not `cached`, without asking the cache
  none,      ///< none; makes the lists that `uncached` makes
};

/// Called with a list just made, and the reference items that it was made between.
using OnList = std::function<void(const CandidateList&, const Reference& emitter, const Reference& receiver)>;

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
  /// Has every list from now on shown, but the emitter's; none again with {}.
  void show_lists(OnList on_list) { on_list_ = std::move(on_list); }

  /// Begins with another emitter. The last blocker stays cached.
  void begin_emitter(const Reference& emitter);
  /// Answers rays; leaves `answers` of others alone. One answer for each ray.
  void receive(const Reference& receiver, const PairPoints& points, std::span<RayAnswer> answers,
               CastRays rays = CastRays::all);
  /// Forgets the last blocker.
  void clear_cache() { caster_.clear_cache(); }

  [[nodiscard]] const CastCounters& cast_counters() const { return caster_.counters(); }
  [[nodiscard]] const CullCounters& cull_counters() const { return builder_.counters(); }

 private:
  /// The receiver at work.
  struct Pair {
    const Reference& receiver;
    PairPoints points;
    bool has_list = false;  ///< receiver_list_ is its
  };
  struct Group {
    std::span<const std::array<float, 3>> points;
    bool is_all;
  };

  template <CastRays kRays>
  void cast_pair(Pair pair, std::span<RayAnswer> answers);
  template <CastRays kRays>
  void cast_group(Pair& pair, const Group& group, std::span<RayAnswer> answers);
  [[nodiscard]] const CandidateList& list_for(Pair& pair, const Group& group);
  void build(const Reference& receiver, std::uint64_t rays, const CandidateList& from, CandidateList& list);
  [[nodiscard]] std::uint32_t shared_volume(const scene::FaceRun& own) const;
  [[nodiscard]] const CandidateList& shared_list(std::uint32_t volume, std::size_t emitter_points);

  const ItemTree& tree_;
  ListOptions options_;
  ListBuilder builder_;
  ListCaster caster_;
  OnList on_list_;
  std::vector<std::uint32_t> samples_below_;  ///< of each item; empty: not known
  std::vector<scene::Box<float>> volumes_;    ///< around each item with samples and the boxes of these
  std::deque<CandidateList> shared_lists_;    ///< this emitter's, then used ones to make others in
  std::unordered_map<std::uint32_t, const CandidateList*> shared_list_of_;  ///< of this emitter, by volume
  CandidateList receiver_list_, group_list_;
};

}  // namespace gnomon::fast
