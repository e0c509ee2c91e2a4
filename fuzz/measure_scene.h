// SPDX-License-Identifier: GPL-3.0-or-later
// Asks methods about the workloads of a scene, judges them by the truth, and times them side by side.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/scene_measurement.h"
#include "fuzz/scene_method.h"
#include "fuzz/scene_variant.h"
#include "fuzz/workload.h"
#include "scene/scene.h"

namespace gnomon::fuzz {

struct MeasureOptions {
  WorkloadOptions workload;
  std::vector<std::string> workloads;         ///< names
  std::vector<const SceneMethod*> methods;    ///< rows
  std::vector<std::array<double, 3>> lights;  ///< instead of the scene's own, where there are any
  unsigned rounds = 5;                        ///< timed, after one that isn't
  /// Candidate lists on progressive radiosity too, with these further rows; else none. Timed in a third of
  /// the rounds: they take long.
  std::optional<std::vector<ListSpec>> lists;
  /// Lists that are held against the exact candidates, as ListMeasureOptions has it.
  std::size_t checked_lists = ListMeasureOptions{}.checked_lists;
  bool chosen = false;  ///< methods were chosen by name: then none is left out for taking too long
};

/// Called now and then with the share of a scene that is done and what is being done.
using OnMeasured = std::function<void(double done, const std::string& where)>;

/// Measures one variant of a scene, and adds what comes of it. The scene gets the lights of the
/// options, is moved and scaled, rounded to floats, then given lights and view where it has none. Each
/// workload is recorded once, by exact answers; every method then answers it untimed, is judged, and is
/// timed: in each round all methods in turn, forwards and backwards, each with the queries in the order of
/// the image and in a shuffled one. Throws std::runtime_error for scenes beyond the range of floats.
void measure_scene(const std::string& name, const scene::Scene& given, const SceneVariant& variant,
                   const MeasureOptions& options, Measurement& measurement, const OnMeasured& on_progress);

}  // namespace gnomon::fuzz
