// SPDX-License-Identifier: MIT
//
// OWN FACES. Facing is the sign of D = n . d of fast/hierarchy_triangles_inl.h, with the same error. An own
// ball blocks when m . d > 0, m = c - p: off by g(5) sum |m_i| |d_i| + 3 eta, as each product has three
// roundings (m, d, its own) and two sums; the sum of magnitudes is computed in the same way.
#include "fast/hierarchy_query.h"

#include <algorithm>
#include <cmath>

namespace gnomon::fast {

bool ShadowCandidates::add(const std::array<std::uint32_t, kWidth>& faces, std::uint32_t lanes) {
  any_ = true;
  if (exact_ == nullptr) return false;
  if (count_ + kWidth > faces_.size() && one_blocks()) return true;
  for (; lanes != 0; lanes &= lanes - 1) {
    faces_[count_++] = faces[static_cast<std::size_t>(std::countr_zero(lanes))];
  }
  return false;
}

bool ShadowCandidates::one_blocks() {
  for (std::size_t i = 0; i < count_; ++i) {
    ++calls_;
    if (exact_->blocks(scene_, faces_[i], query_)) return true;
  }
  count_ = 0;
  return false;
}

ShadowAnswer ShadowCandidates::resolve() {
  if (exact_ == nullptr) return ShadowAnswer::undecided;
  return one_blocks() ? ShadowAnswer::shadowed : ShadowAnswer::lit;
}

int ShadowCandidates::ask_about_facing() {
  if (exact_ == nullptr) return -1;
  ++calls_;
  return exact_->faces_away(scene_, query_) ? 1 : 0;
}

ShadowAnswer ShadowCandidates::ask_about_all() {
  if (exact_ == nullptr) return ShadowAnswer::undecided;
  if (query_.own < scene_.triangles.size() && ask_about_facing() == 1) return ShadowAnswer::facing;
  for (std::uint32_t face = 0; face < scene_.face_count(); ++face) {
    ++calls_;
    if (exact_->blocks(scene_, face, query_)) return ShadowAnswer::shadowed;
  }
  return ShadowAnswer::lit;
}

namespace {

/// The sign of D for the own triangle; 0 when it is not certain (naive: when it is 0).
template <class Tier>
int side_of_own(const TriangleBlock& block, std::size_t lane, const Beam& beam) {
  const float d = block.normal[0][lane] * beam.direction[0] + block.normal[1][lane] * beam.direction[1] +
                  block.normal[2][lane] * beam.direction[2];
  const float error = Tier::kCertified ? block.normal_error[lane] * beam.largest + kTriangleUnderflow : 0.0f;
  return d > error ? 1 : d < -error ? -1 : 0;
}

}  // namespace

template <class Tier>
int way_into(const BallBlock& block, std::size_t lane, const Beam& beam) {
  float sum = 0, magnitudes = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float product = (block.centre[k][lane] - beam.origin[k]) * beam.direction[k];
    sum += product;
    magnitudes += std::abs(product);
  }
  const float error = Tier::kCertified ? kBallWay * magnitudes + kTriangleUnderflow : 0.0f;
  return sum > error ? 1 : sum < -error ? -1 : 0;
}

/// The own face's rules; true when they know the answer. `beam` must be measured.
template <class Tier>
bool own_decides(const HierarchyView& hierarchy, const scene::ShadowQuery& query, const Beam& beam,
                 ShadowCandidates& candidates, ShadowAnswer& answer) {
  const HierarchyArrays& arrays = hierarchy.arrays;
  if (query.own >= arrays.places.size()) return false;
  const FacePlace place = arrays.places[query.own];
  if (query.own < hierarchy.scene.triangles.size()) {
    if (place.one_sided == 0) return false;
    const int side = side_of_own<Tier>(arrays.triangles[place.block], place.lane, beam);
    const int facing = Tier::kCertified && side == 0 ? candidates.ask_about_facing() : side < 0 ? 1 : 0;
    if (facing == 0) return false;
    answer = facing < 0 ? ShadowAnswer::undecided : ShadowAnswer::facing;
    return true;
  }
  const int way = way_into<Tier>(arrays.balls[place.block], place.lane, beam);
  if (way > 0) {
    answer = ShadowAnswer::shadowed;
    return true;
  }
  // A ball left open waits with the others: a certain blocker spares it.
  if (Tier::kCertified && way == 0) {
    (void)candidates.add(arrays.balls[place.block].face, 1u << place.lane);
  }
  return false;
}

template <class Tier>
bool begin_shadow(const HierarchyView& hierarchy, const scene::ShadowQuery& query, Beam& beam,
                  ShadowCandidates& candidates, ShadowAnswer& answer) {
  const HierarchyArrays& arrays = hierarchy.arrays;
  if (Tier::kCertified && !(hierarchy.in_domain && in_certified_domain(query.point, query.light))) {
    answer = candidates.ask_about_all();
    return true;
  }
  bool empty = true;
  for (std::size_t k = 0; k < 3; ++k) {
    beam.origin[k] = static_cast<float>(query.point[k]);
    beam.direction[k] = static_cast<float>(query.light[k]) - beam.origin[k];
    empty &= beam.direction[k] == 0;
  }
  answer = ShadowAnswer::lit;
  if (empty || arrays.nodes.empty()) return true;
  beam.measure();
  if (own_decides<Tier>(hierarchy, query, beam, candidates, answer)) return true;
  beam.template prepare<Tier::kCertified>();
  return false;
}

bool in_ray_domain(const HierarchyView& hierarchy, const scene::RayQuery& query) {
  double largest = 0;
  for (const double d : query.direction) largest = std::max(largest, std::abs(d));
  return hierarchy.in_domain && (largest == 0 || largest >= static_cast<double>(kLeastDirection)) &&
         in_certified_domain(query.origin, query.direction);
}

template <class Tier>
bool begin_ray(const HierarchyView& hierarchy, const scene::RayQuery& query, Beam& beam) {
  bool empty = true;
  for (std::size_t k = 0; k < 3; ++k) {
    beam.origin[k] = static_cast<float>(query.origin[k]);
    beam.direction[k] = static_cast<float>(query.direction[k]);
    empty &= beam.direction[k] == 0;
  }
  if (empty || hierarchy.arrays.nodes.empty()) return false;
  beam.measure();
  beam.template prepare<Tier::kCertified>();
  if (Tier::kCertified) beam.leave_out_slow_axes();
  return true;
}

template bool begin_ray<NaiveTier>(const HierarchyView&, const scene::RayQuery&, Beam&);
template bool begin_ray<CertifiedTier>(const HierarchyView&, const scene::RayQuery&, Beam&);
template int way_into<NaiveTier>(const BallBlock&, std::size_t, const Beam&);
template int way_into<CertifiedTier>(const BallBlock&, std::size_t, const Beam&);
template bool begin_shadow<NaiveTier>(const HierarchyView&, const scene::ShadowQuery&, Beam&,
                                      ShadowCandidates&, ShadowAnswer&);
template bool begin_shadow<CertifiedTier>(const HierarchyView&, const scene::ShadowQuery&, Beam&,
                                          ShadowCandidates&, ShadowAnswer&);

}  // namespace gnomon::fast
