// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/hierarchy.h"

#include "exact/hierarchy_walk.h"

namespace gnomon::exact {

using scene::RayQuery;
using scene::Scene;
using scene::ShadowQuery;

namespace {

struct Walks {
  ShadowTruth (*shadow)(const Scene&, const BuiltHierarchy&, const ShadowQuery&, HierarchyCounters*);
  FirstHit (*first_hit)(const Scene&, const BuiltHierarchy&, const RayQuery&, HierarchyCounters*);
};

Walks best_walks() {
#ifdef GNOMON_EXACT_HAS_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi")) return {avx2::shadow, avx2::first_hit};
#endif
  return {baseline::shadow, baseline::first_hit};
}

const Walks kWalks = best_walks();

}  // namespace

Hierarchy::Hierarchy(const Scene& scene)
    : scene_(scene), built_(std::make_unique<const BuiltHierarchy>(build_hierarchy(scene))) {}

Hierarchy::~Hierarchy() = default;

ShadowTruth Hierarchy::shadow(const ShadowQuery& query) const {
  return kWalks.shadow(scene_, *built_, query, nullptr);
}

ShadowTruth Hierarchy::shadow(const ShadowQuery& query, HierarchyCounters& counters) const {
  return kWalks.shadow(scene_, *built_, query, &counters);
}

FirstHit Hierarchy::first_hit(const RayQuery& ray) const {
  return kWalks.first_hit(scene_, *built_, ray, nullptr);
}

FirstHit Hierarchy::first_hit(const RayQuery& ray, HierarchyCounters& counters) const {
  return kWalks.first_hit(scene_, *built_, ray, &counters);
}

std::size_t Hierarchy::bytes() const {
  return sizeof *this + sizeof *built_ + built_->nodes.capacity() * sizeof(WideNode) +
         built_->float_leaves.capacity() * sizeof(Leaf<float>) +
         built_->double_leaves.capacity() * sizeof(Leaf<double>);
}

}  // namespace gnomon::exact
