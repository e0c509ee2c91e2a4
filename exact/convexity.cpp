// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/convexity.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "exact/vector.h"

// Why this is enough. Let o be the mean of four corners that span space, which lies strictly inside the body
// when there is one. Seen from o, the triangles are
//   (1) all counterclockwise and not edge-on, as o is strictly behind each one's plane,
//   (2) closed: each edge has a triangle on either side, by (1) on opposite sides of the plane through o.
// So they cover the sphere of directions the same number of times everywhere, corners aside (where a
// covering may branch, as a pentagram's does), and
//   (3) a ray from o through the inside of one triangle that meets no other shows that this number is one.
// The triangles then bound a body that is star-shaped as seen from o, and there is but one of it: parts that
// don't hang together would each cover the sphere. With
//   (4) no edge reflex
// its angles at corners are spherical polygons without reflex angles, hence convex, and a connected closed
// set that is convex locally is convex (Tietze and Nakajima 1928). (2) to (4) are the checks of Mehlhorn,
// Naher, Seel, Seidel, Schilz, Schirra and Uhrig, "Checking geometric programs or verification of geometric
// structures" (Computational Geometry 12, 1999), there for simplicial hulls. Coplanar neighbours can't be
// folded over each other: o is strictly behind both.

namespace gnomon::exact {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Triangles = std::span<const Corners>;
using Points = std::vector<std::array<double, 3>>;

/// The sides of a triangle's plane, outward from where its corners turn counterclockwise.
template <class FT>
class Plane {
 public:
  Plane(const Points& points, const Corners& t)
      : corner_(points[t[0]]),
        normal_(cross(between<FT>(corner_, points[t[1]]), between<FT>(corner_, points[t[2]]))) {}

  [[nodiscard]] Sign side(const std::array<double, 3>& p) const {
    return sign_of(dot(normal_, between<FT>(corner_, p)));
  }

 private:
  std::array<double, 3> corner_;
  Vector<FT> normal_;
};

/// The side of one plane that a point is on, in exact numbers where intervals can't tell. Never unknown.
Sign side_of(const Points& points, const Corners& t, std::uint32_t p) {
  const Sign sign = Plane<FilterKernel::FT>(points, t).side(points[p]);
  return sign != Sign::unknown ? sign : Plane<ExactKernel::FT>(points, t).side(points[p]);
}

/// A side of a triangle, by the lesser and the greater point; the triangle's third corner stays in reach.
struct Edge {
  std::uint32_t low, high;
  std::uint32_t triangle;
  std::uint8_t first;  ///< the triangle's corner that the edge starts at
  bool upward;         ///< it runs from low to high

  friend bool operator<(const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.upward, a.triangle) < std::tie(b.low, b.high, b.upward, b.triangle);
  }
};

