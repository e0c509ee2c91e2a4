// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/segment_contact.h"

#include <algorithm>
#include <array>

namespace gnomon::reports {

namespace {

using Vector = std::array<mpq_class, 3>;

Vector between(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  Vector v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = mpq_class(to[i]) - mpq_class(from[i]);
  return v;
}
Vector cross(const Vector& a, const Vector& b) {
  return {mpq_class(a[1] * b[2] - a[2] * b[1]), mpq_class(a[2] * b[0] - a[0] * b[2]),
          mpq_class(a[0] * b[1] - a[1] * b[0])};
}
mpq_class dot(const Vector& a, const Vector& b) {
  return mpq_class(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

}  // namespace

std::optional<mpq_class> plane_parameter(const scene::Scene& scene, std::uint32_t triangle,
                                         const scene::ShadowQuery& query) {
  const std::array<double, 3> a = scene.corner(triangle, 0);
  const Vector normal = cross(between(a, scene.corner(triangle, 1)), between(a, scene.corner(triangle, 2)));
  const mpq_class slope = dot(normal, between(query.point, query.light));
  if (slope == 0) return std::nullopt;
  return mpq_class(dot(normal, between(query.point, a)) / slope);
}

NearestToCentre nearest_to_centre(const scene::Ball<double>& ball, const scene::ShadowQuery& query) {
  const Vector along = between(query.point, query.light);
  Vector to_centre = between(query.point, ball.centre);
  NearestToCentre nearest;
  const mpq_class length = dot(along, along);
  if (length != 0) {
    nearest.parameter = dot(to_centre, along) / length;
    nearest.parameter = std::clamp(nearest.parameter, mpq_class(0), mpq_class(1));
  }
  for (std::size_t i = 0; i < 3; ++i) to_centre[i] -= nearest.parameter * along[i];
  nearest.squared_gap = dot(to_centre, to_centre) - mpq_class(ball.radius) * mpq_class(ball.radius);
  return nearest;
}

}  // namespace gnomon::reports
