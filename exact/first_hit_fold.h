// SPDX-License-Identifier: GPL-3.0-or-later
// From the contacts of a ray to its first hit. Internal to exact/.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "exact/contact.h"
#include "exact/first_hit.h"

namespace gnomon::exact {

/// Takes contacts of one ray in any order, and keeps those that nothing known comes before.
class FirstHitFold {
 public:
  FirstHitFold(const scene::Scene& scene, const scene::RayQuery& ray)
      : scene_(scene), ray_(ray), nearest_{0, HUGE_VAL} {}

  /// Adds a contact; bounds on where are worked out for those that meet.
  void add(std::uint32_t face, Contact contact);
  /// Adds one whose place is known to within bounds.
  void add(std::uint32_t face, Contact contact, HitBounds bounds);
  /// What comes later than this t can't be among the first.
  [[nodiscard]] double latest() const { return nearest_.hi; }
  [[nodiscard]] FirstHit result();

 private:
  struct Met {
    std::uint32_t face;
    Contact contact;
  };

  const scene::Scene& scene_;
  const scene::RayQuery& ray_;
  std::vector<Met> first_;  ///< all tied, exactly
  HitBounds nearest_;       ///< of every one of them
  bool at_end_ = false;
};

}  // namespace gnomon::exact