std::vector<Edge> edges_of(Triangles triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint8_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[t][k], to = triangles[t][(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Each edge is in exactly two triangles, in opposite directions. Edges are sorted, downward ones first: of
/// four with the same ends, the first two run the same way.
bool are_closed(const std::vector<Edge>& edges) {
  if (edges.size() % 2 != 0) return false;
  const auto same_ends = [](const Edge& a, const Edge& b) { return a.low == b.low && a.high == b.high; };
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    if (!same_ends(edges[i], edges[i + 1]) || edges[i].upward || !edges[i + 1].upward) return false;
  }
  return true;
}

/// Corners of the triangles that span space; none when all lie in one plane or the first is degenerate.
std::optional<std::array<std::uint32_t, 4>> spanning_corners(const Points& points, Triangles triangles) {
  const Corners& base = triangles.front();
  for (const Corners& t : triangles) {
    for (const std::uint32_t p : t) {
      if (side_of(points, base, p) != Sign::zero) return {{base[0], base[1], base[2], p}};
    }
  }
  return std::nullopt;
}

/// True when the mean of the four corners, which span space, is strictly behind the triangle's plane. Where
/// one of them is in front, the triangles bound no convex body: false as well. They are not all in the plane
/// unless the triangle has none.
template <class FT>
std::optional<bool> is_behind(const Points& points, const Corners& t,
                              const std::array<std::uint32_t, 4>& corners) {
  const Plane<FT> plane(points, t);
  bool behind = false;
  for (const std::uint32_t p : corners) {
    const Sign sign = plane.side(points[p]);
    if (sign == Sign::unknown) return std::nullopt;
    if (sign == Sign::positive) return false;
    behind |= sign == Sign::negative;
  }
  return behind;
}

/// The ray from o, the mean of four corners, through the centroid of a triangle. Everything is twelve times
/// as large, so that nothing is divided.
template <class FT>
class Ray {
 public:
  Ray(const Points& points, const std::array<std::uint32_t, 4>& corners, const Corners& t)
      : points_(points), origin_(sum(corners, 3)), direction_(minus(sum(t, 4), origin_)) {}

  /// True when the ray meets the closed triangle, which turns counterclockwise as seen from behind the ray.
  [[nodiscard]] std::optional<bool> meets(const Corners& t) const {
    const std::array<Vector<FT>, 3> v{from_origin(t[0]), from_origin(t[1]), from_origin(t[2])};
    bool unknown = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Sign sign = sign_of(dot(direction_, cross(v[k], v[(k + 1) % 3])));
      if (sign == Sign::negative) return false;
      unknown |= sign == Sign::unknown;
    }
    if (unknown) return std::nullopt;
    return true;
  }

 private:
  template <std::size_t N>
  Vector<FT> sum(const std::array<std::uint32_t, N>& corners, int factor) const {
    Vector<FT> total{FT(0), FT(0), FT(0)};
    for (const std::uint32_t p : corners) {
      for (std::size_t k = 0; k < 3; ++k) total[k] = total[k] + FT(points_[p][k]);
    }
    for (FT& x : total) x = x * FT(factor);
    return total;
  }
  [[nodiscard]] Vector<FT> from_origin(std::uint32_t p) const {
    return minus(sum(std::array{p}, 12), origin_);
  }

  static Vector<FT> minus(const Vector<FT>& p, const Vector<FT>& q) {
    return {FT(p[0] - q[0]), FT(p[1] - q[1]), FT(p[2] - q[2])};
  }

  const Points& points_;
  Vector<FT> origin_, direction_;
};

bool is_met_once(const Points& points, Triangles triangles, const std::array<std::uint32_t, 4>& corners) {
  const Ray<FilterKernel::FT> ray(points, corners, triangles.front());
  std::optional<Ray<ExactKernel::FT>> exact_ray;
  for (const Corners& t : triangles.subspan(1)) {
    std::optional<bool> met = ray.meets(t);
    if (!met) {
      if (!exact_ray) exact_ray.emplace(points, corners, triangles.front());
      met = exact_ray->meets(t);
    }
    if (*met) return false;
  }
  return true;
}

}  // namespace

bool is_convex(const scene::Scene& scene, const scene::Object& object) {
  if (object.face_count() == 1) return true;
  if (object.ball_count > 0 || object.triangle_count < 4) return false;
  const Triangles triangles =
      std::span(scene.triangles).subspan(object.first_triangle, object.triangle_count);
  const Points& points = scene.points;
  const std::vector<Edge> edges = edges_of(triangles);
  if (!are_closed(edges)) return false;

  const CGAL::Interval_nt<false>::Protector upward;
  const auto corners = spanning_corners(points, triangles);
  if (!corners) return false;
  for (const Corners& t : triangles) {
    std::optional<bool> behind = is_behind<FilterKernel::FT>(points, t, *corners);
    if (!behind) behind = is_behind<ExactKernel::FT>(points, t, *corners);
    if (!*behind) return false;
  }
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const Corners& neighbour = triangles[edges[i + 1].triangle];
    const std::uint32_t across = neighbour[(edges[i + 1].first + 2) % 3];
    if (side_of(points, triangles[edges[i].triangle], across) == Sign::positive) return false;
  }
  return is_met_once(points, triangles, *corners);
}

}  // namespace gnomon::exact
