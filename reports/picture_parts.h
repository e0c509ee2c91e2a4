// SPDX-License-Identifier: GPL-3.0-or-later
// The two halves of a case's picture, as SVG fragments of a fixed size.
#pragma once

#include <string>

#include "reports/deciding_view.h"

namespace gnomon::reports {

/// A finite number for SVG, two decimals, clamped to +-100000: far enough to be out of every picture.
[[nodiscard]] std::string svg_number(double x);

/// The whole case along the deciding projection, and how many pixels one of the case's ulps takes in it.
struct OverviewPicture {
  static constexpr double kWidth = 320, kHeight = 342;
  std::string svg;
  double pixels_per_ulp = 0;
};

[[nodiscard]] OverviewPicture overview(const ShaftCase& shaft, const DecidingView& view);

/// The neighbourhood of the deciding corner, kSize x kSize pixels, with a line of text on its scale.
struct InsetPicture {
  static constexpr double kSize = 224;
  std::string svg;
  std::string scale;
};

[[nodiscard]] InsetPicture inset(const ShaftCase& shaft, const DecidingView& view);

}  // namespace gnomon::reports
