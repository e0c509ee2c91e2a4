// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/list_runner.h"

#include <algorithm>
#include <ctime>

namespace gnomon::fuzz {
namespace {

using fast::CandidateList;
using fast::ListCaster;
using fast::Reference;
using fast::Segment;

FloatPoint to_float_point(const Vector3& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

scene::Box<float> box_of(std::span<const FloatPoint> points) {
  scene::Box<float> box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.c[axis] = box.c[axis + 3] = points.front()[axis];
    for (const FloatPoint& point : points) {
      box.c[axis] = std::min(box.c[axis], point[axis]);
      box.c[axis + 3] = std::max(box.c[axis + 3], point[axis]);
    }
  }
  return box;
}

scene::Box<float> box_around(const scene::Box<float>& a, const scene::Box<float>& b) {
  scene::Box<float> box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.c[axis] = std::min(a.c[axis], b.c[axis]);
    box.c[axis + 3] = std::max(a.c[axis + 3], b.c[axis + 3]);
  }
  return box;
}

Reference reference_of(const PatchSamples& samples) {
  Reference reference{scene::converted<float>(samples.box), samples.own, {}};
  reference.front = {to_float_point(samples.plane[0]), to_float_point(samples.plane[1]),
                     to_float_point(samples.plane[2])};
  return reference;
}

std::vector<FloatPoint> float_points(const PatchSamples& samples) {
  std::vector<FloatPoint> points;
  for (const Vector3& point : samples.points) points.push_back(to_float_point(point));
  return points;
}

/// Asks the shadow cache first, and holds answers against the truth.
struct CountedRays {
  ListCaster& caster;
  bool cache;
  std::vector<std::uint8_t>& uncached;
  ListCounts& counts;
  static constexpr bool kCast = true;

  bool take(const Segment& segment, std::uint32_t own_from, std::uint32_t own_to, bool hidden) {
    ++counts.rays;
    counts.shadowed += hidden ? 1 : 0;
    const bool hit = cache && caster.cached_blocks(segment, own_from, own_to);
    uncached.push_back(hit ? 0 : 1);
    if (hit && !hidden) ++counts.false_shadowed;
    return !hit;
  }
  void answer(bool blocked, bool hidden) {
    counts.false_lit += !blocked && hidden ? 1 : 0;
    counts.false_shadowed += blocked && !hidden ? 1 : 0;
  }
};

/// Takes the rays that were uncached.
template <bool kCastRays>
struct TimedRays {
  const std::uint8_t* next;
  std::uint64_t& blocked_rays;
  static constexpr bool kCast = kCastRays;

  bool take() { return *next++ != 0; }
  void answer(bool blocked, bool /*hidden*/) { blocked_rays += blocked ? 1 : 0; }
};

double now_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

}  // namespace

std::vector<ListStep> list_steps_of(const std::vector<RadiosityStep>& steps) {
  std::vector<ListStep> ready;
  for (const RadiosityStep& step : steps) {
    ListStep made;
    for (std::size_t i = 0; i < step.pairs.size(); ++i) {
      const RadiosityPair& pair = step.pairs[i];
      ListPair list{
          reference_of(pair.from), {}, float_points(pair.from), float_points(pair.to), &step.hidden[i]};
      list.tight = list.receiver;
      list.tight.box = box_of(list.from);
      made.pairs.push_back(std::move(list));
      // Samples may miss in pairs that see a part of the emitter; the step's reference holds them all.
      const Reference emitter = reference_of(pair.to);
      const scene::Box<float> tight = box_of(made.pairs.back().to);
      if (i == 0) made.emitter = made.tight = emitter, made.tight.box = tight;
      made.emitter.box = box_around(made.emitter.box, emitter.box);
      made.tight.box = box_around(made.tight.box, tight);
    }
    if (!made.pairs.empty()) ready.push_back(std::move(made));
  }
  return ready;
}

ListRunner::ListRunner(const scene::Scene& scene, const fast::ItemTree& tree, const ListSpec& spec,
                       std::span<const std::uint8_t> convex)
    : tree_(tree), spec_(spec), builder_(tree, scene, spec.setup.options, convex), caster_(tree) {}

ListCounts ListRunner::count(std::span<const ListStep> steps, const OnList& on_list) {
  ListCounts counts;
  uncached_.clear();
  on_list_ = &on_list;
  caster_.clear_cache();
  CountedRays rays{caster_, spec_.setup.options.shadow_cache, uncached_, counts};
  for (const ListStep& step : steps) {
    counts.pairs += step.pairs.size();
    run(step, rays);
  }
  on_list_ = nullptr;
  counts.cast = caster_.counters();
  counts.cull = builder_.counters();
  return counts;
}

double ListRunner::time(std::span<const ListStep> steps, bool cast) {
  TimedRays<true> all{uncached_.data(), blocked_};
  TimedRays<false> none{uncached_.data(), blocked_};
  const double start = now_ns();
  for (const ListStep& step : steps) {
    if (cast) {
      run(step, all);
    } else {
      run(step, none);
    }
  }
  return now_ns() - start;
}

