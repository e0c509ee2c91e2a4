// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes with a pair of patches or boxes in hard position: shared corners and edges, duplicates of a
// patch, its plane, in front of it and behind; corners on edges and planes of the hull; tangent balls;
// degenerate faces and patches, flat boxes and points.
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scene/box.h"
#include "scene/float_text.h"
#include "scene/patch_pair.h"
#include "scene/scene_builder.h"
#include "tests/shaft_random.h"

namespace gnomon::tests {

/// What becomes of whole numbers: nothing; scaled by a power of two, as far as doubles go; turned and
/// rounded, so that all that touched does so but for an ulp; stretched along the axes, moved and rounded, so
/// that what was flat still is.
enum class Finish : std::uint8_t { grid, huge, denormal, turned, stretched };

struct PairTrial {
  scene::Scene scene;
  scene::PatchPair pair;
  scene::Box<double> a, b;
};

class PairTrials {
 public:
  using Point = std::array<double, 3>;
  using Corners = std::array<Point, 3>;

  PairTrials(std::uint64_t seed, Finish finish) : random_(seed), finish_(finish) {
    for (double& x : turn_) x = random_.unit() * 2 - 1;
  }

  PairTrial next(int faces) {
    size_ = random_.between(1, 4);
    PairTrial trial;
    Corners a = triangle(), b = triangle();
    if (random_.chance(40)) {  // one above the other
      for (std::size_t k = 0; k < 3; ++k) {
        a[k][2] = 0;
        b[k] = random_.chance(60) ? a[k] : b[k];
        b[k][2] = 4;
      }
    }
    scene::Box<double> box_a = random_.chance(50) ? box() : box_of(a),
                       box_b = random_.chance(50) ? box() : box_of(b);
    const bool in_layers = random_.chance(20);  // like shelves
    if (in_layers) {
      box_a.c[2] = box_a.c[5] = random_.chance(50) ? 0 : 8;
      box_b.c[2] = box_b.c[5] = 8 - box_a.c[2];
    }
    scene::SceneBuilder builder;
    if (random_.chance(50)) {
      add(builder, a);
      add(builder, b);
      trial.pair.a.face = 0;
      trial.pair.b.face = 1;
    }
    while (static_cast<int>(builder.scene().face_count()) < faces) {
      if (random_.chance(20)) {
        const Point centre = random_.chance(50) ? point() : mean(a, b);
        builder.add_ball(finished(centre, random_.below(5) * (random_.chance(50) ? 1 : 0.5)));
      } else {
        Corners v = face(a, b, box_a, box_b);
        if (in_layers && random_.chance(70)) v[0][2] = v[1][2] = v[2][2] = random_.between(-1, 9);
        add(builder, v);
      }
    }
    trial.scene = builder.finish();
    for (std::size_t k = 0; k < 3; ++k) {
      trial.pair.a.corners[k] = finished(a[k]);
      trial.pair.b.corners[k] = finished(b[k]);
    }
    trial.a = finished(box_a);
    trial.b = finished(box_b);
    return trial;
  }

 private:
  double coordinate() { return 4 * random_.below(size_ + 1); }
  Point point() { return {coordinate(), coordinate(), coordinate()}; }
  Corners triangle() {
    Corners v{point(), point(), point()};
    if (random_.chance(5)) v[2] = v[random_.chance(50) ? 0 : 1];
    if (random_.chance(3)) v[1] = v[2] = v[0];
    return v;
  }
  scene::Box<double> box() {
    const Point p = point(), q = random_.chance(15) ? p : point();
    return box_of({p, q, q});
  }
  static scene::Box<double> box_of(const Corners& v) {
    scene::Box<double> box;
    for (std::size_t i = 0; i < 3; ++i) {
      box.c[i] = std::min({v[0][i], v[1][i], v[2][i]});
      box.c[i + 3] = std::max({v[0][i], v[1][i], v[2][i]});
    }
    return box;
  }
  Point corner_of(const scene::Box<double>& box) {
    Point p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = random_.chance(50) ? box.c[i] : box.c[i + 3];
    return p;
  }
  /// A quarter of the way on, which is a whole number.
  Point towards(const Point& p, const Point& q, int quarters) {
    Point r;
    for (std::size_t i = 0; i < 3; ++i) r[i] = p[i] + (q[i] - p[i]) / 4 * quarters;
    return r;
  }
  const Point& any(const Corners& v) { return v[static_cast<std::size_t>(random_.below(3))]; }
  Point mean(const Corners& a, const Corners& b) { return towards(any(a), any(b), random_.between(0, 4)); }

