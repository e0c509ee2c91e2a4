// SPDX-License-Identifier: GPL-3.0-or-later
// Shafts, boxes and balls for timing the batch kernels: random ones, and integers that tie with the planes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fast/batch_types.h"
#include "fast/shaft.h"
#include "fuzz/random.h"
#include "fuzz/shapes.h"

namespace gnomon::bench {

enum class Data { random6, random8, ties, dense_ties };

[[nodiscard]] inline std::string name_of(Data data) {
  switch (data) {
    case Data::random6:
      return "random, 6 planes";
    case Data::random8:
      return "random, 8 planes";
    case Data::ties:
      return "ties, grid of 32";
    case Data::dense_ties:
      return "ties, grid of 8";
  }
  return "?";
}

template <class F>
struct Boxes {
  std::array<std::vector<F>, 6> c;
  [[nodiscard]] fast::BoxesSoA<F> view() const {
    return {{c[0].data(), c[1].data(), c[2].data()}, {c[3].data(), c[4].data(), c[5].data()}, c[0].size()};
  }
};

template <class F>
struct Balls {
  std::array<std::vector<F>, 4> c;
  [[nodiscard]] fast::BallsSoA<F> view() const {
    return {{c[0].data(), c[1].data(), c[2].data()}, c[3].data(), c[0].size()};
  }
};

/// Both reference boxes of a shaft, in floats (the f64 rows use the same numbers).
struct Ends {
  scene::Box<float> a, b;
};

inline scene::Box<float> random_box(fuzz::CaseRandom& random, Data data, float size) {
  scene::Box<float> box;
  const int grid = data == Data::dense_ties ? 8 : 32;
  for (int axis = 0; axis < 3; ++axis) {
    if (data == Data::ties || data == Data::dense_ties) {
      const int lo = random.below(grid), extra = random.below(data == Data::ties ? 5 : 3);
      fuzz::set_axis(box, axis, static_cast<float>(lo), static_cast<float>(std::min(lo + extra, grid - 1)));
    } else {
      const float centre = random.unit<float>();
      fuzz::set_around(box, axis, centre, random.unit<float>() * size);
    }
  }
  return box;
}

/// Shafts with 6 planes (8 for random8).
inline std::vector<Ends> make_shafts(Data data, int count) {
  std::vector<Ends> shafts;
  for (std::uint64_t trial = 0; static_cast<int>(shafts.size()) < count; ++trial) {
    fuzz::CaseRandom random(7, static_cast<std::uint32_t>(data), trial);
    Ends ends;
    ends.a = random_box(random, data, 0.1f);
    ends.b = random_box(random, data, 0.1f);
    if (data == Data::random8) {  // a is extreme on both sides of two axes, b on those of the third
      for (int axis = 0; axis < 3; ++axis) {
        scene::Box<float>& outer = axis < 2 ? ends.a : ends.b;
        outer.lo(axis) = std::min(ends.a.lo(axis), ends.b.lo(axis)) - 0.1f * random.unit<float>() - 0.01f;
        outer.hi(axis) = std::max(ends.a.hi(axis), ends.b.hi(axis)) + 0.1f * random.unit<float>() + 0.01f;
      }
    }
    const auto shaft = fast::form_shaft(ends.a, ends.b, fast::Normals::as_formed);
    if (shaft.plane_count == (data == Data::random8 ? 8 : 6)) shafts.push_back(ends);
  }
  return shafts;
}

template <class F>
Boxes<F> make_boxes(Data data, std::size_t count) {
  Boxes<F> boxes;
  for (auto& array : boxes.c) array.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    fuzz::CaseRandom random(8, static_cast<std::uint32_t>(data), i);
    const scene::Box<float> box = random_box(random, data, 0.02f);
    for (std::size_t k = 0; k < 6; ++k) boxes.c[k][i] = box.c[k];
  }
  return boxes;
}

template <class F>
Balls<F> make_balls(Data data, std::size_t count) {
  Balls<F> balls;
  for (auto& array : balls.c) array.resize(count);
  const bool grid = data == Data::ties || data == Data::dense_ties;
  for (std::size_t i = 0; i < count; ++i) {
    fuzz::CaseRandom random(9, static_cast<std::uint32_t>(data), i);
    const scene::Box<float> box = random_box(random, data, 0.0f);
    for (std::size_t k = 0; k < 3; ++k) balls.c[k][i] = box.c[k];
    balls.c[3][i] =
        grid ? static_cast<F>(random.below(data == Data::ties ? 6 : 3)) : random.unit<float>() * 0.03f;
  }
  return balls;
}

}  // namespace gnomon::bench
