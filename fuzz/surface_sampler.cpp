// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/surface_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fuzz/triangle_sample.h"

namespace gnomon::fuzz {

SurfaceSampler::SurfaceSampler(const scene::Scene& scene) : scene_(scene) {
  sums_.reserve(scene.face_count());
  double sum = 0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const Vector3 normal = cross_product(minus(scene.corner(t, 1), scene.corner(t, 0)),
                                         minus(scene.corner(t, 2), scene.corner(t, 0)));
    sums_.push_back(sum += 0.5 * length_of(normal));
  }
  for (const scene::Ball<double>& ball : scene.balls) {
    sums_.push_back(sum += 4 * std::numbers::pi * ball.radius * ball.radius);
  }
}

std::uint32_t SurfaceSampler::face_at(double share) const {
  const auto at = std::upper_bound(sums_.begin(), sums_.end(), share * sums_.back());
  const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(sums_.size()) - 1;
  return static_cast<std::uint32_t>(std::min(at - sums_.begin(), last));
}

SurfacePoint SurfaceSampler::point_on(std::uint32_t face, CaseRandom& random) const {
  if (face < scene_.triangles.size()) {
    return {as_floats(point_in_triangle(scene_.corner(face, 0), scene_.corner(face, 1),
                                        scene_.corner(face, 2), random)),
            face};
  }
  const scene::Ball<double>& ball = scene_.balls[face - scene_.triangles.size()];
  // Uniform on the sphere: the height is (Archimedes). Trigonometry differs between libraries, so the angle's
  // direction is drawn by rejection.
  const double z = random.between(-1.0, 1.0), r = std::sqrt(1 - z * z);
  double x = 0, y = 0, square = 0;
  do {
    x = random.between(-1.0, 1.0);
    y = random.between(-1.0, 1.0);
    square = x * x + y * y;
  } while (!(square > 1e-6 && square <= 1));
  const double scale = r / std::sqrt(square);
  return {as_floats(along(ball.centre, {x * scale, y * scale, z}, ball.radius)), face};
}

std::array<double, 3> hit_point(const scene::Scene& scene, std::uint32_t face, const scene::RayQuery& ray) {
  const Vector3& d = ray.direction;
  double t = 0;
  if (face < scene.triangles.size()) {
    const Vector3& a = scene.corner(face, 0);
    const Vector3 normal = cross_product(minus(scene.corner(face, 1), a), minus(scene.corner(face, 2), a));
    const double slope = dot_product(normal, d);
    // A ray in the face's plane enters somewhere on its rim: a corner stands for it.
    if (slope == 0) return as_floats(a);
    t = dot_product(normal, minus(a, ray.origin)) / slope;
  } else {
    const scene::Ball<double>& ball = scene.balls[face - scene.triangles.size()];
    const Vector3 from = minus(ray.origin, ball.centre);
    const double a = dot_product(d, d), b = dot_product(from, d);
    const double c = dot_product(from, from) - ball.radius * ball.radius;
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    t = face == ray.own ? (-b + root) / a : std::max(0.0, (-b - root) / a);
  }
  // A slope of almost 0 may make the quotient infinite.
  return std::isfinite(t) ? as_floats(along(ray.origin, d, t)) : ray.origin;
}

}  // namespace gnomon::fuzz
