// SPDX-License-Identifier: MIT
// The faces that a ray may meet first: what intervals leave open, predicates decide.
#include "fast/hierarchy_query.h"

namespace gnomon::fast {

void HitCandidates::drop_farther() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (hits_[i].lo <= nearest_) hits_[kept++] = hits_[i];
  }
  count_ = kept;
}

void HitCandidates::make_room() {
  drop_farther();
  if (count_ < hits_.size()) return;
  if (exact_ != nullptr) {
    leave_first();
  } else {
    lost_ = true;
  }
}

void HitCandidates::leave_first() {
  const auto ask_whether_met = [this](const Hit& hit) {
    if (hit.certain) return true;
    ++calls_;
    return exact_->meets(scene_, hit.face, query_);
  };
  std::size_t met = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    Hit hit = hits_[i];
    if (!ask_whether_met(hit)) continue;
    hit.certain = true;
    if (met == 0) {
      hits_[met++] = hit;
      continue;
    }
    ++calls_;
    const std::strong_ordering order = exact_->compare_hits(scene_, hit.face, hits_[0].face, query_);
    if (order < 0 || (order == 0 && hit.face < hits_[0].face)) hits_[0] = hit;
  }
  count_ = met;
  if (met != 0 && hits_[0].hi < nearest_) nearest_ = hits_[0].hi;
}

std::uint32_t HitCandidates::resolve() {
  drop_farther();
  if (lost_) return kUndecidedFace;
  if (count_ > 1 || (count_ == 1 && !hits_[0].certain)) {
    if (exact_ == nullptr) return kUndecidedFace;
    leave_first();
  }
  return count_ == 0 ? scene::kNoFace : hits_[0].face;
}

std::uint32_t HitCandidates::ask_about_all() {
  if (exact_ == nullptr) return kUndecidedFace;
  for (std::uint32_t face = 0; face < scene_.face_count(); ++face) {
    add(face, 0, std::numeric_limits<float>::infinity(), false);
  }
  return resolve();
}

}  // namespace gnomon::fast
