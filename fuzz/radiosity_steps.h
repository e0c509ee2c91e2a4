// SPDX-License-Identifier: GPL-3.0-or-later
// Progressive radiosity: the workload of Haines and Wallace, "Statistics".
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "fuzz/radiosity.h"

namespace gnomon::fuzz {

struct StepOptions {
  std::size_t steps = 20;        ///< each shoots the light of one emitter
  std::size_t emitter_side = 1;  ///< samples of an emitter: the square of this
  double spacing = 0;            ///< of receivers' mesh points, in the scene's units; 0: default_spacing()
};

/// One step: an emitter and all patches that face it.
struct RadiosityStep {
  RadiosityPatch emitter;
  std::vector<RadiosityPair> pairs;       ///< receivers in their order
  std::vector<std::vector<bool>> hidden;  ///< of each pair, whether each ray is blocked, exactly
};

/// The steps of progressive radiosity, Wallace, Elmquist and Haines 1989: every step takes the patch with the
/// most light that it has not sent yet (all lights shine alike, by their area, and send before the polygons
/// do; polygons reflect half of what arrives), and finds what each mesh point of each receiver that faces it
/// gets of it, by rays to the samples of the emitter, as a disc of their share of its area sends it. Rays go
/// out where both surfaces face each other; `hidden` answers them exactly. `emitter` of a pair is the step's
/// number, `receiver` that of the polygon in patches_of(). A scene without polygon lights begins with the
/// largest polygons. The scene has floats alone.
[[nodiscard]] std::vector<RadiosityStep> record_steps(
    const scene::Scene& scene, const std::function<bool(const scene::ShadowQuery&)>& hidden,
    const StepOptions& options);

/// A spacing of mesh points for a scene of that size: a 40th of the largest side of its box.
[[nodiscard]] double default_spacing(const scene::Scene& scene);

}  // namespace gnomon::fuzz
