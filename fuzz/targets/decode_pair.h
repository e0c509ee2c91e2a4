// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes to small scenes with a pair of boxes or of patches: every byte string is valid, and short ones reach
// faces that touch the shaft, shared corners, own faces, flat boxes and degenerate patches.
#pragma once

#include "fuzz/pair_method.h"
#include "fuzz/targets/decode_shadow.h"

namespace gnomon::fuzz {

template <class Query>
struct SmallPair {
  scene::Scene scene;
  Query query;
  int shift = 0;       ///< all numbers times 2^shift are another case of the same answer
  bool floats = true;  ///< all numbers are
};

class PairDecoder : SceneDecoder {
 public:
  explicit PairDecoder(Bytes bytes) : SceneDecoder(bytes) {}

  [[nodiscard]] SmallPair<BoxPair> boxes() {
    SmallPair<BoxPair> result;
    result.scene = decode_scene();
    result.floats = !doubles_;
    for (scene::Box<float>* box : {&result.query.a, &result.query.b}) {
      const Point p = end(), q = end();
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t k = static_cast<std::size_t>(axis);
        set_axis(*box, axis, to_float(p[k]), to_float(q[k]));
      }
    }
    result.shift = bytes_.small() % 41;
    return result;
  }

  [[nodiscard]] SmallPair<scene::PatchPair> patches() {
    SmallPair<scene::PatchPair> result;
    result.scene = decode_scene();
    result.floats = !doubles_;
    for (scene::Patch* patch : {&result.query.a, &result.query.b}) {
      const unsigned kind = bytes_.next();
      const bool own = kind % 4 != 0 && !triangles_.empty();
      if (own) patch->face = static_cast<std::uint32_t>(kind / 4 % triangles_.size());
      for (std::size_t k = 0; k < 3; ++k) {
        patch->corners[k] = own && kind % 4 != 3 ? points_[triangles_[patch->face][k]] : end();
      }
    }
    result.shift = bytes_.small() % 41;
    return result;
  }

 private:
  [[nodiscard]] static float to_float(double x) { return static_cast<float>(std::clamp(x, -0x1p41, 0x1p41)); }
};

}  // namespace gnomon::fuzz
