// SPDX-License-Identifier: GPL-3.0-or-later
// The shadows of a scene as one method sees them, and where it is wrong.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "fuzz/scene_method.h"
#include "reports/png.h"
#include "scene/scene.h"

namespace gnomon::reports {

/// Pixels whose answer is wrong for some light, each once: by the worst of its errors, in this order.
struct WrongPixels {
  std::size_t false_lit = 0, false_shadowed = 0, wrong_reason = 0, undecided = 0;
  std::size_t touching = 0;  ///< wrong or undecided on touching queries alone
  std::size_t seen = 0;      ///< pixels that see a face

  [[nodiscard]] std::size_t all() const {
    return false_lit + false_shadowed + wrong_reason + undecided + touching;
  }
};

struct ShadowPicture {
  Pixels shadows;  ///< what the method says: brighter where more lights are lit
  Pixels errors;   ///< the truth in grey, wrong pixels in colour
  WrongPixels wrong;
};

inline constexpr Colour kFalseLit{230, 30, 30}, kFalseShadowed{40, 90, 255}, kWrongReason{200, 60, 220},
    kUndecided{250, 200, 0}, kTouching{0, 170, 90};

/// Draws `columns` by `rows` pixels of a scene of floats with lights and view (fuzz::complete()). What a
/// pixel sees is decided exactly; the method is asked for each light (polygon lights by
/// fuzz::kPointsPerPolygonLight points), and so is the truth. Undecided counts as half lit.
[[nodiscard]] ShadowPicture draw_shadows(const scene::Scene& scene, const fuzz::SceneMethod& method,
                                         std::size_t columns, std::size_t rows,
                                         const std::function<void(double)>& on_progress);

}  // namespace gnomon::reports
