// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the batch kernels share: forcing instruction sets, and batches of hard boxes and balls
// around the shafts of every distribution.
#pragma once

#include <hwy/targets.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fast/batch_types.h"
#include "fast/shaft.h"
#include "fast/slab_ball.h"
#include "fuzz/generator.h"
#include "fuzz/shapes.h"

namespace gnomon::tests {

/// Calls f(name) with each instruction set that this processor has and the library was compiled for, forced.
template <class Function>
void for_each_target(const Function& f) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    f(std::string(hwy::TargetName(target)));
  }
  hwy::SetSupportedTargetsForTest(0);
}

template <class F>
constexpr scene::Scalar kScalarOf = sizeof(F) == 4 ? scene::Scalar::f32 : scene::Scalar::f64;

/// All distributions that need no file.
inline std::vector<fuzz::DistributionChoice> file_free_distributions() {
  std::vector<fuzz::DistributionChoice> choices;
  for (const fuzz::Distribution& distribution : fuzz::distributions()) {
    if (!distribution.needs_argument) choices.push_back({&distribution, ""});
  }
  return choices;
}

template <class F>
struct BoxBatch {
  scene::Box<F> a, b;
  std::array<std::vector<F>, 6> c;

  void add(const scene::Box<F>& t) {
    for (std::size_t i = 0; i < 6; ++i) c[i].push_back(t.c[i]);
  }
  [[nodiscard]] fast::BoxesSoA<F> view() const {
    return {{c[0].data(), c[1].data(), c[2].data()}, {c[3].data(), c[4].data(), c[5].data()}, c[0].size()};
  }
};

template <class F>
struct BallBatch {
  scene::Box<F> a, b;
  std::array<std::vector<F>, 4> c;

  void add(const scene::Ball<F>& t) {
    for (std::size_t i = 0; i < 3; ++i) c[i].push_back(t.centre[i]);
    c[3].push_back(t.radius);
  }
  [[nodiscard]] fast::BallsSoA<F> view() const {
    return {{c[0].data(), c[1].data(), c[2].data()}, c[3].data(), c[0].size()};
  }
};

/// t with its near or far corner of a random plane of the shaft moved to that plane, a few ulps off.
template <class F>
scene::Box<F> at_a_plane(fuzz::CaseRandom& random, const fast::Shaft<F>& shaft, scene::Box<F> t) {
  if (shaft.plane_count == 0) return t;
  const fast::ShaftPlane<F>& plane =
      shaft.plane_set[static_cast<std::size_t>(random.below(shaft.plane_count))];
  const bool near = random.chance(0.5);
  const double share = random.below(8) == 0 ? random.below(2) : random.unit<double>();
  const int ulps = random.integer(-2, 2);
  const double af = static_cast<double>(shaft.a.c[plane.far0]),
               ag = static_cast<double>(shaft.a.c[plane.far1]);
  const double bf = static_cast<double>(shaft.b.c[plane.far0]),
               bg = static_cast<double>(shaft.b.c[plane.far1]);
  const F x = static_cast<F>(af + share * (bf - af)), y = static_cast<F>(ag + share * (bg - ag));
  const auto put = [&](fast::Face face, F to) {
    const std::size_t side = near ? fast::opposite(face) : face, other = near ? face : fast::opposite(face);
    if (!std::isfinite(to)) return;
    t.c[side] = to;
    if (fast::is_max(static_cast<fast::Face>(side)) == (t.c[other] > to)) t.c[other] = to;
  };
  put(plane.far0, x);
  put(plane.far1, fuzz::step_ulps(y, ulps));
  return t;
}

template <class F>
BoxBatch<F> make_boxes(const fuzz::DistributionChoice& choice, std::uint64_t trial, int count) {
  const auto generator = fuzz::make_generator<scene::ShaftBoxCase>(choice, kScalarOf<F>);
  fuzz::CaseRandom random(20, 1, trial);
  const auto own = scene::converted<F>(generator->make(random));
  const fast::Shaft<F> shaft = fast::form_shaft(own.a, own.b, fast::Normals::as_formed);
  BoxBatch<F> batch{own.a, own.b, {}};
  batch.add(own.t);
  for (int i = 1; i < count; ++i) {
    fuzz::Triple<F> c = scene::converted<F>(generator->make(random));
    switch (random.below(5)) {
      case 0:  // the same t, moved by ulps
        c.t = own.t;
        for (F& x : c.t.c) x = fuzz::step_ulps(x, random.integer(-2, 2));
        break;
      case 1:  // coordinates shared with the shaft
        for (std::size_t k = 0; k < 6; ++k) {
          const F pool[] = {own.a.c[k % 3], own.a.c[k % 3 + 3], own.b.c[k % 3], own.b.c[k % 3 + 3], c.t.c[k]};
          c.t.c[k] = pool[random.below(5)];
        }
        break;
      case 2:
        c.t = at_a_plane(random, shaft, c.t);
        break;
      case 3:
        c.t = at_a_plane(random, shaft, own.t);
        break;
      default:
        break;
    }
    for (int axis = 0; axis < 3; ++axis) fuzz::set_axis(c.t, axis, c.t.lo(axis), c.t.hi(axis));
    batch.add(c.t);
  }
  return batch;
}

