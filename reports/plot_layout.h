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
  double ns = 0;     ///< where the mark sits on the time axis
  bool off = false;  ///< the true time is less than the axis holds (named in the label)
  double true_ns = 0;
  Share errors;
  double label_dx = 0, label_dy = 0;
  std::string label_anchor = "start";

  /// The method, and the time where the axis does not show it.
  [[nodiscard]] std::string label() const;

  /// Where the mark sits: the rate, or for zero errors its upper bound.
  [[nodiscard]] double height() const { return errors.k == 0 ? errors.rate.high95 : errors.rate.value; }
};

/// The exact reference's median time, and what to call it in the plot.
struct ReferenceLine {
  std::string label;
  double ns = 0;
};

/// One panel; all panels have one size, in pixels.
struct PlotPanel {
  static constexpr double kWidth = 440, kHeight = 330;
  LogAxis x, y;
  std::vector<PlotPoint> points;
  std::vector<ReferenceLine> references;
};

/// Points of the summaries that were timed and asked for `measure`.
[[nodiscard]] std::vector<PlotPoint> plot_points(std::span<const Summary> summaries, Measure measure);

/// One line, or one for each scalar when their references take times that differ by more than a quarter.
[[nodiscard]] std::vector<ReferenceLine> reference_lines(std::span<const Summary> summaries);

/// Axes that hold all points and the references, with room for labels. The trivial method takes no time to
/// speak of; where it would push the others together it does not count for the axis.
[[nodiscard]] LogAxis time_axis(std::span<const PlotPoint> points, std::span<const ReferenceLine> references);
[[nodiscard]] LogAxis error_axis(std::span<const PlotPoint> points);

/// Moves the marks that the time axis does not hold to its lower end, and says so in their labels.
void pull_in(PlotPanel& panel);

/// Chooses each label's place so that labels cover neither marks nor each other, as far as there is room.
void place_labels(PlotPanel& panel);

}  // namespace gnomon::reports
