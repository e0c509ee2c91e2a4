// SPDX-License-Identifier: GPL-3.0-or-later
// A second reference for `shaft-candidates` and `patch-pair`: convex combinations of corners, as linear
// programs in rationals, and the nearest point of a hull by the conditions that make it one. No separating
// directions, no s, no filter.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/box.h"
#include "scene/patch_pair.h"
#include "tests/exact_simplex.h"
#include "tests/shadow_by_definition.h"
#include "tests/shaft_rational_reference.h"

namespace gnomon::tests {

using Points = std::vector<Rational3>;

/// Weights of points and of others such that both have one weighted mean in common.
inline ExactSimplex common_point(const Points& points, const Points& others) {
  std::vector<ExactSimplex::Row> rows(5, ExactSimplex::Row(points.size() + others.size() + 1, 0));
  for (std::size_t j = 0; j < points.size() + others.size(); ++j) {
    const bool first = j < points.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rows[axis][j] = first ? points[j][axis] : mpq_class(-others[j - points.size()][axis]);
    }
    rows[first ? 3 : 4][j] = 1;
  }
  rows[3].back() = rows[4].back() = 1;
  return ExactSimplex(std::move(rows));
}

inline Points triangle_points(const scene::Scene& scene, std::uint32_t face) {
  return {rational(scene.corner(face, 0)), rational(scene.corner(face, 1)), rational(scene.corner(face, 2))};
}

inline bool meets_shaft_by_definition(const scene::Scene& scene, std::uint32_t face,
                                      const scene::Box<double>& a, const scene::Box<double>& b) {
  if (face >= scene.triangles.size()) {
    return refer_by_brute_force(scene::ShaftBallCase{a, b, scene.balls[face - scene.triangles.size()]})
               .truth != scene::Category::outside;
  }
  Points corners;
  for (const scene::Box<double>* box : {&a, &b}) {
    for (int corner = 0; corner < 8; ++corner) {
      Rational3 p;
      for (int axis = 0; axis < 3; ++axis) {
        p[static_cast<std::size_t>(axis)] = corner >> axis & 1 ? box->hi(axis) : box->lo(axis);
      }
      corners.push_back(p);
    }
  }
  return common_point(corners, triangle_points(scene, face)).feasible();
}

inline Points corners_of(const scene::PatchPair& pair) {
  Points corners;
  for (const scene::Patch* patch : {&pair.a, &pair.b}) {
    for (const auto& p : patch->corners) corners.push_back(rational(p));
  }
  return corners;
}

/// How some points lie to the segments between two patches.
enum class Between : std::uint8_t { apart, at_patches, within };

/// `within`: some mean of the points is one of both patches' corners in which either patch has a weight. As
/// the means make a convex set, that is so when the greatest weights of both are positive.
inline Between between(const Points& points, const Points& patches) {
  const ExactSimplex program = common_point(patches, points);
  if (!program.feasible()) return Between::apart;
  std::vector<mpq_class> of_a(6 + points.size(), 0), of_b = of_a;
  for (std::size_t k = 0; k < 3; ++k) of_a[k] = of_b[k + 3] = 1;
  return program.greatest(of_a) > 0 && program.greatest(of_b) > 0 ? Between::within : Between::at_patches;
}

/// The point of the affine hull of some points that is nearest to 0, by its equations: weights w of sum 1,
/// and x * v_i the same for all. Empty when the weights are not unique, or one is negative.
inline std::optional<Rational3> foot_of_origin(const Points& v) {
  const std::size_t n = v.size();
  std::vector<std::vector<mpq_class>> rows(n + 1, std::vector<mpq_class>(n + 2, 0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = scalar_product(v[i], v[j]);
    rows[i][n] = rows[n][i] = 1;
  }
  rows[n][n + 1] = 1;
  for (std::size_t column = 0; column <= n; ++column) {
    std::size_t pivot = column;
    while (pivot <= n && rows[pivot][column] == 0) ++pivot;
    if (pivot > n) return std::nullopt;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t i = 0; i <= n; ++i) {
      if (i == column || rows[i][column] == 0) continue;
      const mpq_class by = rows[i][column] / rows[column][column];
      for (std::size_t j = column; j <= n + 1; ++j) rows[i][j] -= by * rows[column][j];
    }
  }
  Rational3 x{0, 0, 0};
  for (std::size_t i = 0; i < n; ++i) {
    const mpq_class weight = rows[i][n + 1] / rows[i][i];
    if (weight < 0) return std::nullopt;
    x = x + weight * v[i];
  }
  return x;
}

