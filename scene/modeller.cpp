// SPDX-License-Identifier: MIT
#include "scene/modeller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/turn.h"

namespace gnomon::scene {
namespace {

double to_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

}  // namespace

void Modeller::object(std::string name, Shape shape, double transmittance) {
  builder_.begin_object(std::move(name), transmittance, true);
  scene().objects.back().declared_convex = shape == Shape::convex;
  shape_ = shape;
}

double Modeller::on_lattice(double x) const {
  // The sum with 0 makes one zero of two.
  return to_float(std::floor(x / step_ + 0.5) * step_) + 0.0;
}

Point3 Modeller::on_lattice(const Point3& p) const {
  return {on_lattice(p[0]), on_lattice(p[1]), on_lattice(p[2])};
}

Point3 Modeller::placed(const Point3& p) const {
  return on_lattice({placement_.x + placement_.cos * p[0] - placement_.sin * p[1],
                     placement_.y + placement_.sin * p[0] + placement_.cos * p[1], placement_.z + p[2]});
}

void Modeller::quadrangle(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  builder_.add_triangle(a, b, c);
  builder_.add_triangle(a, c, d);
}

void Modeller::cap(const std::vector<Point3>& polygon) {
  if (shape_ == Shape::concave) {
    (void)builder_.add_polygon(polygon);
    return;
  }
  for (std::size_t k = 2; k < polygon.size(); ++k)
    builder_.add_triangle(polygon[0], polygon[k - 1], polygon[k]);
}

void Modeller::loft_placed(std::span<const std::vector<Point3>> rings) {
  for (std::size_t r = 1; r < rings.size(); ++r) {
    const std::vector<Point3>&below = rings[r - 1], &above = rings[r];
    for (std::size_t k = 0; k < below.size(); ++k) {
      const std::size_t next = k + 1 == below.size() ? 0 : k + 1;
      quadrangle(below[k], below[next], above[next], above[k]);
    }
  }
  cap({rings.front().rbegin(), rings.front().rend()});
  cap(rings.back());
}

void Modeller::loft(std::span<const std::vector<Point3>> rings) {
  std::vector<std::vector<Point3>> all(rings.begin(), rings.end());
  for (std::vector<Point3>& ring : all) {
    for (Point3& p : ring) p = placed(p);
  }
  loft_placed(all);
}

void Modeller::box(const Point3& lo, const Point3& hi) {
  const Point2 outline[] = {{lo[0], lo[1]}, {hi[0], lo[1]}, {hi[0], hi[1]}, {lo[0], hi[1]}};
  Point3 p[8];
  for (std::size_t k = 0; k < 4; ++k) {
    p[k] = placed({outline[k][0], outline[k][1], lo[2]});
    p[k + 4] = {p[k][0], p[k][1], placed({0, 0, hi[2]})[2]};
  }
  for (std::size_t k = 0; k < 4; ++k) quadrangle(p[k], p[(k + 1) % 4], p[(k + 1) % 4 + 4], p[k + 4]);
  quadrangle(p[3], p[2], p[1], p[0]);
  quadrangle(p[4], p[5], p[6], p[7]);
}

void Modeller::meshed_box(const Point3& lo, const Point3& hi, const std::array<std::uint32_t, 3>& cells) {
  const auto at = [&](std::size_t axis, std::uint32_t i) {
    return i == cells[axis] ? hi[axis] : lo[axis] + (hi[axis] - lo[axis]) * i / cells[axis];
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (std::uint32_t i = 0; i < cells[u]; ++i) {
      for (std::uint32_t j = 0; j < cells[v]; ++j) {
        for (const bool upper : {false, true}) {
          const auto corner = [&](std::uint32_t di, std::uint32_t dj) {
            Point3 p;
            p[axis] = upper ? hi[axis] : lo[axis];
            p[u] = at(u, i + di);
            p[v] = at(v, j + dj);
            return placed(p);
          };
          if (upper) {
            quadrangle(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
          } else {
            quadrangle(corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0));
          }
        }
      }
    }
  }
}

void Modeller::prism(std::span<const Point2> outline, double bottom, double top) {
  std::vector<std::vector<Point3>> rings(2);
  for (const Point2& p : outline) {
    rings[0].push_back(placed({p[0], p[1], bottom}));
    rings[1].push_back(placed({p[0], p[1], top}));
  }
  loft_placed(rings);
}

void Modeller::pyramid(std::span<const Point2> outline, double bottom, const Point3& apex) {
  std::vector<Point3> base;
  for (const Point2& p : outline) base.push_back(placed({p[0], p[1], bottom}));
  for (std::size_t k = 0; k < base.size(); ++k) {
    builder_.add_triangle(base[k], base[(k + 1) % base.size()], placed(apex));
  }
  std::ranges::reverse(base);
  cap(base);
}

void Modeller::tetrahedron(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Point3 p = placed(a), q = placed(b), r = placed(c), s = placed(d);
  builder_.add_triangle(p, q, r);
  builder_.add_triangle(p, r, s);
  builder_.add_triangle(p, s, q);
  builder_.add_triangle(q, s, r);
}

void Modeller::turned(std::span<const Point2> profile, std::uint32_t sides) {
  std::vector<std::vector<Point3>> rings(profile.size());
  for (std::size_t r = 0; r < profile.size(); ++r) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      const Direction d = turn(k, sides);
      rings[r].push_back(placed({profile[r][0] * d.cos, profile[r][0] * d.sin, profile[r][1]}));
    }
  }
  loft_placed(rings);
}

void Modeller::ball(const Point3& centre, double radius) {
  Point3 c = placed(centre);
  builder_.add_ball({c, on_lattice(radius)});
}

void Modeller::ceiling_light(const Point2& lo, const Point2& hi, double height) {
  scene().polygon_lights.push_back(
      {{on_lattice({lo[0], lo[1], height}), on_lattice({lo[0], hi[1], height}),
        on_lattice({hi[0], hi[1], height}), on_lattice({hi[0], lo[1], height})}});
  // The mean of the corners as they are: one more bit, and so a float.
  const std::vector<Point3>& corners = scene().polygon_lights.back().corners;
  scene().point_lights.push_back(
      {{(corners[0][0] + corners[2][0]) / 2, (corners[0][1] + corners[2][1]) / 2, corners[0][2]}});
}

void Modeller::view(const Point3& from, const Point3& at, double angle) {
  scene().view = View{on_lattice(from), on_lattice(at), {0, 0, 1}, angle, 0.0625, 512, 512};
}

std::vector<Point2> regular_polygon(std::uint32_t corners, double radius, bool side_first) {
  std::vector<Point2> polygon;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const Direction d = turn(2 * k + (side_first ? 1 : 0), 2 * corners);
    polygon.push_back({radius * d.cos, radius * d.sin});
  }
  return polygon;
}

}  // namespace gnomon::scene
