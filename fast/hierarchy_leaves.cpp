// SPDX-License-Identifier: MIT
//
// NORMALS. Write v = 2^-53 for the roundoff of doubles. Differences of floats in double precision are off by
// at most v of themselves, products by another v, their difference by another: with e1, e2 the exact edges,
// |n_i - exact| <= gamma_v(4) (|e1_j e2_k| + |e1_k e2_j|) <= 4.1 v (..), and underflow is out of reach:
// products of two floats are at least 2^-298. Rounding to float adds u |n_i| + eta.
//
// THE ERROR CONSTANTS E and N, as fast/hierarchy_triangles_inl.h defines them, are computed in double
// precision and rounded up, with room for the few roundings that they meet later (a factor 1 + 16 u).
#include "fast/hierarchy_leaves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/hierarchy_bounds.h"
#include "fast/is_float.h"

namespace gnomon::fast {

namespace {

/// The least float >= x times (1 + 16 u).
float rounded_up(double x) {
  const float nearest = static_cast<float>(x * (1 + 16 * static_cast<double>(Rounding<float>::u)));
  return std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

}  // namespace

TriangleBlock make_triangle_block(const scene::Scene& scene, const std::array<std::uint32_t, kWidth>& faces) {
  constexpr double u = Rounding<float>::u, v = Rounding<double>::u;
  constexpr double kTwoEta = Rounding<float>::two_eta;
  TriangleBlock block;
  block.face = faces;
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    const auto &a = scene.corner(faces[lane], 0), &b = scene.corner(faces[lane], 1),
               &c = scene.corner(faces[lane], 2);
    std::array<double, 3> e1, e2;
    double sum1 = 0, sum2 = 0, normal_sum = 0, normal_off = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      e1[k] = b[k] - a[k];
      e2[k] = c[k] - a[k];
      block.v0[k][lane] = static_cast<float>(a[k]);
      block.to_v1[k][lane] = static_cast<float>(a[k]) - static_cast<float>(b[k]);
      block.to_v2[k][lane] = static_cast<float>(c[k]) - static_cast<float>(a[k]);
      sum1 += std::abs(e1[k]);
      sum2 += std::abs(e2[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const double p = e1[i] * e2[j], q = e1[j] * e2[i];
      const auto n = static_cast<float>(p - q);
      block.normal[k][lane] = n;
      normal_sum += std::abs(static_cast<double>(n));
      normal_off += 4.2 * v * (std::abs(p) + std::abs(q)) +
                    u * std::abs(static_cast<double>(n)) * (1 + 2 * u) + kTwoEta;
    }
    block.edge_error[lane] = rounded_up(kEdgeOperations * u * std::max(sum1, sum2));
    block.normal_error[lane] = rounded_up(kNormalOperations * u * normal_sum + normal_off);
  }
  return block;
}

BallBlock make_ball_block(const scene::Scene& scene, const std::array<std::uint32_t, kWidth>& faces) {
  BallBlock block;
  block.face = faces;
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    const scene::Ball<double>& ball = scene.balls[faces[lane] - scene.triangles.size()];
    for (std::size_t k = 0; k < 3; ++k) block.centre[k][lane] = static_cast<float>(ball.centre[k]);
    block.radius[lane] = static_cast<float>(ball.radius);
  }
  return block;
}

std::array<float, 6> box_around_ball(const scene::Ball<double>& ball) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  constexpr float kFarFloat = std::numeric_limits<float>::infinity();
  std::array<float, 6> box;
  for (std::size_t k = 0; k < 3; ++k) {
    // A sum or difference of doubles is within half an ulp, so the next double is beyond it; the float next
    // to a rounded one is beyond what was rounded. Radius 0 stays exact.
    double lo = ball.centre[k], hi = lo;
    if (ball.radius > 0) {
      lo = std::nextafter(lo - ball.radius, -kFar);
      hi = std::nextafter(hi + ball.radius, kFar);
    }
    box[k] = static_cast<float>(lo);
    box[k + 3] = static_cast<float>(hi);
    if (!is_float(lo)) box[k] = std::nextafter(box[k], -kFarFloat);
    if (!is_float(hi)) box[k + 3] = std::nextafter(box[k + 3], kFarFloat);
  }
  return box;
}

}  // namespace gnomon::fast
