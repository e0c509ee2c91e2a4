// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/brute_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fuzz/float_faces.h"

namespace gnomon::fuzz {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Ray {
  Vector origin, direction;
};

/// The parameters at which a ray enters and leaves a face; NaN where it misses.
struct Span {
  float enter, leave;
};
constexpr Span kMiss{std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::quiet_NaN()};

class BruteCaster : public SceneCaster {
 public:
  explicit BruteCaster(const scene::Scene& scene) : faces_(scene) {}

  void shadows(std::span<const scene::ShadowQuery> queries, std::span<Answer> answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = static_cast<Answer>(shadow(queries[i]));
  }

  void first_hits(std::span<const scene::RayQuery> rays, std::span<std::uint32_t> faces) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) faces[i] = first_hit(rays[i]);
  }

  [[nodiscard]] std::size_t bytes() const override { return faces_.bytes(); }

  [[nodiscard]] std::optional<TestCounts> count_tests(
      std::span<const scene::ShadowQuery> queries) const override {
    TestCounts counts;
    for (const scene::ShadowQuery& query : queries) shadow(query, &counts.faces);
    return counts;
  }

  [[nodiscard]] std::optional<TestCounts> count_hit_tests(
      std::span<const scene::RayQuery> rays) const override {
    TestCounts counts;
    for (const scene::RayQuery& ray : rays) first_hit(ray, &counts.faces);
    return counts;
  }

 private:
  [[nodiscard]] std::size_t face_count() const { return faces_.triangles.size() + faces_.balls.size(); }

  [[nodiscard]] Span meet(std::size_t face, const Ray& ray) const {
    return face < faces_.triangles.size() ? meet_triangle(face, ray)
                                          : meet_ball(face - faces_.triangles.size(), ray);
  }

  [[nodiscard]] Span meet_triangle(std::size_t face, const Ray& ray) const {
    const auto& [i, j, k] = faces_.triangles[face];
    const Vector ab = faces_.points[j] - faces_.points[i], ac = faces_.points[k] - faces_.points[i];
    const Vector p = cross(ray.direction, ac);
    const float determinant = dot(ab, p);
    if (determinant == 0) return kMiss;
    const float inverse = 1 / determinant;
    const Vector from = ray.origin - faces_.points[i];
    const float u = dot(from, p) * inverse;
    if (!(u >= 0 && u <= 1)) return kMiss;
    const Vector q = cross(from, ab);
    const float v = dot(ray.direction, q) * inverse;
    if (!(v >= 0 && u + v <= 1)) return kMiss;
    const float t = dot(ac, q) * inverse;
    return {t, t};
  }

  [[nodiscard]] Span meet_ball(std::size_t ball, const Ray& ray) const {
    const Vector from = ray.origin - faces_.balls[ball].centre;
    const float a = dot(ray.direction, ray.direction), b = dot(from, ray.direction);
    const float c = dot(from, from) - faces_.balls[ball].radius * faces_.balls[ball].radius;
    const float discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return kMiss;
    const float root = std::sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
  }

  scene::Shadow shadow(const scene::ShadowQuery& query, std::uint64_t* tests = nullptr) const {
    if (faces_.faces_away(query)) return scene::Shadow::facing;
    const Vector point = to_floats(query.point);
    const Ray ray{point, to_floats(query.light) - point};
    if (faces_.own_ball_blocks(query.own, point, ray.direction)) return scene::Shadow::shadowed;
    for (std::size_t face = 0; face < face_count(); ++face) {
      if (face == query.own) continue;
      if (tests != nullptr) ++*tests;
      const Span span = meet(face, ray);
      if (span.enter < 1 && span.leave > 0) return scene::Shadow::shadowed;
    }
    return scene::Shadow::lit;
  }

  std::uint32_t first_hit(const scene::RayQuery& query, std::uint64_t* tests = nullptr) const {
    const Ray ray{to_floats(query.origin), to_floats(query.direction)};
    const bool into_own = faces_.own_ball_blocks(query.own, ray.origin, ray.direction);
    float nearest = kInfinity;
    std::uint32_t found = scene::kNoFace;
    for (std::size_t face = 0; face < face_count(); ++face) {
      if (face == query.own && !into_own) continue;
      if (tests != nullptr) ++*tests;
      const Span span = meet(face, ray);
      // A ball that the ray starts in is met at once; the own one where the ray leaves it.
      const float t = face == query.own ? span.leave : std::max(span.enter, 0.0F);
      if (!(span.leave > 0 && t < nearest)) continue;
      nearest = t;
      found = static_cast<std::uint32_t>(face);
    }
    return found;
  }

  FloatFaces faces_;
};

}  // namespace

std::unique_ptr<SceneCaster> make_brute_caster(const scene::Scene& scene) {
  return std::make_unique<BruteCaster>(scene);
}

}  // namespace gnomon::fuzz
