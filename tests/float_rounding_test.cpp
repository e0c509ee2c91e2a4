// SPDX-License-Identifier: GPL-3.0-or-later
// Does the compiler round where it is told to? g++ 12 from -O2 on does not without -fno-tree-slp-vectorize.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "scene/ball.h"
#include "scene/scalar.h"

namespace gnomon::scene {
namespace {

// Not inlined, so that neither the numbers nor what becomes of them is known.
[[gnu::noinline]] std::array<double, 3> rounded(double x, double y, double z) {
  return {static_cast<double>(static_cast<float>(x)), static_cast<double>(static_cast<float>(y)),
          static_cast<double>(static_cast<float>(z))};
}

[[gnu::noinline]] Ball<double> rounded(const Ball<double>& ball) {
  return converted<double>(converted<float>(ball));
}

TEST(FloatRounding, NeighbouringConversionsRound) {
  const std::array<double, 3> point = rounded(0.1, 0.2, 0.3);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(is_float(point[k])) << k;
  EXPECT_EQ(point[0], 0.100000001490116119384765625);
  const Ball<double> ball = rounded(Ball<double>{{0.1, 0.2, 0.3}, 0.4});
  for (const double x : {ball.centre[0], ball.centre[1], ball.centre[2], ball.radius})
    EXPECT_TRUE(is_float(x)) << x;
}

}  // namespace
}  // namespace gnomon::scene
