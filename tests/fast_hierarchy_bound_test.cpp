// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of fast/hierarchy*, from both sides: never exceeded, and not many times what occurs.
#include <gtest/gtest.h>

#include "fast/hierarchy_build.h"
#include "fast/hierarchy_leaves.h"
#include "fast/hierarchy_probe.h"
#include "tests/batch_cases.h"
#include "tests/fast_hierarchy_truth.h"
#include "tests/hard_scenes.h"
#include "tests/ray_beam.h"

namespace gnomon::tests {

namespace {

template <bool kCertified>
fast::Beam beam_of(const scene::ShadowQuery& query) {
  fast::Beam beam;
  for (std::size_t k = 0; k < 3; ++k) {
    beam.origin[k] = static_cast<float>(query.point[k]);
    beam.direction[k] = static_cast<float>(query.light[k]) - beam.origin[k];
  }
  beam.measure();
  beam.prepare<kCertified>();
  return beam;
}

/// The largest share of its bound that an error took.
struct Share {
  double most = 0;

  void add(float computed, const Rational& exact, float bound, const std::string& text) {
    const Rational off = abs(Rational(computed) - exact);
    ASSERT_LE(off, Rational(bound)) << text << ": " << computed << " is off by " << off.get_d();
    most = std::max(most, Rational(off / Rational(bound)).get_d());
  }
  void report(const char* name, double at_least) const {
    std::printf("%s: at most %.3f of its bound\n", name, most);
    testing::Test::RecordProperty(name, std::to_string(most));
    // Fewer trials find less.
    EXPECT_GT(most, kSanitized ? at_least / 3 : at_least) << name;
  }
};

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

TEST(FastHierarchyBounds, TriangleValuesStayWithinThem) {
  Share edges, third, products, normals;
  for (const HardKind kind : kHardKinds) {
    for (std::uint64_t seed = 40; seed < 43; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, 24, 0);
      const fast::HierarchyArrays arrays = fast::build_hierarchy(scene);
      for (const auto& query : hard_queries(kind, scene, seed, affordable(24))) {
        const fast::Beam beam = beam_of<true>(query);
        const RationalPoint p = rational(query.point), d = rational(query.light) - p;
        for (const fast::TriangleBlock& block : arrays.triangles) {
          const fast::TriangleProbe probe = fast::probe_triangles(block, beam);
          for (std::size_t lane = 0; lane < fast::kWidth; ++lane) {
            const RationalPoint v0 = rational(scene.corner(block.face[lane], 0));
            const RationalPoint e1 = rational(scene.corner(block.face[lane], 1)) - v0,
                                e2 = rational(scene.corner(block.face[lane], 2)) - v0;
            const RationalPoint n = cross(e1, e2), c = v0 - p, r = cross(c, d);
            const Rational u = dot(r, e2), v = -dot(r, e1), det = dot(n, d), t = dot(n, c);
            const std::string text = name_of(kind) + " " + std::to_string(seed);
            edges.add(probe.u[lane], u, probe.edge_error[lane], text + " u");
            edges.add(probe.v[lane], v, probe.edge_error[lane], text + " v");
            // The kernel holds all three against the bound of w.
            ASSERT_LE(probe.edge_error[lane], probe.w_error[lane]);
            third.add(probe.w[lane], det - u - v, probe.w_error[lane], text + " w");
            products.add(probe.t[lane], t, probe.t_error[lane], text + " t");
            normals.add(probe.d[lane], det, probe.d_error[lane], text + " d");
            products.add(probe.t[lane] - probe.d[lane], t - det, probe.t_error[lane] + probe.d_error[lane],
                         text + " t - d");
            if (HasFatalFailure()) return;
          }
        }
      }
    }
  }
  edges.report("u and v", 0.2);
  third.report("w", 0.1);
  products.report("t and t - d", 0.25);
  normals.report("d", 0.25);
}

namespace {

/// Climbs towards large shares of a bound: `share_of` some floats, moved a few at a time. The first `ones` of
/// them start a little above 1 in magnitude, where roundings are relatively largest; the others small, so
/// that differences to them are rounded.
template <std::size_t kCount, class ShareOf>
double climb(Random& random, std::size_t ones, int steps, const ShareOf& share_of) {
  std::array<double, kCount> x;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double size = i < ones ? 1 + random.unit() * 0x1p-6 : random.unit() * 0x1p-6;
    x[i] = as_float(random.chance(50) ? size : -size);
  }
  double best = share_of(x);
  for (int step = 0; step < steps; ++step) {
    auto moved = x;
    for (int moves = random.between(1, 2); moves > 0; --moves) {
      double& number = moved[static_cast<std::size_t>(random.below(kCount))];
      const int size = random.between(-30, -6);
      number = as_float(number + std::ldexp(random.unit() - 0.5, size));
    }
    const double share = share_of(moved);
    if (share >= best) {
      best = share;
      x = moved;
    }
  }
  return best;
}

}  // namespace

