// SPDX-License-Identifier: GPL-3.0-or-later
// How many planes the shaft of two random boxes has, exactly: no sampling.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "fast/shaft.h"

namespace gnomon::tests {
namespace {

/// An axis of both boxes, by the ranks of the four coordinates.
struct Ranks {
  float a_lo, a_hi, b_lo, b_hi;
};

/// Four independent draws of one continuous law, two for each interval, come in 4! orders alike; the smaller
/// of two is the lower end, so that the six ways to give two of the four ranks to A are equally likely.
constexpr std::array<Ranks, 6> kOrders{
    {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};

/// Claim S3: 0, 4, 6 and 8 planes in 1/108, 1/9, 20/27 and 5/36 of the cases, that is 0.9, 11.1, 74.1 and
/// 13.9 %. The plane set depends on the orders along the three axes alone, so 6^3 shafts stand for all.
TEST(PlaneStatistics, RandomBoxesHaveThePublishedSharesOfPlanes) {
  std::map<int, int> counts;
  for (const Ranks& x : kOrders) {
    for (const Ranks& y : kOrders) {
      for (const Ranks& z : kOrders) {
        const scene::Box<float> a{{x.a_lo, y.a_lo, z.a_lo, x.a_hi, y.a_hi, z.a_hi}};
        const scene::Box<float> b{{x.b_lo, y.b_lo, z.b_lo, x.b_hi, y.b_hi, z.b_hi}};
        ++counts[fast::form_shaft(a, b, fast::Normals::as_formed).plane_count];
      }
    }
  }
  EXPECT_EQ(counts,
            (std::map<int, int>{{0, 216 / 108}, {4, 216 / 9}, {6, 216 * 20 / 27}, {8, 216 * 5 / 36}}));
}

}  // namespace
}  // namespace gnomon::tests
