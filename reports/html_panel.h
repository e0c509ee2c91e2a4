// SPDX-License-Identifier: GPL-3.0-or-later
// One panel of the speed-against-error plot as a still picture.
#pragma once

#include <string>

#include "reports/plot_layout.h"

namespace gnomon::reports {

struct PanelText {
  const char* title;
  const char* axis;
  const char* time = "ns per case";
};

/// The panel as an SVG element that needs no script; `what` says in words what was asked.
[[nodiscard]] std::string panel_svg(const PlotPanel& panel, const PanelText& text, const std::string& what);

}  // namespace gnomon::reports