TEST(FastHierarchyBounds, TriangleBoundsAreNotManyTimesWhatOccurs) {
  const char* const names[] = {"u", "v", "w", "t", "d", "t - d"};
  for (int which = 0; which < 6; ++which) {
    double most = 0;
    for (std::uint64_t start = 0; start < 10; ++start) {
      Random random(1000 * start + static_cast<std::uint64_t>(which));
      const double share = climb<15>(random, 6, affordable(1000), [&](std::array<double, 15> x) {
        // Nearly equal edges: what is off in the normal's product doesn't hide what is off in the edges'.
        for (std::size_t k = 0; start % 2 != 0 && k < 3; ++k)
          x[9 + k] = as_float(x[6 + k] + x[9 + k] * 0x1p-6);
        scene::Scene scene;
        scene.points = {{x[0], x[1], x[2]}, {x[6], x[7], x[8]}, {x[9], x[10], x[11]}};
        scene.triangles = {{0, 1, 2}};
        const scene::ShadowQuery query{{x[12], x[13], x[14]}, {x[3], x[4], x[5]}};
        const fast::TriangleBlock block = fast::make_triangle_block(scene, {});
        const fast::TriangleProbe probe = fast::probe_triangles(block, beam_of<true>(query));
        const RationalPoint p = rational(query.point), d = rational(query.light) - p,
                            v0 = rational(scene.points[0]);
        const RationalPoint e1 = rational(scene.points[1]) - v0, e2 = rational(scene.points[2]) - v0;
        const RationalPoint n = cross(e1, e2), c = v0 - p, r = cross(c, d);
        const Rational u = dot(r, e2), v = -dot(r, e1), det = dot(n, d), t = dot(n, c);
        const Rational exact[] = {u, v, det - u - v, t, det, t - det};
        const float computed[] = {probe.u[0], probe.v[0], probe.w[0],
                                  probe.t[0], probe.d[0], probe.t[0] - probe.d[0]};
        const float bounds[] = {probe.edge_error[0], probe.edge_error[0],
                                probe.w_error[0],    probe.t_error[0],
                                probe.d_error[0],    probe.t_error[0] + probe.d_error[0]};
        return Rational(abs(Rational(computed[which]) - exact[which]) / Rational(bounds[which])).get_d();
      });
      most = std::max(most, share);
    }
    std::printf("%s: up to %.3f of its bound found by climbing\n", names[which], most);
    EXPECT_LE(most, 1) << names[which];
    EXPECT_GT(most, kSanitized ? 0.05 : 0.13) << names[which];
  }
}

TEST(FastHierarchyBounds, BallBoundsAreNotManyTimesWhatOccurs) {
  double most = 0;
  for (std::uint64_t start = 0; start < 6; ++start) {
    Random random(2000 + start);
    // A radius that makes the depth about 0, so that the offset's error shows; or a tiny one.
    most = std::max(
        most, climb<9>(random, 6, affordable(1000), [start](const std::array<double, 9>& x) {
          scene::Scene scene;
          scene.balls = {{{x[0], x[1], x[2]}, start % 2 == 0 ? 0.0 : 0.5}};
          const scene::ShadowQuery query{{x[3], x[4], x[5]}, {x[6], x[7], x[8]}};
          const fast::BallBlock block = fast::make_ball_block(scene, {});
          const fast::BallProbe probe = fast::probe_balls(block, beam_of<true>(query), 1);
          const RationalPoint p = rational(query.point), d = rational(query.light) - p,
                              m = rational(scene.balls[0].centre) - p;
          const Rational dd = dot(d, d);
          if (dd < Rational(0x1p-99)) return 0.0;
          Rational s = dot(m, d) / dd;
          s = s < 0 ? Rational(0) : s > 1 ? Rational(1) : s;
          const RationalPoint q{Rational(m[0] - s * d[0]), Rational(m[1] - s * d[1]),
                                Rational(m[2] - s * d[2])};
          const Rational r(scene.balls[0].radius);
          return Rational(abs(Rational(probe.depth[0]) - (r * r - dot(q, q))) / Rational(probe.error[0]))
              .get_d();
        }));
  }
  std::printf("depths: up to %.3f of its bound found by climbing\n", most);
  EXPECT_LE(most, 1);
  EXPECT_GT(most, kSanitized ? 0.1 : 0.25);
}