  /// A corner of a face: anywhere, on a segment between the patches or the boxes or a step beyond its end, in
  /// a patch's plane, or a corner.
  Point corner(const Corners& a, const Corners& b, const scene::Box<double>& box_a,
               const scene::Box<double>& box_b) {
    switch (random_.below(7)) {
      case 0:
      case 1:
        return point();
      case 2:
        return towards(any(a), any(b), random_.between(-1, 5));
      case 3:
        return towards(corner_of(box_a), corner_of(box_b), random_.between(-1, 5));
      case 4: {
        const Corners& v = random_.chance(50) ? a : b;
        Point p;
        const int x = random_.between(-4, 4), y = random_.between(-4, 4);
        for (std::size_t i = 0; i < 3; ++i) {
          p[i] = v[0][i] + (v[1][i] - v[0][i]) / 4 * x + (v[2][i] - v[0][i]) / 4 * y;
        }
        return p;
      }
      case 5:
        return any(random_.chance(50) ? a : b);
      default: {  // a step off
        Point p = mean(a, b);
        p[static_cast<std::size_t>(random_.below(3))] += random_.between(-1, 1);
        return p;
      }
    }
  }
  Corners face(const Corners& a, const Corners& b, const scene::Box<double>& box_a,
               const scene::Box<double>& box_b) {
    const auto one = [&] { return corner(a, b, box_a, box_b); };
    Corners v{one(), one(), one()};
    const Corners& patch = random_.chance(50) ? a : b;
    switch (random_.below(7)) {
      case 0:
        v = patch;
        std::swap(v[static_cast<std::size_t>(random_.below(3))], v[0]);
        break;
      case 1:
        v[0] = patch[0];
        v[1] = patch[1];
        break;
      case 2:
      case 6:  // large, across
        for (std::size_t k = 0; k < 3; ++k) {
          v[k] = {k == 1 ? 60.0 : -30.0, k == 2 ? 60.0 : -30.0, 1.0 * random_.between(1, 3)};
        }
        if (random_.chance(30)) v[0][2] += random_.between(-2, 2);
        if (random_.chance(20)) v[1] = corner(a, b, box_a, box_b);
        break;
      case 3:
        if (random_.chance(40)) v[2] = v[0];
        if (random_.chance(30)) v[1] = v[0];
        break;
      default:
        break;
    }
    return v;
  }

  double scaled(double x) const {
    return finish_ == Finish::huge       ? std::ldexp(x, 1000)
           : finish_ == Finish::denormal ? std::ldexp(x, -1073)
                                         : x;
  }
  Point finished(const Point& p) const {
    if (finish_ == Finish::stretched) return {stretched(p[0], 0), stretched(p[1], 1), stretched(p[2], 2)};
    if (finish_ != Finish::turned) return {scaled(p[0]), scaled(p[1]), scaled(p[2])};
    Point q;
    for (std::size_t i = 0; i < 3; ++i) {
      q[i] = turn_[i] * p[0] + turn_[i + 3] * p[1] + turn_[i + 6] * p[2] + turn_[i + 9];
    }
    return q;
  }
  double stretched(double x, std::size_t axis) const {
    return x * (1 + std::fabs(turn_[axis])) + turn_[9 + axis];
  }
  /// Boxes can't be turned: they are stretched.
  scene::Box<double> finished(scene::Box<double> box) const {
    const bool stretch = finish_ == Finish::turned || finish_ == Finish::stretched;
    for (std::size_t i = 0; i < 6; ++i) box.c[i] = stretch ? stretched(box.c[i], i % 3) : scaled(box.c[i]);
    return box;
  }
  scene::Ball<double> finished(const Point& centre, double radius) const {
    return {finished(centre),
            finish_ == Finish::turned || finish_ == Finish::stretched ? radius : scaled(std::floor(radius))};
  }
  void add(scene::SceneBuilder& builder, const Corners& v) const {
    builder.add_triangle(finished(v[0]), finished(v[1]), finished(v[2]));
  }

  Random random_;
  Finish finish_;
  int size_ = 1;
  std::array<double, 12> turn_{};
};

/// A trial for people: all numbers in hexadecimal.
inline std::string text_of(const PairTrial& trial) {
  std::ostringstream text;
  const auto add = [&](const auto& numbers) {
    for (const double x : numbers) text << ' ' << scene::hex_text(x);
  };
  text << "boxes";
  add(trial.a.c);
  add(trial.b.c);
  for (const scene::Patch* patch : {&trial.pair.a, &trial.pair.b}) {
    text << "\npatch (face " << static_cast<std::int32_t>(patch->face) << ")";
    for (const auto& p : patch->corners) add(p);
  }
  for (std::size_t t = 0; t < trial.scene.triangles.size(); ++t) {
    text << "\ntri";
    for (std::size_t k = 0; k < 3; ++k) add(trial.scene.corner(t, k));
  }
  for (const scene::Ball<double>& ball : trial.scene.balls) {
    text << "\nball";
    add(ball.centre);
    text << ' ' << scene::hex_text(ball.radius);
  }
  return text.str();
}

}  // namespace gnomon::tests
