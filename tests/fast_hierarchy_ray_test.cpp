// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters at which rays meet faces, with numbers of all magnitudes in the certified tier's domain:
// from denormal floats to 2^40, so that quotients overflow and underflow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/first_hit.h"
#include "exact/shadow.h"
#include "fast/hierarchy.h"
#include "fast/hierarchy_build.h"
#include "fast/hierarchy_leaves.h"
#include "fast/hierarchy_probe.h"
#include "tests/fast_hierarchy_truth.h"
#include "tests/ray_beam.h"
#include "tests/search_trials.h"

namespace gnomon::tests {

namespace {

using Point = std::array<double, 3>;

double clamped_float(double x) {
  return static_cast<double>(static_cast<float>(std::clamp(x, -0x1p40, 0x1p40)));
}

/// A float of that magnitude or less, of any sign.
double about(Random& random, double magnitude) {
  return clamped_float((2 * random.unit() - 1) * magnitude);
}

/// Powers of two as differently large as lengths and directions in the domain can be.
double any_magnitude(Random& random, int least, int most) {
  return std::ldexp(1.0, random.between(least, most));
}

Point point_about(Random& random, const Point& centre, double magnitude) {
  Point p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = clamped_float(centre[k] + about(random, magnitude));
  return p;
}

/// A ray through or past something near a point that is t directions away, and how far off the thing is.
struct Aim {
  scene::RayQuery ray;
  Point target;
  double off;
};

Aim random_aim(Random& random) {
  Aim aim;
  const double length = any_magnitude(random, -55, 40);
  const Point origin = random.chance(50) ? Point{} : point_about(random, {}, any_magnitude(random, -149, 38));
  Point direction;
  do {
    for (double& x : direction) x = random.chance(25) ? 0 : about(random, length);
  } while (direction == Point{});
  aim.ray = {origin, direction, scene::kNoFace};
  const double t = any_magnitude(random, -80, 90);
  for (std::size_t k = 0; k < 3; ++k) aim.target[k] = clamped_float(origin[k] + t * direction[k]);
  aim.off = any_magnitude(random, -149, 39);
  return aim;
}

std::array<std::uint32_t, fast::kWidth> first_faces() {
  std::array<std::uint32_t, fast::kWidth> faces;
  for (std::uint32_t i = 0; i < fast::kWidth; ++i) faces[i] = i;
  return faces;
}

/// Floats may be infinite, and rationals not.
bool at_most(float a, const Rational& b) {
  return !std::isinf(a) ? Rational(a) <= b : a < 0;
}
bool at_least(float a, const Rational& b) {
  return !std::isinf(a) ? Rational(a) >= b : a > 0;
}

/// The line against one ball, by the distance to its centre: no roots.
struct BallOnLine {
  RationalPoint m, d;
  Rational r, closest;

  BallOnLine(const scene::RayQuery& ray, const scene::Ball<double>& ball)
      : m(rational(ball.centre) - rational(ray.origin)),
        d(rational(ray.direction)),
        r(ball.radius),
        closest(dot(m, d) / dot(d, d)) {}

