// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements as a table and as a result file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/scene_measurement.h"

namespace gnomon::reports {

/// A table for each scene, variant and workload, what was left out, and what the columns mean.
[[nodiscard]] std::string measure_text(const fuzz::Measurement& measurement);

/// What the command line says of a measurement.
struct MeasureCommand {
  std::string text;  ///< that can be typed again
  std::uint64_t seed = 1;
  std::vector<std::string> lights;  ///< instead of the scenes' own
  unsigned rounds = 0;
  bool complete = true;  ///< all scenes are in
};

/// The result file: rows, the same bytes on every run, and apart from them what was measured.
[[nodiscard]] std::string measure_json(const fuzz::Measurement& measurement, const MeasureCommand& command);

}  // namespace gnomon::reports
