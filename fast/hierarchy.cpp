// SPDX-License-Identifier: MIT
#include "fast/hierarchy.h"

#include <cmath>
#include <stdexcept>

#include "fast/hierarchy_query.h"

namespace gnomon::fast {

namespace {

/// True when x is in the certified tier's domain.
bool checked(double x) {
  if (!is_float(x)) {
    throw std::runtime_error("a hierarchy of floats needs a scene whose coordinates are floats");
  }
  return std::abs(x) <= static_cast<double>(kMostMagnitude);
}

}  // namespace

Hierarchy::Hierarchy(const scene::Scene& scene) : scene_(scene) {
  for (const auto& point : scene.points) {
    for (const double x : point) in_domain_ &= checked(x);
  }
  for (const auto& ball : scene.balls) {
    for (const double x : ball.centre) in_domain_ &= checked(x);
    in_domain_ &= checked(ball.radius);
  }
  arrays_ = std::make_unique<const HierarchyArrays>(build_hierarchy(scene));
}

Hierarchy::~Hierarchy() = default;

std::size_t Hierarchy::bytes() const {
  return arrays_->nodes.capacity() * sizeof(WideNode) +
         arrays_->triangles.capacity() * sizeof(TriangleBlock) +
         arrays_->balls.capacity() * sizeof(BallBlock) + arrays_->places.capacity() * sizeof(FacePlace);
}

void Hierarchy::shadows(Tier tier, std::span<const scene::ShadowQuery> queries,
                        std::span<ShadowAnswer> answers) const {
  run_shadows(tier, {scene_, *arrays_, in_domain_}, queries, answers, nullptr, nullptr);
}
void Hierarchy::shadows(Tier tier, std::span<const scene::ShadowQuery> queries,
                        std::span<ShadowAnswer> answers, TestCounters& counters) const {
  run_shadows(tier, {scene_, *arrays_, in_domain_}, queries, answers, nullptr, &counters);
}
void Hierarchy::shadows_exact(const ExactFaces& faces, std::span<const scene::ShadowQuery> queries,
                              std::span<ShadowAnswer> answers) const {
  run_shadows(Tier::certified, {scene_, *arrays_, in_domain_}, queries, answers, &faces, nullptr);
}
void Hierarchy::shadows_exact(const ExactFaces& faces, std::span<const scene::ShadowQuery> queries,
                              std::span<ShadowAnswer> answers, TestCounters& counters) const {
  run_shadows(Tier::certified, {scene_, *arrays_, in_domain_}, queries, answers, &faces, &counters);
}

void Hierarchy::first_hits(Tier tier, std::span<const scene::RayQuery> queries,
                           std::span<std::uint32_t> answers) const {
  run_first_hits(tier, {scene_, *arrays_, in_domain_}, queries, answers, nullptr, nullptr);
}
void Hierarchy::first_hits(Tier tier, std::span<const scene::RayQuery> queries,
                           std::span<std::uint32_t> answers, TestCounters& counters) const {
  run_first_hits(tier, {scene_, *arrays_, in_domain_}, queries, answers, nullptr, &counters);
}
void Hierarchy::first_hits_exact(const ExactFaces& faces, std::span<const scene::RayQuery> queries,
                                 std::span<std::uint32_t> answers) const {
  run_first_hits(Tier::certified, {scene_, *arrays_, in_domain_}, queries, answers, &faces, nullptr);
}
void Hierarchy::first_hits_exact(const ExactFaces& faces, std::span<const scene::RayQuery> queries,
                                 std::span<std::uint32_t> answers, TestCounters& counters) const {
  run_first_hits(Tier::certified, {scene_, *arrays_, in_domain_}, queries, answers, &faces, &counters);
}

}  // namespace gnomon::fast
