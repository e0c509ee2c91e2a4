// SPDX-License-Identifier: MIT
#include "fast/pair_visibility.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fast/hierarchy_bounds.h"
#include "fast/is_float.h"
#include "fast/pair_arrays.h"
#include "fast/pair_plane.h"
#include "fast/pair_tile.h"

namespace gnomon::fast {

using scene::PairVisibility;

PairScratch::PairScratch() : data_(std::make_unique<Data>()) {}
PairScratch::~PairScratch() = default;
PairScratch::PairScratch(PairScratch&&) noexcept = default;
PairScratch& PairScratch::operator=(PairScratch&&) noexcept = default;

namespace {

bool checked(double x) {
  if (!is_float(x)) {
    throw std::runtime_error("a caster of pairs in floats needs a scene whose coordinates are floats");
  }
  return std::abs(x) <= static_cast<double>(kMostMagnitude);
}

}  // namespace

PairCaster::PairCaster(const scene::Scene& scene, std::span<const std::uint8_t> convex_objects)
    : scene_(scene) {
  for (const auto& point : scene.points) {
    for (const double x : point) in_domain_ &= checked(x);
  }
  for (const auto& ball : scene.balls) {
    for (const double x : ball.centre) in_domain_ &= checked(x);
    in_domain_ &= checked(ball.radius);
  }
  convex_runs_.emplace_back();
  if (!convex_objects.empty()) convex_run_of_.resize(scene.triangles.size());
  for (std::size_t i = 0; i < scene.objects.size() && i < convex_objects.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    if (convex_objects[i] == 0 || object.triangle_count == 0) continue;
    std::fill_n(convex_run_of_.begin() + static_cast<std::ptrdiff_t>(object.first_triangle),
                object.triangle_count, static_cast<std::uint32_t>(convex_runs_.size()));
    convex_runs_.push_back({static_cast<std::uint32_t>(object.first_triangle),
                            static_cast<std::uint32_t>(object.triangle_count)});
  }
  arrays_ = std::make_unique<const PairArrays>(scene);
}

PairCaster::~PairCaster() = default;

std::size_t PairCaster::bytes() const {
  const HierarchyArrays& tree = arrays_->tree;
  return tree.nodes.capacity() * sizeof(WideNode) + tree.triangles.capacity() * sizeof(TriangleBlock) +
         tree.balls.capacity() * sizeof(BallBlock) + tree.places.capacity() * sizeof(FacePlace) +
         arrays_->corners.capacity() * sizeof(CornerBlock);
}

PairArrays::PairArrays(const scene::Scene& scene) : tree(build_hierarchy(scene)) {
  // Not its address, which the next one may have.
  static std::atomic<std::uint64_t> casters{0};
  number = ++casters;
  corners.resize(tree.triangles.size());
  for (std::size_t block = 0; block < corners.size(); ++block) {
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      const std::uint32_t face = tree.triangles[block].face[lane];
      for (std::size_t k = 0; k < 3; ++k) {
        corners[block].v1[k][lane] = static_cast<float>(scene.corner(face, 1)[k]);
        corners[block].v2[k][lane] = static_cast<float>(scene.corner(face, 2)[k]);
        corners[block].number[k][lane] = scene.triangles[face][k];
      }
    }
  }
}

namespace {

/// Answers without the tree: by the predicate alone, or not at all.
PairResult by_all_faces(const scene::Scene& scene, const PairPatch& from, const PairPatch& to,
                        const ExactFaces* exact, std::span<ShadowAnswer> answers, PairCounters* counters) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t k = 0; k < to.size(); ++k) {
      scene::ShadowQuery query;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        query.point[axis] = static_cast<double>(from.coordinates(axis)[i]);
        query.light[axis] = static_cast<double>(to.coordinates(axis)[k]);
      }
      ShadowAnswer& answer = answers[from.given(i) * to.size() + to.given(k)];
      const auto finite = [](const std::array<double, 3>& p) {
        return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
      };
      if (exact == nullptr || !finite(query.point) || !finite(query.light)) {
        answer = ShadowAnswer::undecided;
        continue;
      }
      answer = ShadowAnswer::lit;
      for (std::uint32_t face = 0; face < scene.face_count() && answer == ShadowAnswer::lit; ++face) {
        if (from.own.contains(face) || to.own.contains(face)) continue;
        if (counters != nullptr) ++counters->exact;
        if (exact->blocks(scene, face, query)) answer = ShadowAnswer::shadowed;
      }
    }
  }
  return {};
}

struct Call {
  const scene::Scene& scene;
  const PairArrays& arrays;
  bool in_domain;
  Hierarchy::Tier tier;
  const ExactFaces* exact;
};

PairResult answer_pair(const Call& call, const PairPatch& from, const PairPatch& to, PairScratch& scratch,
                       std::span<ShadowAnswer> answers, PairCounters* counters) {
  PairScratch::Data& data = scratch.data();
  if (data.owner != call.arrays.number) {
    data.owner = call.arrays.number;
    data.last_blocker = {};
  }
  PairResult result;
  if (from.size() == 0 || to.size() == 0) {
    result.visibility = PairVisibility::all;
  } else if (call.tier == Hierarchy::Tier::certified && !(call.in_domain && from.in_domain && to.in_domain)) {
    result = by_all_faces(call.scene, from, to, call.exact, answers, counters);
  } else if (call.arrays.tree.nodes.empty()) {
    std::fill(answers.begin(), answers.end(), ShadowAnswer::lit);
    result.visibility = PairVisibility::all;
  } else {
    result = run_pair(call.tier, {call.scene, call.arrays}, from, to, data, answers, call.exact, counters);
  }
  if (counters != nullptr) {
    ++counters->pairs;
    counters->rays += from.size() * to.size();
    counters->all += result.visibility == PairVisibility::all;
    counters->none += result.visibility == PairVisibility::none;
  }
  return result;
}

}  // namespace

