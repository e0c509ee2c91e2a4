// SPDX-License-Identifier: GPL-3.0-or-later
// Where everything of the speed-against-error plot goes; the still picture and the one with controls share
// it.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reports/summary.h"

namespace gnomon::reports {

/// Which error a panel shows.
enum class Measure { kCulls, kInsides, kWaste };

/// A logarithmic axis: its ends, 0 < lo < hi, and its ticks with their labels.
struct LogAxis {
  double lo = 1, hi = 10;
  std::vector<std::pair<double, std::string>> ticks;

  /// 0 at lo, 1 at hi, clamped.
  [[nodiscard]] double share(double value) const;
};

/// A method's mark. Label offsets are in pixels from the mark; anchor is SVG's text-anchor.
struct PlotPoint {
  std::string method, tier, scalar, distribution;
  double ns = 0;
  Share errors;
  double label_dx = 0, label_dy = 0;
  std::string label_anchor = "start";

  /// Where the mark sits: the rate, or for zero errors its upper bound.
  [[nodiscard]] double height() const { return errors.k == 0 ? errors.rate.high95 : errors.rate.value; }
};

/// The measured reference's time, or nothing.
using ReferenceTime = std::optional<double>;

/// One panel; all panels have one size, in pixels.
struct PlotPanel {
  static constexpr double kWidth = 440, kHeight = 330;
  LogAxis x, y;
  std::vector<PlotPoint> points;
  ReferenceTime reference_ns;
};

/// Points of the summaries that were timed and asked for `measure`.
[[nodiscard]] std::vector<PlotPoint> plot_points(std::span<const Summary> summaries, Measure measure);

/// Axes that hold all points (and the reference's times), with room for labels.
[[nodiscard]] LogAxis time_axis(std::span<const PlotPoint> points, std::span<const double> reference_ns);
[[nodiscard]] LogAxis error_axis(std::span<const PlotPoint> points);

/// Chooses each label's place so that labels cover neither marks nor each other, as far as there is room.
void place_labels(PlotPanel& panel);

}  // namespace gnomon::reports