TEST(FastHierarchyBounds, RaysMeetFacesBetweenTheirParameters) {
  int certain = 0;
  double nearest_end = 1;  // how near to an end, as a share of the interval
  for (const HardKind kind : {HardKind::soup, HardKind::mesh, HardKind::far_mesh, HardKind::skinny}) {
    const scene::Scene scene = hard_scene(kind, 55, 24, 8);
    const fast::HierarchyArrays arrays = fast::build_hierarchy(scene);
    for (const auto& query : hard_queries(kind, scene, 55, affordable(200))) {
      const scene::RayQuery ray = ray_of(query);
      const fast::Beam beam = beam_of_ray(ray);
      const RationalPoint p = rational(ray.origin), d = rational(ray.direction);
      for (const fast::TriangleBlock& block : arrays.triangles) {
        const fast::RayProbe probe = fast::probe_ray(block, beam);
        for (std::size_t lane = 0; lane < fast::kWidth; ++lane) {
          if ((probe.certain >> lane & 1) == 0) continue;
          const auto t = on_triangle(scene, block.face[lane], p, d, false);
          ASSERT_TRUE(t.has_value() && *t->from == *t->to) << name_of(kind);
          const Rational lo(probe.lo[lane]), hi(probe.hi[lane]);
          ASSERT_TRUE(lo <= *t->from && *t->from <= hi) << name_of(kind);
          ++certain;
          const Rational room = std::min(Rational(*t->from - lo), Rational(hi - *t->from));
          nearest_end = std::min(nearest_end, Rational(room / (hi - lo)).get_d());
        }
      }
      for (const fast::BallBlock& block : arrays.balls) {
        const fast::RayProbe probe = fast::probe_ray(block, beam);
        for (std::size_t lane = 0; lane < fast::kWidth; ++lane) {
          if ((probe.certain >> lane & 1) == 0) continue;
          // The first point in the ball: none before lo, one at hi.
          const scene::Ball<double>& ball = scene.balls[block.face[lane] - scene.triangles.size()];
          const RationalPoint m = rational(ball.centre) - p;
          const auto inside = [&](const Rational& t) {
            const RationalPoint q{Rational(m[0] - t * d[0]), Rational(m[1] - t * d[1]),
                                  Rational(m[2] - t * d[2])};
            return dot(q, q) <= Rational(ball.radius) * Rational(ball.radius);
          };
          const Rational lo(probe.lo[lane]), hi(probe.hi[lane]);
          ASSERT_TRUE(lo == 0 || !inside(lo)) << name_of(kind);
          ASSERT_TRUE(inside(hi)) << name_of(kind);
        }
      }
    }
  }
  std::printf("%d parameters, at least %.3f of their interval from its ends\n", certain, nearest_end);
  EXPECT_GT(certain, 100);
  EXPECT_LT(nearest_end, 0.45);
}

TEST(FastHierarchyBounds, DepthsInBallsStayWithinThem) {
  Share segments, rays;
  for (const HardKind kind : kHardKinds) {
    for (std::uint64_t seed = 50; seed < 53; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, 8, 16);
      const fast::HierarchyArrays arrays = fast::build_hierarchy(scene);
      for (const auto& query : hard_queries(kind, scene, seed, affordable(40))) {
        const fast::Beam beam = beam_of<true>(query);
        const RationalPoint p = rational(query.point), d = rational(query.light) - p;
        const Rational dd = dot(d, d);
        if (dd < Rational(0x1p-99)) continue;
        for (const fast::BallBlock& block : arrays.balls) {
          for (const bool segment : {true, false}) {
            const fast::BallProbe probe =
                fast::probe_balls(block, beam, segment ? 1.0f : std::numeric_limits<float>::infinity());
            for (std::size_t lane = 0; lane < fast::kWidth; ++lane) {
              const scene::Ball<double>& ball = scene.balls[block.face[lane] - scene.triangles.size()];
              const RationalPoint m = rational(ball.centre) - p;
              Rational s = dot(m, d) / dd;
              if (s < 0) s = 0;
              if (segment && s > 1) s = 1;
              const RationalPoint q{Rational(m[0] - s * d[0]), Rational(m[1] - s * d[1]),
                                    Rational(m[2] - s * d[2])};
              const Rational depth = Rational(ball.radius) * Rational(ball.radius) - dot(q, q);
              (segment ? segments : rays)
                  .add(probe.depth[lane], depth, probe.error[lane], name_of(kind) + " depth");
              if (HasFatalFailure()) return;
            }
          }
        }
      }
    }
  }
  segments.report("depths on segments", 0.05);
  rays.report("depths on rays", 0.05);
}