void PairCaster::set_plane(PairPatch& patch) const {
  const scene::FaceRun own = patch.own;
  if (!patch.in_domain || !in_domain_ || own.first >= scene_.triangles.size()) return;
  set_own_plane(scene_, patch);
  if (own.count == 0 || convex_run_of_.empty()) return;
  const std::uint32_t run = convex_run_of_[own.first];
  // Leaving the object out must leave out the whole run.
  if (run != 0 && convex_runs_[run].contains(own.first + own.count - 1)) patch.convex = convex_runs_[run];
}

void PairCaster::prepare(std::span<const std::array<float, 3>> points, scene::FaceRun own,
                         PairPatch& patch) const {
  patch.assign(points, own);
  set_plane(patch);
}

void PairCaster::prepare(const RayBatch& batch, PairScratch& scratch) const {
  PairScratch::Data& data = scratch.data();
  // What planes need of the scene lies anywhere in memory: asked for ahead, it comes while points are copied.
  const auto in_scene = [&](const scene::FaceRun& own) { return own.first < scene_.triangles.size(); };
  for (const scene::FaceRun* own : {&batch.own_from, &batch.own_to}) {
    if (!in_scene(*own)) continue;
    hwy::Prefetch(&scene_.triangles[own->first]);
    if (!convex_run_of_.empty()) hwy::Prefetch(&convex_run_of_[own->first]);
  }
  data.from.assign(batch.from, batch.own_from);
  data.to.assign(batch.to, batch.own_to);
  for (const scene::FaceRun* own : {&batch.own_from, &batch.own_to}) {
    if (!in_scene(*own)) continue;
    for (const std::uint32_t corner : scene_.triangles[own->first]) hwy::Prefetch(&scene_.points[corner]);
  }
  set_plane(data.from);
  set_plane(data.to);
}

PairPatch PairCaster::prepare(std::span<const std::array<float, 3>> points, scene::FaceRun own) const {
  PairPatch patch;
  prepare(points, own, patch);
  return patch;
}

PairResult PairCaster::shadows_naive(const PairPatch& from, const PairPatch& to, PairScratch& scratch,
                                     std::span<ShadowAnswer> answers, PairCounters* counters) const {
  return answer_pair({scene_, *arrays_, in_domain_, Hierarchy::Tier::naive, nullptr}, from, to, scratch,
                     answers, counters);
}
PairResult PairCaster::shadows_certified(const PairPatch& from, const PairPatch& to, PairScratch& scratch,
                                         std::span<ShadowAnswer> answers, PairCounters* counters) const {
  return answer_pair({scene_, *arrays_, in_domain_, Hierarchy::Tier::certified, nullptr}, from, to, scratch,
                     answers, counters);
}
PairResult PairCaster::shadows_exact(const ExactFaces& faces, const PairPatch& from, const PairPatch& to,
                                     PairScratch& scratch, std::span<ShadowAnswer> answers,
                                     PairCounters* counters) const {
  return answer_pair({scene_, *arrays_, in_domain_, Hierarchy::Tier::certified, &faces}, from, to, scratch,
                     answers, counters);
}

PairResult PairCaster::shadows_naive(const RayBatch& batch, PairScratch& scratch,
                                     std::span<ShadowAnswer> answers, PairCounters* counters) const {
  prepare(batch, scratch);
  const PairScratch::Data& data = scratch.data();
  return shadows_naive(data.from, data.to, scratch, answers, counters);
}
PairResult PairCaster::shadows_certified(const RayBatch& batch, PairScratch& scratch,
                                         std::span<ShadowAnswer> answers, PairCounters* counters) const {
  prepare(batch, scratch);
  const PairScratch::Data& data = scratch.data();
  return shadows_certified(data.from, data.to, scratch, answers, counters);
}
PairResult PairCaster::shadows_exact(const ExactFaces& faces, const RayBatch& batch, PairScratch& scratch,
                                     std::span<ShadowAnswer> answers, PairCounters* counters) const {
  prepare(batch, scratch);
  const PairScratch::Data& data = scratch.data();
  return shadows_exact(faces, data.from, data.to, scratch, answers, counters);
}

void PairCaster::candidates(const PairPatch& from, const PairPatch& to,
                            std::vector<std::uint32_t>& faces) const {
  faces.clear();
  if (from.size() == 0 || to.size() == 0) return;
  if (in_domain_ && from.in_domain && to.in_domain) {
    if (!arrays_->tree.nodes.empty()) run_candidates(*arrays_, from, to, faces);
    return;
  }
  for (std::uint32_t face = 0; face < scene_.face_count(); ++face) {
    if (!from.own.contains(face) && !to.own.contains(face)) faces.push_back(face);
  }
}

void PairCaster::shaft_faces(const scene::Box<float>& a, const scene::Box<float>& b,
                             std::vector<std::uint32_t>& faces) const {
  faces.clear();
  bool inside = in_domain_;
  for (std::size_t i = 0; i < 6; ++i) {
    inside &= std::abs(a.c[i]) <= kMostMagnitude && std::abs(b.c[i]) <= kMostMagnitude;
  }
  if (!inside) {
    faces.resize(scene_.face_count());
    std::iota(faces.begin(), faces.end(), 0u);
  } else if (!arrays_->tree.nodes.empty()) {
    run_shaft_faces(*arrays_, a.c, b.c, faces);
  }
}

}  // namespace gnomon::fast