/// The point of the hull of some points that is nearest to 0: x with x * v_i >= x * x for all of them, which
/// is a mean of at most four.
inline Rational3 nearest_to_origin(const Points& v) {
  for (unsigned subset = 1; subset < 1u << v.size(); ++subset) {
    if (__builtin_popcount(subset) > 4) continue;
    Points chosen;
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (subset >> i & 1) chosen.push_back(v[i]);
    }
    const std::optional<Rational3> x = foot_of_origin(chosen);
    if (!x) continue;
    const mpq_class square = scalar_product(*x, *x);
    const auto keeps_off = [&](const Rational3& p) { return scalar_product(*x, p) >= square; };
    if (std::all_of(v.begin(), v.end(), keeps_off)) return *x;
  }
  throw std::logic_error("a hull without a nearest point");
}

/// How a face lies to the segments between the patches; balls that only touch from outside are `at_patches`
/// when they do so at a patch.
inline Between face_between(const scene::Scene& scene, std::uint32_t face, const scene::PatchPair& pair) {
  Points patches = corners_of(pair);
  if (face < scene.triangles.size()) return between(triangle_points(scene, face), patches);
  const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
  const Rational3 centre = rational(ball.centre);
  Points seen;
  for (const Rational3& p : patches) seen.push_back(p - centre);
  const Rational3 nearest = nearest_to_origin(seen);
  const mpq_class radius(ball.radius);
  const mpq_class beyond = scalar_product(nearest, nearest) - radius * radius;
  if (beyond != 0) return beyond < 0 ? Between::within : Between::apart;
  return between({nearest + centre}, patches);
}

inline bool hides_by_definition(const scene::Scene& scene, std::uint32_t face, const scene::PatchPair& pair) {
  const Points patches = corners_of(pair);
  const auto normal = [&](std::size_t patch) {
    const Rational3& o = patches[3 * patch];
    return vector_product(patches[3 * patch + 1] - o, patches[3 * patch + 2] - o);
  };
  for (std::size_t patch = 0; patch < 2; ++patch) {
    const Rational3 n = normal(patch);
    const auto height = [&](const Rational3& p) -> mpq_class {
      return scalar_product(n, p - patches[3 * patch]);
    };
    const int side = sgn(height(patches[3 * (1 - patch)]));
    for (std::size_t k = 0; k < 3; ++k) {
      if (side == 0 || sgn(height(patches[3 * (1 - patch) + k])) != side) return false;
    }
    if (face < scene.triangles.size()) {
      for (const Rational3& p : triangle_points(scene, face)) {
        if (sgn(height(p)) != side) return false;
      }
    } else {
      const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
      const mpq_class h = height(rational(ball.centre)), r(ball.radius);
      if (sgn(h) != side || h * h <= r * r * scalar_product(n, n)) return false;
    }
  }
  for (const auto& p : pair.a.corners) {
    for (const auto& q : pair.b.corners) {
      const Definition definition(scene, RationalPath(scene::ShadowQuery{p, q}));
      if (definition.meeting(face) <= Meeting::end) return false;
    }
  }
  return true;
}

inline scene::PairVisibility pair_by_definition(const scene::Scene& scene, const scene::PatchPair& pair) {
  bool blocked = false, hidden = false;
  for (std::uint32_t face = 0; face < scene.face_count(); ++face) {
    if (face == pair.a.face || face == pair.b.face) continue;
    blocked = blocked || face_between(scene, face, pair) == Between::within;
    hidden = hidden || hides_by_definition(scene, face, pair);
  }
  if (!blocked) return scene::PairVisibility::all;
  return hidden ? scene::PairVisibility::none : scene::PairVisibility::part;
}

}  // namespace gnomon::tests
