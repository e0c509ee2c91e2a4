// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/shadow_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/hierarchy.h"
#include "fuzz/camera.h"
#include "fuzz/lights.h"
#include "fuzz/surface_sampler.h"
#include "fuzz/vectors.h"

namespace gnomon::reports {
namespace {

using fuzz::Vector3;
using scene::Shadow;

constexpr Colour kBackground{205, 215, 228};

std::uint8_t byte_of(double linear) {
  // The power that sRGB is close to.
  return static_cast<std::uint8_t>(std::lround(255 * std::pow(std::clamp(linear, 0.0, 1.0), 1 / 2.2)));
}

/// |cos| of the angle between the surface and the ray: shape without any light, so that faces in shadow can
/// be told apart.
double turned_to(const scene::Scene& scene, std::uint32_t face, const Vector3& point, const Vector3& ray) {
  Vector3 normal;
  if (face < scene.triangles.size()) {
    const Vector3& a = scene.corner(face, 0);
    normal =
        fuzz::cross_product(fuzz::minus(scene.corner(face, 1), a), fuzz::minus(scene.corner(face, 2), a));
  } else {
    normal = fuzz::minus(point, scene.balls[face - scene.triangles.size()].centre);
  }
  return std::fabs(fuzz::dot_product(fuzz::unit_of(normal), fuzz::unit_of(ray)));
}

/// What is wrong with a pixel.
struct Errors {
  bool false_lit = false, false_shadowed = false, wrong_reason = false, undecided = false, touching = false;

  void add(const exact::ShadowTruth& truth, fuzz::Answer answer) {
    if (answer == static_cast<fuzz::Answer>(truth.answer)) return;
    if (truth.touching) {
      touching = true;
    } else if (answer >= fuzz::kUndecided) {
      undecided = true;
    } else if (answer == static_cast<fuzz::Answer>(Shadow::lit)) {
      false_lit = true;
    } else {
      (truth.answer == Shadow::lit ? false_shadowed : wrong_reason) = true;
    }
  }

  /// Counts the pixel; its colour, or `otherwise` when nothing is wrong.
  [[nodiscard]] Colour count(WrongPixels& wrong, const Colour& otherwise) const {
    ++wrong.seen;
    if (false_lit) return ++wrong.false_lit, kFalseLit;
    if (false_shadowed) return ++wrong.false_shadowed, kFalseShadowed;
    if (wrong_reason) return ++wrong.wrong_reason, kWrongReason;
    if (undecided) return ++wrong.undecided, kUndecided;
    if (touching) return ++wrong.touching, kTouching;
    return otherwise;
  }
};

/// Warm where light falls, cold in shadow.
Colour shade(double lit, double turned) {
  const double ambient = 0.16 * (0.25 + 0.75 * turned), light = 0.78 * lit * (0.35 + 0.65 * turned);
  return {byte_of(0.9 * ambient + light), byte_of(0.95 * ambient + 0.96 * light),
          byte_of(1.2 * ambient + 0.86 * light)};
}

Colour grey(double lit, double turned) {
  const std::uint8_t level = byte_of(0.35 + 0.45 * (0.15 + 0.85 * lit) * (0.4 + 0.6 * turned));
  return {level, level, level};
}

class Painter {
 public:
  Painter(const scene::Scene& scene, const fuzz::SceneMethod& method, std::size_t columns, std::size_t rows)
      : scene_(scene),
        camera_(*scene.view, columns, rows),
        lights_(fuzz::light_points(scene)),
        truth_(scene),
        caster_(method.make(scene)) {
    picture_.shadows = {columns, rows, std::vector<Colour>(columns * rows, kBackground)};
    picture_.errors = {columns, rows, std::vector<Colour>(columns * rows, Colour{255, 255, 255})};
  }

  ShadowPicture paint(const std::function<void(double)>& on_progress) {
    for (std::size_t row = 0; row < camera_.rows(); ++row) {
      paint_row(row);
      on_progress(static_cast<double>(row + 1) / static_cast<double>(camera_.rows()));
    }
    return std::move(picture_);
  }

 private:
  struct Seen {
    std::size_t pixel;
    double turned;
  };

  void paint_row(std::size_t row) {
    seen_.clear();
    queries_.clear();
    for (std::size_t column = 0; column < camera_.columns(); ++column) {
      const scene::RayQuery ray = camera_.ray(column, row);
      const std::vector<std::uint32_t> faces = truth_.first_hit(ray).faces;
      if (faces.empty()) continue;
      const Vector3 point = fuzz::hit_point(scene_, faces.front(), ray);
      seen_.push_back(
          {row * camera_.columns() + column, turned_to(scene_, faces.front(), point, ray.direction)});
      for (const Vector3& light : lights_) queries_.push_back({point, light, faces.front()});
    }
    answers_.assign(queries_.size(), fuzz::kRejected);
    caster_->shadows(queries_, answers_);
    for (std::size_t i = 0; i < seen_.size(); ++i) paint_pixel(seen_[i], i * lights_.size());
  }

  void paint_pixel(const Seen& seen, std::size_t first) {
    Errors errors;
    double said = 0, truly = 0;
    for (std::size_t k = first; k < first + lights_.size(); ++k) {
      const exact::ShadowTruth truth = truth_.shadow(queries_[k]);
      errors.add(truth, answers_[k]);
      said += answers_[k] >= fuzz::kUndecided                         ? 0.5
              : answers_[k] == static_cast<fuzz::Answer>(Shadow::lit) ? 1
                                                                      : 0;
      truly += truth.answer == Shadow::lit ? 1 : 0;
    }
    const double count = static_cast<double>(lights_.size());
    picture_.shadows.colours[seen.pixel] = shade(said / count, seen.turned);
    picture_.errors.colours[seen.pixel] = errors.count(picture_.wrong, grey(truly / count, seen.turned));
  }

  const scene::Scene& scene_;
  fuzz::Camera camera_;
  std::vector<Vector3> lights_;
  exact::Hierarchy truth_;
  std::unique_ptr<fuzz::SceneCaster> caster_;
  ShadowPicture picture_;
  std::vector<Seen> seen_;  // of one row
  std::vector<scene::ShadowQuery> queries_;
  std::vector<fuzz::Answer> answers_;
};

}  // namespace

ShadowPicture draw_shadows(const scene::Scene& scene, const fuzz::SceneMethod& method, std::size_t columns,
                           std::size_t rows, const std::function<void(double)>& on_progress) {
  return Painter(scene, method, columns, rows).paint(on_progress);
}

}  // namespace gnomon::reports