namespace {

/// The parameters in [0, 1] at which p + t d is in child i's box grown by `more` of its distance from p.
bool meets_box(const fast::WideNode& node, std::size_t i, const RationalPoint& p, const RationalPoint& d) {
  Rational from = 0, to = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational lo = Rational(node.bounds[k][i]) - p[k], hi = Rational(node.bounds[k + 3][i]) - p[k];
    if (d[k] == 0) {
      if (lo > 0 || hi < 0) return false;
      continue;
    }
    const Rational a = (d[k] > 0 ? lo : hi) / d[k], b = (d[k] > 0 ? hi : lo) / d[k];
    if (a > from) from = a;
    if (b < to) to = b;
  }
  return from <= to;
}

}  // namespace

TEST(FastHierarchyBounds, NoBoxThatTheSegmentMeetsIsSkipped) {
  int met = 0, visited = 0, naive_skips = 0, boxes = 0;
  const auto check = [&](const fast::WideNode& node, const scene::ShadowQuery& query,
                         const std::string& text) {
    const RationalPoint p = rational(query.point), d = rational(query.light) - p;
    const std::uint32_t certified = fast::probe_boxes(node, beam_of<true>(query), 1);
    const std::uint32_t naive = fast::probe_boxes(node, beam_of<false>(query), 1);
    for (std::size_t i = 0; i < fast::kWidth; ++i) {
      if (node.bounds[0][i] > node.bounds[3][i]) {
        ASSERT_EQ(certified >> i & 1, 0u) << text;
        continue;
      }
      const bool truth = meets_box(node, i, p, d);
      ++boxes;
      met += truth;
      visited += static_cast<int>(certified >> i & 1);
      naive_skips += truth && (naive >> i & 1) == 0;
      ASSERT_TRUE(!truth || (certified >> i & 1) != 0) << text << " child " << i;
    }
  };
  for (const HardKind kind : kHardKinds) {
    for (std::uint64_t seed = 60; seed < 64; ++seed) {
      const scene::Scene scene = hard_scene(kind, seed, 40, 8);
      const fast::HierarchyArrays arrays = fast::build_hierarchy(scene);
      for (const auto& query : hard_queries(kind, scene, seed, affordable(100))) {
        for (const fast::WideNode& node : arrays.nodes) {
          check(node, query, name_of(kind));
          if (HasFatalFailure()) return;
        }
      }
    }
  }
  // Boxes at corners, sides and near misses of segments of all sizes, down to denormal ones.
  Random random(7);
  for (int trial = 0; trial < affordable(4000); ++trial) {
    const int smallest = random.between(-149, 30);
    const auto number = [&] {
      const int sign = random.chance(50) ? 1 : -1;
      return random.chance(25) ? 0
                               : sign * as_float(std::ldexp(1 + random.unit(), random.between(smallest, 38)));
    };
    scene::ShadowQuery query;
    for (std::size_t k = 0; k < 3; ++k) {
      query.point[k] = number();
      query.light[k] = random.chance(25) ? query.point[k] : number();
    }
    fast::WideNode node;
    for (std::size_t i = 0; i < fast::kWidth; ++i) {
      const double t = random.unit();
      for (std::size_t k = 0; k < 3; ++k) {
        const double on = query.point[k] + t * (query.light[k] - query.point[k]);
        const double ends[] = {query.point[k], query.light[k], as_float(on), number()};
        const double a = ends[random.below(4)], b = ends[random.below(4)];
        node.bounds[k][i] = static_cast<float>(std::min(a, b));
        node.bounds[k + 3][i] = static_cast<float>(std::max(a, b));
      }
    }
    check(node, query, "trial " + std::to_string(trial));
    if (HasFatalFailure()) return;
  }
  std::printf("of %d boxes %d met, %d visited; the naive test skips %d\n", boxes, met, visited, naive_skips);
  EXPECT_GT(naive_skips, 0);
  EXPECT_LT(visited, met + met / 4);
}

}  // namespace gnomon::tests