  [[nodiscard]] int side(const Rational& t) const {
    const RationalPoint q{Rational(m[0] - t * d[0]), Rational(m[1] - t * d[1]), Rational(m[2] - t * d[2])};
    return cmp(dot(q, q), Rational(r * r));
  }
  [[nodiscard]] bool is_met() const { return side(closest >= 0 ? closest : Rational(0)) <= 0; }
  /// Whether x is at most, at least the parameter at which the ray enters the ball, 0 from within.
  [[nodiscard]] bool before_entry(float x) const {
    return x <= 0 || (at_most(x, closest) && side(Rational(x)) >= 0);
  }
  [[nodiscard]] bool after_entry(float x) const {
    return x >= 0 && (std::isinf(x) || Rational(x) >= closest || side(Rational(x)) <= 0);
  }
  /// The same of where the line leaves it.
  [[nodiscard]] bool before_exit(float x) const {
    return x <= 0 || at_most(x, closest) || (!std::isinf(x) && side(Rational(x)) <= 0);
  }
  [[nodiscard]] bool after_exit(float x) const {
    return x >= 0 && (std::isinf(x) || (Rational(x) >= closest && side(Rational(x)) >= 0));
  }
};

}  // namespace

TEST(FastHierarchyRays, EnterAndLeaveBallsBetweenTheirParametersAtAnyMagnitude) {
  Random random(811);
  int certain = 0, met = 0, far = 0, near = 0;
  for (std::uint64_t i = 0; i < search_trials(6000); ++i) {
    const Aim aim = random_aim(random);
    scene::Scene scene;
    for (std::size_t k = 0; k < fast::kWidth; ++k) {
      const double off = std::max(aim.off * std::ldexp(1.0, -random.below(12)), 0x1p-149);
      scene.balls.push_back(
          {point_about(random, aim.target, off), std::abs(about(random, random.chance(50) ? 4 * off : off))});
    }
    const fast::BallBlock block = fast::make_ball_block(scene, first_faces());
    const fast::Beam beam = beam_of_ray(aim.ray);
    const fast::RayProbe in = fast::probe_ray(block, beam), out = fast::probe_ray(block, beam, true);
    for (std::size_t lane = 0; lane < fast::kWidth; ++lane) {
      const BallOnLine truth(aim.ray, scene.balls[lane]);
      const auto has = [lane](std::uint32_t bits) { return (bits >> lane & 1) != 0; };
      const std::string text = "trial " + std::to_string(i) + ", ball " + std::to_string(lane) + ": " +
                               std::to_string(in.lo[lane]) + " to " + std::to_string(in.hi[lane]);
      if (!truth.is_met()) {
        ASSERT_FALSE(has(in.certain)) << text;
        continue;
      }
      ++met;
      ASSERT_TRUE(has(in.possible)) << text;
      ASSERT_TRUE(truth.before_entry(in.lo[lane])) << text;
      if (!has(in.certain)) continue;
      ++certain;
      ASSERT_TRUE(truth.after_entry(in.hi[lane])) << text;
      // An own ball that the ray goes into.
      if (truth.closest > 0) {
        ASSERT_TRUE(has(out.certain)) << text;
        ASSERT_TRUE(truth.before_exit(out.lo[lane])) << text << ", leaving";
        ASSERT_TRUE(truth.after_exit(out.hi[lane])) << text << ", leaving";
      }
      // Where radii's squares in units of the direction leave the floats.
      const double share = scene.balls[lane].radius / static_cast<double>(beam.largest);
      far += share > 0x1p64 ? 1 : 0;
      near += share > 0 && share < 0x1p-70 ? 1 : 0;
    }
  }
  std::printf("%d balls met, %d for certain, %d large ones, %d small ones\n", met, certain, far, near);
  EXPECT_GT(certain, affordable(2000));
  EXPECT_GT(far, affordable(100));
  EXPECT_GT(near, affordable(20));
}

TEST(FastHierarchyRays, MeetTrianglesBetweenTheirParametersAtAnyMagnitude) {
  Random random(812);
  int certain = 0, met = 0;
  for (std::uint64_t i = 0; i < search_trials(1500); ++i) {
    const Aim aim = random_aim(random);
    scene::Scene scene;
    for (std::uint32_t k = 0; k < fast::kWidth; ++k) {
      for (int corner = 0; corner < 3; ++corner)
        scene.points.push_back(point_about(random, aim.target, aim.off));
      scene.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    const fast::TriangleBlock block = fast::make_triangle_block(scene, first_faces());
    const fast::RayProbe probe = fast::probe_ray(block, beam_of_ray(aim.ray));
    const RationalPoint p = rational(aim.ray.origin), d = rational(aim.ray.direction);
    for (std::uint32_t lane = 0; lane < fast::kWidth; ++lane) {
      const auto t = on_triangle(scene, lane, p, d, false);
      const auto has = [lane](std::uint32_t bits) { return (bits >> lane & 1) != 0; };
      const std::string text = "trial " + std::to_string(i) + ", triangle " + std::to_string(lane);
      if (!t || (t->to && *t->to <= 0)) {
        ASSERT_FALSE(has(probe.certain)) << text;
        continue;
      }
      ++met;
      ASSERT_TRUE(has(probe.possible)) << text;
      const Rational from = t->from && *t->from > 0 ? *t->from : Rational(0);
      ASSERT_TRUE(at_most(probe.lo[lane], from)) << text;
      if (!has(probe.certain)) continue;
      ++certain;
      ASSERT_TRUE(at_least(probe.hi[lane], from)) << text;
    }
  }
  std::printf("%d triangles met, %d for certain\n", met, certain);
  EXPECT_GT(certain, affordable(200));
}

namespace {

std::uint32_t first_hit_by_exact_tier(const scene::Scene& scene, const scene::RayQuery& ray) {
  const fast::ExactFaces faces{exact::blocks, exact::faces_away, exact::meets, exact::compare_hits};
  std::uint32_t face = 0;
  fast::Hierarchy(scene).first_hits_exact(faces, {&ray, 1}, {&face, 1});
  return face;
}

}  // namespace

// Found by a fuzz target: the square of the large ball's radius over that of the direction is beyond floats.
TEST(FastHierarchyRays, ALargeBallBehindASmallOneIsNotFirst) {
  scene::Scene scene;
  scene.balls = {{{-0x1p+40, 0x1.668c08p-128, -0x1.0000fcp-125}, 0x1p+40},
                 {{0, 0x1.fc02p-134, 0x1.14p-125}, 0},
                 {{0, 0, 0x1.555cp-135}, 0x1.7f1c76p-117}};
  const scene::RayQuery ray{{0x1.7d8cp-25, 0, 0}, {-0x1.7d8cp-25, 0, 0}, 1};
  EXPECT_EQ(exact::first_hit_by_all_faces(scene, ray).faces, std::vector<std::uint32_t>{2});
  EXPECT_EQ(first_hit_by_exact_tier(scene, ray), 2u);
}

TEST(FastHierarchyRays, FirstHitsAreThoseOfExactPredicatesAtAnyMagnitude) {
  Random random(813);
  int hits = 0, of_own = 0;
  for (std::uint64_t i = 0; i < search_trials(4000); ++i) {
    scene::Scene scene;
    Aim aim = random_aim(random);
    for (int k = random.between(1, 12); k > 0; --k) {
      if (random.chance(30)) aim.off = random_aim(random).off;
      if (random.chance(30)) aim.target = point_about(random, aim.ray.origin, aim.off);
      if (random.chance(60)) {
        scene.balls.push_back(
            {point_about(random, aim.target, aim.off), std::abs(about(random, 2 * aim.off))});
      } else {
        const auto first = static_cast<std::uint32_t>(scene.points.size());
        for (int corner = 0; corner < 3; ++corner)
          scene.points.push_back(point_about(random, aim.target, aim.off));
        scene.triangles.push_back({first, first + 1, first + 2});
      }
    }
    if (random.chance(30))
      aim.ray.own = static_cast<std::uint32_t>(random.below(static_cast<int>(scene.face_count())));
    const std::vector<std::uint32_t> truth = exact::first_hit_by_all_faces(scene, aim.ray).faces;
    const std::uint32_t face = first_hit_by_exact_tier(scene, aim.ray);
    if (truth.empty()) {
      ASSERT_EQ(face, scene::kNoFace) << "trial " << i;
      continue;
    }
    ++hits;
    of_own += truth.front() == aim.ray.own ? 1 : 0;
    ASSERT_TRUE(std::find(truth.begin(), truth.end(), face) != truth.end()) << "trial " << i;
  }
  std::printf("%d of the rays meet something, %d their own ball first\n", hits, of_own);
  EXPECT_GT(hits, affordable(1500));
  EXPECT_GT(of_own, affordable(20));
}

}  // namespace gnomon::tests
