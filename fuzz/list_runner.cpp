// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/list_runner.h"

#include <algorithm>
#include <limits>

#include "fast/box_around.h"
#include "fuzz/thread_time.h"

namespace gnomon::fuzz {
namespace {

using fast::box_around;
using fast::box_of;
using fast::CastRays;
using fast::RayAnswer;
using fast::Reference;

FloatPoint to_float_point(const Vector3& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
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

/// The spec's options; rays that start elsewhere than at a list of their own have too few for one.
fast::ListOptions options_of(const ListSpec& spec) {
  fast::ListOptions options = spec.setup.options;
  if (spec.start != ListStart::lists) options.min_rays = std::numeric_limits<std::uint32_t>::max();
  // Then the root is the emitter list.
  if (spec.start == ListStart::root)
    options.emitter_list = options.behind_emitter = options.back_faces = false;
  return options;
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
    : tight_boxes_(spec.tight_boxes),
      shares_lists_(spec.setup.options.super_least > 0),
      caster_(tree, scene, options_of(spec), convex) {}

void ListRunner::begin(const ListStep& step) {
  if (shares_lists_) {
    receivers_.clear();
    for (const ListPair& pair : step.pairs) {
      const Reference& receiver = receiver_of(pair);
      receivers_.push_back({receiver.own, static_cast<std::uint32_t>(pair.from.size()), receiver.box});
    }
    caster_.set_receivers(receivers_);
  }
  caster_.begin_emitter(tight_boxes_ ? step.tight : step.emitter);
}

ListCounts ListRunner::count(std::span<const ListStep> steps, const fast::OnList& on_list) {
  ListCounts counts;
  std::size_t rays = 0;
  for (const ListStep& step : steps) {
    for (const ListPair& pair : step.pairs) rays += pair.points().rays();
  }
  answers_.assign(rays, RayAnswer::lit);
  caster_.clear_cache();
  caster_.show_lists(on_list);
  std::span<RayAnswer> rest(answers_);
  for (const ListStep& step : steps) {
    begin(step);
    counts.pairs += step.pairs.size();
    for (const ListPair& pair : step.pairs) {
      const std::span<RayAnswer> answers = rest.first(pair.points().rays());
      rest = rest.subspan(answers.size());
      caster_.receive(receiver_of(pair), pair.points(), answers);
      for (std::size_t i = 0; i < answers.size(); ++i) {
        const bool hidden = (*pair.hidden)[i], blocked = answers[i] != RayAnswer::lit;
        ++counts.rays;
        counts.shadowed += hidden ? 1 : 0;
        counts.false_lit += !blocked && hidden ? 1 : 0;
        counts.false_shadowed += blocked && !hidden ? 1 : 0;
      }
    }
  }
  caster_.show_lists({});
  counts.cast = caster_.cast_counters();
  counts.cull = caster_.cull_counters();
  return counts;
}

double ListRunner::time(std::span<const ListStep> steps, bool cast) {
  const CastRays which = cast ? CastRays::uncached : CastRays::none;
  std::span<RayAnswer> rest(answers_);
  const double start = thread_ns();
  for (const ListStep& step : steps) {
    begin(step);
    for (const ListPair& pair : step.pairs) {
      const std::size_t rays = pair.points().rays();
      caster_.receive(receiver_of(pair), pair.points(), rest.first(rays), which);
      rest = rest.subspan(rays);
    }
  }
  return thread_ns() - start;
}

}  // namespace gnomon::fuzz