/// The radius at which a ball around p touches the shaft from outside, or (p within) one of its sides from
/// inside; in doubles.
template <class F>
double touching_radius(const fast::Shaft<F>& shaft, const std::array<F, 3>& p) {
  const auto a = scene::converted<double>(shaft.a), b = scene::converted<double>(shaft.b);
  std::array<double, 3> centre;
  for (std::size_t i = 0; i < 3; ++i) centre[i] = static_cast<double>(p[i]);
  const double outer = std::sqrt(fast::squared_distance_to_shaft(a, b, centre));
  if (outer > 0) return outer;
  const auto wide = fast::form_shaft(a, b, fast::Normals::unit);
  double inner = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double x = centre[static_cast<std::size_t>(axis)];
    inner = std::min({inner, x - wide.extent.lo(axis), wide.extent.hi(axis) - x});
  }
  for (const auto& plane : wide.planes()) inner = std::min(inner, -plane.value_at(centre));
  return std::max(inner, 0.0);
}

template <class F>
BallBatch<F> make_balls(const fuzz::DistributionChoice& choice, std::uint64_t trial, int count) {
  const auto generator = fuzz::make_generator<scene::ShaftBallCase>(choice, kScalarOf<F>);
  fuzz::CaseRandom random(22, 1, trial);
  const auto own = scene::converted<F>(generator->make(random));
  const fast::Shaft<F> shaft = fast::form_shaft(own.a, own.b, fast::Normals::as_formed);
  BallBatch<F> batch{own.a, own.b, {}};
  batch.add(own.t);
  for (int i = 1; i < count; ++i) {
    const auto other = scene::converted<F>(generator->make(random));
    scene::Ball<F> t = other.t;
    const int kind = random.below(6);
    if (kind == 0) {  // the same ball, moved by ulps
      t = own.t;
      for (F& x : t.centre) x = fuzz::step_ulps(x, random.integer(-1, 1));
      t.radius = fuzz::step_ulps(t.radius, random.integer(-2, 2));
    } else if (kind <= 3) {  // centres on the shaft's coordinates, edges and planes, or anywhere
      for (std::size_t k = 0; k < 3; ++k) {
        const F pool[] = {own.a.c[k], own.a.c[k + 3], own.b.c[k], own.b.c[k + 3], other.t.centre[k]};
        t.centre[k] = pool[kind == 1 ? random.below(5) : 4];
      }
      if (kind == 2 && shaft.plane_count > 0) {
        const scene::Box<F> box = at_a_plane(
            random, shaft,
            scene::Box<F>{{t.centre[0], t.centre[1], t.centre[2], t.centre[0], t.centre[1], t.centre[2]}});
        for (std::size_t k = 0; k < 3; ++k) t.centre[k] = box.c[k];
      }
      // Touching, a few ulps off, or touching a side or a point.
      const int ulps = random.integer(-3, 3);
      t.radius = fuzz::step_ulps(static_cast<F>(touching_radius(shaft, t.centre)), ulps);
      if (random.chance(0.2)) t.radius = 0;
    }
    if (!(t.radius >= 0)) t.radius = 0;
    if (!std::isfinite(t.radius)) t.radius = std::numeric_limits<F>::max();
    batch.add(t);
  }
  return batch;
}

template <class F>
std::string text_of(const scene::Ball<F>& ball) {
  char text[160];
  std::snprintf(text, sizeof text, "%a %a %a %a", static_cast<double>(ball.centre[0]),
                static_cast<double>(ball.centre[1]), static_cast<double>(ball.centre[2]),
                static_cast<double>(ball.radius));
  return text;
}

template <class F>
std::string text_of(const scene::Box<F>& box) {
  std::string text;
  char number[64];
  for (const F x : box.c) {
    std::snprintf(number, sizeof number, "%a ", static_cast<double>(x));
    text += number;
  }
  return text;
}

}  // namespace gnomon::tests
