// SPDX-License-Identifier: GPL-3.0-or-later
// Batches of rays for the tests of fast/pair_visibility.h.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "exact/first_hit.h"
#include "exact/shadow.h"
#include "exact/side_of_face.h"
#include "fast/pair_visibility.h"
#include "fuzz/float_faces.h"
#include "tests/hard_scenes.h"

namespace gnomon::tests {

using fast::RayBatch;
using fast::ShadowAnswer;
using scene::FaceRun;

using Points = std::vector<std::array<float, 3>>;
using Answers = std::vector<ShadowAnswer>;

inline const fast::ExactFaces kExactFaces{exact::blocks, exact::faces_away, exact::meets,
                                          exact::compare_hits};

/// A batch with its points.
struct BatchCase {
  Points from, to;
  FaceRun own_from, own_to;

  [[nodiscard]] RayBatch batch() const { return {from, to, own_from, own_to}; }
  [[nodiscard]] std::size_t rays() const { return from.size() * to.size(); }
  [[nodiscard]] scene::ShadowQuery query(std::size_t i) const {
    scene::ShadowQuery query;
    for (std::size_t k = 0; k < 3; ++k) {
      query.point[k] = static_cast<double>(from[i / to.size()][k]);
      query.light[k] = static_cast<double>(to[i % to.size()][k]);
    }
    return query;
  }
};

/// Points on two triangles, on their edges or anywhere; every other time so that the rays leave the first one
/// on its front, exactly: what lies behind is then left out.
inline BatchCase hard_case(HardKind kind, const scene::Scene& scene, Random& random) {
  HardPoints points(kind, random);
  constexpr int kSizes[] = {1, 2, 3, 4, 5, 8, 9, 16, 17, 20};
  const auto triangle = [&] {
    return static_cast<std::uint32_t>(random.below(static_cast<int>(scene.triangles.size())));
  };
  const std::uint32_t first = triangle(), second = triangle();
  const bool leaves_front = random.chance(50);
  BatchCase made;
  const auto fill = [&](Points& list, std::uint32_t face, FaceRun& own, int least_side) {
    if (leaves_front || random.chance(70)) own = {face, random.chance(80) ? 1u : 2u};
    const int count = kSizes[random.below(10)];
    const bool on_corners = random.chance(25), anywhere = random.chance(20);
    for (int tries = 0; static_cast<int>(list.size()) < count; ++tries) {
      Point3 p = on_corners                      ? scene.corner(face, list.size() % 3)
                 : anywhere || random.chance(10) ? points.point()
                                                 : points.on(scene, face);
      // Moved by a few ulps; now and then it stays where it is.
      for (int step = 0; leaves_front && step < 4 && exact::side_of_face(scene, first, p) < least_side;
           ++step) {
        double& x = p[static_cast<std::size_t>(random.below(3))];
        x = as_float(x + (random.chance(50) ? 1 : -1) * std::abs(x) * 0x1p-22);
      }
      if (leaves_front && tries < 400 && exact::side_of_face(scene, first, p) < least_side) continue;
      list.push_back(fuzz::to_floats(p));
    }
  };
  fill(made.from, first, made.own_from, 0);
  fill(made.to, second, made.own_to, 1);
  if (random.chance(5)) made.to[0] = made.from[0];
  if (random.chance(50)) {
    std::swap(made.from, made.to);
    std::swap(made.own_from, made.own_to);
  }
  return made;
}

}  // namespace gnomon::tests
