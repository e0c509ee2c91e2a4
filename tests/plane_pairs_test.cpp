// SPDX-License-Identifier: GPL-3.0-or-later
// The looked-up plane set against the paper's two lists, for every outcome of "which box is extreme on which
// face".
#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "fast/shaft.h"

namespace gnomon {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// The paper's wording: all combinations of elements of one list with those of the other, but for matching
/// directions.
Pairs combined(const fast::ExtremeLists& lists) {
  Pairs pairs;
  for (std::size_t i = 0; i < lists.count_a; ++i) {
    for (std::size_t j = 0; j < lists.count_b; ++j) {
      if (fast::axis_of(lists.of_a[i]) == fast::axis_of(lists.of_b[j])) continue;
      pairs.emplace_back(lists.of_a[i], lists.of_b[j]);
    }
  }
  return pairs;
}

TEST(PlanePairs, FollowThePapersListsForEveryOutcomeOnAllSixFaces) {
  std::set<int> outcomes;
  for (int outcome = 0; outcome < 729; ++outcome) {
    scene::Box<float> a, b;
    int digits = outcome;
    for (int face = 0; face < 6; ++face, digits /= 3) {
      // 0 tie, 1 a extreme, 2 b extreme; minima around 0, maxima around 10.
      const float base = face < 3 ? 0.0F : 10.0F, outwards = face < 3 ? -1.0F : 1.0F;
      a.c[static_cast<std::size_t>(face)] = base + (digits % 3 == 1 ? outwards : 0.0F);
      b.c[static_cast<std::size_t>(face)] = base + (digits % 3 == 2 ? outwards : 0.0F);
    }
    const Pairs expected = combined(fast::extreme_lists(a, b));
    const fast::Shaft<float> shaft = fast::form_shaft(a, b, fast::Normals::as_formed);
    Pairs formed;
    for (const fast::ShaftPlane<float>& plane : shaft.planes()) formed.emplace_back(plane.far0, plane.far1);
    EXPECT_EQ(formed, expected) << "outcome " << outcome;
    outcomes.insert(shaft.plane_count);
  }
  // With ties 0 to 8 but never 7 planes (claim S3).
  EXPECT_EQ(outcomes, (std::set<int>{0, 1, 2, 3, 4, 5, 6, 8}));
}

}  // namespace
}  // namespace gnomon