template <class Rays>
void ListRunner::run(const ListStep& step, Rays& rays) {
  builder_.begin_emitter(spec_.tight_boxes ? step.tight : step.emitter);
  whole_of_ = nullptr;
  shared_.clear();
  if (spec_.setup.options.super_least > 0) count_points_below(step);
  for (const ListPair& pair : step.pairs) run_pair(step, pair, rays);
}

template <class Rays>
void ListRunner::run_pair(const ListStep& step, const ListPair& pair, Rays& rays) {
  const fast::ListOptions& options = spec_.setup.options;
  const std::uint32_t own_from = tree_.primitive_of(pair.receiver.own.first);
  const std::uint32_t own_to = tree_.primitive_of(step.emitter.own.first);
  const std::size_t lights = pair.to.size(), points = pair.from.size();
  const CandidateList* given = spec_.start == ListStart::root           ? &builder_.root_list()
                               : spec_.start == ListStart::emitter_list ? &builder_.emitter_list()
                               : points * lights < options.min_rays     ? &builder_.emitter_list()
                                                                        : nullptr;
  const std::size_t group = options.clump == 0 ? points : std::max<std::size_t>(1, options.clump / lights);
  for (std::size_t first = 0; first < points; first += group) {
    const std::size_t last = std::min(points, first + group);
    const CandidateList* list = given;
    if (list == nullptr && !options.wait_for_miss) list = &list_for(pair, first, last);
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t k = 0; k < lights; ++k) {
        const bool hidden = (*pair.hidden)[i * lights + k];
        if constexpr (requires { rays.take(); }) {
          if (!rays.take()) continue;
        }
        const Segment segment(pair.from[i], pair.to[k]);
        if constexpr (!requires { rays.take(); }) {
          if (!rays.take(segment, own_from, own_to, hidden)) continue;
        }
        if (list == nullptr) list = &list_for(pair, first, last);
        if constexpr (Rays::kCast) {
          const ListCaster::Hit hit = caster_.cast(*list, segment, own_from, own_to);
          if (hit.item != fast::kNoItem) builder_.count_hit(hit.item);
          rays.answer(hit.primitive != fast::kNoItem, hidden);
        }
      }
    }
  }
}

const CandidateList& ListRunner::list_for(const ListPair& pair, std::size_t first, std::size_t last) {
  const fast::ListOptions& options = spec_.setup.options;
  if (const CandidateList* const shared = shared_list(pair)) return *shared;
  const Reference& receiver = spec_.tight_boxes ? pair.tight : pair.receiver;
  const std::uint64_t rays = (last - first) * pair.to.size();
  if (last - first == pair.from.size()) {
    builder_.build(receiver, rays, list_);
    report(list_, receiver);
    return list_;
  }
  Reference part = receiver;
  part.box = box_of(std::span(pair.from).subspan(first, last - first));
  if (options.nested) {
    if (whole_of_ != &pair) {
      builder_.build(receiver, pair.from.size() * pair.to.size(), whole_);
      whole_of_ = &pair;
    }
    builder_.build(part, rays, whole_, list_);
  } else {
    builder_.build(part, rays, list_);
  }
  report(list_, part);
  return list_;
}

/// The list of the least volume around the receiver with points enough, if it has not too many.
const CandidateList* ListRunner::shared_list(const ListPair& pair) {
  const fast::ListOptions& options = spec_.setup.options;
  if (options.super_least == 0) return nullptr;
  std::uint32_t item = tree_.primitive_of(pair.receiver.own.first);
  while (item != fast::kNoItem && points_below_[item] < options.super_least) item = tree_.parent(item);
  if (item == fast::kNoItem || points_below_[item] > options.super_most) return nullptr;
  std::unique_ptr<SharedList>& shared = shared_[item];
  if (!shared) {
    shared = std::make_unique<SharedList>();
    shared->volume.box = box_around(tree_.item(item).box, pair.receiver.box);
    builder_.build(shared->volume, points_below_[item] * pair.to.size(), shared->list);
    report(shared->list, shared->volume);
  }
  // Points may lie an ulp or so beside their patch, and it beside the volume.
  return box_around(shared->volume.box, pair.receiver.box) == shared->volume.box ? &shared->list : nullptr;
}

void ListRunner::count_points_below(const ListStep& step) {
  points_below_.assign(tree_.size(), 0);
  for (const ListPair& pair : step.pairs) {
    const auto points = static_cast<std::uint32_t>(pair.from.size());
    for (std::uint32_t item = tree_.primitive_of(pair.receiver.own.first); item != fast::kNoItem;
         item = tree_.parent(item)) {
      points_below_[item] += points;
    }
  }
}

void ListRunner::report(const CandidateList& list, const Reference& receiver) const {
  if (on_list_ != nullptr && *on_list_) (*on_list_)(list, builder_.emitter(), receiver);
}

}  // namespace gnomon::fuzz
